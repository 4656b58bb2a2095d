#!/bin/sh
# soname.sh LIBDIR CONSUMERS: the links, the SONAME and who needs it.
set -eu
libdir=$1
consumers=$2

soname=$(readelf -d "$libdir/libmedax.so" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
version=$(sed -n 's/^Version: //p' "$libdir/pkgconfig/medax.pc")
case $version in
    0.*) expected=libmedax.so.${version%.*} ;;
    *) expected=libmedax.so.${version%%.*} ;;
esac
echo "SONAME $soname, expected $expected for version $version"
[ "$soname" = "$expected" ]
[ "$(readlink "$libdir/libmedax.so")" = "$soname" ]
[ "$(readlink "$libdir/$soname")" = "libmedax.so.$version" ]

needs() { readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(libmedax.*\)\]/\1/p'; }
echo "the shared consumer needs '$(needs "$consumers/cmake/consumer")', the static one '$(needs "$consumers/cmake_static/consumer")'"
[ "$(needs "$consumers/cmake/consumer")" = "$soname" ]
[ -z "$(needs "$consumers/cmake_static/consumer")" ]
