#!/usr/bin/env bash
# Workers of a frame never touch the same word at the same time: ThreadSanitizer watches three of
# them draw frames of patches and of facets, in both forms of the shadow test.
set -eu
. "$(dirname "$0")/../support/core.sh"

flags="-std=c++20 -O1 -g1 -fsanitize=thread -w -I$root"
echo 'int main() {}' >"$scratch/control.cpp"
"$CXX" $flags "$scratch/control.cpp" -o "$scratch/control" 2>/dev/null && "$scratch/control" ||
  skip "$CXX has no ThreadSanitizer, or it does not run here"
for one in $(rooms_in_one "$scratch" $sources); do
  "$CXX" $flags -c "$one" -o "$one.o" &
  [ "$(jobs -r | wc -l)" -lt 2 ] || wait -n
done
"$CXX" $flags -c tests/guards/threads.cpp -o "$scratch/threads.o"
wait
"$CXX" $flags "$scratch"/*.o -o "$scratch/threads"
"$scratch/threads" >"$scratch/log" 2>&1 ||
  { head -30 "$scratch/log"; fail "the workers of a frame share a word, or draw another frame"; }
! "$scratch/threads" race >"$scratch/log" 2>&1 || fail "two threads that share a word are not seen"
verdict "three workers share no word that one of them writes"
