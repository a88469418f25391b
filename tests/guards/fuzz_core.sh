#!/usr/bin/env bash
# The core holds under libFuzzer with AddressSanitizer and UndefinedBehaviorSanitizer: each target
# of tests/fuzz/core compares it with the implementation in C of tests/independent/c, or with brute
# force, ten seconds from its committed corpus, or as many as the argument or UMBRA78_FUZZ_SECONDS
# says (bash tests/guards/fuzz_core.sh 3600). An input that breaks one is kept in out/fuzz.
set -eu
. "$(dirname "$0")/../support/core.sh"
. "$root/tests/support/fuzz.sh"

used=$(echo $sources | tr ' ' '\n' |
  grep -E '^(fixed|hw|hw/memory|raster|shadow/filters|shadow/rivals)/[^/]*[.]cpp$')
mkdir "$scratch/core"
core=$(rooms_in_one "$scratch/core" $used)
text=$(ls tests/independent/c/*.c | grep -v '/main[.]c$')
for source in $core $(ls tests/fuzz/core/*.cpp); do
  echo "clang++ $instrumented -c $source -o $(object_of "$source")"
done >"$scratch/commands"
for source in $text; do
  echo "clang -std=c11 -O1 -fno-sanitize-recover=all -fsanitize=$sanitizers -c $source" \
    "-o $scratch/$(basename "$source" .c).text.o"
done >>"$scratch/commands"
compile "the targets of the core"
fuzz tests/fuzz/core "the core's target" "" \
  $(for source in $core; do object_of "$source"; done) "$scratch"/*.text.o
