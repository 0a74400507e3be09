"""Runs the built `esmc` for the tests: ESMC names the program, ESM_DATA the folder of test data."""

import json
import os
import resource
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path

ESMC = os.environ["ESMC"]
DATA = Path(os.environ["ESM_DATA"])

CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 1) for y in (0, 1) for z in (0, 1)) + "".join(
    f"f {face}\n" for face in ("1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"))
PROJECTOR = {"pose": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1], "width": 0.1, "height": 0.1,
             "kind": "parallel"}


def rounds_of(few, many):
    """How many rounds a test runs: as tests/support/rounds.h says."""
    return many if os.environ.get("ESM_LONG_TESTS", "0") not in ("", "0") else few


def seed_of(round):
    """The seed of a round: as tests/support/rounds.h says."""
    return int(os.environ.get("ESM_TEST_SEED") or 0) + round


def processor_time(process):
    """s that a running program has computed: unlike time that passes, the same on a busy machine."""
    fields = Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def finished_processor_time():
    """s that the programs have computed which were started here and have ended."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return children.ru_utime + children.ru_stime


def command(*arguments, **options):
    """The finished process, its output as text."""
    return subprocess.run([ESMC, *map(str, arguments)], capture_output=True, text=True, timeout=240, **options)


class Case(unittest.TestCase):
    """A test in an empty folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="esmc-test-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, content=None):
        """A path in the test's folder; with `content` (text, bytes or JSON) the file is written."""
        path = self.folder / name
        if isinstance(content, bytes):
            path.write_bytes(content)
        elif isinstance(content, str):
            path.write_text(content)
        elif content is not None:
            path.write_text(json.dumps(content))
        return path

    def data(self, name):
        path = DATA / name
        if not path.exists():
            self.skipTest(f"test data not here: {name}")
        return path

    def done(self, *arguments, **options):
        """The JSON object of a command that must succeed and print nothing else."""
        process = command(*arguments, "--json", **options)
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        return json.loads(process.stdout)

    def fails(self, code, *arguments, naming=None, **options):
        """The one line on standard error of a command that must end with `code`."""
        process = command(*arguments, **options)
        self.assertEqual(process.returncode, code, process.stderr)
        self.assertRegex(process.stderr, r"\Aesmc: [^\n]+\n\Z")
        if naming is not None:
            self.assertIn(str(naming), process.stderr)
        return process.stderr

    def sample(self, name="liver"):
        path = self.file(f"{name}.esm")
        self.done("sample", name, "-o", path)
        return path

    def changed_manifest(self, name, change):
        """The tube as a project of that name, its manifest changed."""
        with zipfile.ZipFile(self.sample("tube")) as old, zipfile.ZipFile(self.file(name), "w") as new:
            for entry in old.namelist():
                content = old.read(entry)
                if entry.endswith("manifest.json"):
                    content = json.dumps(change(json.loads(content)))
                new.writestr(entry, content)
        return self.file(name)

    def assertKeys(self, report, types):
        """Every key is there with a value of its type; a tuple names several types."""
        for key, kind in types.items():
            self.assertIn(key, report)
            self.assertIsInstance(report[key], kind, key)
            self.assertFalse(kind in (int, float) and isinstance(report[key], bool), key)
