#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Fails when one fails.
#   ./test.sh [PRESET]   release (default), debug or asan
#   ./test.sh --bench    measures instead, in the release build, and prints ratios: on a machine that does nothing else
#   ./test.sh --bench --against FILE | --record FILE   compares with an earlier program: see scripts/compare_benchmarks.py
#   ./test.sh --window [turn|colours|NODES|MESH…]   measures how soon the window answers, also while a mesh is imported,
#                                      what an edit takes to be seen, and how a large organ turns
#   ./test.sh --growth [REPETITIONS]   measures how cost grows with the surface, and fails where it grows too fast
set -euo pipefail
cd "$(dirname "$0")"

scripts/install-packages.sh
if [[ ${1:-} == --bench ]]; then
  cmake --preset release -DESM_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target benchmarks
  case ${2:-} in
    --against | --record) exec scripts/compare_benchmarks.py build/release/bin/benchmarks "${@:2}" ;;
    *) exec build/release/bin/benchmarks "${@:2}" ;;
  esac
fi

if [[ ${1:-} == --growth ]]; then
  cmake --preset release -DESM_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target growth
  exec build/release/bin/growth "${@:2}"
fi

if [[ ${1:-} == --window ]]; then
  cmake --preset release -DESM_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target responsiveness
  exec xvfb-run -a -s "-screen 0 1440x900x24" build/release/bin/responsiveness "${@:2}"
fi

preset=${1:-release}
cmake --preset "$preset" ${CI:+-DESM_WARNINGS_AS_ERRORS=ON -DESM_GROUP_TESTS=ON}
cmake --build --preset "$preset"
scripts/run-tests.sh "$preset"
