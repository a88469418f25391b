#!/usr/bin/env bash
# The readers of models, packed files and scenes hold under libFuzzer with AddressSanitizer and
# UndefinedBehaviorSanitizer: each target of tests/fuzz runs ten seconds from its committed corpus,
# or as many as the argument or UMBRA78_FUZZ_SECONDS says (bash tests/guards/fuzz.sh 3600). An input
# that breaks one is kept in out/fuzz.
set -eu
. "$(dirname "$0")/../support/core.sh"

seconds=${1:-${UMBRA78_FUZZ_SECONDS:-10}}
sanitizers=address,undefined
command -v clang++ >/dev/null || skip "no clang++, so no libFuzzer"
echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' \
  >"$scratch/control.cpp"
clang++ -fsanitize=fuzzer,$sanitizers "$scratch/control.cpp" -o "$scratch/control" 2>/dev/null ||
  skip "clang++ has no libFuzzer"

# What reads is instrumented; the rest of the core, which a scene's checks name, is only there.
flags="-std=c++20 -w -I$root"
instrumented="$flags -O1 -g1 -fno-sanitize-recover=all -fsanitize=fuzzer-no-link,$sanitizers"
read_by="$(ls tools/models/*.cpp tools/scene/*.cpp | grep -v '/scene_file[.]cpp$')
tools/stream/packed_reader.cpp tools/stream/hills.cpp raster/extent.cpp
tools/io/suggest.cpp tools/io/text_formats.cpp raster/placing.cpp raster/shading.cpp
raster/solids.cpp raster/scene.cpp raster/view.cpp raster/projection.cpp shadow/bias.cpp"
echo '#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>' >"$scratch/common.hpp"
clang++ $instrumented -x c++-header "$scratch/common.hpp" -o "$scratch/common.pch" 2>/dev/null ||
  skip "no fmt or no nlohmann-json, so no program"
precompile "clang++ $flags -O0"

object_of() { echo "$scratch/$(basename "$1" .cpp)$(dirname "$1" | tr / _).o"; }
mkdir "$scratch/read" "$scratch/unread"
readers=$(rooms_in_one "$scratch/read" $read_by)
others=$(comm -23 <(echo $sources | tr ' ' '\n' | sort) <(echo $read_by | tr ' ' '\n' | sort))
core=$(rooms_in_one "$scratch/unread" $others)
for source in $readers $(ls tests/fuzz/*.cpp); do
  echo "$instrumented -include-pch $scratch/common.pch -c $source -o $(object_of "$source")"
done >"$scratch/commands"
for source in $core; do
  echo "$flags -O0 $precompiled -c $source -o $(object_of "$source")"
done >>"$scratch/commands"
if ! xargs -P2 -L1 clang++ <"$scratch/commands" >"$scratch/log" 2>&1; then
  head -20 "$scratch/log"
  fail "the readers do not compile"
  verdict
fi
# The instrumented objects come first, so that inline functions are theirs.
objects=$(for source in $readers $core; do object_of "$source"; done)
echo "built in $SECONDS s"

# run READER: one target, from a copy of its corpus, which it adds to.
run() {
  local name=$1 folder=$scratch/$1
  mkdir "$folder" "$folder/found"
  cp -r "tests/fuzz/corpus/$name" "$folder/corpus"
  clang++ -fsanitize=fuzzer,$sanitizers "$(object_of "tests/fuzz/$name.cpp")" $objects -lfmt \
    -o "$folder/target" &&
    "$folder/target" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=2048 -seed=1978 \
      -artifact_prefix="$folder/found/" "$folder/corpus" && touch "$folder/held"
}
names=$(for source in tests/fuzz/*.cpp; do basename "$source" .cpp; done)
for name in $names; do
  [ -d "tests/fuzz/corpus/$name" ] || fail "tests/fuzz/corpus/$name is not there"
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
  run "$name" >"$scratch/log_$name" 2>&1 &
done
wait
for name in $names; do
  if [ -e "$scratch/$name/held" ]; then
    echo "$name: $(grep -E '^Done' "$scratch/log_$name" || true)"
    continue
  fi
  grep -E 'ERROR|runtime error|SUMMARY|undefined reference|error:' "$scratch/log_$name" | head -10
  kept=""
  for input in "$scratch/$name/found/"*; do
    [ -f "$input" ] || continue
    mkdir -p out/fuzz
    cp "$input" "out/fuzz/$name-${input##*/}"
    kept="$kept out/fuzz/$name-${input##*/}"
  done
  fail "the reader of $name breaks on${kept:- no kept input; see above}"
done
verdict "$(echo $names | wc -w) readers, $seconds s each"
