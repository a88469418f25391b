#!/usr/bin/env bash
# pytest on the module for Python of a build folder; exit 77 where that was not built.
#   run.sh WHY-NOT PYTHON BUILD-FOLDER
set -eu
why=$1 python=$2 build=$3
[ -n "$why" ] || "$python" -c "import pytest" 2>/dev/null || why="missing: python3-pytest"
if [ -n "$why" ]; then
  echo "left out: $why"
  exit 77
fi
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$build/test-output/python"
cd "$build/test-output/python" # the example writes its picture here
PYTHONPATH=$build/python UMBRA78_PROGRAM=$build/umbra78 exec "$python" -B -m pytest -q \
  -p no:cacheprovider --doctest-modules "$here" "$build/python/umbra78/__init__.py"
