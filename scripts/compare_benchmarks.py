#!/usr/bin/env python3
"""Compares this program's benchmarks with an earlier one's, in turn on the same machine.

    ./test.sh --bench --against FILE [FLAGS]   FILE: an earlier `benchmarks` program, or a baseline that names its commit
    ./test.sh --bench --record FILE [FLAGS]    makes such a baseline of the commit that is checked out

Times say nothing on another machine, nor an hour later on the same. So a baseline is no table to hold times against,
but a commit: its benchmarks are built in build/baseline and run in turn with today's, nine times each, so that a
machine that becomes slower meanwhile does so for both. A benchmark is slower when its median is so by more than 3 %
beyond the spread of the nine runs. FLAGS go to both programs, for instance --benchmark_filter='naive.*'.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections import namedtuple
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TOLERANCE = 0.03
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}

Comparison = namedtuple("Comparison", "name before now ratio spread is_slower")


def times_of_run(report):
    """Benchmark -> median of its repetitions' wall times, s, from what Google Benchmark writes."""
    times = {}
    for run in report["benchmarks"]:
        if run["run_type"] == "iteration" and not run.get("error_occurred"):
            name = run["run_name"].partition("/min_time:")[0]
            times.setdefault(name, []).append(run["real_time"] * SECONDS[run["time_unit"]])
    return {name: statistics.median(of_name) for name, of_name in times.items()}


def spread(times):
    """How far runs of the same lie apart, as a part of their median; the fastest and the slowest of many left out."""
    ordered = sorted(times)
    if len(ordered) >= 5:
        ordered = ordered[1:-1]
    return (ordered[-1] - ordered[0]) / statistics.median(times)


def compare(before, now):
    """Of every benchmark that both have: benchmark -> times of its runs, s, before and now."""
    comparisons = []
    for name in sorted(before.keys() & now.keys()):
        medians = statistics.median(before[name]), statistics.median(now[name])
        ratio = medians[1] / medians[0]
        apart = max(spread(before[name]), spread(now[name]))
        comparisons.append(Comparison(name, *medians, ratio, apart, ratio > 1 + TOLERANCE + apart))
    return comparisons


def run(program, flags):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "times.json"
        line = [program, f"--benchmark_out={out}", "--benchmark_out_format=json", *flags]
        if subprocess.run(line, stdout=subprocess.DEVNULL).returncode != 0 or not out.exists():
            sys.exit(f"{program}: did not run to its end as a benchmark program")
        return times_of_run(json.loads(out.read_text()))


def run_in_turn(programs, runs, flags):
    """For each program: benchmark -> times of its runs. Each goes first every other time."""
    times = [{} for _ in programs]
    for number in range(runs):
        turns = list(zip(programs, times))
        for program, of_program in turns if number % 2 == 0 else reversed(turns):
            print(f"run {number + 1} of {runs}: {program}", file=sys.stderr, flush=True)
            for name, seconds in run(program, flags).items():
                of_program.setdefault(name, []).append(seconds)
    return times


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, check=True, capture_output=True).stdout


def built_at(commit):
    """The benchmarks of an earlier commit, built once."""
    folder = ROOT / "build/baseline" / commit
    program = folder / "build/release/bin/benchmarks"
    if not program.exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["tar", "-x", "-C", folder], input=git("archive", commit), check=True)
        subprocess.run(["cmake", "--preset", "release", "-DESM_BUILD_BENCHMARKS=ON", "-DESM_BUILD_TESTS=OFF",
                        "-DESM_BUILD_EDITOR=OFF"], cwd=folder, check=True)
        subprocess.run(["cmake", "--build", "--preset", "release", "--target", "benchmarks"], cwd=folder, check=True)
    return program


def earlier_program(file):
    if not file.exists():
        sys.exit(f"{file}: does not exist")
    if os.access(file, os.X_OK):
        return file.resolve()
    try:
        commit = str(json.loads(file.read_text())["commit"])
        return built_at(git("rev-parse", "--verify", f"{commit}^{{commit}}").decode().strip())
    except (ValueError, KeyError, TypeError):
        sys.exit(f"{file}: is neither a benchmark program nor a baseline made with --record")
    except subprocess.CalledProcessError:
        sys.exit(f"{file}: the benchmarks of its commit, {commit}, cannot be built from this repository")


def processor():
    names = [line.partition(":")[2].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return f"{len(names)} × {names[0]}" if names else "unknown"


def record(program, file, runs, flags):
    if git("status", "--porcelain", "--untracked-files=no"):
        sys.exit("there are changes that are in no commit: a baseline is of a commit")
    (times,) = run_in_turn([program], runs, flags)
    rows = {name: {"median": statistics.median(of_name), "fastest": min(of_name), "slowest": max(of_name)}
            for name, of_name in sorted(times.items())}
    baseline = {"commit": git("rev-parse", "HEAD").decode().strip(), "processor": processor(), "runs": runs,
                "seconds": rows}
    file.write_text(json.dumps(baseline, indent=1, ensure_ascii=False) + "\n")


def report(before, now):
    """Prints the comparison; whether nothing is slower."""
    comparisons = compare(before, now)
    if not comparisons:
        sys.exit("the two programs have no benchmark in common")
    print(f"{'wall time':<52} {'before µs':>12} {'now µs':>12} {'ratio':>7} {'spread':>7}")
    for row in sorted(comparisons, key=lambda row: row.ratio, reverse=True):
        print(f"{row.name:<52} {1e6 * row.before:12.2f} {1e6 * row.now:12.2f} {row.ratio:7.3f} {100 * row.spread:5.1f} %"
              + ("  slower" if row.is_slower else ""))
    for name in sorted(before.keys() ^ now.keys()):
        print(f"{name:<52} {'only before' if name in before else 'only now'}")
    slower = sum(row.is_slower for row in comparisons)
    print(f"{len(comparisons)} compared, {slower} slower by more than {100 * TOLERANCE:.0f} % beyond the spread")
    return slower == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--against", type=Path, metavar="FILE")
    parser.add_argument("--record", type=Path, metavar="FILE")
    parser.add_argument("--runs", type=int, default=9)
    options, flags = parser.parse_known_args()
    if (options.against is None) == (options.record is None) or options.runs < 1:
        parser.error("give one of --against FILE and --record FILE, and at least one run")
    program = options.program.resolve()
    if options.record:
        record(program, options.record, options.runs, flags)
        return 0
    before, now = run_in_turn([earlier_program(options.against), program], options.runs, flags)
    return 0 if report(before, now) else 1


if __name__ == "__main__":
    sys.exit(main())
