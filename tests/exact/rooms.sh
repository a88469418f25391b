#!/usr/bin/env bash
# The tests of the rooms fixed and hw on processors with other words than this one: 32 bits, and
# the high byte first. Called by tools/exact --all.
#   rooms.sh FOLDER
# Into FOLDER/rooms goes a line "target|room|passed|seconds|status" for each.
set -eu
folder=$(realpath "$1")
. "$(dirname "$0")/../support/core.sh"
gtest=/usr/src/googletest/googletest
: >"$folder/rooms"
[ -d $gtest ] || { echo "skipped: the room tests need libgtest-dev's sources"; exit 0; }
mkdir -p "$scratch/tests/support"
echo "#define UMBRA78_SOURCE_DIR \"$root\"" >"$scratch/tests/support/paths.hpp"

# In one file, as the quick build has them; but for those that need RapidCheck's library. A trap
# ends a process, which qemu's emulation of a processor reports in its own way: the death tests are
# left to x86-64.
all_of() {
  local file
  for file in $(find "$@" -name '*.cpp' -not -name 'long_*' -not -name properties_test.cpp |
    sort); do
    echo "#include \"$file\""
  done
}
TIMEFORMAT=%U
room_tests() { # NAME RUN COMPILER ...: both rooms
  local name=$1 run=$2 room passed status
  shift 2
  if ! command -v "$1" >/dev/null || { [ -n "$run" ] && ! command -v "$run" >/dev/null; }; then
    echo "skipped: room tests on $name: there is no $1 or no $run" >&2
    return
  fi
  local flags="-std=c++20 -w -O1 -I$root -I$scratch -DGTEST_HAS_PTHREAD=0"
  local built="$scratch/$1"
  $* $flags -I$gtest -c $gtest/src/gtest-all.cc -o "$built-gtest.o"
  $* $flags -I$gtest -c $gtest/src/gtest_main.cc -o "$built-main.o"
  for room in fixed hw; do
    all_of tests/$room >"$scratch/tests_of_$room.cpp"
    status=passed
    : >"$folder/rooms.out"
    $* $flags -I$gtest/include "$scratch/tests_of_$room.cpp" tests/support/trapped.cpp \
      $(rooms_in_one "$scratch" $(find fixed hw -name '*.cpp')) "$built-gtest.o" "$built-main.o" \
      -o "$scratch/tests-of-$room" 2>"$folder/rooms.log" || status="failed: it does not build"
    rm -f "$scratch"/hw*.cpp
    [ "$status" != passed ] || { time $run "$scratch/tests-of-$room" \
      --gtest_filter='-*Trap*:*Death*' \
      >"$folder/rooms.out" 2>>"$folder/rooms.log"; } 2>"$folder/rooms.time" ||
      status="failed: $(grep -m1 '^\[  FAILED' "$folder/rooms.out" || echo it ends early)"
    passed=$(grep -c '^\[       OK' "$folder/rooms.out" || true)
    echo "$name|$room|$passed|$(cat "$folder/rooms.time" 2>/dev/null || echo 0)|$status" |
      tee -a "$folder/rooms"
    [ "$status" = passed ] || fail "the tests of $room on $name: $status; see $folder/rooms.log"
  done
}
# g++-12-multilib comes without a link to the headers that both word sizes share.
room_tests "x86-32" "" g++ -m32 -idirafter /usr/include/x86_64-linux-gnu
room_tests "s390x" qemu-s390x-static s390x-linux-gnu-g++ -static
room_tests "m68k" qemu-m68k-static m68k-linux-gnu-g++ -static
verdict "the tests of fixed and hw on other processors"
