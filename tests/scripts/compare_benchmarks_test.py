import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
import compare_benchmarks as bench  # noqa: E402

# A program that takes as long as it is told, run for run, and writes what Google Benchmark does.
PROGRAM = """#!/usr/bin/env python3
import json, sys
out = next(a.partition("=")[2] for a in sys.argv if a.startswith("--benchmark_out="))
rows = [{{"run_name": name + "/min_time:0.020/repeats:3/real_time", "run_type": "iteration", "real_time": time,
         "time_unit": "us"}} for name, time in {times}.items()]
open(out, "w").write(json.dumps({{"benchmarks": rows}}))
"""


class Compare(unittest.TestCase):
    def is_slower(self, before, now):
        (row,) = bench.compare({"step": before}, {"step": now})
        return row.is_slower

    def test_three_percent_are_let_pass_and_more_is_not(self):
        self.assertFalse(self.is_slower([1.0] * 9, [1.029] * 9))
        self.assertTrue(self.is_slower([1.0] * 9, [1.031] * 9))
        self.assertFalse(self.is_slower([1.0] * 9, [0.5] * 9))

    def test_what_lies_within_the_spread_of_either_is_let_pass(self):
        apart = [1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.05, 1.05]
        self.assertFalse(self.is_slower(apart, [1.07] * 9))
        self.assertFalse(self.is_slower([1.0] * 9, [1.07 * time for time in apart]))
        self.assertTrue(self.is_slower(apart, [1.09] * 9))

    def test_one_run_that_was_disturbed_hides_nothing(self):
        self.assertTrue(self.is_slower([1.0] * 8 + [3.0], [1.05] * 9))
        self.assertFalse(self.is_slower([1.0] * 9, [1.0] * 8 + [3.0]))

    def test_compares_only_what_both_have(self):
        rows = bench.compare({"a": [1.0], "gone": [1.0]}, {"a": [1.0], "new": [1.0]})
        self.assertEqual([row.name for row in rows], ["a"])


class Times(unittest.TestCase):
    def test_are_medians_of_repetitions_in_seconds(self):
        def row(time, kind="iteration", **others):
            return {"run_name": "step, 2 threads/min_time:0.020/repeats:3/real_time", "run_type": kind,
                    "real_time": time, "time_unit": "us", **others}
        report = {"benchmarks": [row(3), row(1), row(2), row(9, "aggregate"), row(9, error_occurred=True)]}
        self.assertEqual(bench.times_of_run(report), {"step, 2 threads": 2e-6})


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def program(self, name, times):
        path = self.folder / name
        path.write_text(PROGRAM.format(times=times))
        path.chmod(0o755)
        return path

    def against(self, before, now):
        return subprocess.run([sys.executable, SCRIPTS / "compare_benchmarks.py", now, "--against", before, "--runs", "3"],
                              capture_output=True, text=True)

    def test_are_run_in_turn_and_the_slower_one_is_named(self):
        old = self.program("old", {"step": 10, "pack": 5})
        self.assertEqual(self.against(old, old).returncode, 0)
        process = self.against(old, self.program("new", {"step": 10, "pack": 6, "more": 1}))
        self.assertEqual(process.returncode, 1)
        self.assertEqual([line for line in process.stdout.splitlines() if line.endswith("  slower")][0].split()[0], "pack")
        turns = [Path(line.split(": ")[1]).name for line in process.stderr.splitlines()]
        self.assertEqual(turns, ["old", "new", "new", "old", "old", "new"])

    def test_what_is_no_baseline_is_refused_in_a_line(self):
        new = self.program("new", {"step": 10})
        for name, content in (("none", None), ("text", "hello"), ("list.json", "[]"), ("empty.json", "{}"),
                              ("lost.json", json.dumps({"commit": "0" * 40}))):
            file = self.folder / name
            if content is not None:
                file.write_text(content)
            process = self.against(file, new)
            self.assertEqual((process.returncode, process.stderr.count("\n")), (1, 1), process.stderr)
            self.assertIn(name, process.stderr)


if __name__ == "__main__":
    unittest.main(buffer=True)
