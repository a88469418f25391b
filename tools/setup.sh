# Sourced by tools/figures, tools/test and tools/bench: packages and builds.
# Debian packages that are missing are installed where that is allowed, else named in one line.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

core_packages="g++ cmake make libgtest-dev"
program_packages="g++ cmake make libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
libstb-dev libkissfft-dev"
# The live page's machine is compiled to WebAssembly.
page_packages="clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32
libclang-rt-19-dev-wasm32 wasi-libc libfmt-dev libtomlplusplus-dev nlohmann-json3-dev
libkissfft-dev libstb-dev"

installed() { [ "$(dpkg-query -W -f '${Status}' "$1" 2>/dev/null)" = "install ok installed" ]; }

# need PACKAGE ...: has them, installs them, or says what to do and ends.
need() {
  local missing="" package run=""
  command -v dpkg-query >/dev/null || return 0 # not Debian: cmake says what it does not find
  for package in "$@"; do installed "$package" || missing="$missing $package"; done
  [ -z "$missing" ] && return 0
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then run="sudo -n"; else
      echo "missing:$missing; install them with: sudo apt-get install$missing" >&2
      exit 1
    fi
  fi
  echo "installing:$missing"
  { $run apt-get update -qq && DEBIAN_FRONTEND=noninteractive $run apt-get install -y -qq \
    --no-install-recommends $missing; } >"${TMPDIR:-/tmp}/umbra78-apt.log" 2>&1 || {
    echo "could not install:$missing; see ${TMPDIR:-/tmp}/umbra78-apt.log," \
      "or install them with: sudo apt-get install$missing" >&2
    exit 1
  }
}

# want PACKAGE ...: like need, for what is optional; its absence is one line.
want() {
  local package
  for package in "$@"; do
    installed "$package" || (need "$package") >/dev/null 2>&1 ||
      echo "without $package: what it is for is left out"
  done
}

# build FOLDER TARGETS CMAKE-OPTION ...: quiet unless something is wrong. A new folder is built with
# ninja, which keeps all cores busy to the end, or, where that cannot be installed, with make, and
# several files at a time, which takes half the time (-DUMBRA78_UNITY=OFF for one's own folder).
build() {
  local folder=$1
  shift
  build_in "$folder" "$root" "$@"
}

# build_in FOLDER SOURCES TARGETS CMAKE-OPTION ...: the same for another CMakeLists.txt.
build_in() {
  local folder=$root/build/$1 sources=$2 targets=$3 log generator=""
  shift 3
  mkdir -p "$folder"
  log=$folder/build.log
  echo "building ${folder#"$root"/}"
  if [ ! -e "$folder/CMakeCache.txt" ]; then
    command -v ninja >/dev/null || (need ninja-build) >/dev/null 2>&1 || true
    ! command -v ninja >/dev/null || generator="-GNinja"
    generator="$generator -DUMBRA78_UNITY=ON"
  fi
  if ! { cmake -S "$sources" -B "$folder" $generator "$@" &&
    cmake --build "$folder" --target $targets -j "$(nproc)"; } >"$log" 2>&1; then
    cat "$log" >&2
    echo "the build failed; its output is above and in $log" >&2
    exit 1
  fi
  grep -h '^-- umbra78: ' "$log" | cut -c 4- || true
}
