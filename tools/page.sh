#!/usr/bin/env bash
# The studio's page (apps/studio/page) and its tools.
#   tools/page.sh build        builds dist/, unless it is what the sources give already
#   tools/page.sh packages     installs what package-lock.json lists into node_modules/, unless it is there
#   tools/page.sh script NAME  runs a script of package.json
#   tools/page.sh run WORD...  runs a program of its packages in the page's folder
# Node comes from the system where it has a new one, else from npm (Debian 12's own is 18; the package `node` brings 22, and npm
# another npm to it: under 18 it would leave out packages that need more, and Debian's own does not run with 22).
# A source archive with dist/ in it builds without npm: dist/.sources says what dist/ was built from.
# Where the file build/page.keep exists, a page that cannot be built leaves the last one in place: for hours in which somebody
# edits the page and somebody else the engine in one checkout.
set -euo pipefail
. "$(dirname "$0")/common.sh"

page=$root/apps/studio/page
cd "$page"

fail() {
  printf 'tools/page.sh: %s\n' "$@" >&2
  exit 1
}

# Runs a command with Node 20.19 or newer, and with the programs of the page's packages, in front of PATH.
with_node() {
  local PATH=$page/node_modules/.bin:$PATH
  if node -e 'const [a, b] = process.versions.node.split(".").map(Number); process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)' 2>/dev/null; then
    "$@"
  elif command -v npx >/dev/null; then
    npx --yes --package node@22 --package npm@10 -- "$@"
  else
    fail "the page needs Node 20.19 or newer, or npm to fetch it; run tools/setup.sh build, or configure with -DLISSOM_STUDIO=OFF"
  fi
}

script() {
  with_node sh -c "$(python3 -c 'import json, sys; print(json.load(open("package.json"))["scripts"][sys.argv[1]])' "$1")"
}

# One number for all that a build reads.
sources_hash() {
  { find index.html package.json package-lock.json tsconfig.json vite.config.ts src public -type f 2>/dev/null || true; } |
    LC_ALL=C sort | while IFS= read -r file; do
    printf '%s ' "$file"
    sha256sum <"$file"
  done | sha256sum | cut -c 1-16
}

# Whether node_modules/ holds what package-lock.json asks for; npm notes what it has installed.
installed() {
  python3 - <<'END'
import json, sys
try:
    wanted, there = (json.load(open(name))["packages"] for name in ("package-lock.json", "node_modules/.package-lock.json"))
except (OSError, ValueError, KeyError):
    sys.exit(1)
same = lambda name: name in there and there[name].get("version") == wanted[name].get("version")
sys.exit(0 if all(same(n) or (wanted[n].get("optional") and n not in there) for n in wanted if n) else 1)
END
}

packages() {
  # What tests of the whole studio import is found from where they are.
  [ -e "$root/tests/studio/node_modules" ] || ln -sfn ../../apps/studio/page/node_modules "$root/tests/studio/node_modules"
  installed && return
  say "page: installing packages from package-lock.json"
  with_node npm ci --no-audit --no-fund --ignore-scripts --loglevel=error >&2 || fail \
    "the packages of the page could not be installed (no network?). What helps:" \
    "  a source archive with apps/studio/page/dist, which needs none," \
    "  or -DLISSOM_STUDIO=OFF, which builds lissom without the studio"
}

build() {
  local wanted
  wanted=$(sources_hash)
  [ -f dist/index.html ] && [ "$(cat dist/.sources 2>/dev/null)" = "$wanted" ] && return
  packages
  say "page: building"
  local log
  log=$(mktemp)
  script build >"$log" 2>&1 || {
    cat "$log" >&2
    rm -f "$log"
    if [ -f "$root/build/page.keep" ] && [ -f dist/index.html ]; then
      say "page: COULD NOT BE BUILT; build/page.keep says to go on with the last one"
      return
    fi
    fail "the page could not be built; what its tools said stands above"
  }
  rm -f "$log"
  echo "$wanted" >dist/.sources
}

# Build folders share dist/ and node_modules/.
mkdir -p "$root/build"
exec 9>"$root/build/page.lock"
command -v flock >/dev/null && flock 9
case "${1:-}" in
  build) build ;;
  packages) packages ;;
  script)
    packages
    exec 9>&-
    script "$2"
    ;;
  run)
    shift
    packages
    exec 9>&-
    with_node "$@"
    ;;
  *)
    sed -n '2,13p' "$root/tools/page.sh" | sed 's/^# \{0,1\}//' >&2
    exit 2
    ;;
esac
