# Sourced by tests/guards/fuzz*.sh after core.sh: compiler, seconds, runs from committed corpora.

seconds=${1:-${UMBRA78_FUZZ_SECONDS:-10}}
sanitizers=address,undefined
command -v clang++ >/dev/null || skip "no clang++, so no libFuzzer"
echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' \
  >"$scratch/control.cpp"
clang++ -fsanitize=fuzzer,$sanitizers "$scratch/control.cpp" -o "$scratch/control" 2>/dev/null ||
  skip "clang++ has no libFuzzer"
flags="-std=c++20 -w -I$root"
instrumented="$flags -O1 -g1 -fno-sanitize-recover=all -fsanitize=fuzzer-no-link,$sanitizers"

object_of() { echo "$scratch/$(basename "$1" .cpp)$(dirname "$1" | tr / _).o"; }

# compile WHAT: the commands of $scratch/commands, two at a time.
compile() {
  xargs -P2 -L1 env <"$scratch/commands" >"$scratch/log" 2>&1 || {
    head -20 "$scratch/log"
    fail "$1 do not compile"
    verdict
  }
  echo "built in $SECONDS s"
}

# fuzz FOLDER WHAT LIBRARIES OBJECT...: each target of the folder from a copy of its corpus, to
# which it adds, two at a time.
fuzz() {
  local folder=$1 what=$2 libraries=$3 name names
  shift 3
  names=$(for source in "$folder"/*.cpp; do basename "$source" .cpp; done)
  for name in $names; do
    [ -d "$folder/corpus/$name" ] || fail "$folder/corpus/$name is not there"
    while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
    fuzz_one "$folder" "$name" "$libraries" "$@" >"$scratch/log_$name" 2>&1 &
  done
  wait
  for name in $names; do report_one "$what" "$name"; done
  verdict "$(echo $names | wc -w) targets, $seconds s each"
}

fuzz_one() {
  local folder=$1 name=$2 libraries=$3 own=$scratch/$2
  shift 3
  mkdir "$own" "$own/found"
  cp -r "$folder/corpus/$name" "$own/corpus"
  clang++ -fsanitize=fuzzer,$sanitizers "$(object_of "$folder/$name.cpp")" "$@" $libraries \
    -o "$own/target" &&
    "$own/target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -seed=1978 \
      -artifact_prefix="$own/found/" "$own/corpus" && touch "$own/held"
}

report_one() {
  local what=$1 name=$2 kept="" input
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
  fail "$what $name breaks on${kept:- no kept input; see above}"
}
