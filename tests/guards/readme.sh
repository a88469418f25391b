#!/usr/bin/env bash
# The README's map lists every room of CMakeLists.txt, in its order and with its words, and only
# folders that exist. The README's library example is tests/guards/example.cpp.
set -eu
. "$(dirname "$0")/../support/core.sh"

# Each as lines "folder: meaning".
grep -v '^ *#' CMakeLists.txt | tr '\n' ' ' | grep -oE 'umbra78_room\([a-z0-9_/]+ *"[^"]*"' |
  sed -E 's/umbra78_room\(([^ ]+) +"([^"]*)"/\1: \2/; s/  +/ /g' >"$scratch/declared"
[ "$(wc -l <"$scratch/declared")" -ge 20 ] || fail "CMakeLists.txt declares too few rooms"
sed -nE 's/^ *- \[[^]]*\/\]\(([^)]*)\): (.*)$/\1: \2/p' README.md | sed -E 's/\. (See|Here) .*$//' \
  >"$scratch/listed"
cut -d: -f1 "$scratch/declared" >"$scratch/rooms"
grep -F -x -f "$scratch/declared" "$scratch/listed" >"$scratch/equal" || true
if ! diff "$scratch/declared" "$scratch/equal" >"$scratch/differ"; then
  cat "$scratch/differ"
  fail "README.md's map is not that of CMakeLists.txt (<: CMakeLists.txt, >: README.md)"
fi
while read -r folder; do
  [ -d "$folder" ] || fail "README.md lists $folder/, which is not there"
done < <(cut -d: -f1 "$scratch/listed")
# A folder below another is indented below it.
awk 'match($0, /^ *- \[[^]]*\/\]\([^)]*\): /) {
       indent = match($0, /-/) - 1
       path = $0; sub(/^[^(]*\(/, "", path); sub(/\).*/, "", path)
       depth = gsub(/\//, "/", path)
       if (indent != 2 * depth) {print "README.md:" FNR ": indented by " indent; bad = 1}
     }
     END {exit bad}' README.md || fail "README.md's map is not indented as its folders lie"

sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d' >"$scratch/copy"
sed -n '/^#include/,$p' tests/guards/example.cpp >"$scratch/example"
[ -s "$scratch/copy" ] || fail "README.md has no C++ example"
diff "$scratch/example" "$scratch/copy" ||
  fail "README.md's example is not tests/guards/example.cpp (<)"
verdict "the README's map is that of CMakeLists.txt, and its example is compiled and run"
