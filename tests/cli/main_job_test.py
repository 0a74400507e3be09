"""The whole way on organs as they come: import, tissue, poke, photo, package, pictures.

Pictures stay in ESM_PICTURES, where that is set, to be looked at."""

import csv
import math
import os
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

from esmc import Case, command
from import_test import IMPORT_KEYS

INFO_KEYS = {**IMPORT_KEYS, "regions": list, "photos": list, "textures": int, "fuzzy_systems": list,
             "critical_dt": dict, "fixed": int, "tethers": int, "instrument": bool}


class MainJobTest(Case):
    def whole_way(self, name, mesh, *options, photo):
        project, package = self.file(f"{name}.esm"), self.file(f"{name}.glb")
        imported = self.done("import", self.data(f"meshes/{mesh}"), "-o", project, *options)
        self.assertKeys(imported, IMPORT_KEYS)
        centre, size = imported["centre"], imported["size"]
        front = max(self.nodes_of(project), key=lambda node: node[2])
        self.mark(project, front, max(size) / 4, imported)
        self.poke(project, front, max(size))
        self.photograph(project, centre, size, self.data(f"images/{photo}"))
        self.hand_over(project, package)
        self.draw(project, name)
        return imported

    def nodes_of(self, project):
        scene = self.file("still.json", {"duration": 1e-6})
        self.done("simulate", project, "--scene", scene, "--dt", "1e-6", "-o", self.file("rest.csv"))
        rest = self.rows("rest.csv")
        return [row[2:] for row in rest[:len(rest) // 2]]

    def rows(self, name):
        with open(self.file(name)) as table:
            return [[float(value) for value in row] for row in list(csv.reader(table))[1:]]

    def mark(self, project, centre, radius, imported):
        ellipsoid = " ".join(map(str, [*centre, radius, radius, radius]))
        report = self.done("tissue", project, "--system", "susilap-g", "--set", "consistency=2.8",
                           "--ellipsoid", ellipsoid, "--name", "soft spot", "-o", project)
        self.assertTrue(0 < report["nodes"] < imported["nodes"])
        self.assertGreater(report["spring_constant"], 0)
        info = self.done("info", project)
        self.assertKeys(info, INFO_KEYS)
        self.assertTrue(all(step is None or step > 0 for integrator, step in info["critical_dt"].items()
                            if integrator != "note"))

    def poke(self, project, front, size):
        """A sphere dips into the front; the tissue there yields and nothing is ever not a number."""
        radius = 0.08 * size
        away, deep = ([front[0], front[1], front[2] + distance * radius] for distance in (2, 0.3))
        scene = self.file("poke.json", {
            "duration": 0.3, "tethers": [{"every": 3, "spring_constant": 2.4, "viscosity": 10.7}],
            "instrument": {"shape": "sphere", "radius": radius, "path": [[0, *away], [0.2, *deep], [0.3, *deep]]},
            "record": {"every": 0.1, "nodes": "all"}})
        report = self.done("simulate", project, "--scene", scene, "-o", self.file("poke.csv"))
        self.assertTrue(report["stable"], report["outcome"])
        rows = self.rows("poke.csv")
        self.assertTrue(all(math.isfinite(value) for row in rows for value in row))
        nodes = len(rows) // 4
        moved = max(math.dist(start[2:], end[2:]) for start, end in zip(rows[:nodes], rows[-nodes:]))
        self.assertTrue(0.5 * radius < moved < 1.5 * radius, moved / radius)
        self.assertGreater(min(math.dist(row[2:], deep) for row in rows[-nodes:]), 0.98 * radius)

    def photograph(self, project, centre, size, photo):
        """Projected from the front over the middle of the organ."""
        pose = [1, 0, 0, centre[0], 0, 1, 0, centre[1], 0, 0, 1, centre[2] + size[2], 0, 0, 0, 1]
        shape = {"pose": pose, "width": 0.6 * size[0], "height": 0.6 * size[1], "kind": "parallel"}
        projector = self.file("pose.json", shape)
        self.done("texture", "pack", project, "--size", "2048", "-o", project)
        self.no_seams(project, photo, self.file("through.json", {**shape, "occlusion": False}))
        report = self.done("texture", "photo", project, "--photo", photo, "--projector", projector, "--blend", "30", "-o", project)
        self.assertGreater(report["triangles"], 20)
        baked = self.done("texture", "bake", project, "-o", self.file("textures"))
        self.assertEqual(len(baked["files"]), 1)

    def no_seams(self, project, photo, projector):
        """A photo that goes through the organ runs on across every edge; where it ends at what is hidden, it may not.
        What remains is that two patches sample the photo at other places: 10 to 24 of 255 on these organs. An edge of
        the photo itself, as a patch out of its place would show, is above 140."""
        through = self.file("through.esm")
        self.done("texture", "photo", project, "--photo", photo, "--projector", projector, "--blend", "30", "-o", through)
        self.assertLess(self.done("texture", "bake", through, "-o", self.file("through"))["seam_error"], 48)

    def hand_over(self, project, package):
        self.assertEqual(self.done("validate", project), {"valid": True, "problems": []})
        self.assertEqual(self.done("export", project, "-o", package, "--to", "glb"),
                         {"files": [str(package)], "bytes": package.stat().st_size, "differences": []})
        self.assertEqual(self.done("validate", package), {"valid": True, "problems": []})
        magic, version, length = struct.unpack("<4sII", package.read_bytes()[:12])
        self.assertEqual((magic, version, length), (b"glTF", 2, package.stat().st_size))
        reader = Path(__file__).with_name("read_package.py")
        subprocess.run([sys.executable, reader, package, "--project", project], check=True, stdout=subprocess.DEVNULL)
        ours, theirs = self.done("info", project), self.done("info", package)
        for key in ("nodes", "springs", "triangles", "textures", "fuzzy_systems", "fixed", "tethers"):
            self.assertEqual(ours[key], theirs[key], key)
        self.assertAlmostEqual(ours["mass"] / theirs["mass"], 1, places=5)
        self.assertNotIn("flipped_triangles", theirs, "what import repaired is no matter of the package")
        self.assertNotIn("repairs", command("info", package).stdout)

    def draw(self, project, name):
        kept = os.environ.get("ESM_PICTURES")
        for part, options in {"surface": [], "springs": ["--show", "surface,springs,regions,projectors"],
                              "side": ["--view", "right"]}.items():
            picture = self.file(f"{name}-{part}.png")
            self.assertEqual(self.done("render", project, "-o", picture, "--size", "800x600", *options)["size"], [800, 600])
            self.assertGreater(picture.stat().st_size, 5000)
            if kept:
                shutil.copy(picture, Path(kept))

    def test_own_liver(self):
        project = self.sample("liver")
        self.done("sample", "vessels", "-o", self.file("vessels.png"))
        info = self.done("info", project)
        self.photograph(project, info["centre"], info["size"], self.file("vessels.png"))
        self.hand_over(project, self.file("liver.glb"))
        self.draw(project, "own-liver")

    def test_liver_of_the_reference_atlas(self):
        report = self.whole_way("hra-liver", "VH_M_Liver.glb", photo="lap-liver-gallbladder.jpg")
        self.assertEqual([report[key] for key in ("components", "boundary_edges", "non_manifold_edges")], [10, 733, 1050])

    def test_fallopian_tube(self):
        report = self.whole_way("tube", "VH_F_Fallopian_Tube_L.glb", photo="hk-colon-lumen.png")
        self.assertEqual([report[key] for key in ("components", "boundary_edges", "non_manifold_edges")], [1, 47, 0])

    def test_liver_of_a_patient(self):
        report = self.whole_way("h07-liver", "sks-liver-H07.ply", "--unit", "mm", photo="lap-liver-gallbladder.jpg")
        self.assertEqual([report[key] for key in ("components", "boundary_edges", "non_manifold_edges")], [8, 0, 0])

    def test_open_colon(self):
        report = self.whole_way("colon", "GCA-00020-transverse-colon-open.vtk", "--unit", "mm", "--up", "z",
                                photo="hk-colon-lumen.png")
        self.assertEqual([report[key] for key in ("components", "boundary_edges", "non_manifold_edges")], [1, 240, 0])

    def test_ventricles(self):
        report = self.whole_way("ventricles", "colin27-lateral-ventricles-ascii.stl", "--unit", "mm",
                                photo="hk-colon-lumen.png")
        self.assertEqual([report[key] for key in ("components", "boundary_edges", "non_manifold_edges")], [1, 0, 0])


if __name__ == "__main__":
    unittest.main()
