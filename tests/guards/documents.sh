#!/usr/bin/env bash
# Documents lead somewhere: each relative link in a *.md is a file or folder of the repository, and
# each #anchor a heading of the document that it names. And the lines of code that RIVALS.md tells
# of each rival are those of its files, within a tenth.
set -eu
. "$(dirname "$0")/../support/core.sh"

# The anchors of a document's headings, as GitHub makes them: lower case, blanks to hyphens, other
# punctuation left out.
anchors() {
  awk '/^```/ {code = !code} !code && /^#+ / {sub(/^#+ +/, ""); print}' "$1" |
    sed -E 's/\[([^]]*)\]\([^)]*\)/\1/g; s/`//g' | tr '[:upper:]' '[:lower:]' |
    sed -E 's/[^[:alnum:] _-]//g; s/ /-/g'
}

# The targets of [text](target) and of images, code left out, each with its line: "LINE TARGET".
links() {
  awk '/^```/ {code = !code}
       !code && !/^    / {
         gsub(/`[^`]*`/, "")
         while (match($0, /\]\([^()]*(\([^()]*\)[^()]*)*\)/)) {
           print FNR, substr($0, RSTART + 2, RLENGTH - 3)
           $0 = substr($0, RSTART + RLENGTH)
         }
       }' "$1"
}

# check DOCUMENT LINE TARGET
check() {
  local document=$1 where="$1:$2" target=${3%% \"*} path anchor
  case $target in http://* | https://* | mailto:*) return 0 ;; esac
  path=${target%%#*}
  if [ -n "$path" ]; then path=$(dirname "$document")/$path; else path=$document; fi
  if [ ! -e "$path" ]; then
    fail "$where: there is no $target"
  elif [ "$target" != "${target#*#}" ]; then
    anchor=${target#*#}
    anchors "$path" | grep -qxF -- "$anchor" || fail "$where: $path has no heading #$anchor"
  fi
}

documents=$(find . -name '*.md' -not -path './build*' -not -path './out/*' -not -path './.git/*' |
  sed 's:^\./::' | sort)
count=0
check_all() {
  local document line target
  for document in "$@"; do
    while read -r line target; do
      count=$((count + 1))
      check "$document" "$line" "$target"
    done < <(links "$document")
  done
}
check_all $documents
[ "$count" -ge 10 ] || fail "only $count links were found"

# A broken link and a broken anchor are found.
before=$failures
printf '# One\n\n[a](control.md#one) [b](nowhere.md) [c](#two)\n' >"$scratch/control.md"
check_all "$scratch/control.md" >"$scratch/log"
found=$((failures - before))
failures=$before
[ $found -eq 2 ] || fail "the control's two broken links give $found findings"
# Rows "| form | files without their ends | lines |" of its last section.
rivals=shadow/rivals/RIVALS.md
forms=0
while IFS='|' read -r _ form files told _; do
  lines=$(for file in $files; do cat "shadow/rivals/$file".[ch]pp; done | sed 's://.*::' |
    grep -cv '^[[:space:]]*$')
  forms=$((forms + 1))
  [ $((10 * lines)) -le $((11 * told)) ] && [ $((10 * lines)) -ge $((9 * told)) ] ||
    fail "$rivals: $form has $lines lines of code, and not$told"
done < <(sed -n '/^## 10[.]/,$p' "$rivals" | grep -E '^\| [a-z_, ]+ \| [a-z_ ]+ \| [0-9]+ \|$')
[ "$forms" -ge 9 ] || fail "$rivals: only $forms rows of lines were found"
verdict "$count links of $(echo $documents | wc -w) documents"
