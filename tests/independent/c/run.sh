#!/usr/bin/env bash
# Builds the implementation in C, which was written from hw/MACHINE.md and hw/machine/ alone, with
# warnings as errors, and compares all that the text publishes: vectors, figures, every variant.
#   tests/independent/c/run.sh           by cc
#   tests/independent/c/run.sh --clang   vectors and figures by clang
#   tests/independent/c/run.sh --faults  that a changed hash and each of the faults below is found
# CC=NAME takes another compiler.
set -eu -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
warnings="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Werror"

# build COMPILER PROGRAM SOURCE...: all at once, two compilers at a time
build() {
  local compiler=$1 program=$2
  shift 2
  mkdir -p "$program.o"
  printf '%s\n' "$@" | xargs -P 2 -I{} sh -c \
    '"$0" -std=c11 -O2 '"$warnings"' -I"$1" -c "$2" -o "$3/$(basename "$2" .c).o"' \
    "$compiler" "$here" {} "$program.o"
  "$compiler" "$program".o/*.o -o "$program"
}

# compare PROGRAM ARGUMENT...: with the text of $text
text=$root/hw
compare() {
  local program=$1
  shift
  "$program" "$@" "$here/../vectors" "$text/MACHINE.md" "$text"/machine/*.md
}

# Faults in the code, each a file, what is replaced by what, and a variant that shows it.
faults() {
  cat <<'END'
notation.c|HALF_UP: more = half > 0|HALF_UP: more = half >= 0|s_percentage
big.c|twice = big_shift(a, 1)|twice = big_shift(a, 0)|vectors
views.c|depth_min / 64 - 1|depth_min / 64|s_world
blocks.c|<= 126976|<= 120000|s_mesh
samples.c|weight >= -128|weight >= -64|s_near_eye
shading.c|n_dot_v >> 14|n_dot_v >> 13|s_mesh
triangles.c|t\[0\] = 1024|t[0] = 1023|s_mesh
noise.c|(u64)9 <<|(u64)5 <<|s_jittered
filters.c|step = (x + 128) >> 8|step = (x + 127) >> 8|s_edges
shadow_test.c|four\[k\] == s->background_code|four[k] < 0|s_coarse_z
receiver.c|slope \* factor, 8, CEILING|slope * factor, 8, FLOOR|vectors
sectors.c|xy_bits - 1;|xy_bits - 1 - (q->axis == 2);|s_sectors_nearest
dicing.c|6 \* uu|5 * uu|vectors
ground.c|times(rise, 64)|times(rise, 63)|vectors
float_store.c|drop, HALF_EVEN|drop, HALF_UP|s_float
receiver.c|? code : kept_code(code, s)|? code : code|s_float_reversed
receiver.c|kept_code(s->deepest_drawn, s)|s->deepest_drawn|s_float_far
shadow_test.c|code = kept_code(code, s)|(void)kept_code|s_float_nearest
END
}

found() { # found WHAT COMMAND...: the command has to end with 1, because something differs
  local what=$1 status=0
  shift
  "$@" >"$scratch/output" 2>&1 || status=$?
  if [ $status -ne 1 ] || ! grep -q DIFFERS "$scratch/output"; then
    echo "not found (status $status): $what"
    return 1
  fi
  echo "found: $what"
}

main() {
  local compiler=${CC:-cc} second status=0
  [ "${1:-}" != --clang ] || compiler=clang
  command -v "$compiler" >/dev/null || {
    echo "left out: no C compiler '$compiler'; install it, or name another by CC="
    exit 0
  }
  build "$compiler" "$scratch/machine" "$here"/*.c
  case "${1:-}" in
    --clang) compare "$scratch/machine" --only vectors --only figures ;;
    --faults) try_faults "$compiler" ;;
    "")
      compare "$scratch/machine" --part 1/2 >"$scratch/second" &
      second=$!
      compare "$scratch/machine" --part 0/2 || status=1
      wait $second || status=1
      cat "$scratch/second"
      return $status
      ;;
    *)
      echo "$0: unknown option '$1'; see its first lines" >&2
      return 2
      ;;
  esac
}

try_faults() {
  local compiler=$1 status=0 file from to variant
  mkdir "$scratch/text" "$scratch/sources"
  cp -r "$root/hw/MACHINE.md" "$root/hw/machine" "$scratch/text"
  sed -i -E '/^\| s_blob \| mask \|/s/[0-9a-f]`/!`/' "$scratch/text/machine/figures.md"
  text=$scratch/text
  found "a hash of s_blob changed in the text" compare "$scratch/machine" --only s_blob || status=1
  text=$root/hw
  while IFS=$'\t' read -r file from to variant; do
    sed "s#$from#$to#" "$here/$file" >"$scratch/sources/$file"
    cmp -s "$here/$file" "$scratch/sources/$file" && { echo "no such line: $from" && status=1; }
    rm -rf "$scratch/fault" "$scratch/fault.o"
    cp -r "$scratch/machine.o" "$scratch/fault.o"
    build "$compiler" "$scratch/fault" "$scratch/sources/$file"
    found "$file: $from -> $to" compare "$scratch/fault" --only "$variant" || status=1
  done < <(faults | tr '|' '\t')
  return $status
}
main "$@"
