#!/usr/bin/env bash
# What reads, and the core, hold under libFuzzer with AddressSanitizer and
# UndefinedBehaviorSanitizer: each target of tests/fuzz and tests/fuzz/core runs ten seconds from
# its committed corpus, two at a time. The readers' targets read any bytes; the core's compare it
# with the implementation in C of tests/independent/c, or with brute force. An input that breaks one
# is kept in out/fuzz.
#   fuzz.sh                  what `tools/test --fuzz` runs, on the rooms of its build
#   fuzz.sh SECONDS NAME ... these targets, or all, for longer; tests/fuzz/record adds them up
set -eu
. "$(dirname "$0")/../support/core.sh"

seconds=${1:-10}
[ $# -eq 0 ] || shift
built=${UMBRA78_FUZZED:-$root/build/sanitize}
command -v clang++ >/dev/null || skip "no clang++, so no libFuzzer"
grep -qs fsanitize-coverage "$built/build.ninja" \
  "$built"/CMakeFiles/umbra78_tools_scene.dir/flags.make ||
  skip "no rooms for the fuzzers; tools/test --fuzz builds them"
instrumented="-O1 -g1 -w -I$root -fsanitize=fuzzer-no-link,address,undefined"
instrumented="$instrumented -fno-sanitize-recover=all"
rooms=$(cd "$built" && ls -d "$PWD"/libumbra78_{fixed,hw,raster,shadow,tools_io,tools_models}*.a \
  "$PWD"/libumbra78_tools_{scene,stream}.a 2>/dev/null || true)

sources=$(ls tests/fuzz/*.cpp tests/fuzz/core/*.cpp)
[ $# -eq 0 ] ||
  sources=$(for name in "$@"; do ls tests/fuzz/{,core/}"$name.cpp" 2>/dev/null || true; done)
[ -n "$sources" ] || { echo "fuzz.sh: no target has such a name: $*" >&2; exit 2; }
object_of() { echo "$scratch/$(basename "${1%.*}").o"; }
for source in $sources; do
  echo "clang++ -std=c++20 $instrumented -c $source -o $(object_of "$source")"
done >"$scratch/commands"
for source in $(ls tests/independent/c/*.c | grep -v '/main[.]c$'); do
  echo "clang -std=c11 -O1 -fno-sanitize-recover=all -fsanitize=address,undefined -c $source" \
    "-o $scratch/$(basename "$source").text.o"
done >>"$scratch/commands"
xargs -P2 -L1 env <"$scratch/commands" >"$scratch/log" 2>&1 || {
  head -20 "$scratch/log"
  fail "the targets do not compile"
  verdict
}
echo "built in $SECONDS s"

# run SOURCE: it adds to a copy of its corpus.
run() {
  local name own corpus
  name=$(basename "$1" .cpp) corpus=$(dirname "$1")/corpus
  own=$scratch/$name
  mkdir -p "$own/found"
  cp -r "$corpus/$name" "$own/corpus"
  clang++ -fsanitize=fuzzer,address,undefined "$(object_of "$1")" "$scratch"/*.text.o \
    -Wl,--start-group $rooms -Wl,--end-group -lfmt -o "$own/target" &&
    "$own/target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -seed=1978 \
      -artifact_prefix="$own/found/" "$own/corpus" && touch "$own/held"
}
report() {
  local name kept="" input
  name=$(basename "$1" .cpp)
  if [ -e "$scratch/$name/held" ]; then
    echo "$name: $(grep -E '^Done' "$scratch/log_$name" || true)"
    return
  fi
  grep -E 'ERROR|runtime error|SUMMARY|undefined reference|error:' "$scratch/log_$name" | head -10
  for input in "$scratch/$name/found/"*; do
    [ -f "$input" ] || continue
    mkdir -p out/fuzz
    cp "$input" "out/fuzz/$name-${input##*/}"
    kept="$kept out/fuzz/$name-${input##*/}"
  done
  fail "${1%.cpp} breaks on${kept:- no kept input; see above}"
}
for source in $sources; do
  [ -d "$(dirname "$source")/corpus/$(basename "$source" .cpp)" ] || fail "$source has no corpus"
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
  run "$source" >"$scratch/log_$(basename "$source" .cpp)" 2>&1 &
done
wait
for source in $sources; do report "$source"; done
verdict "$(echo "$sources" | wc -l) targets, $seconds s each"
