# Sourced by tests/guards/*.sh: where the core is, how it is compiled, and what becomes of a
# finding.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
rooms="fixed hw raster shadow"
headers=$(find $rooms -name '*.hpp' | sort)
sources=$(find $rooms -name '*.cpp' | sort)
standard_headers=$(cat $headers $sources | sed -n 's/^#include \(<.*>\).*/\1/p' | sort -u)
CXX=${CXX:-g++}
scratch=$(mktemp -d "${TMPDIR:-/tmp}/umbra78-guard.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
failures=0

# fail WHAT: prints it and remembers that the guard has failed.
fail() {
  echo "guard: $1"
  failures=$((failures + 1))
}
# skip WHY: ends the guard without a verdict. CTest counts exit code 77 as skipped.
skip() {
  echo "left out: $1"
  exit 77
}
verdict() {
  [ "$failures" -eq 0 ] || exit 1
  echo "held: $1"
}

# A file without its comments and without what is in quotes, line for line.
plain_text() { sed -e 's://.*::' -e 's:"[^"]*"::g' "$1"; }

# precompile COMPILER-WITH-OPTIONS [WORD ...]: compiles the core's standard headers once and poisons
# the words after them. What is compiled with $precompiled and the same options reads them from
# there, in a third of the time.
precompile() {
  local compiler=$1 h
  shift
  {
    for h in $standard_headers; do
      case "$h $compiler" in # the lanes' header, of shadow/row_forms.cpp alone
        "<immintrin.h> clang"*) ;; # which reads it itself: clang++ 14 precompiles it badly
        "<immintrin.h> "*) printf '#ifdef __SSE2__\n#include %s\n#endif\n' "$h" ;;
        *) echo "#include $h" ;;
      esac
    done
    [ $# -eq 0 ] || echo "#pragma GCC poison $*"
  } >"$scratch/standard.hpp"
  if $compiler --version | grep -q clang; then
    precompiled="-include-pch $scratch/standard.pch"
    $compiler -x c++-header "$scratch/standard.hpp" -o "$scratch/standard.pch"
  else
    precompiled="-Werror=invalid-pch -include $scratch/standard.hpp"
    $compiler -x c++-header "$scratch/standard.hpp" -o "$scratch/standard.hpp.gch"
  fi
}

# rooms_in_one FOLDER [FILE ...]: for each room a file that includes all sources of the core, or
# those of FILE ... that it has; prints the files' names. A room's names differ from file to file,
# and what is compiled at once takes a fifth of the time. The build compiles each file alone.
rooms_in_one() {
  local folder=$1 source one
  shift
  for source in ${@:-$sources}; do
    one=$folder/$(dirname "$source" | tr / _).cpp
    [ -e "$one" ] || echo "$one"
    echo "#include \"$source\"" >>"$one"
  done
}

# A file that includes every header of the core.
every_header() {
  local h
  for h in $headers; do echo "#include \"$h\""; done
}
