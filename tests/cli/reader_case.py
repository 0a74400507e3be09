"""What the tests of the readers in examples/readers share."""

import csv
import json
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from esmc import Case

READERS = Path(__file__).resolve().parents[2] / "examples" / "readers"
KEPT = sorted((Path(__file__).resolve().parents[1] / "data" / "packages").glob("*.glb"))
sys.path.insert(0, str(READERS))
import esm_package  # noqa: E402: its folder is known only now

PULLED, FORCE = 85, (0, 0, -0.001)
HELD = {"fixed": [{"nodes": list(range(10))}]}


def tissue(spring_constant, viscosity, mass):
    values = {"spring_constant": spring_constant, "viscosity": viscosity, "mass": mass}
    return [word for key, value in values.items() for word in ("--override", f"{key}={value}")]


LIGHT, HEAVIER, OVERDAMPED = tissue(20, 0.01, 0.02), tissue(20, 0.01, 0.5), tissue(20, 10, 0.02)


def size_of(package):
    rest = package.nodes["restPosition"]
    return max(max(rest[axis::3]) - min(rest[axis::3]) for axis in range(3))


def largest_difference(one, other):
    return max(abs(a - b) for a, b in zip(one, other, strict=True))


def json_of(content):
    """The JSON of a package, and the bytes after it."""
    length, = struct.unpack_from("<I", content, 12)
    return json.loads(content[20:20 + length]), content[20 + length:]


def with_json(gltf, rest):
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest


def changed(content, change):
    """A package whose JSON was changed: `change` gets the extension and all of it."""
    gltf, rest = json_of(content)
    change(gltf["extensions"]["ESM_spring_mass"], gltf)
    return with_json(gltf, rest)


class ReaderCase(Case):
    def exported(self, *tissue, project=None, scene=HELD):
        """A package of a tube, or of another project, with that tissue."""
        project, package = project or self.sample("tube"), self.file("organ.glb")
        self.done("tissue", project, "--name", "whole", *tissue, "-o", project)
        self.done("scene", project, "--scene", self.file("held.json", {"duration": 1, **scene}), "-o", project)
        self.done("export", project, "--to", "glb", "-o", package)
        return package

    def light_tube(self, *options):
        """Tissue with so little viscosity that semi-implicit Euler takes long steps."""
        return self.exported(*LIGHT, *options)

    def last_frame(self, file, count):
        with open(file) as table:
            rows = list(csv.DictReader(table))[-count:]
        return [float(row[axis]) for row in rows for axis in "xyz"]

    def simulated(self, package, time_step, steps, integrator="euler", **scene):
        """Where our own program moves the nodes and the surface of a package, with what it holds."""
        read = esm_package.read_package(package)
        duration = steps * time_step
        forces = [{"node": PULLED, "force": FORCE, "from": 0, "to": 2 * duration}] if "moves" not in scene else []
        scene = {"duration": duration, **HELD, "forces": forces, "record": {"every": duration}, **scene}
        self.done("simulate", package, "--scene", self.file("run.json", scene), "--integrator", integrator, "--dt", time_step,
                  "-o", self.file("nodes.csv"), "--surface", self.file("surface.csv"))
        return (self.last_frame(self.file("nodes.csv"), len(read.nodes["mass"])),
                self.last_frame(self.file("surface.csv"), len(read.surface["vertexNodes"])))


@unittest.skipUnless(shutil.which("mcs") and shutil.which("mono"), "no C# compiler is here (mono-mcs, mono-runtime)")
class CSharpCase(ReaderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory(prefix="esmc-test-")
        cls.addClassCleanup(folder.cleanup)
        cls.program = Path(folder.name) / "EsmPackage.exe"
        subprocess.run(["mcs", "-warnaserror", "-define:ESM_PACKAGE_PROGRAM", f"-out:{cls.program}", READERS / "EsmPackage.cs"], check=True)

    def read(self, *arguments):
        return subprocess.run(["mono", self.program, *map(str, arguments)], capture_output=True, text=True, timeout=240)

    def said(self, files):
        """What the reader says of each file, a line each."""
        done = self.read("--each", *files)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), len(files), "more than a line of a file")
        return lines
