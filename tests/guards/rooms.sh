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
  local folder=$1 file line included room
  for file in $(find "$folder" -maxdepth 1 \( -name '*.hpp' -o -name '*.cpp' \) | sort); do
    while IFS= read -r line; do
      included=${line#*\"}
      included=${included%%\"*}
      room=$(dirname "$included")
      [[ " ${may[$folder]} " == *" $room "* ]] ||
        fail "$file:${line%%:*}: $folder/ must not include $included"
    done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$file")
  done
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
for file in $headers $sources; do
  while IFS= read -r line; do
    included=${line#*<}
    included=${included%%>*}
    # The compiler's own names of a processor's lanes: no library comes with them.
    [ "$file $included" = "shadow/row_forms.cpp immintrin.h" ] && continue
    [[ " ${allowed_standard//$'\n'/ } " == *" $included "* ]] ||
      fail "$file:${line%%:*}: the core must not include <$included>"
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*<' "$file")
  # `new (place)` only names where an object stands.
  plain_text "$file" | sed -E 's/#include.*//; s/\bnew \(//g' >"$scratch/text"
  while IFS= read -r line; do
    fail "$file:${line%%:*}: not in the core: ${line#*:}"
  done < <(grep -nE "$forbidden" "$scratch/text")
done

# Tests mirror the rooms, but for those that belong to no single one.
for folder in $(find tests -mindepth 2 -name '*.?pp' -printf '%h\n' | sort -u); do
  case $folder in tests/claims | tests/fuzz | tests/guards | tests/support) continue ;; esac
  case $folder in tests/installed | tests/systemc | tests/fuzz/core) continue ;; esac
  case $folder in tests/exact | tests/proofs) continue ;; esac
  [ -n "${may[${folder#tests/}]:-}" ] || fail "$folder/ tests no room of CMakeLists.txt"
done

# Tests of a room of the core see the core, tests/ and nothing of tools/.
for room in $rooms; do
  for file in $(find "tests/$room" -name '*.?pp'); do
    grep -nE '#include "tools/' "$file" && fail "$file: tests of the core must not need tools/"
  done
done

# Source files, scripts without an ending among them; not the data.
sources_in() {
  find "$@" -type f \( -name '*.?pp' -o -name '*.[ch]' -o -name '*.in' -o -name '*.sh' \
    -o -name '*.py' -o -name '*.gp' -o -name '*.js' -o -name '*.css' -o -name '*.html' \
    -o ! -name '*.*' \) | sort
}
short() {
  local limit=$1 file
  shift
  for file in "$@"; do
    [ "$(wc -l <"$file")" -le "$limit" ] || fail "$file has more than $limit lines"
    awk -v f="$file" 'length($0) > 100 {print f ":" FNR ": longer than 100 columns"; bad = 1}
                      END {exit bad}' "$file" || fail "$file has long lines"
  done
}
short 350 $(sources_in $rooms tools .ci)
short 450 $(sources_in tests)
verdict "rooms, includes, heap, exceptions, floating point, tests, length"
