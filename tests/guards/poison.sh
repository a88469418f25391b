#!/usr/bin/env bash
# No token of the core names floating point, the heap, exceptions, containers or libm: the core's
# standard headers are read first, the names are poisoned, and then every header and source must
# still compile. The compiler reads tokens, so macros and generated code hide nothing.
set -eu
. "$(dirname "$0")/../support/core.sh"

words="float double malloc calloc realloc free throw try catch vector string deque unique_ptr
shared_ptr function stable_sort printf sqrt sin cos tan atan2 pow exp log lround"
poisoned() {
  for h in $standard_headers; do echo "#include $h"; done
  echo "#pragma GCC poison ${words//$'\n'/ }"
  for f in "$@"; do echo "#include \"$f\""; done
}
compile() { "$CXX" -std=c++20 -I"$root" -fsyntax-only "$1"; }

poisoned $headers >"$scratch/headers.cpp"
compile "$scratch/headers.cpp" || fail "a header of the core uses a poisoned name"
for source in $sources; do
  poisoned "$source" >"$scratch/source.cpp"
  compile "$scratch/source.cpp" || fail "$source uses a poisoned name"
done
# And the poison works.
poisoned $headers >"$scratch/control.cpp"
echo 'inline double control() { return 0; }' >>"$scratch/control.cpp"
compile "$scratch/control.cpp" 2>"$scratch/log" && fail "the poison does nothing"
verdict "no poisoned name in $(echo $headers $sources | wc -w) files"
