#!/bin/sh
# Runs the filters in Debian's meshlabserver, which needs a display, and checks what it writes.
# server.sh SERVER COMMON PLUGIN OUTPUTS SCRIPTS FOLDER
set -eu
server=$1 common=$2 plugin=$3 outputs=$4 scripts=$5 made=$6

# MeshLab looks for plugins beside its library, which it finds from where its program is: so a tree of links beside a copy of
# the program has one plugin more than what is installed, which stays as it is.
tree=$made/tree
rm -rf "$tree"
plugins=$(dirname "$common")/plugins
mkdir -p "$tree$(dirname "$server")" "$tree$plugins"
cp "$server" "$tree$server"
ln -s "$common" "$tree$common"
ln -s "$plugins"/*.so "$plugin" "$tree$plugins"

cd "$made"
run() {
    log=$1.log
    shift
    status=0
    "$tree$server" "$@" >"$log" 2>&1 || status=$?
}
succeeds() {
    run "$@"
    [ "$status" -eq 0 ] || { cat "$log"; echo "meshlabserver ended with $status"; exit 1; }
}
# meshlabserver ends so, with 255, when a filter returns false.
fails() {
    said=$1
    shift
    run "$@"
    [ "$status" -eq 255 ] && grep -q "^$said" "$log" || { cat "$log"; echo "no '$said', but $status"; exit 1; }
    grep -m 1 "^$said" "$log"
}

succeeds surface -i torus.ply -s "$scripts/surface.mlx" -o surface.ply -l c
"$outputs" surface surface.ply
succeeds axis -i torus.ply -s "$scripts/axis.mlx" -o axis.ply -l c -m vq vc
"$outputs" axis axis.ply torus.ply
succeeds core -i torus.ply -s "$scripts/core.mlx" -o core.ply -l c -m vq
"$outputs" core core.ply torus.ply
succeeds thickness -i box.ply -s "$scripts/thickness.mlx" -o thickness.ply -l c -m vq vc
"$outputs" thickness thickness.ply

for filter in surface axis core thickness; do
    fails 'The layer has no vertices' empty -i empty.ply -s "$scripts/$filter.mlx"
    fails 'There is no current layer' none -s "$scripts/$filter.mlx"
done
fails 'The layer has no faces' faceless -i torus.ply -s "$scripts/thickness.mlx"

# MeshLab's own documentation asks every filter for its help and its parameters.
succeeds dump -d filters.txt
grep -c '^.section f[0-9]* medax: ' filters.txt | grep -qx 4
