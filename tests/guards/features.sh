#!/usr/bin/env bash
# A build without any feature of hw/features.hpp draws figure 3 to the last bit, says what figure 4
# would need, and is small. CMake refuses a feature that it does not know, and lists those it does.
#   features.sh            the guard
#   features.sh --sizes    the table of README.md: bytes of text and data of a program that draws
#                          figure 3, by feature set, here and for a Cortex-M3; takes some minutes
set -eu
. "$(dirname "$0")/../support/core.sh"

all=$(sed -nE 's/^ +X\(([a-z0-9_]+), .*/\1/p' hw/features.hpp)

# left_out FEATURE ...: the bits of UMBRA78_LEFT_OUT of a build with these alone.
left_out() {
  local name bit=1 mask=0
  for name in $all; do
    [[ " $* " == *" $name "* ]] || mask=$((mask + bit))
    bit=$((2 * bit))
  done
  echo "$mask"
}

# bytes COMPILER SIZE-PROGRAM LINK-OPTIONS FEATURE ...: of the linked program, text and data.
bytes() {
  local compiler=$1 size=$2 link=$3 source objects=""
  shift 3
  compiler="$compiler -DUMBRA78_LEFT_OUT=$(left_out "$@") -ffunction-sections -fdata-sections"
  for source in $sources tests/guards/figure3.cpp; do
    case $source in */settings.cpp | */profiles.cpp | */stream.cpp) continue ;; esac
    $compiler -c "$source" -o "$scratch/$(echo "$source" | tr / _).o"
    objects="$objects $scratch/$(echo "$source" | tr / _).o"
  done
  $compiler $objects -Wl,--gc-sections $link -o "$scratch/linked"
  "$size" "$scratch/linked" | awk 'NR == 2 {print $1 + $2}'
}

if [ "${1:-}" = --sizes ]; then
  common="-std=c++20 -DNDEBUG -fno-exceptions -fno-rtti -I$root"
  newlib=/usr/include/newlib
  arm="arm-none-eabi-g++ $common -Os -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -ffreestanding
-fno-threadsafe-statics -Wno-psabi"
  for folder in "$newlib"/c++/*/ "$newlib"/c++/*/arm-none-eabi/thumb/v7-m/nofp/ "$newlib"/; do
    [ -d "$folder" ] && arm="$arm -isystem $folder"
  done
  while read -r names; do
    host=$(bytes "$CXX $common -O2" size "" $names)
    small=-
    if command -v arm-none-eabi-g++ >/dev/null; then  # without the C library, which is not counted
      small=$(bytes "${arm//$'\n'/ }" arm-none-eabi-size \
        "-nostdlib -Wl,-emain -Wl,--unresolved-symbols=ignore-all -lgcc" $names)
    fi
    echo "${names:-none} | $host | $small"
  done <<SETS

rows
bilinear dither
bilinear dither filters
bilinear dither filters perspective triangles
$(echo $all)
SETS
  exit 0
fi

if cmake -S "$root" -B "$scratch/refused" -DUMBRA78_FEATURES="filters;no_such" \
  >"$scratch/log" 2>&1; then
  fail "CMake takes a feature that there is not"
fi
grep -q "unknown feature 'no_such'" "$scratch/log" || fail "CMake does not name the feature"
for name in $all; do
  grep -q "^    $name: " "$scratch/log" || fail "CMake does not list the feature $name"
done
if cmake -S "$root" -B "$scratch/refused" -DUMBRA78_FEATURES=dicing >"$scratch/log" 2>&1; then
  fail "CMake takes dicing without triangles"
fi

cmake -S "$root" -B "$scratch/least" -DUMBRA78_FEATURES=none -DCMAKE_CXX_COMPILER="$CXX" \
  -DUMBRA78_UNITY=ON \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DUMBRA78_WERROR=ON \
  >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/least" --target umbra78_figure3 >"$scratch/built" 2>&1 ||
  { tail -20 "$scratch/built"; exit 1; }
"$scratch/least/umbra78_figure3" >"$scratch/drawn"
[ "$(wc -l <"$scratch/drawn")" -eq 4 ] || fail "the least build does not print four hashes"
grep -vxF -f tests/goldens/hashes.txt "$scratch/drawn" &&
  fail "the least build draws another figure 3"
if "$scratch/least/umbra78_figure3" 4 >"$scratch/drawn"; then
  fail "the least build draws figure 4, which interpolates"
fi
grep -q "figure 4 needs the feature bilinear" "$scratch/drawn" ||
  fail "the least build does not say what figure 4 needs"
grep -A2 '^ *text' "$scratch/built" || true
verdict "figure 3 by a build without any feature"
