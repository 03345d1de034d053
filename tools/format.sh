#!/usr/bin/env bash
# clang-format over all our C++ sources.
#   tools/format.sh          rewrites them
#   tools/format.sh --check  only says which lines differ
set -euo pipefail
. "$(dirname "$0")/common.sh"

format=$(command -v clang-format-14 || command -v clang-format) || {
  echo "tools/format.sh: clang-format is missing; run tools/setup.sh ci" >&2
  exit 1
}
mapfile -t files < <(sources)
if [ ${#files[@]} -eq 0 ]; then
  echo "tools/format.sh: no sources found" >&2
  exit 1
fi
if [ "${1:-}" = --check ]; then
  bad=$("$format" --dry-run "${files[@]}" 2>&1 | grep -F Wclang-format-violations | cut -d : -f 1,2 | sort -u -t : -k 1,1 || true)
  if [ -n "$bad" ]; then
    echo "$bad"
    echo "tools/format.sh: these files are not formatted, first from the lines given; run 'make format'" >&2
    exit 1
  fi
  say "format: ${#files[@]} files are as they should be"
else
  "$format" -i "${files[@]}"
  say "format: ${#files[@]} files"
fi
