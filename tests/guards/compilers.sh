#!/usr/bin/env bash
# The figures are the same, buffer by buffer, from every compiler, at every optimisation, with the
# sanitizers and without, run after run and whatever memory held before: equal to each other, to
# tests/goldens/hashes.txt and to the hashes in hw/MACHINE.md. Two builds at a time.
set -eu
. "$(dirname "$0")/../support/core.sh"

compilers=""
for c in g++ clang++; do
  command -v $c >/dev/null && compilers="$compilers $c" || echo "left out: $c is not installed"
done
sanitized="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all"

# The longest first, so that both cores are busy to the end.
jobs_file=$scratch/jobs
for flags in "$sanitized" "-O3 -march=native" -O3 -O2 -O0; do
  for c in $compilers; do echo "$c $flags"; done
done >"$jobs_file"

# The figures are drawn without these files, which would be compiled here and not run.
drawn_by=$(echo "$sources" | grep -vE '^hw/memory/|/memory_replay[.]cpp$|/stream[.]cpp$')

# Builds and runs one line of the list; its output stands beside it, `failed` if there is none.
# Each build's memory holds another byte before: were a hash to depend on it, it would differ from
# the others', as it would if one compiler were wrong. A build at -O2 is quick and runs twice, which
# tells the two apart.
run() {
  local hashes=$1 byte
  shift
  for byte in "$@"; do "$scratch/program" "$byte" >"$hashes-$byte" || return 1; done
}
build_and_run() {
  local name=$1 outer=$scratch compiler bytes
  shift
  compiler="$* -std=c++20 -I$root"
  scratch=$scratch/$name # this runs in a shell of its own: only its own copy changes
  bytes=$((21 * name))
  [[ $compiler != *" -O2 "* ]] || bytes="$bytes 0"
  mkdir "$scratch"
  if precompile "$compiler" >"$outer/log$name" 2>&1 &&
    $compiler $precompiled tests/support/hash_figures.cpp $(rooms_in_one "$scratch" $drawn_by) \
      -o "$scratch/program" >>"$outer/log$name" 2>&1 &&
    run "$outer/hashes$name" $bytes 2>>"$outer/log$name"; then :; else
    touch "$outer/failed$name"
  fi
  rm -rf "$scratch"
}
number=0
while IFS= read -r line; do
  number=$((number + 1))
  [ $number -le 2 ] || wait -n || true
  build_and_run $number $line &
done <"$jobs_file"
wait

reference=$scratch/hashes1-21
number=0
while IFS= read -r line; do
  number=$((number + 1))
  if [ -e "$scratch/failed$number" ]; then
    head -20 "$scratch/log$number"
    fail "$line: does not build or does not run"
    continue
  fi
  for hashes in "$scratch/hashes$number-"*; do
    diff "$reference" "$hashes" ||
      fail "$line, memory full of ${hashes##*-}: not the hashes of $(head -1 "$jobs_file") (above)"
  done
done <"$jobs_file"

[ -s "$reference" ] || fail "there are no hashes"
goldens=tests/goldens/hashes.txt
while read -r buffer hash; do
  case $buffer in *_wide | *_leaf | *_correct) continue ;; esac
  if [ -f $goldens ]; then
    grep -qx "$buffer $hash" $goldens || fail "$buffer is $hash, not what $goldens says"
  fi
  grep -qhE "\| $buffer \| \`$hash\`" hw/MACHINE.md hw/machine/*.md ||
    fail "$buffer is $hash, not what hw/MACHINE.md says"
done <"$reference"
verdict "$(wc -l <"$reference") buffers equal in $(wc -l <"$jobs_file") builds"
