#!/usr/bin/env bash
# What `cmake --install` puts into a prefix works without the tree that it came from: programs in
# C++ and in C99 are built against it, in CMake and by hand, and draw the goldens; the program finds
# its scenes and goldens; nothing names the place where it was built. And the Debian package holds
# the same, runs from an unpacked tree, and is installed and removed without a trace.
#   installed.sh BUILD-FOLDER [PYTHON]
set -eu
build=$1
python=${2:-python3}
. "$(dirname "$0")/../support/core.sh"
prefix=$scratch/prefix
CC=${CC:-cc}

cmake --install "$build" --prefix "$scratch/first" >"$scratch/log" ||
  { cat "$scratch/log"; exit 1; }
mv "$scratch/first" "$prefix" # it may be moved

# Users' programs.
drawn() { # drawn WHAT GOLDENS PROGRAM: it draws so many
  local count
  "$3" >"$scratch/drawn" 2>"$scratch/cycles" || fail "$1 does not run"
  count=$(grep -cxF -f tests/goldens/hashes.txt "$scratch/drawn" || true)
  [ "$count" -eq "$2" ] || { cat "$scratch/drawn"; fail "$1 draws $count of $2 goldens"; }
}
users() { # users WHAT PREFIX: find_package(umbra78) there, and what is built with it
  rm -rf "$scratch/user"
  cmake -S tests/installed -B "$scratch/user" -DCMAKE_PREFIX_PATH="$2" -DCMAKE_C_COMPILER="$CC" \
    -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_BUILD_TYPE=Release >"$scratch/log" 2>&1 &&
    cmake --build "$scratch/user" >>"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
  grep -q "umbra78_DIR:PATH=$2/" "$scratch/user/CMakeCache.txt" ||
    fail "$1: find_package(umbra78) finds another than that of $2"
  drawn "$1: a user's program in C++" 1 "$scratch/user/user_cpp"
  drawn "$1: a user's program in C" 8 "$scratch/user/user_core"
  drawn "$1: the same by the shared object" 8 "$scratch/user/user_c"
  grep -qx 'umbra78 [0-9.]*: [0-9]* cycles' "$scratch/cycles" || fail "$1: a user's program: cycles"
}
users "installed" "$prefix"
lib=$(dirname "$(find "$prefix" -name libumbra78.a)")
$CC -std=c99 -I"$prefix/include/umbra78" tests/installed/user.c "$lib/libumbra78.a" \
  -o "$scratch/by_hand" || fail "a C program needs more than libumbra78.a"
drawn "a C program linked by hand" 8 "$scratch/by_hand"
nm -D --defined-only "$lib/libumbra78.so" | awk '$2 == "T" {print $3}' >"$scratch/shown"
grep -v '^umbra78_' "$scratch/shown" && fail "the shared object shows more than the C face"

# No place where it was built.
for file in $(find "$prefix" -type f \( -perm -100 -o -name '*.so*' -o -name '*.a' -o \
  -name '*.cmake' -o -name '*.h*' -o -name '*.1' \)); do
  LC_ALL=C grep -aqF -e "$root/" -e "$(cd "$build" && pwd)" -e "$scratch" "$file" &&
    fail "${file#"$prefix"/} names a folder of the build"
done

# The program, its manual page and its completion.
program() { # program PREFIX: what a new user does first
  local at=$1 out=$scratch/out
  rm -rf "$out" && mkdir "$out"
  "$at/bin/umbra78" --version | grep -qx "umbra78 $version" || fail "$at: --version"
  (cd "$out" && "$at/bin/umbra78" figures --no-scenes --check >log 2>&1) ||
    { cat "$out/log"; fail "$at: umbra78 figures --check"; }
  (cd "$out" && "$at/bin/umbra78" render "$at/share/umbra78/scenes/figures.toml" --no-truth |
    grep -q ab64fc35fd81f688) || fail "$at: umbra78 render draws another figure 6"
}
version=$(sed -nE 's/.*UMBRA78_VERSION_TEXT "(.*)"/\1/p' shadow/c/umbra78.h)
manual() { # manual PREFIX
  local page=$1/share/man/man1/umbra78.1
  [ -e "$page" ] || { gzip -d <"$page.gz" >"$scratch/page"; page=$scratch/page; }
  for word in render figures study 'lookup' completion; do
    grep -q -- "$word" "$page" || fail "the manual page has no $word"
  done
  if command -v man >/dev/null; then
    LC_ALL=C.UTF-8 MANWIDTH=100 man --warnings -l "$page" 2>"$scratch/log" >/dev/null || true
    [ ! -s "$scratch/log" ] || { head -3 "$scratch/log"; fail "the manual page has errors"; }
  fi
}
complete_as() { # complete_as PREFIX LINE: what bash would offer
  bash -c '. "$1"; COMP_LINE=$2; COMP_POINT=${#2}; _umbra78 2>/dev/null
    echo "${COMPREPLY[*]}"' bash "$1/share/bash-completion/completions/umbra78" "$2"
}
offers() { # offers PREFIX LINE WORDS
  local got
  got=$(complete_as "$1" "$2")
  [ "$got" = "$3" ] || fail "$1: the completion of '$2' offers '$got' and not '$3'"
}
completion() { # completion PREFIX
  offers "$1" "umbra78 pl" "plan"
  offers "$1" "umbra78 render x.toml --js" "--json"
  offers "$1" "umbra78 study er" "error-time"
  offers "$1" "umbra78 study error-time --no" "--no-host-times"
  offers "$1" "umbra78 render x.toml --set loo" "lookup="
  offers "$1" "umbra78 render x.toml --set lookup=bi" "bilinear"
}
the_program() { # the_program PREFIX: if it is there
  [ -x "$1/bin/umbra78" ] || return 0
  program "$1"
  manual "$1"
  completion "$1"
}
the_program "$prefix"

# The module for Python, where it was built.
module() { # module PREFIX
  local packages=$1/lib/python3/dist-packages
  [ -d "$packages/umbra78" ] || return 0
  PYTHONPATH=$packages "$python" -B -c "
import umbra78
frame = umbra78.render(umbra78.Scene.file(umbra78.scenes() / 'figures.toml'), truth=False)
print('picture6', frame.hashes['picture'])" >"$scratch/drawn" || fail "$1: import umbra78"
  grep -qxF -f tests/goldens/hashes.txt "$scratch/drawn" || fail "$1: Python draws another figure 6"
}
module "$prefix"

# The Debian package.
if command -v cpack >/dev/null && command -v dpkg-deb >/dev/null; then
  (cd "$build" && cpack -B "$scratch/deb") >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
  package=$(ls "$scratch"/deb/umbra78_"$version"_*.deb)
  dpkg-deb -x "$package" "$scratch/tree"
  the_program "$scratch/tree/usr"
  users "unpacked" "$scratch/tree/usr"
  module "$scratch/tree/usr"
  find "$scratch/tree" -perm -002 ! -type l | grep . && fail "the package has files all may write"
  if [ "$(id -u)" -eq 0 ]; then # dpkg itself, with a root and a database of its own
    mkdir -p "$scratch/dpkg"/{updates,info,triggers}
    touch "$scratch/dpkg/status"
    dpkg_there() {
      dpkg --root="$scratch/host" --admindir="$scratch/dpkg" --force-depends \
        --force-script-chrootless --log=/dev/null "$@" >"$scratch/log" 2>&1 ||
        { cat "$scratch/log"; fail "dpkg $*"; }
    }
    mkdir "$scratch/host"
    dpkg_there -i "$package"
    [ -e "$scratch/host/usr/lib" ] || fail "dpkg installs nothing"
    dpkg_there --purge umbra78
    find "$scratch/host" -type f | grep . && fail "dpkg leaves files"
  fi
else
  echo "without cpack and dpkg-deb the Debian package is not tested"
fi
verdict "installed, moved, packed, removed: umbra78 $version"
