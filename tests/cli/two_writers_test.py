"""Two processes that change one project: no change is lost, and the one that comes second is told by whom."""

import fcntl
import os
import signal
import struct
import subprocess
import time
import unittest
from pathlib import Path

from esmc import ESMC, Case

F_OFD_SETLK = 37
LOCKED_BYTE = struct.pack("hhqqi4x", fcntl.F_WRLCK, os.SEEK_SET, 1 << 62, 1, 0)


class TwoWritersTest(Case):
    def started(self, *line):
        process = subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def wait_until_locked(self, process, file):
        """Until the process holds a lock on the file, as the system's list of its open files says."""
        while process.poll() is None:
            for entry in Path(f"/proc/{process.pid}/fd").iterdir():
                try:
                    if entry.samefile(file) and "lock:" in Path(f"/proc/{process.pid}/fdinfo/{entry.name}").read_text():
                        return
                except OSError:
                    pass  # closed in the meantime
            time.sleep(0.01)
        self.fail(f"ended without a lock: {process.communicate()}")

    def measuring(self, project):
        """A writer that computes for minutes between reading the project and writing it."""
        scene = self.file("long.json", {"duration": 10000, "forces": [{"node": 85, "force": [0, 0, -1]}]})
        process = self.started("tradeoff", project, "--scene", scene, "--max-seconds", "100", "-o", project)
        self.wait_until_locked(process, project)
        return process

    def test_the_second_of_two_writers_is_refused_and_told_the_first(self):
        project = self.sample("tube")
        first, before = self.measuring(project), project.read_bytes()
        self.done("sample", "vessels", "-o", self.file("photo.png"))
        scene = self.file("still.json", {"duration": 0.1})
        for line in (["tissue", project], ["tissue", self.sample("uterus")], ["scene", project, "--scene", scene],
                     ["texture", "pack", project], ["sample", "liver"], ["tradeoff", project]):
            with self.subTest(line):
                message = self.fails(1, *line, "-o", project, naming=project)
                self.assertIn(f"process {first.pid} ({ESMC} tradeoff", message)
        self.assertEqual(project.read_bytes(), before)
        self.done("info", project)
        self.done("tissue", project, "-o", self.file("other.esm"))

    def test_a_writer_that_was_killed_or_stopped_leaves_no_lock(self):
        project = self.sample("tube")
        files = {"tube.esm", "long.json"}
        for how in (signal.SIGKILL, signal.SIGINT):
            process = self.measuring(project)
            process.send_signal(how)
            process.communicate()
            self.assertEqual({path.name for path in self.folder.iterdir()}, files)
            self.done("tissue", project, "--name", how.name, "-o", project)
        self.assertEqual([region["name"] for region in self.done("info", project)["regions"][-2:]], ["SIGKILL", "SIGINT"])

    def test_the_lock_is_one_that_other_programs_can_take(self):
        project = self.sample("tube")
        with open(project, "r+b") as stream:
            fcntl.fcntl(stream, F_OFD_SETLK, LOCKED_BYTE)
            self.assertIn(f"process {os.getpid()} (", self.fails(1, "tissue", project, "-o", project, naming=project))
        self.done("tissue", project, "-o", project)

    def test_what_came_between_without_a_lock_is_not_lost_either(self):
        project, other = self.sample("tube"), self.sample("liver").read_bytes()
        scene = self.file("short.json", {"duration": 0.1, "forces": [{"node": 85, "force": [0, 0, -1]}]})
        first = self.started("tradeoff", project, "--scene", scene, "--max-seconds", "1", "-o", project)
        self.wait_until_locked(first, project)
        self.file("other.esm", other).replace(project)
        error = first.communicate()[1]
        self.assertEqual(first.returncode, 1)
        self.assertRegex(error, r"\Aesmc: [^\n]*was changed by another program[^\n]*\n\Z")
        self.assertEqual(project.read_bytes(), other)

    def test_no_region_of_many_writers_is_lost(self):
        project = self.sample("tube")
        writers = [self.started("tissue", project, "--name", f"region {i}", "-o", project) for i in range(6)]
        written = []
        for i, process in enumerate(writers):
            process.wait()
            if process.returncode == 0:
                written.append(f"region {i}")
            else:
                self.assertEqual(process.returncode, 1)
                self.assertRegex(process.stderr.read(), "is being changed by|was changed by another program")
        names = [region["name"] for region in self.done("info", project)["regions"]]
        self.assertTrue(written)
        self.assertEqual(sorted(names[1:]), written)


if __name__ == "__main__":
    unittest.main()
