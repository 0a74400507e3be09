#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Fails when one fails.
#   ./test.sh [PRESET]   release (default), debug or asan
#   ./test.sh --bench    measures instead, in the release build, and prints ratios: on a machine that does nothing else
set -euo pipefail
cd "$(dirname "$0")"

scripts/install-packages.sh
if [[ ${1:-} == --bench ]]; then
  cmake --preset release -DESM_BUILD_BENCHMARKS=ON
  cmake --build --preset release --target benchmarks
  exec build/release/bin/benchmarks "${@:2}"
fi

preset=${1:-release}
cmake --preset "$preset" ${CI:+-DESM_WARNINGS_AS_ERRORS=ON -DESM_GROUP_TESTS=ON}
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
