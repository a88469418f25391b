# Sourced by tests/guards/*.sh: where the core is, and what becomes of a finding.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
rooms="fixed hw raster shadow"
headers=$(find $rooms -name '*.hpp' | sort)
sources=$(find $rooms -name '*.cpp' | sort)
standard_headers=$(cat $headers $sources | sed -n 's/^#include \(<.*>\).*/\1/p' | sort -u)
CXX=${CXX:-g++}
scratch=$(mktemp -d "${TMPDIR:-/tmp}/umbra78-guard.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
failures=0

# fail WHAT: prints it and remembers that the guard has failed.
fail() {
  echo "guard: $1"
  failures=$((failures + 1))
}
# skip WHY: ends the guard without a verdict.
skip() {
  echo "left out: $1"
  exit 0
}
verdict() {
  [ "$failures" -eq 0 ] || exit 1
  echo "held: $1"
}

# A file without its comments and without what is in quotes, line for line.
plain_text() { sed -e 's://.*::' -e 's:"[^"]*"::g' "$1"; }
