#!/usr/bin/env bash
# clang-tidy over the sources of the engine, the scenes and the apps; headers are seen through the sources.
#   tools/lint.sh [FILE...]     default: all .cpp of lissom, scenes and apps
set -euo pipefail
. "$(dirname "$0")/common.sh"

tidy=$(command -v clang-tidy-14 || command -v clang-tidy) || {
  echo "tools/lint.sh: clang-tidy is missing; run tools/setup.sh ci" >&2
  exit 1
}
[ -f build/release/compile_commands.json ] || cmake --preset release -Wno-dev >/dev/null
files=("$@")
[ $# -gt 0 ] || mapfile -t files < <(sources lissom scenes apps | grep '\.cpp$')
if [ ${#files[@]} -eq 0 ]; then
  echo "tools/lint.sh: no sources found" >&2
  exit 1
fi

# The command lines are g++'s, so some warning options mean nothing here; the summaries ("N warnings generated") neither.
start=$SECONDS
status=0
printf '%s\0' "${files[@]}" |
  xargs -0 -n 1 -P "$(jobs)" "$tidy" -p build/release --quiet --extra-arg=-Wno-unknown-warning-option 2> >(grep -vE '^[0-9]+ warnings? .*generated' >&2) || status=1
say "lint: ${#files[@]} files in $((SECONDS - start)) s"
exit $status
