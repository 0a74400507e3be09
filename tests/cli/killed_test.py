"""Programs that are killed while they save: what lies there afterwards is the old or the new, whole."""

import random
import subprocess
import time
import unittest

from esmc import ESMC, Case, finished_processor_time, processor_time, rounds_of, seed_of


class KilledTest(Case):
    def killed(self, line, after):
        """Runs the program until it has computed for `after` seconds, and no further."""
        process = subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and processor_time(process) < after:
            time.sleep(0.0005)
        process.kill()
        process.wait()

    def test_a_project_is_the_old_or_the_new_one(self):
        project, changed = self.sample("liver"), self.file("changed.esm")
        self.done("texture", "pack", project, "--size", "2048", "-o", project)
        old = project.read_bytes()
        line = ["tissue", project, "--override", "mass=0.5", "-o"]
        before = finished_processor_time()
        self.done(*line, changed)
        whole, new = finished_processor_time() - before, changed.read_bytes()
        for number in range(rounds_of(10, 1000)):
            seed = seed_of(number)
            with self.subTest(f"seed {seed}"):
                project.write_bytes(old)
                self.killed([*line, project], after=random.Random(seed).uniform(0, 1.1 * whole))
                self.assertIn(project.read_bytes(), (old, new))


if __name__ == "__main__":
    unittest.main()
