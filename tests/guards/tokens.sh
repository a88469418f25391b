#!/usr/bin/env bash
# Two promises of the core's text, checked by the compiler, which reads tokens and knows types, so
# that macros and generated code hide nothing. Both are checked in one compilation.
#   - No token names floating point, the heap, exceptions, containers or libm: the core's standard
#     headers are read first, then the names are poisoned.
#   - A right shift of a signed value rounds, so in the core it has one owner: fixed::floor_shift
#     and what fixed/rounding.hpp makes of it. Every other >> has an unsigned left operand: a copy
#     of the core is compiled in which each >> is an operator that is defined for unsigned values
#     and deleted for signed ones.
set -eu
. "$(dirname "$0")/../support/core.sh"
# It is the text that is read, so one compiler is enough; clang++ finds poisoned names in its own
# pragmas and in the header of the lanes.
case $("$CXX" --version) in
  *clang*) CXX=g++ && command -v g++ >/dev/null || skip "no g++, which reads the core's tokens" ;;
esac

cat >"$scratch/shift.hpp" <<'END'
#include <concepts>
namespace guard {
// a >> n  is rewritten as  a >> guard::Count{} + n, which + and - of n leave whole.
struct Count {
    int n = 0;
    constexpr operator int() const { return n; }
    friend constexpr Count operator+(Count c, std::integral auto n) {
        return {c.n + static_cast<int>(n)};
    }
    friend constexpr Count operator-(Count c, std::integral auto n) {
        return {c.n - static_cast<int>(n)};
    }
    friend constexpr auto operator>>(std::unsigned_integral auto v, Count c) { return v >> c.n; }
    friend void operator>>(std::signed_integral auto, Count) = delete;
};
}  // namespace guard
END

# Operators have a blank or a line's end on each side; the second > of a template has none.
rewrite='/guard: the one signed shift/! s/(^| )>>( |$)/\1>> guard::Count{} +\2/g'
awk '{
    sub(/\/\/.*/, ""); gsub(/"[^"]*"/, "")
    if (/>>=|[\])A-Za-z0-9_]>>[A-Za-z0-9_]/) { print FILENAME ":" FNR ":" $0; bad = 1 }}
  END {exit bad}' $headers $sources ||
  fail ">>= and >> without blanks are not checked; write v = v >> n"
mkdir "$scratch/core"
cp --parents $headers $sources $(find $rooms -name '*.h') "$scratch/core" # .h for C: no shifts
(cd "$scratch/core" && sed -i -E "$rewrite" $headers $sources)
[ "$(grep -ho 'guard: the one signed shift' $headers $sources | wc -l)" -eq 1 ] ||
  fail "one line of the core may shift a signed value"

words="float double malloc calloc realloc free throw try catch vector string deque unique_ptr
shared_ptr function stable_sort printf sqrt sin cos tan atan2 pow exp log lround"
compiler="$CXX -std=c++20 -I$scratch/core"
precompile "$compiler" $words
compile() {
  $compiler $precompiled -include "$scratch/shift.hpp" -fsyntax-only "$1" >"$scratch/log" 2>&1
}
every_header >"$scratch/core/headers.cpp"
for source in "$scratch/core/headers.cpp" $(rooms_in_one "$scratch"); do
  compile "$source" && continue
  grep -E 'error|required from' "$scratch/log" | sed "s:$scratch/core/::" | head -20
  fail "$source uses a poisoned name, or shifts a signed value by >>: use fixed::floor_shift"
done

# And it finds one of each, in plain code and in a template, and lets an unsigned shift pass.
control() {
  echo "$1" >"$scratch/control.txt"
  sed -E "$rewrite" "$scratch/control.txt" >"$scratch/control.cpp"
  compile "$scratch/control.cpp"
}
control 'inline double f() { return 0; }' && fail "the poison does nothing"
grep -q 'poisoned.*double' "$scratch/log" || fail "the control does not compile for another reason"
control 'int f(int v) { return v >> 1; }' && fail "a signed shift compiles"
control 'template <class T> T f(T v) { return T((v + 1) >> 2); } long g(long v) { return f(v); }' &&
  fail "a signed shift in a template compiles"
control 'unsigned f(unsigned v, int n) { return (v >> n - 1 & 3) + (v >> n + 1); }' ||
  fail "an unsigned shift does not compile"
verdict "no poisoned name and no bare signed shift in $(echo $headers $sources | wc -w) files"
