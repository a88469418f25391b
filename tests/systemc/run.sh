#!/usr/bin/env bash
# Asks SystemC (package libsystemc-dev) for its tables of rounding and overflow and compares them
# with tables.txt, which tests/fixed/systemc_test.cpp computes without it. A planted error of
# half_away has to show.   tests/systemc/run.sh --write  writes tables.txt.
set -eu -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export SYSTEMC_DISABLE_COPYRIGHT_MESSAGE=1
compiler=${CXX:-g++}
if ! echo '#include <systemc.h>' | "$compiler" -std=c++17 -E -x c++ - >/dev/null 2>&1; then
  echo "left out: SystemC's own tables (apt-get install libsystemc-dev)"
  exit 0
fi
"$compiler" -std=c++17 -O2 -DSC_INCLUDE_FX "$here/tables.cpp" -lsystemc -o "$scratch/tables"
"$scratch/tables" >"$scratch/found"
if [ "${1:-}" = --write ]; then
  cp "$scratch/found" "$here/tables.txt"
  exit 0
fi
if ! diff "$here/tables.txt" "$scratch/found"; then
  echo "SystemC's tables differ from tests/systemc/tables.txt (< the file, > SystemC)"
  exit 1
fi
"$scratch/tables" --half-away=half_up >"$scratch/faulty"
diff "$here/tables.txt" "$scratch/faulty" | grep '^>' >"$scratch/wrong" || true
wrong=$(wc -l <"$scratch/wrong")
if [ "$wrong" -eq 0 ] || grep -v half_away "$scratch/wrong"; then
  echo "a wrong half_away is not found where it is"
  exit 1
fi
echo "held: SystemC's $(wc -l <"$here/tables.txt") tables; a wrong half_away differs in $wrong"
