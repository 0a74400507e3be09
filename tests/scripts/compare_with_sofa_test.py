import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
import compare_with_sofa as sofa  # noqa: E402


class CompareWithSofa(unittest.TestCase):
    def test_the_error_is_that_of_the_motion(self):
        rest, moved = [(0, 0, 0), (1, 0, 0)], [(0, 0, 0), (1, 0, 2)]
        here = {0.0: rest, 0.1: moved}
        self.assertEqual(sofa.relative_error(here, here, 0.01), 0)
        self.assertEqual(sofa.relative_error(here, {0.0: rest, 0.1: rest}, 0.01), 1)
        self.assertAlmostEqual(sofa.relative_error(here, {0.0: rest, 0.1004: [(0, 0, 0), (1, 0, 2.02)]}, 0.01), 0.01)

    def test_a_motion_that_ends_early_is_none(self):
        here = {0.0: [(0, 0, 0)], 0.1: [(0, 0, 1)]}
        with self.assertRaisesRegex(sofa.Failed, "no state at 0.1 s"):
            sofa.relative_error(here, {0.0: [(0, 0, 0)], 0.05: [(0, 0, 0.5)]}, 0.01)
        with self.assertRaisesRegex(sofa.Failed, "nothing moves"):
            sofa.relative_error({0.0: [(0, 0, 0)], 0.1: [(0, 0, 0)]}, here, 0.01)

    def test_digits_that_sofa_leaves_out_are_no_motion(self):
        here = {0.0: [(0.1234564, 0, 0)], 0.1: [(0.1334564, 0, 0)]}
        there = {0.0: [(0.123456, 0, 0)], 0.1: [(0.133456, 0, 0)]}
        self.assertLess(sofa.relative_error(here, there, 0.01), 1e-12)

    def test_a_node_that_begins_elsewhere_is_off_there_alone(self):
        here = {0.0: [(0.1, 0, 0)], 0.1: [(0.2, 0, 0)]}
        self.assertEqual(sofa.relative_error(here, {0.0: [(0.11, 0, 0)], 0.1: [(0.2, 0, 0)]}, 0.01), 0)

    def test_times_are_those_at_which_sofa_writes(self):
        self.assertEqual(sofa.evenly([0, 0.05, 0.1, 0.15000000001, 0.17]), [0, 0.05, 0.1, 0.15000000001])
        self.assertEqual(sofa.evenly([0, 0.17]), [0, 0.17])

    def test_states_are_read_as_sofa_writes_them(self):
        with tempfile.TemporaryDirectory() as folder:
            state = Path(folder) / "state.txt"
            state.write_text("T= 0\n  X= 0 0 0 1 2 3 \nT= 0.1\n  X= 0 0 1 1 2e-1 3 \n")
            self.assertEqual(sofa.frames_in_sofa(state), {0.0: [(0, 0, 0), (1, 2, 3)], 0.1: [(0, 0, 1), (1, 0.2, 3)]})

    def test_without_sofa_it_says_so(self):
        process = subprocess.run([sys.executable, SCRIPTS / "compare_with_sofa.py", "organ.esm", "--runsofa", "no-such-program"], capture_output=True, text=True)
        self.assertEqual((process.returncode, process.stdout), (3, ""))
        self.assertIn("no-such-program", process.stderr)

    def test_another_release_than_the_installed_one_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "runSofa-26.06.00"
            program.write_text("#!/bin/sh\n")
            program.chmod(0o755)
            for options, said in ((["--release", "24.06"], "is of release 26.06"), (["--dt", "0"], "above 0"), (["--dt", "nan"], "above 0")):
                process = subprocess.run([sys.executable, SCRIPTS / "compare_with_sofa.py", "organ.esm", "--runsofa", program, *options],
                                         capture_output=True, text=True)
                self.assertEqual((process.returncode, process.stdout), (1, ""))
                self.assertIn(said, process.stderr)


if __name__ == "__main__":
    unittest.main()
