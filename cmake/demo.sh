#!/bin/sh
# demo.sh OUT: samples a built-in shape, makes its power crust, and says what came out and where.
set -eu
out=$1
medax=${CARGO_TARGET_DIR:-target}/release/medax
mkdir -p "$out"

show() {
    echo
    echo "\$ medax $*"
    "$medax" "$@"
}
show sample genus3 -o "$out/points.ply"
show crust "$out/points.ply" -o "$out/surface.ply" --shape "$out/axis.vtu" --poles "$out/poles.ply"

echo
echo "Three handles, and so genus 3. The files, for MeshLab, Blender or ParaView:"
echo "  $out/points.ply   the sample, all that the rest was made from"
echo "  $out/surface.ply  the power crust: a closed surface of convex polygons"
echo "  $out/axis.vtu     the inner power shape, an approximation of the medial axis, with radii"
echo "  $out/poles.ply    the centres of the polar balls, with radii and labels"
