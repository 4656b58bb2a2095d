#!/bin/sh
# demo.sh OUT: samples a built-in shape, makes its power crust, and says what came out and where.
set -eu
out=$1
medax=${CARGO_TARGET_DIR:-target}/release/medax
mkdir -p "$out"
