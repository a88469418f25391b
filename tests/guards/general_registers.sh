#!/usr/bin/env bash
# The core compiles where a float has no register to live in: -mgeneral-regs-only on x86-64. Without
# optimisation, so that nothing is compiled away.
set -eu
. "$(dirname "$0")/../support/core.sh"
[ "$(uname -m)" = x86_64 ] || skip "-mgeneral-regs-only is tried on x86-64 only"

compiler="$CXX -std=c++20 -I$root -O0 -fno-exceptions -fno-rtti -mgeneral-regs-only"
precompile "$compiler"
for source in $(rooms_in_one "$scratch"); do
  $compiler $precompiled -c "$source" -o "$scratch/object.o" ||
    fail "$source needs more than general registers"
done
echo 'int control(double d) { return static_cast<int>(d + 0.5); }' >"$scratch/control.cpp"
$compiler -c "$scratch/control.cpp" -o "$scratch/object.o" 2>"$scratch/log" &&
  fail "a double compiles all the same"
verdict "general registers suffice for $(echo $sources | wc -w) sources"
