#!/usr/bin/env bash
# Builds and runs the program of tools/exact for one target; tools/exact calls it, several at a
# time, and report.awk reads what it leaves.
#   run.sh TARGET SCENES FOLDER [ONLY]
# TARGET is a name of targets.txt, SCENES the source that umbra78_exact_words has printed, ONLY how
# the names of the cases begin that are drawn. Into FOLDER go: lines (what the program printed),
# log, built and ran (seconds of processor time), bytes (of text, data and zeros), inputs (a hash
# of what all that follows from), and status: drawn, skipped: WHY or failed: WHY.
set -eu
target=$1 scenes=$(realpath "$2")
mkdir -p "$3"
folder=$(realpath "$3") only=${4:-}
. "$(dirname "$0")/../support/core.sh"

line=$(grep -v '^#' tests/exact/targets.txt | sed -E 's/ *\| */|/g' |
  awk -F'|' -v name="$target" '$1 == name {print NR "|" $0}')
[ -n "$line" ] || { echo "tests/exact/targets.txt has no target '$target'" >&2; exit 2; }
IFS='|' read -r number _ _ runs_by compiler <<<"$line"
[ "$runs_by" = "${runs_by#*:}" ] || only=${only:-${runs_by#*:}} # a slow one draws less
runs_by=${runs_by%%:*}
case $runs_by in
  cortex_m3) compiler="$compiler -mthumb -mfloat-abi=soft" ;;
  riscv32) compiler="$compiler -mabi=ilp32 -misa-spec=2.2" ;;
esac
filler=$(((37 * number) % 256)) # another one for each: nothing may depend on it
program=$scratch/program

# What this target's lines follow from: with UMBRA78_EXACT_KEEP set they are not drawn again.
inputs=$({
  echo "$line $only"
  cat $headers $sources "$scenes" tests/exact/{*.?pp,*.ld,page.html,run_wasm.mjs,run.sh}
  "${compiler%% *}" --version 2>/dev/null || true
} | sha256sum | cut -c 1-40)
if [ -n "${UMBRA78_EXACT_KEEP:-}" ] && [ "$(cat "$folder/inputs" 2>/dev/null)" = "$inputs" ] &&
  grep -qx drawn "$folder/status"; then
  exit 0
fi
rm -f "$folder"/*
echo "$inputs" >"$folder/inputs"
finish() {
  echo "$1" >"$folder/status"
  exit 0
}
TIMEFORMAT=%U
# step NAME COMMAND ...: its seconds into the file NAME, what it prints into NAME.out, its messages
# into the log.
step() {
  local name=$1
  shift
  { time "$@" >"$folder/$name.out" 2>>"$folder/log"; } 2>"$folder/$name"
}
has() { command -v "$1" >/dev/null || finish "skipped: there is no $1"; }

# --- building ------------------------------------------------------------------------------------

# The core without what no frame calls; the memory that the largest case takes.
drawn_by=$(echo "$sources" | grep -vE '^hw/memory/|/memory_replay[.]cpp$|/stream[.]cpp$|/c/')
common="-std=c++20 -w -I$root -DUMBRA78_EXACT_MEMORY=0x380000 -DUMBRA78_EXACT_FILLER=$filler
-DUMBRA78_EXACT_ONLY=\"$only\""
common=${common//$'\n'/ }
# With UMBRA78_EXACT_LEAST set only the features of figures 1 to 8 and of windows of taps: a quarter
# of the time to build. The bits that such a build draws are the same.
if [ -n "${UMBRA78_EXACT_LEAST:-}" ]; then
  left_out=0 bit=1
  for name in $(sed -nE 's/^ +X\(([a-z0-9_]+), .*/\1/p' hw/features.hpp); do
    case $name in
      perspective | bilinear | windows | dither | filters) ;;
      *) left_out=$((left_out + bit)) ;;
    esac
    bit=$((2 * bit))
  done
  common="$common -DUMBRA78_LEFT_OUT=$left_out"
  drawn_by=$(echo "$drawn_by" | grep -vE '/(facet|facet_batch|triangle)[.]cpp$' |
    grep -vE '/(dice|diced_view|planar)[.]cpp$' |
    grep -vE '/(blob|post_process_rows|row_.*|ledger|costs|ground|rivals)[.]cpp$' |
    grep -vE '/(reuse|visible_list)[.]cpp$' |
    grep -vE '/(ap120b|clocked|rivals)/|/(rival_casts|irregular_map|object_space_casts)[.]cpp$')
fi
bare="-fno-exceptions -fno-rtti -ffreestanding -ffunction-sections -fdata-sections"
bare="$bare -fno-threadsafe-statics -Wno-psabi"

# Newlib's headers, which gcc-arm-none-eabi and Debian's riscv64-unknown-elf do without.
newlib_headers() {
  local newlib=/usr/include/newlib folder
  for folder in "$newlib"/c++/*/ "$newlib"/c++/*/arm-none-eabi/thumb/v7-m/nofp/ "$newlib"/; do
    [ ! -d "$folder" ] || echo "-isystem $folder"
  done
}
build_hosted() {
  $compiler $common "$scenes" tests/exact/draw.cpp tests/exact/port_hosted.cpp \
    $(rooms_in_one "$scratch" $drawn_by) -o "$program"
}
build_bare() {
  local headers
  headers=$(newlib_headers)
  $compiler $common $bare $headers -fno-tree-loop-distribute-patterns \
    -c tests/exact/bare_memory.cpp -o "$scratch/bare_memory.o"
  $compiler $common $bare $headers -nostdlib -T "tests/exact/$runs_by.ld" -Wl,--gc-sections \
    "$scenes" tests/exact/draw.cpp "tests/exact/port_$runs_by.cpp" "$scratch/bare_memory.o" \
    $(rooms_in_one "$scratch" $drawn_by) -lgcc -o "$program"
}
# __multi3, which the product of 64 x 64 bits calls, is in the compiler's own library; memcpy and
# the like in WASI's C library, of which nothing is linked that would import anything.
build_wasm() {
  local llvm=/usr/lib/llvm-${compiler##*clang++-}
  llvm=${llvm%% *}
  $compiler --target=wasm32-wasi $common -fno-exceptions -fno-rtti -nostdlib \
    -isystem "$llvm/include/wasm32-wasi/c++/v1" "$scenes" tests/exact/draw.cpp \
    tests/exact/port_wasm32.cpp $(rooms_in_one "$scratch" $drawn_by) \
    -L/usr/lib/wasm32-wasi -lc "$llvm"/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a \
    -fuse-ld="$llvm/bin/wasm-ld" -Wl,--no-entry -Wl,-z,stack-size=1048576 -Wl,--strip-all \
    -o "$program"
}

# --- running -------------------------------------------------------------------------------------

run_cortex_m3() {
  timeout 1200 qemu-system-arm -M mps2-an385 -nographic -monitor none -serial null \
    -icount shift=0 -semihosting-config enable=on,target=native -kernel "$program" 2>&1
}
run_riscv32() {
  local cpu=rv32
  [[ $compiler == *march=rv32im* ]] || cpu=rv32,m=off,a=off,f=off,d=off,c=off
  timeout 1200 qemu-system-riscv32 -M virt -cpu $cpu -bios none -nographic -monitor none \
    -serial stdio -icount shift=0 -kernel "$program" </dev/null
}
run_chromium() {
  base64 -w 100 "$program" >"$scratch/program64"
  awk -v filler="$filler" -v program="$scratch/program64" '
    sub(/@PROGRAM@.*/, "") {
      printf "%s", $0
      while ((getline line < program) > 0) print line
      print "`.replace(/\\s/g, \"\")), c => c.charCodeAt(0));"
      next
    }
    {sub(/@FILLER@/, filler); print}' tests/exact/page.html >"$scratch/page.html"
  timeout 600 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$scratch/profile" \
    --dump-dom "file://$scratch/page.html" |
    sed -n '/<pre id="lines">/,/<\/pre>/{s/.*<pre id="lines">//; s/<\/pre>.*//; /./p}'
}
case $runs_by in
  here) build=build_hosted run="$program $filler $only" ;;
  qemu-*) build=build_hosted run="$runs_by $program $filler $only" ;;
  cortex_m3) build=build_bare run=run_cortex_m3 ;;
  riscv32) build=build_bare run=run_riscv32 ;;
  node) build=build_wasm run="node tests/exact/run_wasm.mjs $program $filler" ;;
  chromium) build=build_wasm run=run_chromium ;;
esac
case $runs_by in
  here) ;;
  cortex_m3) has qemu-system-arm ;;
  riscv32) has qemu-system-riscv32 ;;
  *) has "$runs_by" ;;
esac
has "${compiler%% *}"
case $runs_by in
  here | qemu-*)
    echo 'int main() {}' >"$scratch/empty.cpp"
    $compiler "$scratch/empty.cpp" -o "$program" 2>>"$folder/log" ||
      finish "skipped: ${compiler%% *} does not link with these options"
    ;;
esac
step built $build || finish "failed: it does not build"
# A processor without floats needs no helper in their place: there is none among what is linked.
if [ $build = build_bare ]; then
  floats=$(nm "$program" | awk '{print $NF}' | tr '\n' ' ' |
    grep -oE '__(aeabi_([fd](add|r?sub|mul|div|cmp|2)|u?[il]2[fd])|(add|sub|mul|div)[sd]f3|fix)' ||
    true)
  [ -z "$floats" ] || finish "failed: floating point is in it: $floats"
fi
case $runs_by in
  node | chromium) wc -c <"$program" ;;
  *) size "$program" 2>/dev/null | awk 'NR == 2 {print $1, $2, $3}' ;;
esac >"$folder/bytes"
ran=0
step ran $run || ran=$?
mv "$folder/ran.out" "$folder/lines"
[ $ran -eq 0 ] || finish "failed: it ends with $ran"
grep -qx 'all drawn' "$folder/lines" || finish "failed: $(grep -m1 '^failed' "$folder/lines" ||
  echo 'not all was drawn')"
finish drawn
