#!/usr/bin/env bash
# Runs the tests of a build, and says again at the end what the failed ones of googletest said: a program of
# hundreds of tests prints them all.
#   scripts/run-tests.sh PRESET [OPTIONS OF CTEST…]
set -euo pipefail
cd "$(dirname "$0")/.."

log=build/${1:?name a preset: release, debug or asan}/Testing/Temporary/LastTest.log
rm -f "$log"
failed=0
ctest --preset "$1" --parallel "$(nproc)" "${@:2}" || failed=$?
if ((failed == 0)) || [[ ! -f $log ]]; then exit "$failed"; fi

# A test that has neither passed nor failed when its program ends has ended it.
awk '
  function say() {
    if (!isTitled) print "\n== What the failed tests of googletest said"
    isTitled = 1
    printf "%s", said
    runs = 0
  }
  /^<end of output>/ { if (runs) say(); next }
  /^\[ RUN      \]/ { said = ""; runs = 1 }
  runs { said = said $0 "\n" }
  /^\[  FAILED  \]/ && runs { say() }
  /^\[       OK \]/ || /^\[  SKIPPED \]/ { runs = 0 }
' "$log"
exit "$failed"
