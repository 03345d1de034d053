#!/usr/bin/env bash
# What `make run` shows once the tool is built: a gridshell that rises, a hexagon sheet that hangs and a butterfly of rods on
# stretched fabric that lifts its wings, solved, drawn and written for ParaView; then a sheet that is designed to bend and
# stretch as four others do, with a report and a file for a printer; last the studio, open on the butterfly, until Ctrl-C.
# Results go to out/. Where nobody looks (no terminal, or CI is set) the studio is only shown to answer.
set -euo pipefail
. "$(dirname "$0")/common.sh"

lissom=build/release/lissom
if [ ! -x "$lissom" ]; then
  echo "tools/run_demo.sh: $lissom is not there; build it with 'make run'" >&2
  exit 1
fi

# Prints a command the way a user would type it, and runs it.
show() {
  printf '\n$ %s\n' "$*"
  "$@"
}

show "$lissom" --version
for structure in scenes/data/gridshell.lissom scene:hexagon_sheet scenes/data/fabric/butterfly.lissom; do
  show "$lissom" solve "$structure" -o out --picture png --field stress --vtu
done


# The design ends where its parameters end (exit code 13), where the iterations that it was given end (12), or where it is as
# good as it gets (0); which of them comes first hangs on roundings.
printf '\n$ %s\n' "$lissom design scene:sheet_design -o out"
status=0
"$lissom" design scene:sheet_design -o out || status=$?
[ "$status" -eq 0 ] || [ "$status" -eq 12 ] || [ "$status" -eq 13 ] || exit "$status"

printf '\nIn %s/out:\n' "$PWD"
ls -1 out
printf '%s\n' \
  "" \
  ".png    the shape in colour (largest stress at the surface), the drawn one in grey" \
  ".vtu    the same for ParaView, with strain, curvature, twist and energy as arrays" \
  ".html   the report of a design: before and after beside the target, convergence, parameters, the print" \
  ".3mf    what to print, in mm" \
  ".json   everything that was computed; 'lissom solve --resume' goes on from it, 'lissom draw' draws it" \
  "" \
  "Next: the studio, which opens now; 'build/release/lissom --help', docs/guide."

printf '\n$ %s\n' "$lissom studio butterfly --folder out"
if [ -t 0 ] && [ -t 1 ] && [ -z "${CI:-}" ]; then
  exec "$lissom" studio butterfly --folder out
fi
python3 tools/check_studio.py "$lissom" studio butterfly --folder out
