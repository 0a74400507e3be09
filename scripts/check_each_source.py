#!/usr/bin/env python3
"""Lets a compiler read each source by itself and complain: no code is made of it, and nothing is linked.

    scripts/check_each_source.py BUILD      BUILD: a configured folder of Ninja's, sources not compiled together

That every source includes what it uses shows here alone, since a release compiles many together. What the sources
read must be there first: headers that Qt's tools write, and others' headers precompiled. The latter are made by their
own commands, not by Ninja, which would compile first whatever the target links.
"""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path


def written_by_qt(listed):
    """Of Ninja's targets, those that write headers."""
    return re.findall(r"^([^:\n]+_autogen/timestamp): ", listed, re.M)


def precompiles(entry):
    return entry["file"].endswith("/cmake_pch.hxx.cxx")


def command_of(entry):
    words = shlex.split(entry["command"])
    if Path(words[0]).name == "ccache":
        words = words[1:]
    return words if precompiles(entry) else [*words, "-fsyntax-only"]


def complaint_of(entry):
    done = subprocess.run(command_of(entry), cwd=entry["directory"], capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stdout + done.stderr or f"{entry['file']}: not compiled"


def complaints_of(entries):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [text for text in pool.map(complaint_of, entries) if text]


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build = Path(sys.argv[1])
    listed = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], check=True, capture_output=True, text=True)
    subprocess.run(["ninja", "-C", build, *written_by_qt(listed.stdout)], check=True, stdout=subprocess.DEVNULL)
    entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
               if "_autogen/" not in entry["file"]]
    sources = [entry for entry in entries if "/CMakeFiles/" not in entry["file"]]
    complaints = complaints_of(filter(precompiles, entries)) or complaints_of(sources)
    for text in complaints:
        print(text, file=sys.stderr)
    print(f"{len(sources)} sources, each by itself: {len(complaints)} with complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
