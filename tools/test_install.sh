#!/usr/bin/env bash
# Installs a finished build to a temporary prefix, then builds and runs the program of tests/install against it.
#   tools/test_install.sh BUILD_DIR
set -euo pipefail
build=$(cd "${1:?usage: tools/test_install.sh BUILD_DIR}" && pwd)
. "$(dirname "$0")/common.sh"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/install.log" || {
  cat "$scratch/install.log"
  exit 1
}
# A copy, so that no header of the repository can be found by accident.
cp -r tests/install "$scratch/consumer"
cmake -S "$scratch/consumer" -B "$scratch/build" -G Ninja -DCMAKE_PREFIX_PATH="$scratch/prefix"
cmake --build "$scratch/build"
"$scratch/build/consumer"
if [ -x "$scratch/prefix/bin/lissom" ]; then
  "$scratch/prefix/bin/lissom" --version
fi
