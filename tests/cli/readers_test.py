import csv
import json
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from esmc import Case, command, rounds_of, seed_of

ROOT = Path(__file__).resolve().parents[2]
READERS = ROOT / "examples" / "readers"
KEPT = sorted((ROOT / "tests" / "data" / "packages").glob("*.glb"))
sys.path.insert(0, str(READERS))
import esm_package  # noqa: E402: its folder is known only now

PULLED, FORCE = 85, (0, 0, -0.001)
HELD = {"fixed": [{"nodes": list(range(10))}]}


def size_of(package):
    rest = package.nodes["restPosition"]
    return max(max(rest[axis::3]) - min(rest[axis::3]) for axis in range(3))


def largest_difference(one, other):
    return max(abs(a - b) for a, b in zip(one, other, strict=True))


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
        return self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.02", *options)

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


class PythonReaderTest(ReaderCase):
    def agrees(self, file, time_step, steps, within, integrator="euler", **scene):
        """That both move alike, to a part of the organ's size, and move at all."""
        nodes, surface = self.simulated(file, time_step, steps, integrator, **scene)
        package = esm_package.read_package(file)
        motion = esm_package.Motion(package, integrator)
        for _ in range(steps):
            motion.step(time_step, {PULLED: FORCE})
        size = size_of(package)
        self.assertGreater(largest_difference(package.nodes["restPosition"], nodes), 1e-4 * size)
        self.assertLess(largest_difference(motion.positions, nodes), within * size)
        self.assertLess(largest_difference(esm_package.carried(package, motion.positions), surface), within * size)

    def test_reads_every_kept_package(self):
        self.assertGreater(len(KEPT), 10)
        for file in KEPT:
            package, info = esm_package.read_package(file), self.done("info", file)
            self.assertEqual((len(package.nodes["mass"]), len(package.springs["restLength"])), (info["nodes"], info["springs"]), file)
            self.assertEqual(len(package.surface["triangles"]), 3 * info["triangles"], file)

    def test_moves_light_tissue_as_we_do(self):
        self.agrees(self.light_tube(), 3e-4, 1000, 1e-12)

    def test_moves_a_wall_that_bends_as_we_do(self):
        project = self.sample("tube")
        self.done("tissue", project, "--bending", "0.002", "-o", project)
        self.agrees(self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.02",
                                  project=project), 2e-4, 100, 1e-12)

    def test_moves_springs_that_stiffen_as_we_do(self):
        self.agrees(self.light_tube("--biphasic", "0.01", "8"), 1e-4, 1000, 1e-12)

    def test_moves_overdamped_tissue_as_we_do(self):
        self.agrees(self.exported("--override", "spring_constant=20", "--override", "viscosity=10", "--override", "mass=0.02"),
                    5e-3, 40, 1e-10, "split")

    def test_moves_a_surface_over_fewer_nodes_as_we_do(self):
        project = self.file("coarse.esm")
        self.done("import", self.data("meshes/sks-liver-coloured.ply"), "--unit", "mm", "--detail", "200", "-o", project)
        package = self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.5",
                                project=project)
        self.agrees(package, 2e-4, 300, 1e-12)

    def test_moves_a_filled_body_as_we_do(self):
        project = self.file("solid.esm")
        self.done("import", self.data("meshes/sofa-liver-coarse.obj"), "--unit", "cm", "--fill", "body-centred", "--spacing", "0.006",
                  "-o", project)
        self.agrees(self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.5",
                                  project=project), 1e-4, 200, 1e-12)

    def test_leads_nodes_as_we_do(self):
        file, steps, time_step = self.light_tube(), 200, 3e-4
        way = [0.002, 0, -0.001]
        nodes, _ = self.simulated(file, time_step, steps, moves=[{"node": PULLED, "path": [[0, 0, 0, 0], [steps * time_step, *way]]}])
        package = esm_package.read_package(file)
        motion, rest = esm_package.Motion(package), package.nodes["restPosition"][3 * PULLED:3 * PULLED + 3]
        for step in range(1, steps + 1):
            motion.step(time_step, led={PULLED: [a + step / steps * b for a, b in zip(rest, way)]})
        self.assertLess(largest_difference(motion.positions, nodes), 1e-12 * size_of(package))

    def test_moves_fluid_as_we_do(self):
        project = self.file("closed.esm")
        self.done("import", self.data("meshes/sofa-liver-coarse.obj"), "--unit", "cm", "-o", project)
        fluid = {"fillings": [{"part": 0, "stiffness": 2000}]}
        file = self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.5",
                             project=project, scene={**HELD, **fluid})
        self.agrees(file, 5e-5, 300, 1e-12, **fluid)

    def test_as_numpy_it_is_the_same_memory(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("NumPy is not here")
        package = esm_package.read_package(KEPT[0])
        rest = esm_package.shaped(package.nodes["restPosition"], 3)
        self.assertEqual(rest.shape, (len(package.nodes["mass"]), 3))
        rest[1, 2] = 7
        self.assertEqual(package.nodes["restPosition"][5], 7)


def damaged(content, random):
    """Bytes that were changed, or an end that was cut off."""
    content = bytearray(content)
    if random.random() < 0.2:
        return bytes(content[:random.randrange(len(content))])
    for _ in range(random.randrange(1, 20)):
        content[random.randrange(min(len(content), 6000))] = random.randrange(256)
    return bytes(content)


OTHER_VALUES = [None, True, -1, 0, 1, 10 ** 9, 1 << 40, 1.5, float("inf"), float("nan"), "", "SCALAR", [], [{}], {}]


def places_in(json, way=()):
    """The way to each value that another holds."""
    for key, value in (json.items() if isinstance(json, dict) else enumerate(json) if isinstance(json, list) else ()):
        yield (*way, key)
        yield from places_in(value, (*way, key))


def change_json(model, gltf, random):
    """Takes a value out of a package, or puts another in its place, mostly without check sums, which would notice all of it."""
    if random.random() < 0.7:
        model.pop("checksums", None)
    holder = random.choice([model, gltf])
    *way, last = random.choice(list(places_in(holder)))
    for key in way:
        holder = holder[key]
    if random.random() < 0.3:
        del holder[last]
    else:
        holder[last] = random.choice(OTHER_VALUES)


class DamagedPackageTest(ReaderCase):
    def refused(self, file):
        """The message of the reader that refuses it; None where it can be read."""
        try:
            esm_package.read_package(file)
        except esm_package.PackageError as problem:
            self.assertNotIn("\n", str(problem))
            return str(problem)

    def changed(self, source, change):
        """A package whose extension was changed."""
        content = source.read_bytes()
        length, = struct.unpack_from("<I", content, 12)
        gltf = json.loads(content[20:20 + length])
        change(gltf["extensions"]["ESM_spring_mass"], gltf)
        text = json.dumps(gltf).encode()
        text += b" " * (-len(text) % 4)
        rest = content[20 + length:]
        return self.file("changed.glb", struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) + text + rest)

    def test_names_what_is_wrong(self):
        source = KEPT[1]
        self.assertIn("cut off", self.refused(self.file("cut.glb", source.read_bytes()[:-4])))
        self.assertIn("glTF", self.refused(self.file("text.glb", "a text that is no package at all")))
        for word, change in (
                ("version 10", lambda model, _: model.update(version=10)),
                ("damps", lambda model, _: model.update(damping="axial")),
                ("no springs", lambda model, _: model.pop("springs")),
                ("springs", lambda model, _: model["springs"].update(count=-1)),
                ("elements", lambda model, _: model["nodes"].update(count=7)),
                ("mean", lambda model, _: model["springs"].update(springConstant=model["springs"]["restLength"])),
                ("accessors", lambda model, _: model["nodes"].update(mass=10 ** 9)),
                ("sheet", lambda model, _: model.update(sheet=7)),
                ("beyond", lambda _, gltf: gltf["bufferViews"][0].update(byteLength=1 << 40))):
            self.assertIn(word, self.refused(self.changed(source, change)) or "was read")

    def test_notices_a_flipped_bit(self):
        source = next(file for file in KEPT if "checksums" in esm_package.read_package(file).json)
        content = bytearray(source.read_bytes())
        start = 20 + struct.unpack_from("<I", content, 12)[0] + 8
        content[start + 2] ^= 1
        self.assertIn("check sum", self.refused(self.file("flipped.glb", bytes(content))) or "was read")
        self.assertIn("no bufferViews", self.refused(self.changed(source, lambda _, gltf: gltf.pop("bufferViews"))) or "was read")

    def test_never_breaks_on_damage(self):
        seen = 0
        for round in range(rounds_of(200, 5000)):
            source = random.Random(seed_of(round))
            content = damaged(source.choice(KEPT).read_bytes(), source)
            seen += self.refused(self.file("damaged.glb", content)) is not None
        self.assertGreater(seen, 50)

    def test_never_breaks_on_changed_json(self):
        seen = 0
        for round in range(rounds_of(200, 5000)):
            source = random.Random(seed_of(round))
            seen += self.refused(self.changed(source.choice(KEPT), lambda model, gltf: change_json(model, gltf, source))) is not None
        self.assertGreater(seen, 50)


@unittest.skipUnless(shutil.which("mcs") and shutil.which("mono"), "no C# compiler is here (mono-mcs, mono-runtime)")
class CSharpReaderTest(ReaderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory(prefix="esmc-test-")
        cls.addClassCleanup(folder.cleanup)
        cls.program = Path(folder.name) / "EsmPackage.exe"
        subprocess.run(["mcs", "-warnaserror", "-define:ESM_PACKAGE_PROGRAM", f"-out:{cls.program}", READERS / "EsmPackage.cs"], check=True)

    def read(self, *arguments):
        return subprocess.run(["mono", self.program, *map(str, arguments)], capture_output=True, text=True, timeout=240)

    def test_reads_every_kept_package(self):
        for file in KEPT:
            info, hinges, done = self.done("info", file), esm_package.read_package(file).hinges, self.read(file)
            self.assertEqual((done.returncode, done.stderr), (0, ""), file)
            count = len(hinges.get("stiffness", ()))
            self.assertEqual(done.stdout, f"{info['nodes']} nodes, {info['springs']} springs, {count} hinges\n")

    def agrees(self, file, time_step, steps):
        nodes, surface = self.simulated(file, time_step, steps)
        done = self.read(file, steps, time_step, PULLED, *FORCE)
        self.assertEqual(done.stderr, "")
        found = [[float(number) for number in line.split()] for line in done.stdout.splitlines()[1:]]
        size = size_of(esm_package.read_package(file))
        self.assertLess(largest_difference(found[0], nodes), 1e-12 * size)
        self.assertLess(largest_difference(found[1], surface), 1e-12 * size)

    def test_moves_light_tissue_as_we_do(self):
        self.agrees(self.light_tube(), 3e-4, 1000)

    def test_moves_a_wall_that_bends_and_stiffens_as_we_do(self):
        project = self.sample("tube")
        self.done("tissue", project, "--bending", "0.002", "-o", project)
        self.agrees(self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.02",
                                  "--biphasic", "0.01", "2", project=project), 1e-4, 300)

    def test_moves_a_surface_over_fewer_nodes_as_we_do(self):
        project = self.file("coarse.esm")
        self.done("import", self.data("meshes/sks-liver-coloured.ply"), "--unit", "mm", "--detail", "200", "-o", project)
        self.agrees(self.exported("--override", "spring_constant=20", "--override", "viscosity=0.01", "--override", "mass=0.5",
                                  project=project), 2e-4, 300)

    def test_notices_a_flipped_bit(self):
        source = next(file for file in KEPT if "checksums" in esm_package.read_package(file).json)
        content = bytearray(source.read_bytes())
        content[20 + struct.unpack_from("<I", content, 12)[0] + 8 + 2] ^= 1
        self.assertIn("check sum", self.read(self.file("flipped.glb", bytes(content))).stderr)

    def test_refuses_what_is_damaged(self):
        refused = 0
        for round in range(rounds_of(10, 300)):
            source = random.Random(seed_of(round))
            done = self.read(self.file("damaged.glb", damaged(source.choice(KEPT).read_bytes(), source)))
            self.assertIn(done.returncode, (0, 1), done.stderr)
            if done.returncode:
                self.assertRegex(done.stderr, r"\A[^\n]+damaged\.glb: [^\n]+\n\Z")
            refused += done.returncode
        self.assertGreater(refused, 0)


if __name__ == "__main__":
    unittest.main()
