#!/usr/bin/env bash
# What `make run` shows once the tool is built.
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
