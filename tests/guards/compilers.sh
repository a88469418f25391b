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
sanitized="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all"

jobs_file=$scratch/jobs
for c in $compilers; do
  for flags in -O0 -O2 -O3 "-O3 -march=native" "$sanitized"; do echo "$c $flags"; done
done >"$jobs_file"

# Builds and runs one line of the list; its output stands beside it, `failed` if there is none.
build_and_run() {
  local name=$1 outer=$scratch compiler
  shift
  compiler="$* -std=c++20 -I$root"
  scratch=$scratch/$name # this runs in a shell of its own: only its own copy changes
  mkdir "$scratch"
  if precompile "$compiler" >"$outer/log$name" 2>&1 &&
    $compiler $precompiled tests/support/hash_figures.cpp $sources -o "$scratch/program" \
      >>"$outer/log$name" 2>&1 &&
    "$scratch/program" 0 >"$outer/first$name" 2>>"$outer/log$name" &&
    "$scratch/program" 219 >"$outer/second$name" 2>>"$outer/log$name"; then :; else
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

reference=$scratch/first1
number=0
while IFS= read -r line; do
  number=$((number + 1))
  if [ -e "$scratch/failed$number" ]; then
    head -20 "$scratch/log$number"
    fail "$line: does not build or does not run"
    continue
  fi
  for run in first second; do
    diff "$reference" "$scratch/$run$number" ||
      fail "$line, $run run: not the hashes of $(head -1 "$jobs_file") (above)"
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
verdict "$(wc -l <"$reference") buffers equal in $(wc -l <"$jobs_file") builds, two runs each"
