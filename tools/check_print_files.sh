#!/usr/bin/env bash
# Asks programs of others whether files for printers are clean. Not part of `make test`: it installs a slicer.
#   tools/check_print_files.sh FILE.3mf|FILE.stl...     pictures of a layer go to the folder of LISSOM_LAYERS, if that is set
# manifold-3d (npm, into a temporary folder) has to take every object without an error and with the volume of its triangles;
# PrusaSlicer (Debian) has to call it manifold and to slice it without errors or warnings.
set -euo pipefail
. "$(dirname "$0")/common.sh"

if [ $# -eq 0 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
if ! command -v prusa-slicer >/dev/null; then
  say "installing prusa-slicer"
  apt-get -q update >/dev/null
  DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends prusa-slicer >/dev/null
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
say "installing manifold-3d"
(cd "$folder" && npm install --silent --no-fund --no-audit --ignore-scripts manifold-3d@3.5.4 >/dev/null)
python3 "$(dirname "$0")/check_print_files.py" --tools "$folder" ${LISSOM_LAYERS:+--layers "$LISSOM_LAYERS"} "$@"
