#!/usr/bin/env bash
# Plants the faults of faults/, one at a time, into copies of the core, and sees each caught by the
# target or guard that its file names. Called by tools/exact --faults.
#   faults.sh FOLDER
# FOLDER has scenes.cpp. Prints a Markdown table, which also goes to FOLDER/faults.md.
set -eu
work=$(realpath "$1")
. "$(dirname "$0")/../support/core.sh"
export UMBRA78_EXACT_LEAST=1

# Equal or not to hashes.txt; what is not drawn has no part in it.
judge() { # FOLDER: prints equal, differs (with what), or the status
  local status
  status=$(cat "$1/status")
  [ "$status" = drawn ] || { echo "$status"; return; }
  sed -n 's/^buffer //p' "$1/lines" >"$1/buffers"
  [ -s "$1/buffers" ] || { echo "failed: nothing was drawn"; return; }
  local differing
  differing=$(grep -vxF -f tests/exact/hashes.txt "$1/buffers" | awk '{print $2}' | head -3)
  [ -z "$differing" ] && echo equal || echo differs: $differing
}
copy() { # FOLDER: the core, and what draws and checks it
  rm -rf "$1"
  mkdir -p "$1/tests"
  cp -r $rooms "$1"
  cp -r tests/exact tests/guards tests/support "$1/tests"
}
try_target() { # COPY NAME CASES: prints what became of it
  bash "$1/tests/exact/run.sh" "$2" "$work/scenes.cpp" "$1/drawn" "$3" >&2
  judge "$1/drawn"
}
try_guard() { # COPY NAME: prints equal, caught or skipped
  local status=0
  bash "$1/tests/guards/$2.sh" >"$1/log" 2>&1 || status=$?
  case $status in
    0) echo equal ;;
    77) echo "skipped: $(sed -n 's/^left out: //p' "$1/log" | head -1)" ;;
    *) echo "caught" ;;
  esac
}
try() { # COPY "target NAME: CASES"|"guard NAME"
  local by=${2#* }
  case $2 in
    target*) try_target "$1" "${by%%: *}" "${by#*: }" ;;
    guard*) try_guard "$1" "$by" ;;
  esac
}

# "name file by program" of each: a sed program, whose first lines say the rest.
for program in "$root"/tests/exact/faults/*.sed; do
  printf '%s\t%s\t%s\t%s\n' "$(sed -n 's/^# fault: //p' "$program")" \
    "$(sed -n 's/^# in: //p' "$program")" "$(sed -n 's/^# by: //p' "$program")" "$program"
done >"$scratch/list"
one_fault() { # NUMBER NAME FILE BY PROGRAM: a row of the table into row-NUMBER
  local place=$scratch/$1 found
  copy "$place"
  sed -i -z -E -f "$5" "$place/$3"
  if cmp -s "$3" "$place/$3"; then
    found="it could not be planted"
  else
    found=$(try "$place" "$4")
  fi
  echo "| $2 | $3 | ${4#target } | $found |" >"$scratch/row-$1"
  rm -rf "$place"
}
# Without a fault nothing is caught, so a finding is the fault's.
no_fault() { # NUMBER BY
  local place=$scratch/$1 found
  copy "$place"
  found=$(try "$place" "$2")
  rm -rf "$place"
  case $found in
    equal | skipped*) ;;
    *) echo "$2 finds a fault where none is planted: $found" >"$scratch/false-$1" ;;
  esac
}
number=0
while IFS=$'\t' read -r name file by program; do
  number=$((number + 1))
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  one_fault $((100 + number)) "$name" "$file" "$by" "$program" </dev/null &
done <"$scratch/list"
sound=200
while IFS= read -r by; do
  sound=$((sound + 1))
  while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
  no_fault $sound "$by" </dev/null &
done < <(cut -f3 "$scratch/list" | sort -u)
wait
{
  printf 'Planted at commit %s.\n\n' "$(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
  echo "| planted | in | caught by | which says |"
  echo "|---|---|---|---|"
  cat "$scratch"/row-*
} | tee "$work/faults.md"
missed=$(grep -cE '\| (equal|it could not be planted) \|$' "$work/faults.md" || true)
for file in "$scratch"/false-*; do [ ! -e "$file" ] || fail "$(cat "$file")"; done
[ "$missed" -eq 0 ] || fail "$missed of $number faults are not caught"
verdict "$number planted faults are caught"
