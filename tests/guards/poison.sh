#!/usr/bin/env bash
# No token of the core names floating point, the heap, exceptions, containers or libm: the core's
# standard headers are read first, the names are poisoned, and then every header and source must
# still compile. The compiler reads tokens, so macros and generated code hide nothing.
set -eu
. "$(dirname "$0")/../support/core.sh"

words="float double malloc calloc realloc free throw try catch vector string deque unique_ptr
shared_ptr function stable_sort printf sqrt sin cos tan atan2 pow exp log lround"
compiler="$CXX -std=c++20 -I$root"
precompile "$compiler" $words
every_header >"$scratch/headers.cpp"
for source in "$scratch/headers.cpp" $(rooms_in_one "$scratch"); do
  $compiler $precompiled -fsyntax-only "$source" || fail "$source uses a poisoned name"
done
# And the poison works.
{
  every_header
  echo 'inline double control() { return 0; }'
} >"$scratch/control.cpp"
$compiler $precompiled -fsyntax-only "$scratch/control.cpp" 2>"$scratch/log" &&
  fail "the poison does nothing"
grep -q 'poisoned.*double' "$scratch/log" || fail "the control does not compile for another reason"
verdict "no poisoned name in $(echo $headers $sources | wc -w) files"
