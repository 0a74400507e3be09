#!/usr/bin/env bash
# Hands every reader of untrusted files ever other content, and ends with 1 where one comes to grief by it.
#   tests/fuzz/run.sh SECONDS [SEED]   SECONDS for each kind of file; SEED 1 unless given
# The programs are built by the preset fuzz. What is reached by new content is kept in
# build/fuzz/corpus and tried first the next time; a finding is kept in build/fuzz/findings, and tried again by
# build/fuzz/bin/fuzz_KIND FINDING.
set -euo pipefail
cd "$(dirname "$0")/../.."

export SECONDS_EACH=${1:?tests/fuzz/run.sh SECONDS [SEED]} SEED=${2:-1}
export UBSAN_OPTIONS=print_stacktrace=1

seeds_of() {
  case $1 in
    fcl | fll) printf '%s\n' tests/data/fuzzy "tests/fuzz/seeds/$1" ;;
    fuzzy_json) printf '%s\n' tests/data/fuzzy presets ;;
    obj | ply | vtk) echo "tests/fuzz/seeds/$1" ;;
    package) echo tests/data/packages ;;
    project) echo tests/data/projects ;;
    projector) echo tests/data/projectors ;;
    scene) echo tests/data/scenes ;;
    tissue_preset) echo presets/tissue ;;
    *) echo "no seeds for $1" >&2 && return 1 ;;
  esac
}

fuzz() {
  local kind=$1 log=build/fuzz/$1.txt list seeds
  list=$(seeds_of "$kind") || return 1
  mapfile -t seeds <<<"$list"
  mkdir -p "build/fuzz/corpus/$kind" build/fuzz/findings
  if build/fuzz/bin/"fuzz_$kind" -seed="$SEED" -max_total_time="$SECONDS_EACH" -timeout=20 -print_final_stats=1 \
    -dict="tests/fuzz/dictionaries/$kind.dict" -artifact_prefix="build/fuzz/findings/$kind-" \
    "build/fuzz/corpus/$kind" "${seeds[@]}" >"$log" 2>&1; then
    echo "$kind: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") files, no finding"
  else
    tail -n 60 "$log" >&2
    echo "$kind: a finding; its whole report is $log" >&2
    return 1
  fi
}
export -f seeds_of fuzz

for program in build/fuzz/bin/fuzz_*; do
  echo "${program##*/fuzz_}"
done | xargs -P "$(nproc)" -I{} bash -c 'fuzz {}'
