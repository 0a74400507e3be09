#!/usr/bin/env bash
# Makes the pictures of the user guide and the README anew, from the program as it is now.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install-packages.sh
cmake --preset release
cmake --build --preset release --target user_guide_pictures
xvfb-run -a -s "-screen 0 1440x900x24" build/release/bin/user_guide_pictures docs/user-guide/pictures
