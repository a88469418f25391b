#!/usr/bin/env bash
# The core keeps nothing between calls: its objects have no variable that can be written, be it at
# namespace scope or a static within a function, inline ones that no source calls among them.
# Constant tables are allowed: those whose addresses the loader fills in, and those that are
# declared constexpr, of which g++ 12 takes some that hold addresses for data that can be written.
set -eu
. "$(dirname "$0")/../support/core.sh"
command -v objdump >/dev/null || skip "no objdump"

compiler="$CXX -std=c++20 -w -I$root -O0 -fno-exceptions -fno-rtti"
! $CXX --version | grep -q 'Free Software' || compiler="$compiler -fkeep-inline-functions"
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
precompile "$compiler"
every_header >"$scratch/headers.cpp"
for source in "$scratch/headers.cpp" $(rooms_in_one "$scratch"); do
  $compiler $precompiled -c "$source" -o "$scratch/object.o" ||
    { fail "$source does not compile"; continue; }
  for symbol in $(writable "$scratch/object.o" | tr ' ' '_' | sort -u); do
    is_constexpr "$symbol" ||
      fail "$(basename "$source" .cpp): $symbol can be written; a frame keeps nothing for the next"
  done
done

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
$compiler -c "$scratch/control.cpp" -o "$scratch/object.o"
found=$(writable "$scratch/object.o" | sort | tr '\n' ' ')
[ "$found" = "at_namespace_scope in_a_function()::kept unnamed " ] ||
  fail "the control gives '$found'"
verdict "nothing of $(echo $headers $sources | wc -w) files can be written between calls"
