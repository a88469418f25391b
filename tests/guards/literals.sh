#!/usr/bin/env bash
# No number of the core is written with a point or an exponent: a floating-point literal needs no
# name that could be poisoned (auto x = 0.5 * i), and in an inline function that nobody calls no
# compiler says a word about it. The text is read as the compiler reads numbers.
set -eu
. "$(dirname "$0")/../support/core.sh"

# FILE: "LINE: NUMBER" of each floating-point literal. Comments, strings and characters are left
# out. A number begins with a digit, or a point and a digit, not within a word; all that may follow
# belongs to it.
literals() {
  awk '
    {
      text = $0
      gsub(/\\["\\\x27]/, "", text)
      gsub(/"[^"]*"/, " ", text)
      gsub(/\x27[^\x27]\x27/, " ", text)
      out = ""
      while (text != "") {
        if (comment) {
          at = index(text, "*/")
          if (at == 0) break
          text = substr(text, at + 2)
          comment = 0
        }
        at = match(text, /\/[*\/]/)
        if (at == 0) { out = out text; break }
        out = out substr(text, 1, at - 1) " "
        if (substr(text, at, 2) == "//") break
        text = substr(text, at + 2)
        comment = 1
      }
      while (match(out, /[A-Za-z_][A-Za-z0-9_]*|[.]?[0-9]([eEpP][-+]|[A-Za-z0-9_.\x27])*/)) {
        token = substr(out, RSTART, RLENGTH)
        out = substr(out, RSTART + RLENGTH)
        if (token ~ /^[A-Za-z_]/) continue
        if (token ~ /[.]/ || token ~ /^0[xX].*[pP]/ || token ~ /^[0-9\x27]+[eE]/)
          print FNR ": " token
      }
    }' "$1"
}
all="$headers $sources $(find $rooms -name '*.h' | sort)"
for file in $all; do
  found=$(literals "$file" | head -3)
  [ -z "$found" ] || fail "$file:$found is a floating-point number; the core has integers alone"
done

# And it finds each way to write one, and nothing else.
cat >"$scratch/control.cpp" <<'CONTROL'
auto a = 0.5 * i;  // 1
auto b = .5f;      /* 2.5 */
auto c = 1e3;
auto d = 0x1p-3;   /* 4.5
   5.5 */ auto e = 5.;
auto f = 0x1e5 + x1.e5 + 1'000'000 + 'x' + 7u;  // "1.5"
auto g = "1.5";
CONTROL
found=$(literals "$scratch/control.cpp" | tr '\n' ' ')
[ "$found" = "1: 0.5 2: .5f 3: 1e3 4: 0x1p-3 5: 5. " ] ||
  fail "the control gives '$found'"
verdict "no floating-point literal in $(echo $all | wc -w) files"
