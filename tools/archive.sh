#!/usr/bin/env bash
# Writes a source archive of what is committed, with the built page of the studio in it, so that it builds without npm.
#   tools/archive.sh [OUTPUT.tar.gz]      default: build/lissom-VERSION.tar.gz
set -euo pipefail
. "$(dirname "$0")/common.sh"

version=$(sed -n 's/^project(lissom VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
output=${1:-build/lissom-$version.tar.gz}
page=apps/studio/page
if [ -n "$(git status --porcelain -- $page)" ]; then
  echo "tools/archive.sh: $page has changes that are not committed; commit them first" >&2
  exit 1
fi
tools/page.sh build
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git archive --prefix="lissom-$version/" -o "$folder/archive.tar" HEAD
# Dates and owners as git archive has them, so that the same commit gives the same bytes.
tar --append -f "$folder/archive.tar" --transform "s|^|lissom-$version/|" --sort=name --owner=0 --group=0 --numeric-owner \
  --mtime="@$(git log -1 --format=%ct)" "$page/dist"
mkdir -p "$(dirname "$output")"
gzip -9n <"$folder/archive.tar" >"$output"
say "archive: $output, $(($(stat -c %s "$output") / 1000)) kB"
