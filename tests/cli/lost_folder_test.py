"""Disks that are full, folders that may not be written to or go away meanwhile: the old file stays, and why is said."""

import os
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

from esmc import ESMC, Case

# Works in a folder ($1) with a file system of its own, of which nobody else knows, and copies what is left in it to $2.
ON_ITS_OWN = """mount -t tmpfs -o size=256k none "$1" || exit 77
cp "$2/old" "$1/out" && {prepare}
shift 2
"$@"
result=$?
cp -a "{inside}/." "{left}"
exit $result"""
FULL = 'head -c 1m /dev/zero >"$1/filling" 2>"$2/said"'
READ_ONLY = 'mount -o remount,ro "$1"'


class LostFolderTest(Case):
    def works(self):
        project = self.sample("tube")
        return {"esm": ["tissue", project], "glb": ["export", project, "--to", "glb"],
                "vtp": ["export", project, "--to", "vtp"], "csv": ["simulate", project, "--scene",
                                                                  self.file("short.json", {"duration": 0.01})]}

    def refused_where(self, prepare):
        """Every command that writes over an old file in a file system that was prepared so."""
        for ending, line in self.works().items():
            inside, left = self.folder / f"inside-{ending}", self.folder / f"left-{ending}"
            for folder in (inside, left):
                folder.mkdir()
            (left / "old").write_bytes(b"what was here before")
            script = ON_ITS_OWN.format(prepare=prepare, inside=inside, left=left)
            process = subprocess.run(["unshare", "-rm", "sh", "-c", script, "sh", inside, left, ESMC, *line, "-o",
                                      inside / "out"], capture_output=True, text=True, timeout=240)
            if process.returncode == 77 or "unshare" in process.stderr:
                self.skipTest(f"no file systems of one's own here: {process.stderr.strip()}")
            with self.subTest(ending):
                self.assertEqual(process.returncode, 1)
                self.assertRegex(process.stderr, rf"\Aesmc: {inside}/out: cannot be written: [^\n]+; [^\n]+\n\Z")
                self.assertEqual((left / "out").read_bytes(), b"what was here before")
                self.assertLessEqual({path.name for path in left.iterdir()}, {"old", "out", "filling", "said"})

    def test_a_full_disk(self):
        self.refused_where(FULL)

    def test_a_read_only_folder(self):
        self.refused_where(READ_ONLY)

    def stopped_at(self, line, moment):
        """The program, asleep at a moment of its writing."""
        environment = {**os.environ, "LD_PRELOAD": str(Path(ESMC).with_name("signal_at_call.so")),
                       "ESM_SIGNAL_AT": moment, "ESM_SIGNAL": str(int(signal.SIGSTOP))}
        process = subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   env=environment)
        self.addCleanup(process.kill)
        _, status = os.waitpid(process.pid, os.WUNTRACED)
        self.assertTrue(os.WIFSTOPPED(status), f"ended before it wrote: {process.returncode}")
        return process

    def test_a_folder_that_goes_away(self):
        for ending, line in self.works().items():
            for moment in ("before fsync", "before linkat", "before rename"):
                with self.subTest(f"{ending}, {moment}"):
                    folder = self.folder / "goes"
                    folder.mkdir()
                    process = self.stopped_at([*line, "-o", folder / "out"], moment)
                    shutil.rmtree(folder)
                    process.send_signal(signal.SIGCONT)
                    output, error = process.communicate(timeout=240)
                    self.assertEqual((process.returncode, output), (1, ""))
                    self.assertRegex(error, rf"\Aesmc: {folder}/out: cannot be written: [^\n]+; [^\n]+\n\Z")
                    self.assertFalse(folder.exists())


if __name__ == "__main__":
    unittest.main()
