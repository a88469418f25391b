#!/usr/bin/env bash
# Rooms include only those before them, and the core only headers that bring no heap, no I/O, no
# clock and no floating point. Nothing allocates, throws or computes in floating point. Files and
# lines stay short.
set -eu
. "$(dirname "$0")/../support/core.sh"

allowed_standard="algorithm array bit compare concepts cstddef cstdint limits new span
string_view type_traits"

forbidden='\b(float|double|new|delete|malloc|calloc|realloc|free|throw|try|catch|typeid)\b'
forbidden="$forbidden|\bdynamic_cast\b|\bthread_local\b|std::(vector|string|map|set|function)\b"
forbidden="$forbidden|std::(unique_ptr|shared_ptr|stable_sort|inplace_merge)\b"

check_room() {
  local room=$1 before=$2 file line included first
  for file in $(find "$room" -name '*.hpp' -o -name '*.cpp' | sort); do
    while IFS= read -r line; do
      included=${line#*:*[\"<]}
      included=${included%%[\">]*}
      first=${included%%/*}
      case $line in
        *\<*) [[ " ${allowed_standard//$'\n'/ } " == *" $included "* ]] ;;
        *) [[ " $before " == *" $first "* ]] ;;
      esac || fail "$file:${line%%:*}: $room/ must not include $included"
    done < <(grep -nE '^[[:space:]]*#[[:space:]]*include' "$file")
    # `new (place)` only names where an object stands.
    plain_text "$file" | sed -E 's/#include.*//; s/\bnew \(//g' >"$scratch/text"
    while IFS= read -r line; do
      fail "$file:${line%%:*}: not in the core: ${line#*:}"
    done < <(grep -nE "$forbidden" "$scratch/text")
  done
}
check_room fixed "fixed"
check_room hw "fixed hw"
check_room raster "fixed hw raster"
check_room shadow "fixed hw raster shadow"

# Tests of a room see the rooms it may see, tests/ and nothing of tools/.
for room in $rooms; do
  for file in $(find "tests/$room" -name '*.?pp'); do
    grep -nE '#include "tools/' "$file" && fail "$file: tests of the core must not need tools/"
  done
done

short() {
  local limit=$1 file
  shift
  for file in $(find "$@" -type f \( -name '*.hpp' -o -name '*.cpp' -o -name '*.sh' \) | sort); do
    [ "$(wc -l <"$file")" -le "$limit" ] || fail "$file has more than $limit lines"
    awk -v f="$file" 'length($0) > 100 {print f ":" FNR ": longer than 100 columns"; bad = 1}
                      END {exit bad}' "$file" || fail "$file has long lines"
  done
}
short 350 $rooms tools
short 450 tests
verdict "rooms, includes, heap, exceptions, floating point, length"
