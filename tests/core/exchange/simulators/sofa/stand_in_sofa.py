#!/usr/bin/env python3
"""Stands in for runSofa: lets the nodes of a scene fall freely, by a formula and not by steps, or fails in every way that it may.

    stand_in_sofa.py -g batch -n STEPS SCENE        the environment's SOFA_ROLE says how to fail
"""

import math
import os
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def numbers(text):
    return [float(word) for word in text.split()]


def fallen(rest, gravity, seconds):
    return [x + gravity[i % 3] * seconds * seconds / 2 for i, x in enumerate(rest)]


def states(scene, steps, role):
    """Times and places as WriteState gives them: a state is written as the next step begins."""
    root = ElementTree.parse(scene).getroot()
    step = float(root.get("dt"))
    period = float(root.find(".//WriteState").get("period"))
    rest = numbers(next(node.get("position") for node in root.iter() if node.get("name") == "topology"))
    every = round(period / step)
    for i in range(0, steps, every):
        seconds = i * step
        places = fallen(rest, numbers(root.get("gravity")), seconds * (2 if role == "far" else 1))
        if role == "nan" and i > 0:
            places[4] = math.nan
        yield seconds, places[:-3] if role == "nodes" else places


def write(scene, steps, role):
    lines = [f"T= {seconds:.6g}\n  X= {' '.join(f'{x:.6g}' for x in places)} \n" for seconds, places in states(scene, steps, role)]
    if role == "short":
        lines = lines[:len(lines) // 2]
    text = "".join(lines)
    if role == "cut":
        text = text[:-20]
    Path(ElementTree.parse(scene).getroot().find(".//WriteState").get("filename")).write_text(text)


def hang():
    """With a process of its own, as a program that is started by a script has one."""
    child = subprocess.Popen(["sleep", "infinity"])
    Path(os.environ["SOFA_PROCESSES"]).write_text(f"{os.getpid()} {child.pid}\n")
    time.sleep(1000)


def main():
    role = os.environ.get("SOFA_ROLE", "")
    _, _, _, _, steps, scene = sys.argv
    print("[ERROR]   [PluginManager] Plugin not found: \"Sofa.GL.Component.Rendering3D\"")
    if role == "hang":
        hang()
    if role == "error":
        print("\x1b[31mno such\ncomponent", file=sys.stderr)
        return 1
    if role != "silent":
        write(Path(scene), int(steps), role)
    print(f"[INFO]    [BatchGUI] {steps} iterations done in 1.5 s ( 66 FPS).")
    return 0


if __name__ == "__main__":
    sys.exit(main())
