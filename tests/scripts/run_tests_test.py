"""Tests scripts/run-tests.sh on a build of its own, whose tests are programs that speak as googletest does."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "run-tests.sh"

PASSED = "[ RUN      ] Organ.IsWhole\nall of it\n[       OK ] Organ.IsWhole (1 ms)\n"
FAILED = "[ RUN      ] Organ.IsSoft\nas stone\n[  FAILED  ] Organ.IsSoft (2 ms)\n"
ENDED = "[ RUN      ] Organ.Falls\nfar down\n"
SUMMARY = "[  FAILED  ] 1 test, listed below:\n[  FAILED  ] Organ.IsSoft\n"


class RunTestsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.project = pathlib.Path(folder.name)
        (self.project / "scripts").mkdir()
        shutil.copy(SCRIPT, self.project / "scripts")
        build = self.project / "build" / "release"
        build.mkdir(parents=True)
        preset = {"name": "release", "configurePreset": "release", "output": {"outputOnFailure": True}}
        (self.project / "CMakePresets.json").write_text(json.dumps({
            "version": 6,
            "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": str(build)}],
            "testPresets": [preset]}))

    def run_tests(self, programs, *options):
        """Runs programs that print a text and exit with a status, and gives what is said at the end."""
        build = self.project / "build" / "release"
        for name, (said, status) in programs.items():
            (build / name).write_text(f"cat <<'END'\n{said}END\nexit {status}\n")
        (build / "CTestTestfile.cmake").write_text(
            "".join(f"add_test({name} sh {build / name})\n" for name in programs))
        run = subprocess.run([self.project / "scripts" / "run-tests.sh", "release", *options],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return run.returncode, run.stdout.partition("== What the failed")[2]

    def test_says_again_what_the_failed_said_alone(self):
        status, said = self.run_tests({"organ": (PASSED + FAILED + PASSED + SUMMARY, 1), "other": (PASSED, 0)})
        self.assertNotEqual(status, 0)
        self.assertIn("Organ.IsSoft\nas stone\n", said)
        self.assertNotIn("all of it", said)
        self.assertNotIn("listed below", said)

    def test_names_the_test_that_ended_its_program(self):
        status, said = self.run_tests({"organ": (PASSED + ENDED, 139)})
        self.assertNotEqual(status, 0)
        self.assertIn("Organ.Falls\nfar down\n", said)
        self.assertNotIn("all of it", said)

        self.assertNotIn("end of output", said)

    def test_says_nothing_of_other_programs_and_of_an_earlier_run(self):
        self.run_tests({"organ": (FAILED, 1)})
        status, said = self.run_tests({"script": ("no such organ\n", 1)})
        self.assertNotEqual(status, 0)
        self.assertEqual(said, "")

    def test_asks_for_a_preset(self):
        run = subprocess.run([self.project / "scripts" / "run-tests.sh"], capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("name a preset", run.stderr)

    def test_says_nothing_where_all_pass(self):
        self.assertEqual(self.run_tests({"organ": (PASSED, 0)}), (0, ""))

    def test_hands_options_on(self):
        self.assertEqual(self.run_tests({"organ": (FAILED, 1), "other": (PASSED, 0)}, "-R", "other"), (0, ""))


if __name__ == "__main__":
    unittest.main()
