import os
import re
import signal
import subprocess
import time
import unittest
from pathlib import Path

from esmc import ESMC, Case, finished_processor_time, processor_time


def wait_until_listening(process):
    """Until the program keeps SIGINT for itself: before, the signal would end it while it is still being loaded."""
    sigint = 1 << (signal.SIGINT - 1)
    while process.poll() is None:
        status = Path(f"/proc/{process.pid}/status").read_text()
        if int(re.search(r"SigBlk:\s*(\w+)", status)[1], 16) & sigint:
            return
        time.sleep(0.005)


def wait_until_worked(process, seconds):
    while process.poll() is None and processor_time(process) < seconds:
        time.sleep(0.005)


def read_about(process, file):
    """What /proc tells of a process; nothing once it has ended."""
    try:
        return Path(f"/proc/{process}/{file}").read_bytes()
    except OSError:
        return b""


def processes_of(file):
    """Those whose command line names the file: the program, and what decodes the file for it."""
    running = [int(folder.name) for folder in Path("/proc").glob("[0-9]*")]
    return [process for process in running if os.fsencode(file) in read_about(process, "cmdline")]


def is_held_to_limits(decoder):
    return re.search(rb"Max cpu time +[0-9]", read_about(decoder, "limits")) is not None


def is_running(process):
    """Not when it is a zombie that waits for the system to take it away."""
    state = read_about(process, "stat")
    return state != b"" and b") Z " not in state


class InterruptTest(Case):
    def stopped(self, line, after):
        """Stops what has computed for `after` seconds, of which it must be at work: within a second more."""
        others = finished_processor_time()
        process = subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        wait_until_listening(process)
        wait_until_worked(process, after)
        self.assertIsNone(process.poll(), "the work ended before it could be stopped")
        before = processor_time(process)
        process.send_signal(signal.SIGINT)
        output, error = process.communicate(timeout=120)
        self.assertLess(finished_processor_time() - others - before, 1)
        self.assertEqual((process.returncode, output), (1, ""))
        self.assertRegex(error, r"\Aesmc: [^\n]+\n\Z")

    def test_a_long_run_stops_within_a_second_and_leaves_what_was_there(self):
        project, out = self.sample("liver"), self.file("out.csv", b"what was here before")
        scene = self.file("long.json", {"duration": 100000, "record": {"every": 0.01}})
        self.stopped(["simulate", project, "--scene", scene, "-o", out, "--json"], after=1)
        self.assertEqual(out.read_bytes(), b"what was here before")
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["liver.esm", "long.json", "out.csv"])

    def test_pages_are_baked_all_or_none_and_the_message_is_true(self):
        project, folder = self.sample("tube"), self.file("textures")
        self.done("texture", "pack", project, "--size", "4096", "--pages", "4", "-o", project)
        folder.mkdir()
        first = folder / "texture-1.png"
        for _ in range(3):
            process = subprocess.Popen([ESMC, "texture", "bake", project, "-o", folder], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, text=True)
            while process.poll() is None and not first.exists():
                time.sleep(0.001)
            process.send_signal(signal.SIGINT)
            error = process.communicate(timeout=60)[1]
            self.assertEqual((process.returncode, error), (0, ""))
            self.assertEqual(len(list(folder.iterdir())), 4)
            for page in folder.iterdir():
                page.unlink()
        self.stopped(["texture", "bake", project, "-o", folder], after=0.3)
        self.assertEqual(list(folder.iterdir()), [])

    def test_work_that_reports_no_progress_stops_too(self):
        mesh = self.data("meshes/VH_F_Vasculature.glb")
        for after in (0, 0.2):
            self.stopped(["import", mesh, "-o", self.file("out.esm"), "--detail", "3000"], after)
            self.assertEqual(list(self.folder.iterdir()), [])

    def reading_for_ever(self):
        """A running import, and the decoder that it started, which would never end."""
        mesh = self.file("sleep.ply", b"ply\n")
        stand_in = {**os.environ, "ESM_DECODE": str(Path(ESMC).with_name("decoding_stand_in"))}
        process = subprocess.Popen([ESMC, "import", mesh, "-o", self.file("out.esm")], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True, env=stand_in)
        self.addCleanup(process.kill)
        while process.poll() is None:
            decoders = [found for found in processes_of(mesh) if found != process.pid and is_held_to_limits(found)]
            if decoders:
                return process, decoders[0]
            time.sleep(0.005)
        self.fail(process.communicate()[1])

    def test_reading_a_mesh_stops_and_so_does_its_decoder(self):
        process, decoder = self.reading_for_ever()
        process.send_signal(signal.SIGINT)
        self.assertRegex(process.communicate(timeout=120)[1], r"\Aesmc: stopped[^\n]+\n\Z")
        self.assertEqual(process.returncode, 1)
        self.assertFalse(Path(f"/proc/{decoder}").exists())
        self.assertEqual([path.name for path in self.folder.iterdir()], ["sleep.ply"])

    def test_a_decoder_that_is_killed_costs_a_message(self):
        process, decoder = self.reading_for_ever()
        os.kill(decoder, signal.SIGKILL)
        self.assertRegex(process.communicate(timeout=120)[1],
                         r"\Aesmc: \S+/sleep.ply: [^\n]*the system ended the decoder[^\n]*\n\Z")
        self.assertEqual(process.returncode, 1)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["sleep.ply"])

    def test_a_decoder_ends_with_the_program_that_waits_for_it(self):
        process, decoder = self.reading_for_ever()
        process.kill()
        process.communicate(timeout=120)
        deadline = time.monotonic() + 120
        while is_running(decoder) and time.monotonic() < deadline:
            time.sleep(0.005)
        self.assertFalse(is_running(decoder))


if __name__ == "__main__":
    unittest.main()
