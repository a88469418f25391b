#!/usr/bin/env bash
# The core compiles for a Cortex-M3, which has no FPU, and calls for nothing that is not there: no
# soft-float helper, no heap, no exceptions, no I/O. By arm-none-eabi-g++ if that is installed
# (gcc-arm-none-eabi, libnewlib-dev and libstdc++-arm-none-eabi-dev: 53 MB to load, 470 MB on disk;
# the libraries, 2 GB more, are not needed), else by clang with the host's headers: both compile to
# objects and look at their symbols, and nothing is linked.
set -eu
. "$(dirname "$0")/../support/core.sh"

flags="-std=c++20 -O0 -mcpu=cortex-m3 -mthumb -mfloat-abi=soft -fno-exceptions -fno-rtti
-ffreestanding -fno-threadsafe-statics -I$root"
if command -v arm-none-eabi-g++ >/dev/null; then
  newlib=$(cd "$(dirname "$(command -v arm-none-eabi-g++)")/.." && pwd)/include/newlib
  includes=""
  for folder in "$newlib"/c++/*/ "$newlib"/c++/*/arm-none-eabi/thumb/v7-m/nofp/ "$newlib"/; do
    [ -d "$folder" ] && includes="$includes -isystem $folder"
  done
  compiler="arm-none-eabi-g++ $flags $includes"
  nm=arm-none-eabi-nm
elif command -v clang++ >/dev/null && command -v g++ >/dev/null; then
  # The host's C++ headers, found by asking its compiler; stubs for its other word size.
  includes=""
  for folder in $(g++ -std=c++20 -E -x c++ -v /dev/null 2>&1 |
    sed -n '/#include <...>/,/^End/s/^ \(.*\)/\1/p'); do
    case $folder in */gcc/*) ;; *) includes="$includes -isystem $folder" ;; esac
  done
  mkdir -p "$scratch/gnu"
  touch "$scratch/gnu/stubs-32.h" "$scratch/gnu/stubs-soft.h"
  compiler="clang++ --target=arm-none-eabi -nostdinc++ -D_GNU_SOURCE $flags -isystem $scratch"
  compiler="$compiler $includes"
  nm=$(command -v llvm-nm || command -v llvm-nm-14 || command -v nm)
else
  skip "no arm-none-eabi-g++ and no clang++ for a Cortex-M3"
fi
compiler=${compiler//$'\n'/ }
precompile "$compiler"

forbidden='__aeabi_[fd](add|sub|rsub|mul|div|cmp|2)|__aeabi_(i|ui|l|ul)2[fd]' # soft float
forbidden="$forbidden|malloc|calloc|realloc|_Znw|_Zna|_Zdl|_Zda"              # the heap
forbidden="$forbidden|__cxa_(throw|allocate|begin_catch|guard)|__gxx_personality"
forbidden="$forbidden|printf|fopen|^(sqrt|sin|cos|pow|floor)f?$"
every_header >"$scratch/headers.cpp"
for source in $(rooms_in_one "$scratch") "$scratch/headers.cpp"; do
  if ! $compiler $precompiled -c "$source" -o "$scratch/object.o" 2>"$scratch/log"; then
    head -20 "$scratch/log"
    fail "$source does not compile for a Cortex-M3"
    continue
  fi
  $nm -u "$scratch/object.o" | awk '{print $NF}' >"$scratch/symbols"
  cat "$scratch/symbols" >>"$scratch/needed"
  found=$(grep -E "$forbidden" "$scratch/symbols" | tr '\n' ' ' || true)
  [ -z "$found" ] || fail "$source needs $found"
done
# And the list would find a double.
echo 'int control(double d) { return static_cast<int>(d + 0.5); }' >"$scratch/control.cpp"
$compiler -c "$scratch/control.cpp" -o "$scratch/object.o"
$nm -u "$scratch/object.o" | awk '{print $NF}' | grep -qE "$forbidden" ||
  fail "a double needs nothing that is looked for"
echo "by ${compiler%% *}; outside itself the core needs:" \
  $(grep -v '^_ZN' "$scratch/needed" | sort -u | tr '\n' ' ')
verdict "Cortex-M3, $(echo $sources | wc -w) sources"
