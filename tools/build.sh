#!/usr/bin/env bash
# Configures build/PRESET and builds targets in it.
#   tools/build.sh PRESET [TARGET...]     without targets: everything
set -euo pipefail
. "$(dirname "$0")/common.sh"

preset=${1:?usage: tools/build.sh PRESET [TARGET...]}
shift
say "build: $preset${*:+ ($*)}, $(jobs) at a time"
start=$SECONDS
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake --preset "$preset" -Wno-dev >"$log" 2>&1 || {
  cat "$log" >&2
  exit 1
}
if [ $# -gt 0 ]; then
  cmake --build "build/$preset" -j "$(jobs)" --target "$@"
else
  cmake --build "build/$preset" -j "$(jobs)"
fi
say "build: $preset done in $((SECONDS - start)) s"
