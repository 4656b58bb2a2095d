#!/bin/sh
# Fetches and unpacks the source of the MeshLab that Debian has here: source.sh FOLDER. It comes to lie in FOLDER/source, once.
#
# apt gets a list of sources of its own, in FOLDER: that of the machine stays as it is.
set -eu
mkdir -p "${1:?"usage: $0 FOLDER"}"
cd "$1"
[ ! -d source ] || exit 0

version=$(apt-cache policy meshlab | sed -n 's/^  Candidate: //p')
# Where that version comes from, such as `http://deb.debian.org/debian bookworm/main`.
from=$(apt-cache madison meshlab | awk -F ' *[|] *' -v version="$version" '$2 == version && $3 ~ / Packages$/ { print $3; exit }')
site=$(echo "$from" | cut -d ' ' -f 1)
suite=$(echo "$from" | cut -d ' ' -f 2)
[ -n "$suite" ] || { echo 'medax: apt knows no package meshlab' >&2; exit 1; }

mkdir -p apt/lists/partial
echo "deb-src $site ${suite%/*} ${suite##*/}" >apt/sources.list
ours() {
    apt-get -q -o Dir::Etc::sourcelist="$PWD/apt/sources.list" -o Dir::Etc::sourceparts=- \
        -o Dir::State::lists="$PWD/apt/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
        -o APT::Sandbox::User= "$@"
}
ours update
ours source --download-only "meshlab=$version"
# Debian's changes concern no header that the plugin needs.
rm -rf unpacked
mkdir unpacked
tar -xf meshlab_*.orig.tar.* -C unpacked --strip-components 1
mv unpacked source
