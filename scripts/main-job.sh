#!/usr/bin/env bash
# The main job without a window: a sample organ gets its tissue, is poked, gets a photo and is handed over.
#   scripts/main-job.sh ESMC FOLDER
set -euo pipefail
esmc=$(realpath "$1")
mkdir -p "$2"
cd "$2"

step() { printf '\n%s\n' "$1"; }

step "1. A sample organ"
"$esmc" sample liver -o organ.esm

step "2. Its tissue, in words: a soft spot on the right lobe"
"$esmc" tissue organ.esm --system susilap-g --set consistency=2.8 --name "Soft spot" \
  --ellipsoid "-0.05 0.01 0.04 0.04 0.04 0.04" -o organ.esm

step "3. A poke with a round instrument"
cat >poke.json <<'JSON'
{
  "duration": 1.0,
  "tethers": [{ "every": 3, "spring_constant": 2.4, "viscosity": 10.7 }],
  "instrument": {
    "shape": "sphere",
    "radius": 0.012,
    "path": [[0, -0.05, 0.01, 0.12], [0.5, -0.05, 0.01, 0.05], [1, -0.05, 0.01, 0.12]]
  },
  "record": { "every": 0.1, "nodes": "all" }
}
JSON
"$esmc" simulate organ.esm --scene poke.json -o poke.csv

step "4. A photo on its surface"
"$esmc" sample vessels -o vessels.png
cat >projector.json <<'JSON'
{
  "pose": [1, 0, 0, -0.04,  0, 1, 0, 0.0,  0, 0, 1, 0.15,  0, 0, 0, 1],
  "width": 0.1, "height": 0.1, "kind": "parallel"
}
JSON
"$esmc" texture pack organ.esm --size 2048 -o organ.esm
"$esmc" texture photo organ.esm --photo vessels.png --projector projector.json --blend 40 -o organ.esm
"$esmc" texture bake organ.esm -o textures

step "5. The model package, checked, and pictures"
"$esmc" export organ.esm --to glb -o organ.glb
"$esmc" validate organ.glb
"$esmc" render organ.esm -o surface.png --size 1200x900
"$esmc" render organ.esm -o springs.png --size 1200x900 --show surface,springs,regions,projectors

step "Made in $PWD:"
ls -1
