#!/usr/bin/env bash
# Installs what is missing, builds, and starts the editor; without a display does the main
# job on the command line and leaves the results under out/.
#   ./run.sh [FILE…]   opens projects, surfaces and photos, one after the other
set -euo pipefail
arguments=()
for argument in "$@"; do
  if [[ -e $argument ]]; then argument=$(realpath -- "$argument"); fi
  arguments+=("$argument")
done
cd "$(dirname "$0")"

scripts/install-packages.sh
cmake --preset release >/dev/null
cmake --build --preset release --target esm esmc

if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
  exec build/release/bin/esm "${arguments[@]}"
fi
echo "No display: doing the main job on the command line."
exec scripts/main-job.sh build/release/bin/esmc out
