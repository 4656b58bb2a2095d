#!/bin/sh
# outside.sh cmake|pkgconfig|subdirectory PREFIX SOURCE [TARGET_DIR]: builds the consumers as a stranger would, in a folder of its own
# outside the repository, against a prefix whose name has a space in it, and runs them.
set -eu
kind=$1
prefix=$2
source=$3
here=$(cd "$(dirname "$0")" && pwd)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
case $work in "$source"/*) echo "$work lies in the repository" >&2; exit 1 ;; esac
cp "$here/consumer.c" "$here/consumer.cpp" "$here/consumers.cmake" "$here/$kind"/* "$work"
moved="$work/a prefix"
ln -s "$prefix" "$moved"
cd "$work"

case $kind in
    cmake)
        cmake -S . -B build "-DCMAKE_PREFIX_PATH=$moved"
        cmake --build build
        made=build
        ;;
    subdirectory)
        cmake -S . -B build "-DMEDAX_SOURCE=$source" ${4:+"-DMEDAX_TARGET_DIR=$4"}
        cmake --build build
        made=build
        ;;
    pkgconfig)
        PKG_CONFIG_PATH=$(dirname "$(find "$moved/" -name medax.pc)") make
        made=.
        ;;
esac

needs() { readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(libmedax.*\)\]/\1/p'; }
soname=$(readelf -d "$(find "$prefix" -name libmedax.so)" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
for language in c cpp; do
    "$made/${language}_shared"
    "$made/${language}_static"
    echo "$language: the shared one needs '$(needs "$made/${language}_shared")', the static one '$(needs "$made/${language}_static")'"
    [ "$(needs "$made/${language}_shared")" = "$soname" ]
    [ -z "$(needs "$made/${language}_static")" ]
done
