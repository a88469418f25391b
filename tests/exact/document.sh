#!/usr/bin/env bash
# Writes tests/EXACT.md from what the targets have left; tools/exact --all calls it.
#   document.sh FOLDER COMMIT
# FOLDER has rows and the targets' folders, and, if they were run, rooms and faults.md.
set -eu
work=$(realpath "$1") commit=$2
. "$(dirname "$0")/../support/core.sh"

drawn=$scratch/rows missing=""
: >"$drawn"
while read -r name; do
  row=$(awk -F'|' -v name="$name" '$2 == name' "$work/rows")
  folder=${row##*|}
  if grep -q '^drawn' "$folder/status" 2>/dev/null; then
    echo "$row" >>"$drawn"
  else
    missing="$missing${missing:+; }$name ($(cat "$folder/status" 2>/dev/null || echo not run))"
  fi
done < <(grep -v '^#' tests/exact/targets.txt | sed -E 's/ *\|.*//')
[ -s "$drawn" ] || { echo "document.sh: nothing was drawn" >&2; exit 1; }
date=$(date -u -r "$(tail -1 "$drawn" | cut -d'|' -f4)/status" +%Y-%m-%d)
versions=$(for c in $(cut -d'|' -f3 "$drawn" | cut -d' ' -f1 | sort -u); do
  "$c" --version 2>/dev/null | head -1
done | sed 's/^/- /')

head=$(cat <<END_OF_HEAD
# The same bits everywhere

Written by \`tools/exact --all\`, on $date at commit $commit; do not edit it. One program
([draw.cpp](exact/draw.cpp)) of the core rooms alone draws figures 1 to 8 and a scene of each
method, and prints a hash of every buffer. A mark stands for a case, which has one to six buffers:
\`=\` all of them are those of [hashes.txt](exact/hashes.txt), \`X\` one is not, \`.\` the case was
not drawn (a processor without a multiplier is given the figures 1 to 6 alone). Before a frame each
target's memory holds another byte, so that no hash depends on it. Seconds are of processor time;
those to run are of the emulator where there is one.

$(wc -l <"$drawn") targets of $(grep -vc '^#' tests/exact/targets.txt) have drawn; there are
$(cut -d' ' -f1 tests/exact/hashes.txt | uniq | wc -l) cases with $(wc -l \
    <tests/exact/hashes.txt) buffers.
${missing:+Not drawn: $missing.}
END_OF_HEAD
)
{
  awk -v hashes=tests/exact/hashes.txt -v form=markdown -v head="$head"$'\n' \
    -f tests/exact/report.awk "$drawn" || true
  cat <<'TEXT'

The program holds the words of all its scenes. RAM is what a frame of the largest case takes
together with the program's variables and the deepest stack. The data of a bare program are
constant tables that hold addresses, which g++ 12 takes for data that can be written (the guard
`objects` looks at them). Instructions are counted by QEMU with `-icount`, on the Cortex-M3 in
steps of 40.
TEXT
  if [ -s "$work/rooms" ]; then
    printf '\n## Room tests\n\nThe tests of `fixed` and `hw`, but for those of traps.\n\n'
    printf '| target | room | tests passed | seconds | |\n|---|---|---|---|---|\n'
    sed 's/|/ | /g; s/^/| /; s/$/ |/; s/  */ /g' "$work/rooms"
  fi
  if [ -s "$work/faults.md" ]; then
    printf '\n## Planted faults\n\n'
    cat <<'TEXT'
`tools/exact --faults` plants each into a copy of the core ([faults](exact/faults)).

TEXT
    cat "$work/faults.md"
    untried=""
    for program in tests/exact/faults/*.sed; do
      name=$(sed -n 's/^# fault: //p' "$program")
      grep -qF "| $name |" "$work/faults.md" || untried="$untried${untried:+; }$name"
    done
    [ -z "$untried" ] || printf '\nNot planted in this run: %s.\n' "$untried"
  fi
  printf '\n## Compilers\n\n%s\n' "$versions"
} >tests/EXACT.md
echo "tests/EXACT.md: $(wc -l <"$drawn") targets"
