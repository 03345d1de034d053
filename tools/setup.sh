#!/usr/bin/env bash
# Installs what is missing from Debian's packages. Asks nothing, may be run any number of times.
#   tools/setup.sh [build | test | ci | bench]     test and ci contain the ones before; default: build
#   bench: build, and optimisers of others that benches measure ours by
set -euo pipefail
. "$(dirname "$0")/common.sh"

build_packages=(
  build-essential g++ cmake ninja-build pkg-config git python3
  libeigen3-dev nlohmann-json3-dev libfmt-dev libcli11-dev libcairo2-dev
  libsuitesparse-dev libmetis-dev libcgal-dev libboost-dev libpugixml-dev libzip-dev zlib1g-dev
  libgtest-dev libbenchmark-dev
)
test_packages=(python3-numpy python3-jsonschema python3-meshio admesh)
ci_packages=(clang-format-14 clang-tidy-14)
bench_packages=(coinor-libipopt-dev libalglib-dev)
# What may come from elsewhere than Debian is asked for by its program: Node for the studio's page, a browser for its tests.
command -v npm >/dev/null || build_packages+=(nodejs npm)
command -v chromium >/dev/null || test_packages+=(chromium)

case "${1:-build}" in
  build) wanted=("${build_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
  ci) wanted=("${build_packages[@]}" "${test_packages[@]}" "${ci_packages[@]}") ;;
  bench) wanted=("${build_packages[@]}" "${bench_packages[@]}") ;;
  *)
    echo "tools/setup.sh: unknown list '$1'; choose build, test, ci or bench" >&2
    exit 2
    ;;
esac

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  say "set-up: this system has no apt-get, so nothing is installed"
  echo "What lissom needs, by the names of Debian 12: ${wanted[*]}"
  exit 0
fi

installed=$(dpkg-query -W -f '${db:Status-Abbrev} ${Package}\n' | awk '$1 == "ii" { print $2 }')
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package" <<<"$installed" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  say "set-up: all ${#wanted[@]} packages are installed"
  exit 0
fi
say "set-up: installing ${#missing[@]} of ${#wanted[@]} packages: ${missing[*]}"

become=()
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    become=(sudo -n)
  else
    echo "tools/setup.sh: installing packages needs root, and sudo is absent or would ask for a password. Run once:" >&2
    echo "  sudo apt-get update && sudo apt-get install -y --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" \
    </dev/null >>"$log" 2>&1 && return
  tail -n 30 "$log" >&2
  echo "tools/setup.sh: 'apt-get $*' failed; its last lines stand above" >&2
  exit 1
}
apt update
apt install -y --no-install-recommends "${missing[@]}"
say "set-up: done"
