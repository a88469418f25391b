#!/usr/bin/env bash
# The faults that tests/mutation/run and tools/exact --faults plant still have their places: a fault
# whose line has changed finds nothing. Planting them takes hours, so that is done on demand.
set -eu
. "$(dirname "$0")/../support/core.sh"
command -v python3 >/dev/null || skip "no python3"

python3 -B tests/mutation/run --check || fail "tests/mutation/faults.txt names what is not there"
planted=0
for program in tests/exact/faults/*.sed; do
  file=$(sed -n 's/^# in: //p' "$program")
  sed -z -E -f "$program" "$file" >"$scratch/planted"
  ! cmp -s "$file" "$scratch/planted" || fail "$program changes nothing in $file"
  planted=$((planted + 1))
done
[ "$planted" -ge 14 ] || fail "only $planted faults of portability"
verdict "the places of $(grep -c '^- ' tests/mutation/faults.txt) faults, $planted of portability"
