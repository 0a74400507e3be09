#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Fails when one fails.
#   ./test.sh [PRESET]   release (default), debug or asan
set -euo pipefail
cd "$(dirname "$0")"
preset=${1:-release}

scripts/install-packages.sh
cmake --preset "$preset" ${CI:+-DESM_WARNINGS_AS_ERRORS=ON}
cmake --build --preset "$preset"
ctest --preset "$preset" --parallel "$(nproc)"
