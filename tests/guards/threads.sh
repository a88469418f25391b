#!/usr/bin/env bash
# Workers of a frame never touch the same word at the same time: ThreadSanitizer watches three of
# them draw frames of patches and of facets, in both forms of the shadow test.
set -eu
. "$(dirname "$0")/../support/core.sh"

flags="-std=c++20 -w -I$root"
watched="$flags -O1 -g1 -fsanitize=thread"
echo 'int main() {}' >"$scratch/control.cpp"
"$CXX" $watched "$scratch/control.cpp" -o "$scratch/control" 2>/dev/null && "$scratch/control" ||
  skip "$CXX has no ThreadSanitizer, or it does not run here"
# One worker draws rivals, clocked machines and the array processor: no thread runs those rooms.
for one in $(rooms_in_one "$scratch" $sources); do
  case $(basename "$one" .cpp) in
    *_rivals | *_clocked | *_ap120b | *_memory | shadow_c) options="$flags -O0" ;;
    *) options=$watched ;;
  esac
  "$CXX" $options -c "$one" -o "$one.o" &
  [ "$(jobs -r | wc -l)" -lt 2 ] || wait -n
done
"$CXX" $watched -c tests/guards/threads.cpp -o "$scratch/threads.o"
wait
"$CXX" $watched "$scratch"/*.o -o "$scratch/threads"
"$scratch/threads" >"$scratch/log" 2>&1 ||
  { head -30 "$scratch/log"; fail "the workers of a frame share a word, or draw another frame"; }
! "$scratch/threads" race >"$scratch/log" 2>&1 || fail "two threads that share a word are not seen"
verdict "three workers share no word that one of them writes"
