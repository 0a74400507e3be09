#!/usr/bin/env python3
"""Runs a project's own scene in SOFA and here, and prints a row of the table in docs/simulators.md.

    scripts/compare_with_sofa.py ORGAN.esm [--release VERSION] [--damping isotropic|axial] [--dt SECONDS]
                                 [--runsofa PROGRAM] [--esmc PROGRAM]

The project is handed over by `esmc export`, stepped by an installed `runSofa` without a window, and by
`esmc simulate --max-error 1e-4` as the reference. The error is what `esmc tradeoff` means by it: the root of the summed
squares of how far nodes are apart, over that of how far they moved, at twenty times. SOFA writes six digits of a
place; what nodes that stand still lose by that is taken out. It draws nothing. SOFA is what --runsofa names, or the
environment's ESM_RUNSOFA, or the first `runSofa` on the PATH. Ends with 3 where there is none. Columns of the row:
organ, release and damping, step, error, and s that a second of motion takes in SOFA and here.
"""

import argparse
import csv
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RECORDS = 20


class Failed(Exception):
    """What went wrong, in words."""


def run(*command):
    try:
        process = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    except OSError as error:
        raise Failed(f"{command[0]} cannot be run: {error.strerror}") from None
    if process.returncode:
        raise Failed(f"{command[0]} failed: {process.stderr.strip() or process.stdout.strip()[-500:]}")
    return process.stdout


def say(what):
    """Where the row is printed nothing else is."""
    print(what, file=sys.stderr, flush=True)


def release_of(program):
    """By the name of the file that its links end at, runSofa-26.06.00; the newest without."""
    found = re.match(r"runSofa-(\d+\.\d+)", Path(program).resolve().name)
    return found and found[1]


def checked(options):
    """Whoever is wrong is told before the work. SOFA loads a scene of another release and moves it otherwise."""
    if options.dt is not None and not 0 < options.dt < math.inf:
        raise Failed("--dt: is to be above 0 s")
    installed = release_of(options.runsofa)
    if installed and options.release and installed != options.release:
        raise Failed(f"{options.runsofa} is of release {installed}; leave --release out, or name another by --runsofa")
    options.release = options.release or installed or "26.06"
    return options


def frames_here(table):
    """time -> places of all nodes, from a trajectory of `esmc simulate`."""
    frames = {}
    with open(table, newline="") as rows:
        for row in csv.DictReader(rows):
            place = tuple(float(row[axis]) for axis in "xyz")
            frames.setdefault(float(row["time"]), []).append(place)
    return frames


def frames_in_sofa(state):
    """The same from what WriteState has written."""
    frames, time = {}, None
    for line in state.read_text().splitlines():
        key, _, values = line.strip().partition("=")
        if key == "T":
            time = float(values)
        elif key == "X":
            numbers = [float(word) for word in values.split()]
            frames[time] = list(zip(*[iter(numbers)] * 3))
    return frames


def nearest(frames, time, tolerance):
    found = min(frames, key=lambda other: abs(other - time))
    if abs(found - time) > tolerance:
        raise Failed(f"SOFA has no state at {time} s; its nearest is at {found} s")
    return frames[found]


def squared(first, second):
    return sum((a - b) ** 2 for one, other in zip(first, second) for a, b in zip(one, other))


def rounded_off(place, written):
    """More than rounding is a way: led nodes are a step ahead as SOFA begins."""
    return place - written if abs(place - written) <= 1e-5 * abs(place) else 0


def relative_error(here, there, tolerance):
    """Over all times but the first, of what moved here, from where both are at rest."""
    times = sorted(here)
    rest, written = here[times[0]], nearest(there, times[0], tolerance)
    lost = [[rounded_off(a, b) for a, b in zip(*places)] for places in zip(rest, written, strict=True)]

    def from_rest(frame):
        return [[a + b for a, b in zip(*places)] for places in zip(frame, lost)]
    apart = sum(squared(from_rest(nearest(there, time, tolerance)), here[time]) for time in times[1:])
    moved = sum(squared(here[time], rest) for time in times[1:])
    if not moved:
        raise Failed("nothing moves: give the project a scene with a load, by `esmc scene`")
    return (apart / moved) ** 0.5


def with_recorder(scene, state, period):
    """SOFA's scene, which writes the places of the nodes as it runs, without the surface that nobody sees."""
    tree = ElementTree.parse(scene)
    root = tree.getroot()
    for node in root.iter("Node"):
        for surface in node.findall("Node[@name='surface']"):
            node.remove(surface)
    root.insert(0, ElementTree.Element("RequiredPlugin", pluginName="Sofa.Component.Playback"))
    ElementTree.SubElement(root.find("Node"), "WriteState", filename=str(state), time="0", period=str(period), writeX="1")
    recorded = scene.with_name("recorded.scn")
    tree.write(recorded)
    return recorded


def in_sofa(options, folder, period, duration):
    """Frames every so many seconds, seconds of computing, and the step."""
    handed_over = folder / "organ.sofa"
    export = [options.esmc, "export", options.project, "--to", "sofa", "--sofa", options.release, "--damping", options.damping,
              "-o", handed_over, "--json"]
    longest = options.dt or json.loads(run(*export, "--dry-run"))["dt"]
    step = period / math.ceil(period / longest - 1e-9)
    if step < 0.99 * longest:
        say(f"steps of {1000 * step:g} ms in place of {1000 * longest:g} ms, so that states are written every {period:g} s")
    run(*export, "--dt", step)
    state = folder / "state.txt"
    scene = with_recorder(handed_over / "organ.scn", state, period)
    # One step more, since a state is written as the next step begins.
    steps = round(duration / step) + 1
    say(f"in SOFA, {steps} steps of {1000 * step:g} ms")
    output = run(options.runsofa, "-g", "batch", "-n", steps, scene)
    seconds = re.findall(r"iterations done in ([0-9.e+-]+) s", output)
    if not seconds or not state.exists():
        raise Failed("runSofa ran, and wrote no motion:\n" + output[-2000:])
    return frames_in_sofa(state), float(seconds[-1]), step


def evenly(times):
    """Without the end of a run that ends between two records: SOFA writes at multiples of a time alone."""
    count = times[-1] / times[1]
    return times if abs(count - round(count)) < 1e-6 else times[:-1]


def here(options, folder):
    """Some twenty of the frames that the scene records, and what `esmc` says of a run by the way that is chosen for the organ."""
    say("here, to 1e-4 of the motion")
    run(options.esmc, "simulate", options.project, "--damping", options.damping, "--max-error", "1e-4", "-o",
        folder / "reference.csv", "--json")
    say("here, in the usual way")
    usual = json.loads(run(options.esmc, "simulate", options.project, "--damping", options.damping, "-o", folder / "usual.csv",
                           "--json"))
    frames = frames_here(folder / "reference.csv")
    times = sorted(frames)
    return {time: frames[time] for time in evenly(times[:: max(1, (len(times) - 1) // RECORDS)])}, usual


def row(options, folder):
    info = json.loads(run(options.esmc, "info", options.project, "--json"))
    reference, usual = here(options, folder)
    duration = usual["simulated_s"]
    there, seconds_there, step = in_sofa(options, folder, sorted(reference)[1], duration)
    error = relative_error(reference, there, step / 2)
    return (f"| {Path(options.project).stem}, {info['nodes']} nodes | SOFA {options.release}, {options.damping} | {1000 * step:g} ms "
            f"| {100 * error:.3g} % | {seconds_there / duration:.3g} s | {usual['wall_s'] / duration:.3g} s |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("project")
    parser.add_argument("--release", help="of SOFA, where its program's name does not say it")
    parser.add_argument("--damping", default="isotropic")
    parser.add_argument("--dt", type=float, help="s; a little less where states are to be written in between")
    parser.add_argument("--runsofa", default=os.environ.get("ESM_RUNSOFA", "runSofa"))
    parser.add_argument("--esmc", default=ROOT / "build/release/bin/esmc")
    options = parser.parse_args()
    if not shutil.which(options.runsofa):
        print(f"{options.runsofa}: there is no such program; name SOFA's by --runsofa or ESM_RUNSOFA", file=sys.stderr)
        return 3
    options.runsofa = shutil.which(options.runsofa)
    try:
        checked(options)
        with tempfile.TemporaryDirectory() as folder:
            print(row(options, Path(folder)))
    except Failed as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
