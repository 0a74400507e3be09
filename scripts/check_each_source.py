#!/usr/bin/env python3
"""Lets a compiler read each source by itself and complain: no code is made of it, and nothing is linked.

    scripts/check_each_source.py BUILD      BUILD: a configured folder of Ninja's, sources not compiled together

That every source includes what it uses shows here alone, since a release compiles many together. What the sources
read must be there first: headers that Qt's tools write, and others' headers precompiled.
"""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path


def prerequisites(listed):
    """Of Ninja's targets, those that make what sources read."""
    return re.findall(r"^([^:\n]+(?:_autogen/timestamp|\.pch)): ", listed, re.M)


def command_of(entry):
    words = shlex.split(entry["command"])
    if Path(words[0]).name == "ccache":
        words = words[1:]
    return [*words, "-fsyntax-only"]


def complaint_of(entry):
    done = subprocess.run(command_of(entry), cwd=entry["directory"], capture_output=True, text=True)
    return "" if done.returncode == 0 else done.stdout + done.stderr or f"{entry['file']}: not compiled"


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    build = Path(sys.argv[1])
    listed = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], check=True, capture_output=True, text=True)
    subprocess.run(["ninja", "-C", build, *prerequisites(listed.stdout)], check=True, stdout=subprocess.DEVNULL)
    entries = [entry for entry in json.loads((build / "compile_commands.json").read_text())
               if "_autogen/" not in entry["file"] and "/CMakeFiles/" not in entry["file"]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = [text for text in pool.map(complaint_of, entries) if text]
    for text in complaints:
        print(text, file=sys.stderr)
    print(f"{len(entries)} sources, each by itself: {len(complaints)} with complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
