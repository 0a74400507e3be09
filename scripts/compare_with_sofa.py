#!/usr/bin/env python3
"""Runs a project's own scene in SOFA and here, and prints a row of the table in docs/simulators.md.

    scripts/compare_with_sofa.py ORGAN.esm --duration SECONDS [--release 26.06] [--damping isotropic|axial] [--dt SECONDS]
                                 [--runsofa PROGRAM] [--esmc PROGRAM]

The project is handed over by `esmc export`, stepped by an installed `runSofa` without a window, and by
`esmc simulate --max-error 1e-4` as the reference. The error is what `esmc tradeoff` means by it: the root of the summed
squares of how far nodes are apart, over that of how far they moved, at twenty times. SOFA writes six digits of a
place, which is the least error that can be told. Ends with 3 where no `runSofa` is found.
"""

import argparse
import csv
import json
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
    process = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if process.returncode:
        raise Failed(f"{command[0]} failed: {process.stderr.strip() or process.stdout.strip()[-500:]}")
    return process.stdout


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


def relative_error(here, there, tolerance):
    """Over all times but the first, of what moved here."""
    times = sorted(here)
    rest = here[times[0]]
    apart = sum(squared(nearest(there, time, tolerance), here[time]) for time in times[1:])
    moved = sum(squared(here[time], rest) for time in times[1:])
    if not moved:
        raise Failed("nothing moves: give the project a scene with a load, by `esmc scene`")
    return (apart / moved) ** 0.5


def with_recorder(scene, state, period):
    """SOFA's scene, which writes the places of the nodes as it runs."""
    tree = ElementTree.parse(scene)
    root = tree.getroot()
    root.insert(0, ElementTree.Element("RequiredPlugin", pluginName="Sofa.Component.Playback"))
    ElementTree.SubElement(root.find("Node"), "WriteState", filename=str(state), time="0", period=str(period), writeX="1")
    recorded = scene.with_name("recorded.scn")
    tree.write(recorded)
    return recorded


def in_sofa(options, folder, period):
    """Frames every so many seconds, seconds of computing, and the step."""
    handed_over = folder / "organ.sofa"
    step = ["--dt", options.dt] if options.dt else []
    told = json.loads(run(options.esmc, "export", options.project, "--to", "sofa", "--sofa", options.release, "--damping",
                          options.damping, *step, "-o", handed_over, "--json"))
    state = folder / "state.txt"
    scene = with_recorder(handed_over / "organ.scn", state, period)
    # One step more, since a state is written as the next step begins.
    steps = round(options.duration / told["dt"]) + 1
    output = run(options.runsofa, "-g", "batch", "-n", steps, scene)
    seconds = re.findall(r"iterations done in ([0-9.e+-]+) s", output)
    if not seconds or not state.exists():
        raise Failed("runSofa ran, and wrote no motion:\n" + output[-2000:])
    return frames_in_sofa(state), float(seconds[-1]), told["dt"]


def here(options, folder):
    """Some twenty of the frames that the scene records, and seconds of computing by the way that is chosen for the organ."""
    run(options.esmc, "simulate", options.project, "--damping", options.damping, "--max-error", "1e-4", "-o",
        folder / "reference.csv", "--json")
    usual = json.loads(run(options.esmc, "simulate", options.project, "--damping", options.damping, "-o", folder / "usual.csv",
                           "--json"))
    frames = frames_here(folder / "reference.csv")
    times = sorted(frames)
    picked = times[:: max(1, (len(times) - 1) // RECORDS)]
    return {time: frames[time] for time in picked}, usual["wall_s"]


def row(options, folder):
    info = json.loads(run(options.esmc, "info", options.project, "--json"))
    reference, seconds_here = here(options, folder)
    there, seconds_there, step = in_sofa(options, folder, sorted(reference)[1])
    error = relative_error(reference, there, step / 2)
    return (f"| {Path(options.project).stem}, {info['nodes']} nodes | SOFA {options.release}, {options.damping} | {1000 * step:g} ms "
            f"| {100 * error:.3g} % | {seconds_there / options.duration:.3g} s | {seconds_here / options.duration:.3g} s |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("project")
    parser.add_argument("--release", default="26.06")
    parser.add_argument("--damping", default="isotropic")
    parser.add_argument("--dt")
    parser.add_argument("--duration", type=float, required=True, help="of the project's scene, s")
    parser.add_argument("--runsofa", default="runSofa")
    parser.add_argument("--esmc", default=ROOT / "build/release/bin/esmc")
    options = parser.parse_args()
    options.runsofa = shutil.which(options.runsofa)
    if not options.runsofa:
        print("no runSofa is installed; name it by --runsofa", file=sys.stderr)
        return 3
    try:
        with tempfile.TemporaryDirectory() as folder:
            print(row(options, Path(folder)))
    except Failed as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
