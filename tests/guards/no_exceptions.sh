#!/usr/bin/env bash
# Scene and model reading, settings and closed-form truth need no exceptions, files or threads, so
# that a web page or a microcontroller can use them. They are compiled without exceptions, name no
# header of files or threads, and need nothing of tools/ but each other.
set -eu
. "$(dirname "$0")/../support/core.sh"

# tools/models; tools/scene but for the program's scene_file.cpp, which opens files and throws; of
# tools/truth what is in closed form and what measures a mask against it.
free="$(ls tools/models/*.cpp tools/scene/*.cpp | grep -v '/scene_file[.]cpp$') tools/io/suggest.cpp
tools/io/text_formats.cpp tools/truth/truth.cpp tools/truth/metrics.cpp tools/truth/edge_bands.cpp
tools/truth/edge_distance.cpp"
free=${free//$'\n'/ }
own_headers=$(for source in $free; do
  header=${source%.cpp}.hpp
  [ ! -f "$header" ] || echo "$header"
done)
forbidden='<(c?std(io|dio)\.?h?|fstream|iostream|filesystem|thread|mutex|future|atomic'
forbidden="$forbidden|condition_variable|stdexcept|exception|csignal|unistd\.h)>"

# clang++ takes two thirds of the time.
! command -v clang++ >/dev/null || CXX=clang++
flags="-std=c++20 -O0 -fno-exceptions -fno-rtti -w -I$root"
echo '#include <fmt/format.h>' | "$CXX" $flags -fsyntax-only -x c++ - 2>/dev/null ||
  skip "no fmt, so no program"
for one in $(rooms_in_one "$scratch" $free); do
  "$CXX" $flags -c "$one" -o "$one.o" 2>"$scratch/log" && continue
  head -10 "$scratch/log"
  fail "$(basename "$one" .cpp) does not compile without exceptions"
done
for file in $free $own_headers; do
  found=$(plain_text "$file" | grep -nE "#include $forbidden|\b(throw|try|catch)\b" || true)
  [ -z "$found" ] || fail "$file:$found"
done

nm -u "$scratch"/*.o | sed -n 's/^ *U //p' | sort -u | c++filt | grep '^umbra78::tools' | sort -u \
  >"$scratch/needed" || true
nm --defined-only "$scratch"/*.o | sed -n 's/^[0-9a-f]* [A-Z] //p' | c++filt | sort -u \
  >"$scratch/defined"
missing=$(comm -23 "$scratch/needed" "$scratch/defined")
[ -z "$missing" ] || fail "not among the files without exceptions: $missing"
[ -s "$scratch/needed" ] || fail "the files need nothing of each other: their symbols were not read"

# And a throw would be found.
echo 'void control() { throw 1; }' >"$scratch/control.cpp"
! "$CXX" $flags -fsyntax-only "$scratch/control.cpp" 2>/dev/null || fail "a throw is taken"
echo "without exceptions, files and threads: $free"
verdict "no exceptions in $(echo "$free" | wc -w) sources"
