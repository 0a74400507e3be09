import hashlib
import json
import os
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

from detail_test import surface
from esmc import Case, command
from reader_case import esm_package, json_of

HERE = Path(__file__).parent
SAID = {"title": "Leber „A“", "author": "A. N. Other", "date": "2026-05-17", "licence": "CC BY 4.0"}
VALIDATOR = """
const validator = require("gltf-validator"), fs = require("fs");
Promise.all(process.argv.slice(1).map(file => validator.validateBytes(new Uint8Array(fs.readFileSync(file)))))
  .then(reports => console.log(JSON.stringify(reports.map(report => report.issues))));
"""


def gltf_of(package):
    content = package.read_bytes()
    size, = struct.unpack_from("<I", content, 12)
    return json.loads(content[20:20 + size])


def by_attributes(content):
    """Of all primitives the triangles between surface vertices, and by vertex every place and mass that it is drawn with: without the extension."""
    gltf, container, triangles, drawn = json_of(content)[0], esm_package.Container(content), [], {}
    for primitive in (primitive for mesh in gltf["meshes"] for primitive in mesh["primitives"]):
        attributes = primitive["attributes"]
        vertices = [int(number) for number in container.numbers(attributes["_ESM_VERTEX"], "SCALAR")]
        places = esm_package.rows(container.numbers(attributes["POSITION"], "VEC3"), 3)
        for vertex, place, mass in zip(vertices, places, container.numbers(attributes["_ESM_MASS"], "SCALAR"), strict=True):
            drawn.setdefault(vertex, []).append((place, mass))
        triangles += esm_package.rows([vertices[corner] for corner in container.numbers(primitive["indices"], "SCALAR")], 3)
    return triangles, drawn


def has_validator():
    node = shutil.which("node")
    return node and subprocess.run([node, "-e", "require('gltf-validator')"], capture_output=True).returncode == 0


class PackageTest(Case):
    def imported(self, *options, obj=surface()):
        mesh, self.project, self.package = self.file("organ 1.obj", obj), self.file("organ.esm"), self.file("organ.glb")
        self.done("import", mesh, "-o", self.project, *options)
        return hashlib.sha256(mesh.read_bytes()).hexdigest()

    def exported(self, *options):
        self.done("export", self.project, "--to", "glb", "-o", self.package, *options)
        return self.package

    def read(self, *options):
        reader = subprocess.run([sys.executable, HERE / "read_package.py", self.package, *map(str, options)],
                                capture_output=True, text=True)
        self.assertEqual((reader.returncode, reader.stderr), (0, ""))

    def test_project_and_package_name_the_file_of_the_mesh_with_its_hash(self):
        source = {"file": "organ 1.obj", "sha256": self.imported()}
        self.assertEqual(self.done("info", self.project)["source"], source)
        self.done("tissue", self.project, "--override", "viscosity=3", "-o", self.project)
        told = self.done("info", self.exported())
        self.assertEqual(told["source"], source)
        self.assertEqual([told[key] for key in SAID], [None] * 4)
        self.assertIn("Elastodynamic Shape Modeler", told["program"])
        self.read("--project", self.project)

    def test_a_sample_comes_from_no_file(self):
        self.assertIsNone(self.done("info", self.sample("tube"))["source"])

    def test_who_exports_says_who_made_it(self):
        self.imported()
        words = [word for key, value in SAID.items() for word in ("--" + key, value)]
        told = self.done("info", self.exported(*words))
        self.assertEqual({key: told[key] for key in SAID}, SAID)
        self.read()
        text = command("info", self.package).stdout
        for value in SAID.values():
            self.assertIn(value, text)
        message = self.fails(2, "export", self.project, "--to", "vtp", "-o", self.file("a.vtp"), *words)
        self.assertIn("--title", message)

    def test_attributes_alone_give_the_surface_and_its_masses(self):
        for layout in ([], ["--layout", "charts"]):
            self.imported()
            self.done("texture", "pack", self.project, "--size", 512, *layout, "-o", self.project)
            package = esm_package.read_package(self.exported())
            triangles, drawn = by_attributes(self.package.read_bytes())
            surface, mass = package.surface, package.nodes["mass"]
            self.assertGreater(sum(map(len, drawn.values())), len(drawn), "no vertex is drawn twice")
            self.assertEqual(sorted(triangles), sorted(esm_package.rows(surface["triangles"], 3)))
            self.assertEqual(sorted(drawn), list(range(len(surface["vertexNodes"]))))
            for vertex, shown in drawn.items():
                self.assertEqual(set(shown), {(esm_package.at(surface["restPosition"], vertex), mass[surface["vertexNodes"][vertex]])})
            self.assertAlmostEqual(sum(shown[0][1] for shown in drawn.values()) / sum(mass), 1, delta=1e-12)

    def test_nothing_of_a_package_comes_from_the_clock(self):
        self.imported()
        first = self.exported().read_bytes()
        os.utime(self.project, (1, 1))
        with_other_clock = dict(os.environ, TZ="Pacific/Auckland", USER="somebody", LOGNAME="somebody")
        self.done("export", self.project, "--to", "glb", "-o", self.package, env=with_other_clock)
        self.assertEqual(self.package.read_bytes(), first)

    def test_a_changed_number_is_refused_by_name(self):
        self.imported()
        content = bytearray(self.exported().read_bytes())
        gltf = gltf_of(self.package)
        accessor = gltf["accessors"][gltf["extensions"]["ESM_spring_mass"]["nodes"]["mass"]]
        json_size, = struct.unpack_from("<I", content, 12)
        content[28 + json_size + gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]] ^= 1
        for line in (["info"], ["validate"], ["stability"], ["simulate", "-o", self.file("out.csv")]):
            message = self.fails(1, line[0], self.file("bad.glb", bytes(content)), *line[1:])
            self.assertIn("nodes.mass is damaged", message)

    @unittest.skipUnless(has_validator(), "node finds no gltf-validator here: npm install gltf-validator, and NODE_PATH")
    def test_khronos_validator_finds_neither_errors_nor_warnings(self):
        packages = []

        def add(*options):
            packages.append(self.file(f"{len(packages)}.glb"))
            self.done("export", self.project, "--to", "glb", "-o", packages[-1], *options)

        for options in ([], ["--detail", 60], ["--detail", "rigid"], ["--fill", "body-centred", "--spacing", 0.02],
                        ["--fill", "prisms", "--wall-thickness", 0.003], ["--bending", 0.003]):
            self.imported(*options)
            add("--author", "ü")
        self.project = self.sample("uterus")
        add()
        self.project = self.sample("liver")
        photo, pose = self.file("photo.png"), self.file("pose.json", {
            "pose": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1], "width": 0.3, "height": 0.3, "kind": "parallel"})
        self.done("sample", "vessels", "-o", photo)
        self.done("texture", "photo", self.project, "--photo", photo, "--projector", pose, "--name", "vessels",
                  "-o", self.project)
        add()
        self.done("texture", "finish", self.project, "--layer", "vessels", "--preset", "fat", "--relief", 2, "-o",
                  self.project)
        add("--pictures", "jpeg")
        run = subprocess.run(["node", "-e", VALIDATOR, *map(str, packages)], capture_output=True, text=True, check=True)
        for package, issues in zip(packages, json.loads(run.stdout)):
            found = [issue for issue in issues["messages"] if issue["severity"] < 2]
            self.assertEqual(found, [], package)


if __name__ == "__main__":
    unittest.main()
