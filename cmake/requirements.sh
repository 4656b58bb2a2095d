#!/bin/sh
# Makes sure that what a make target needs is on this machine:
# `cmake/requirements.sh demo|install|test|test-python|test-blender|test-meshlab|bench-peers|docs`.
#
# What is missing is installed with apt-get where that is possible (root, Debian or a relative of
# it), and named first. Elsewhere the list is printed and the script fails. Nothing is touched when
# everything is there.
set -eu

target=${1:?"usage: $0 demo|install|test|test-python|test-blender|test-meshlab|bench-peers|docs"}
packages=''
others=''

missing_package() { packages="$packages $1"; }
missing_other() { others="$others
  - $1"; }

have() { command -v "$1" >/dev/null 2>&1; }
have_header() { printf '#include <%s>\n' "$1" | c++ -std=c++17 -E -x c++ - >/dev/null 2>&1; }

if [ "$target" = docs ]; then
    have doxygen || missing_package doxygen
    python3 -c 'import ensurepip, venv' >/dev/null 2>&1 || missing_package python3-venv
else
    have cargo || missing_other 'Rust with cargo: https://rustup.rs or your distribution'
    have cc || missing_package gcc
fi
if [ "$target" != demo ] && [ "$target" != docs ]; then
    have cmake || missing_package cmake
fi
if [ "$target" = test ] || [ "$target" = bench-peers ]; then
    have c++ || missing_package g++
    have ninja || missing_package ninja-build
    have_header CGAL/version.h || missing_package libcgal-dev
fi
if [ "$target" = bench-peers ]; then
    have_header tbb/global_control.h || missing_package libtbb-dev
fi
if [ "$target" = test ]; then
    have cargo && {
        cargo fmt --version >/dev/null 2>&1 || missing_other 'rustfmt: rustup component add rustfmt'
        cargo clippy --version >/dev/null 2>&1 || missing_other 'clippy: rustup component add clippy'
    }
    have nm || missing_package binutils
    have pkg-config || missing_package pkg-config
    have valgrind || missing_package valgrind
    python3 -c 'import ensurepip, venv' >/dev/null 2>&1 || missing_package python3-venv
    have_header OpenMesh/Core/System/config.h || missing_package libopenmesh-dev
fi
if [ "$target" = test-python ]; then
    python3 -c 'import ensurepip, venv' >/dev/null 2>&1 || missing_package python3-venv
    have strip || missing_package binutils
    # What the wheel of PyMeshLab links and does not carry.
    libraries=$(PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null || true)
    for pair in libgl1=libGL.so.1 libopengl0=libOpenGL.so.0 libfontconfig1=libfontconfig.so.1; do
        case $libraries in *"${pair#*=}"*) ;; *) missing_package "${pair%=*}" ;; esac
    done
fi
if [ "$target" = test-blender ]; then
    # Blender 4.2 is a module for this Python alone.
    have python3.11 || missing_package python3.11
    python3.11 -c 'import ensurepip, venv' >/dev/null 2>&1 || missing_package python3.11-venv
    have strip || missing_package binutils
    # What Blender links, though it opens no window.
    libraries=$(PATH="$PATH:/sbin:/usr/sbin" ldconfig -p 2>/dev/null || true)
    for pair in libxrender1=libXrender.so.1 libxxf86vm1=libXxf86vm.so.1 libxfixes3=libXfixes.so.3 libxi6=libXi.so.6 \
        libxkbcommon0=libxkbcommon.so.0 libsm6=libSM.so.6 libgl1=libGL.so.1 libegl1=libEGL.so.1; do
        case $libraries in *"${pair#*=}"*) ;; *) missing_package "${pair%=*}" ;; esac
    done
fi
if [ "$target" = test-meshlab ]; then
    have c++ || missing_package g++
    have ninja || missing_package ninja-build
    have meshlabserver || missing_package meshlab
    # xvfb-run needs xauth, and does not ask for it.
    have xvfb-run || missing_package xvfb
    have xauth || missing_package xauth
    # Qt's headers lie where only its packages say.
    have moc || missing_package qtbase5-dev
    dpkg -s libqt5opengl5-dev >/dev/null 2>&1 || missing_package libqt5opengl5-dev
    have_header GL/glew.h || missing_package libglew-dev
    have_header eigen3/Eigen/Core || missing_package libeigen3-dev
fi

if [ -n "$others" ]; then
    echo "medax: 'make $target' needs, and cannot install by itself:$others" >&2
    exit 1
fi
[ -n "$packages" ] || exit 0

if [ "$(id -u)" -ne 0 ] || ! have apt-get; then
    echo "medax: 'make $target' needs these packages (Debian's names):$packages" >&2
    have apt-get && echo "medax: install them with: sudo apt-get install$packages" >&2
    exit 1
fi
echo "medax: 'make $target' needs packages that are not here; installing:$packages"
apt-get update -q
# shellcheck disable=SC2086 # one word a package
DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $packages
