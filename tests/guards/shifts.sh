#!/usr/bin/env bash
# A right shift of a signed value rounds, so in the core it has one owner: fixed::floor_shift and
# what fixed/rounding.hpp makes of it. Every other >> of the core has an unsigned left operand. The
# compiler checks it, so it knows the types: a copy of the core is compiled in which each >> is an
# operator that is defined for unsigned values and deleted for signed ones.
set -eu
. "$(dirname "$0")/../support/core.sh"

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
rewrite() {
  sed -E '/guard: the one signed shift/! s/(^| )>>( |$)/\1>> guard::Count{} +\2/g' "$1"
}
for file in $headers $sources; do
  plain_text "$file" | grep -nE '>>=|[])A-Za-z0-9_]>>[A-Za-z0-9_]' &&
    fail "$file: >>= and >> without blanks are not checked; write v = v >> n"
  mkdir -p "$scratch/core/$(dirname "$file")"
  rewrite "$file" >"$scratch/core/$file"
done
[ "$(grep -ho 'guard: the one signed shift' $headers $sources | wc -l)" -eq 1 ] ||
  fail "one line of the core may shift a signed value"

compiler="$CXX -std=c++20 -I$scratch/core"
precompile "$compiler"
compile() {
  $compiler $precompiled -include "$scratch/shift.hpp" -fsyntax-only "$1" >"$scratch/log" 2>&1
}
for h in $headers; do echo "#include \"$h\""; done >"$scratch/core/headers.cpp"
for source in "$scratch/core/headers.cpp" $(rooms_in_one "$scratch"); do
  compile "$source" && continue
  grep -E 'error|required from' "$scratch/log" | sed "s:$scratch/core/::" | head -20
  fail "$source shifts a signed value by >>; use fixed::floor_shift"
done

# And it finds one, in plain code and in a template, and lets an unsigned one pass.
control() {
  echo "$1" >"$scratch/control.txt"
  rewrite "$scratch/control.txt" >"$scratch/control.cpp"
  compile "$scratch/control.cpp"
}
control 'int f(int v) { return v >> 1; }' && fail "a signed shift compiles"
control 'template <class T> T f(T v) { return T((v + 1) >> 2); } long g(long v) { return f(v); }' &&
  fail "a signed shift in a template compiles"
control 'unsigned f(unsigned v, int n) { return (v >> n - 1 & 3) + (v >> n + 1); }' ||
  fail "an unsigned shift does not compile"
verdict "no bare shift of a signed value in $(echo $headers $sources | wc -w) files"
