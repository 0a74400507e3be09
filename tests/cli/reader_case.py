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


def without_sums(model, _):
    model.pop("checksums", None)


def with_number(content, array_of, place, form, value):
    """A package in which one number of an array is another. `array_of`: of the extension and all JSON the accessor's place."""
    content = bytearray(changed(content, without_sums))
    gltf, rest = json_of(bytes(content))
    accessor = gltf["accessors"][array_of(gltf["extensions"]["ESM_spring_mass"], gltf)]
    offset = gltf["bufferViews"][accessor["bufferView"]].get("byteOffset", 0) + accessor.get("byteOffset", 0)
    struct.pack_into(form, content, len(content) - len(rest) + 8 + offset + 4 * place, value)
    return bytes(content)


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

    def filled(self, *values, **fluids):
        """A package of a closed organ with fluid or what else presses in it, and those as a scene has them."""
        project = self.file("closed.esm")
        self.done("import", self.data("meshes/sofa-liver-coarse.obj"), "--unit", "cm", "-o", project)
        fluids = fluids or {"fillings": [{"part": 0, "stiffness": 2000}]}
        return self.exported(*(values or HEAVIER), project=project, scene={**HELD, **fluids}), fluids

    def with_part_on_one_node(self):
        """A package of two closed parts, of which the first hangs on one node, so that the filled one counts as the first."""
        lines, place = self.data("meshes/sofa-liver-coarse.obj").read_text().splitlines(), "v 2 0 0\nv 2.1 0 0\nv 2 0.1 0\nv 2 0 0.1\n"
        faces = [" ".join(["f", *(str(int(corner.split("/")[0]) + 4) for corner in line.split()[1:])]) for line in lines if line[:2] == "f "]
        mesh = self.file("two.obj", place + "\n".join([line for line in lines if line[:2] == "v "]
                                                      + ["f 1 3 2", "f 1 2 4", "f 2 3 4", "f 1 4 3"] + faces))
        self.done("import", mesh, "--unit", "cm", "-o", self.file("two.esm"))
        content = self.exported(*HEAVIER, project=self.file("two.esm")).read_bytes()
        for vertex in range(4):
            for array in (lambda model, _: model["surface"]["vertexNodes"], lambda model, _: model["drawn"][0]["vertexNodes"]):
                content = with_number(content, array, vertex, "<I", 0)
        fluids = {"fillings": [{"part": 0, "stiffness": 2000}], "pressures": [{"part": 0, "path": [[0, 400]]}]}
        return self.file("organ.glb", changed(content, lambda model, _: model.update(version=9, **fluids))), fluids

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
