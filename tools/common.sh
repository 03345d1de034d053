# Sourced by the scripts of this folder: where the repository is, how many jobs, one voice.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1

say() { printf '== %s\n' "$*"; }

# One job per core, but no more than memory carries: a template-heavy source takes up to 1.5 GB.
jobs() {
  local cores memory
  cores=$(nproc 2>/dev/null || getconf _NPROCESSORS_ONLN)
  memory=$(awk '/^MemAvailable:/ { n = int($2 / 1500000); print n < 1 ? 1 : n }' /proc/meminfo 2>/dev/null)
  if [ -n "$memory" ] && [ "$memory" -lt "$cores" ]; then echo "$memory"; else echo "$cores"; fi
}

# Our C++ sources, one per line; folders as arguments, all of them by default.
sources() {
  local folders=("$@")
  [ $# -gt 0 ] || folders=(lissom apps scenes tests bench bindings)
  for folder in "${folders[@]}"; do
    [ -d "$folder" ] && find "$folder" -name node_modules -prune -o -type f \( -name '*.h' -o -name '*.cpp' \) -print
  done | LC_ALL=C sort
}
