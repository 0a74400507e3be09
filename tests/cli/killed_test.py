"""Programs that are killed while they write: what lies there afterwards is the old or the new, whole."""

import os
import random
import signal
import subprocess
import time
import unittest
from pathlib import Path

from esmc import ESMC, Case, finished_processor_time, processor_time, rounds_of, seed_of

# In the order in which a file without a name gets one and takes the place of another.
MOMENTS = ("before fsync", "after fsync", "before linkat", "after linkat", "before rename", "after rename")


class KilledTest(Case):
    def works(self):
        """Commands that write, each with the ending of what it writes."""
        project = self.sample("liver")
        self.done("texture", "pack", project, "--size", "2048", "-o", project)
        return {"esm": ["tissue", project, "--override", "mass=0.5"], "glb": ["export", project, "--to", "glb"],
                "vtp": ["export", project, "--to", "vtp"]}

    def outcomes(self, line, ending):
        """The content of a file before and after a command, and the s that the command computes."""
        changed = self.file(f"changed.{ending}")
        before = finished_processor_time()
        self.done(*line, "-o", changed)
        whole, new = finished_processor_time() - before, changed.read_bytes()
        changed.unlink()
        return line[1].read_bytes() if ending == "esm" else new[:len(new) // 2], new, whole

    def remove_whole(self, litter, new):
        """What lies beside the target: at most a file that has its name, and not yet its place, and is whole."""
        self.assertIn([path.read_bytes() for path in litter], ([], [new]))
        for path in litter:
            path.unlink()

    def killed(self, line, after):
        """Runs the program until it has computed for `after` seconds, and no further."""
        process = subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while process.poll() is None and processor_time(process) < after:
            time.sleep(0.0005)
        process.kill()
        process.wait()

    def test_at_any_time_files_are_the_old_or_the_new_ones(self):
        for kind, (ending, line) in enumerate(self.works().items()):
            old, new, whole = self.outcomes(line, ending)
            out, seen = self.file(f"out.{ending}", old), set()
            before = set(self.folder.iterdir())
            for number in range(rounds_of(7, 200)):
                seed = seed_of(1000 * kind + number)
                with self.subTest(f"{ending}, seed {seed}"):
                    out.write_bytes(old)
                    self.killed([*line, "-o", out], after=random.Random(seed).uniform(0, 1.1 * whole))
                    seen.add(out.read_bytes())
                    self.assertLessEqual(seen, {old, new})
                    self.remove_whole(set(self.folder.iterdir()) - before, new)
            self.assertIn(old, seen, "no program was killed before it had written")

    def killed_at(self, line, moment):
        environment = {**os.environ, "LD_PRELOAD": str(Path(ESMC).with_name("signal_at_call.so")),
                       "ESM_SIGNAL_AT": moment, "ESM_SIGNAL": str(int(signal.SIGKILL))}
        process = subprocess.run([ESMC, *map(str, line)], capture_output=True, text=True, env=environment)
        self.assertEqual(process.returncode, -signal.SIGKILL, process.stderr)

    def test_at_the_moments_at_which_a_file_takes_the_place_of_another(self):
        for ending, line in self.works().items():
            old, new, _ = self.outcomes(line, ending)
            out = self.file(f"out.{ending}")
            for moment in MOMENTS:
                with self.subTest(f"{ending}, {moment}"):
                    out.write_bytes(old)
                    before = set(self.folder.iterdir())
                    self.killed_at([*line, "-o", out], moment)
                    self.assertEqual(out.read_bytes(), new if moment == "after rename" else old)
                    litter = set(self.folder.iterdir()) - before
                    self.assertEqual(len(litter), moment in ("after linkat", "before rename"))
                    self.remove_whole(litter, new)


if __name__ == "__main__":
    unittest.main()
