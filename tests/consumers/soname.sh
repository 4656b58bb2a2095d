#!/bin/sh
# soname.sh LIBDIR SOURCE: the links and the SONAME; and no file that other programs read says where the package was made.
set -eu
libdir=$1
source=$2

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
[ -z "$(readelf -d "$libdir/libmedax.so" | grep -E 'RPATH|RUNPATH')" ]
if grep -rF "$source" "$libdir/cmake/medax" "$libdir/pkgconfig"; then
    echo "these name $source" >&2
    exit 1
fi
