#!/usr/bin/env bash
# The main job without a window: a sample organ gets its tissue, is poked, gets a photo and is handed over.
#   scripts/main-job.sh ESMC FOLDER
set -euo pipefail
esmc=$(realpath "$1")
mkdir -p "$2"
cd "$2"

"$esmc" sample liver -o organ.esm
"$esmc" tissue organ.esm --system susilap-g --set consistency=5.5 --name "Whole organ" -o organ.esm
"$esmc" tissue organ.esm --system susilap-g --set consistency=2.0 --name "Soft spot" \
  --ellipsoid "-0.05 0.01 0.04 0.04 0.04 0.04" -o organ.esm
