#!/usr/bin/env bash
# Runs the tests of a build, and says again at the end what the failed ones said: a program of hundreds of tests
# prints them all.
#   scripts/run-tests.sh PRESET [OPTIONS OF CTEST…]
set -euo pipefail
cd "$(dirname "$0")/.."

failed=0
ctest --preset "$1" --parallel "$(nproc)" "${@:2}" || failed=$?
((failed == 0)) && exit

printf '\n== What the failed tests of googletest said\n'
# A test that has neither passed nor failed when its program ends has ended it.
awk '
  /^\[ RUN      \]/ { said = ""; runs = 1 }
  runs { said = said $0 "\n" }
  /^\[  FAILED  \]/ && runs { printf "%s", said }
  /^\[  FAILED  \]/ || /^\[       OK \]/ || /^\[  SKIPPED \]/ { runs = 0 }
  /^<end of output>/ { if (runs) printf "%s", said; runs = 0 }
' "build/$1/Testing/Temporary/LastTest.log"
exit "$failed"
