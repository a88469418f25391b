#!/usr/bin/env bash
# The readers of models, packed files and scenes hold under libFuzzer with AddressSanitizer and
# UndefinedBehaviorSanitizer: each target of tests/fuzz runs ten seconds from its committed corpus,
# or as many as the argument or UMBRA78_FUZZ_SECONDS says (bash tests/guards/fuzz.sh 3600). An input
# that breaks one is kept in out/fuzz.
set -eu
. "$(dirname "$0")/../support/core.sh"
. "$root/tests/support/fuzz.sh"

# What reads is instrumented; the rest of the core, which a scene's checks name, is only there.
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

mkdir "$scratch/read" "$scratch/unread"
readers=$(rooms_in_one "$scratch/read" $read_by)
others=$(comm -23 <(echo $sources | tr ' ' '\n' | sort) <(echo $read_by | tr ' ' '\n' | sort))
core=$(rooms_in_one "$scratch/unread" $others)
for source in $readers $(ls tests/fuzz/*.cpp); do
  echo "clang++ $instrumented -include-pch $scratch/common.pch -c $source -o $(object_of "$source")"
done >"$scratch/commands"
for source in $core; do
  echo "clang++ $flags -O0 $precompiled -c $source -o $(object_of "$source")"
done >>"$scratch/commands"
compile "the readers"
# The instrumented objects come first, so that inline functions are theirs.
fuzz tests/fuzz "the reader of" -lfmt $(for source in $readers $core; do object_of "$source"; done)
