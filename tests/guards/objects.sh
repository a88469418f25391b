#!/usr/bin/env bash
# What the core's objects promise, without optimisation, so that nothing is compiled away.
#   - They compile where a float has no register to live in: -mgeneral-regs-only, on x86-64.
#   - They keep nothing between calls: no variable can be written, be it at namespace scope or a
#     static within a function, inline ones that no source calls among them. Constant tables are
#     allowed: those whose addresses the loader fills in, and those that are declared constexpr, of
#     which g++ 12 takes some that hold addresses for data that can be written.
#   - They call for no heap, no exceptions, no I/O and none of C's mathematics. (That a processor
#     without floats calls for no helper in their place, tools/exact sees in what it links.)
set -eu
. "$(dirname "$0")/../support/core.sh"
command -v objdump >/dev/null || skip "no objdump"

compiler="$CXX -std=c++20 -w -I$root -O0 -fno-exceptions -fno-rtti -fno-threadsafe-statics"
general=""
[ "$(uname -m)" != x86_64 ] || general="-mgeneral-regs-only"
kept="" # what an inline function keeps is seen where the headers are
! $CXX --version | grep -q 'Free Software' || kept="-fkeep-inline-functions"
# OBJECT: the core's symbols in sections that can be written.
writable() {
  objdump -t "$1" | awk '$0 ~ /^[0-9a-f]+ .* [^ ]+\t[0-9a-f]+/ {
    section = $0
    sub(/\t.*/, "", section)
    sub(/.* /, "", section)
    if (section ~ /^[.](data|bss|tdata|tbss)|COM/ && section !~ /^[.]data[.]rel[.]ro/ &&
        $NF !~ /^[.]/) print $NF
  }' | c++filt | grep -vE '^(std::|guard variable for std::|DW[.]ref)' || true
}
# NAME: whether it is a constexpr of a namespace of the core.
is_constexpr() {
  local name=${1//(anonymous_namespace)::/}
  [[ $name != *')::'* ]] &&
    grep -qhE "^(inline )?constexpr [^(]*\\b${name##*::}(\\{| =|\\[)" $headers $sources
}
# OBJECT: what it calls for that is not there.
absent='malloc|calloc|realloc|_Znw|_Zna|_Zdl|_Zda'                         # the heap
absent="$absent|__cxa_(throw|allocate|begin_catch|guard)|__gxx_personality" # exceptions
absent="$absent|printf|fopen|^(puts|sqrt|sin|cos|pow|floor)f?$"
called() { nm -u "$1" | awk '{print $NF}' | grep -E "$absent" | tr '\n' ' ' || true; }
# check SOURCE OPTIONS
check() {
  $compiler $2 -c "$1" -o "$scratch/object.o" ||
    { fail "$1 does not compile, or needs more than general registers"; return; }
  local found=""
  [ "$2" = "$kept" ] || found=$(called "$scratch/object.o") # standard headers call for the heap
  [ -z "$found" ] || fail "$(basename "$1" .cpp) calls for $found"
  for symbol in $(writable "$scratch/object.o" | tr ' ' '_' | sort -u); do
    is_constexpr "$symbol" ||
      fail "$(basename "$1" .cpp): $symbol can be written; a frame keeps nothing for the next"
  done
}
every_header >"$scratch/headers.cpp"
check "$scratch/headers.cpp" "$kept"
precompile "$compiler $general"
for source in $(rooms_in_one "$scratch"); do check "$source" "$general $precompiled"; done

# And each kind is found, and a constant is not.
cat >"$scratch/control.cpp" <<'CONTROL'
int at_namespace_scope = 1;
static int* unnamed[2];
inline int in_a_function() { static int kept; return ++kept; }
constexpr int table[2] = {1, 2};
extern const int* const addresses[2];
const int* const addresses[2] = {table, table + 1};
int use() { return in_a_function() + *unnamed[0] + *addresses[1] + at_namespace_scope; }
CONTROL
$compiler $kept -c "$scratch/control.cpp" -o "$scratch/object.o"
found=$(writable "$scratch/object.o" | sort | tr '\n' ' ')
[ "$found" = "at_namespace_scope in_a_function()::kept unnamed " ] ||
  fail "the control gives '$found'"
echo 'int* control() { return new int; }' >"$scratch/control.cpp"
$compiler -c "$scratch/control.cpp" -o "$scratch/object.o"
[ -n "$(called "$scratch/object.o")" ] || fail "the heap is not found"
echo 'int control(double d) { return static_cast<int>(d + 0.5); }' >"$scratch/control.cpp"
[ -z "$general" ] ||
  ! $compiler $general -c "$scratch/control.cpp" -o "$scratch/object.o" 2>"$scratch/log" ||
  fail "a double compiles without its registers all the same"
[ -n "$general" ] || echo "left out: -mgeneral-regs-only, which is tried on x86-64 only"
verdict "nothing is kept and ${general:-no flag} suffices for $(echo $sources | wc -w) sources"
