#!/usr/bin/env bash
# Rooms include only those before them, and the core only headers that bring no heap, no I/O, no
# clock and no floating point. Nothing in it allocates, throws or computes in floating point. Each
# room says what it is, each folder of tests has its room, and files and lines stay short.
set -eu
. "$(dirname "$0")/../support/core.sh"

allowed_standard="algorithm array bit compare concepts cstddef cstdint limits new optional span
string_view type_traits"

forbidden='\b(float|double|new|delete|malloc|calloc|realloc|free|throw|try|catch|typeid)\b'
forbidden="$forbidden|\bdynamic_cast\b|\bthread_local\b|std::(vector|string|map|set|function)\b"
forbidden="$forbidden|std::(unique_ptr|shared_ptr|stable_sort|inplace_merge)\b"

# The rooms as CMakeLists.txt declares them: a line each, the folder and then the rooms it names.
grep -v '^ *#' CMakeLists.txt | tr '\n' ' ' | grep -oE 'umbra78_room\([^)]*"[^)]*\)' |
  sed -E 's/umbra78_room\(//; s/"[^"]*"//; s/\)//; s/ +/ /g' >"$scratch/declared"
[ "$(wc -l <"$scratch/declared")" -ge 20 ] || fail "CMakeLists.txt declares too few rooms"
grep -oE '^ *umbra78_room\([^ )]+( "[^"]*)?' CMakeLists.txt | grep -vE '"[^"]{20,}' |
  grep . && fail "CMakeLists.txt: these rooms have no line that says what they are"

# For each room all rooms that it may include: itself, those it names, and theirs. A room is
# declared after those it names, so no arrow runs back.
declare -A may
while read -r room named; do
  may[$room]="$room"
  for other in $named; do
    if [ -z "${may[$other]:-}" ]; then
      fail "CMakeLists.txt: $room names $other, which is not declared before it"
    else
      may[$room]="${may[$room]} ${may[$other]}"
    fi
  done
done <"$scratch/declared"

# Every folder with sources is a room, and its files include only what the room may.
check_room() {
  local folder=$1 file line included
  while IFS= read -r line; do
    file=${line%%:*}
    included=${line#*\"}
    included=${included%%\"*}
    [[ " ${may[$folder]} " == *" ${included%/*} "* ]] ||
      fail "${line%%:*#*}: $folder/ must not include $included"
  done < <(find "$folder" -maxdepth 1 \( -name '*.hpp' -o -name '*.cpp' \) -print0 | sort -z |
    xargs -0 grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"')
}
for folder in $(find $rooms tools -name '*.?pp' -printf '%h\n' | sort -u); do
  case $folder in tools/benchmarks) continue ;; esac
  if [ -z "${may[$folder]:-}" ]; then
    fail "$folder/ is no room of CMakeLists.txt"
  else
    check_room "$folder"
  fi
done

# The core includes only harmless standard headers and names nothing of the heap.
while IFS= read -r line; do
  file=${line%%:*}
  included=${line#*<}
  included=${included%%>*}
  # The compiler's own names of a processor's lanes: no library comes with them.
  [ "$file $included" = "shadow/row_forms.cpp immintrin.h" ] && continue
  [[ " ${allowed_standard//$'\n'/ } " == *" $included "* ]] ||
    fail "${line%%:#*}: the core must not include <$included>"
done < <(grep -nHE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' $headers $sources)
# `new (place)` only names where an object stands.
while IFS= read -r line; do
  fail "not in the core: $line"
done < <(awk '{
    sub(/\/\/.*/, ""); gsub(/"[^"]*"/, ""); sub(/#include.*/, "")
    gsub(/(^|[^A-Za-z0-9_])new \(/, " (")
    print FILENAME ":" FNR ":" $0}' $headers $sources | grep -E "^[^:]*:[0-9]*:.*($forbidden)")

# Tests mirror the rooms, but for those that belong to no single one.
for folder in $(find tests -mindepth 2 -name '*.?pp' -printf '%h\n' | sort -u); do
  case $folder in tests/claims | tests/fuzz | tests/guards | tests/support) continue ;; esac
  case $folder in tests/installed | tests/systemc | tests/fuzz/core) continue ;; esac
  case $folder in tests/exact | tests/proofs) continue ;; esac
  [ -n "${may[${folder#tests/}]:-}" ] || fail "$folder/ tests no room of CMakeLists.txt"
done

# Tests of a room of the core see the core, tests/ and nothing of tools/.
find $(printf 'tests/%s ' $rooms) -name '*.?pp' -print0 | xargs -0 grep -nH '#include "tools/' &&
  fail "tests of the core must not need tools/"

# Source files, scripts without an ending among them; not the data.
sources_in() {
  find "$@" -type f \( -name '*.?pp' -o -name '*.[ch]' -o -name '*.in' -o -name '*.sh' \
    -o -name '*.py' -o -name '*.gp' -o -name '*.js' -o -name '*.css' -o -name '*.html' \
    -o ! -name '*.*' \) | sort
}
short() {
  awk -v limit="$1" '
    FNR == limit + 1 {print FILENAME ": has more than " limit " lines"; bad = 1}
    length($0) > 100 {print FILENAME ":" FNR ": longer than 100 columns"; bad = 1}
    END {exit bad}' "${@:2}" || fail "files or lines are too long"
}
short 350 $(sources_in $rooms tools .ci)
short 450 $(sources_in tests)
verdict "rooms, includes, heap, exceptions, floating point, tests, length"
