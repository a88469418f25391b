#!/usr/bin/env bash
# The core compiles where a float has no register to live in: -mgeneral-regs-only on x86-64.
set -eu
. "$(dirname "$0")/../support/core.sh"
[ "$(uname -m)" = x86_64 ] || skip "-mgeneral-regs-only is tried on x86-64 only"

for source in $sources; do
  "$CXX" -std=c++20 -I"$root" -O2 -fno-exceptions -fno-rtti -mgeneral-regs-only -c "$source" \
    -o "$scratch/object.o" || fail "$source needs more than general registers"
done
echo 'int control(double d) { return static_cast<int>(d + 0.5); }' >"$scratch/control.cpp"
"$CXX" -O2 -mgeneral-regs-only -c "$scratch/control.cpp" -o "$scratch/object.o" \
  2>"$scratch/log" && fail "a double compiles all the same"
verdict "general registers suffice for $(echo $sources | wc -w) sources"
