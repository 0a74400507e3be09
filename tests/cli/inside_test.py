import csv
import subprocess
import sys
import unittest
from pathlib import Path

from detail_test import READER, surface
from esmc import Case, command


class InsideTest(Case):
    def imported(self, *options):
        self.project = self.file("organ.esm")
        return self.done("import", self.file("organ.obj", surface()), "-o", self.project, *options)

    def filled(self, *options):
        return self.done("inside", self.project, "-o", self.project, *options)

    def test_an_organ_is_filled_and_hollow_again(self):
        hollow = self.imported()
        solid = self.filled("--fill", "body-centred", "--spacing", 0.01)
        self.assertEqual((solid["detail"]["lattice"], solid["detail"]["spacing"]), ("body-centred", 0.01))
        for key in ("triangles", "vertices", "size"):
            self.assertEqual(solid[key], hollow[key], key)
        self.assertAlmostEqual(solid["mass"], hollow["mass"], places=12)
        self.assertTrue(self.done("validate", self.project)["valid"])
        self.assertEqual(self.done("info", self.project)["detail"], solid["detail"])
        again = self.filled("--fill", "none")
        self.assertEqual((again["nodes"], again["springs"], again["detail"]), (hollow["nodes"], hollow["springs"], None))

    def test_import_fills_as_inside_does(self):
        filled = self.imported("--fill", "cubic", "--spacing", 0.012)
        self.imported()
        after = self.filled("--fill", "cubic", "--spacing", 0.012)
        for key in ("nodes", "springs", "detail", "mass"):
            self.assertEqual(filled[key], after[key], key)

    def test_what_a_filling_comes_to_is_told_before(self):
        self.imported()
        before = self.project.read_bytes()
        for kind in ("cubic", "body-centred", "diamond"):
            told = self.done("inside", self.project, "--fill", kind)
            self.assertEqual(self.project.read_bytes(), before)
            done = self.done("inside", self.project, "--fill", kind, "-o", self.file("solid.esm"))
            self.assertAlmostEqual(told["nodes"] / done["nodes"], 1, delta=0.25)
            self.assertAlmostEqual(done["nodes"] / 3000, 1, delta=0.35)
            self.assertEqual(told["spacing"], done["detail"]["spacing"])

    def test_an_open_organ_gets_a_wall_of_prisms_and_is_hollow_again(self):
        mesh = self.file("open.obj", "\n".join(surface().splitlines()[:-1]) + "\n")
        self.project = self.file("organ.esm")
        hollow = self.done("import", mesh, "-o", self.project)
        told = self.done("inside", self.project, "--fill", "prisms", "--wall-thickness", 0.002)
        walled = self.filled("--fill", "prisms", "--wall-thickness", 0.002)
        self.assertEqual({key: walled["detail"][key] for key in ("lattice", "wall_thickness", "layers", "tetrahedra")},
                         {"lattice": "prisms", "wall_thickness": 0.002, "layers": 2, "tetrahedra": 6 * hollow["triangles"]})
        for key in ("nodes", "springs"):
            self.assertEqual(told[key], walled[key], key)
        self.assertEqual(walled["nodes"], 3 * hollow["nodes"])
        self.assertGreater(walled["wall"]["volume"], 0)
        self.assertLessEqual(walled["wall"]["least_thickness"], 0.002 * (1 + 1e-9))
        self.assertAlmostEqual(walled["mass"], hollow["mass"], places=12)
        self.assertTrue(self.done("validate", self.project)["valid"])
        self.assertEqual(self.done("info", self.project)["detail"], walled["detail"])
        package = self.file("organ.glb")
        self.done("export", self.project, "--to", "glb", "-o", package)
        self.assertTrue(self.done("validate", package)["valid"])
        self.assertEqual(self.done("info", package)["detail"], walled["detail"])
        subprocess.run([sys.executable, READER, package, "--project", self.project], check=True, stdout=subprocess.DEVNULL)
        again = self.filled("--fill", "none")
        self.assertEqual((again["nodes"], again["springs"], again["detail"]), (hollow["nodes"], hollow["springs"], None))
        imported = self.done("import", mesh, "-o", self.project, "--fill", "prisms", "--wall-thickness", 0.002, "--layers", 1)
        self.assertEqual(imported["nodes"], 2 * hollow["nodes"])

    def test_a_wall_that_is_often_thinner_is_said_to_be(self):
        mesh = self.file("organ.obj", surface())
        self.project = self.file("organ.esm")
        line = ["import", mesh, "-o", self.project, "--fill", "prisms", "--wall-thickness"]
        self.assertEqual(self.done(*line, 0.002)["warnings"], [])
        thick = self.done(*line, 0.05)
        self.assertGreater(thick["wall"]["shortened"], 0.1 * thick["vertices"])
        self.assertIn("%d of %d vertices have a thinner wall than asked for, down to" % (thick["wall"]["shortened"], thick["vertices"]),
                      thick["warnings"][0])
        self.assertEqual(self.done("info", self.project)["warnings"], thick["warnings"])

    def test_what_has_no_wall_is_refused(self):
        self.imported()
        line = ["inside", self.project, "-o", self.project, "--fill", "prisms"]
        self.assertIn("too thick", self.fails(1, *line, "--wall-thickness", 0.9, naming="organ.esm"))
        self.fails(2, *line, "--spacing", 0.01)
        self.fails(2, "inside", self.project, "--fill", "cubic", "--layers", 2)
        self.fails(2, "inside", self.project, "--fill", "cubic", "--wall-thickness", 0.002)

    def test_a_simulator_gets_the_filled_organ(self):
        self.imported("--fill", "body-centred", "--spacing", 0.015)
        package = self.file("organ.glb")
        self.done("export", self.project, "--to", "glb", "-o", package)
        self.assertTrue(self.done("validate", package)["valid"])
        self.assertEqual(self.done("info", package)["detail"], self.done("info", self.project)["detail"])
        subprocess.run([sys.executable, READER, package, "--project", self.project], check=True, stdout=subprocess.DEVNULL)

    def test_a_lattice_may_be_coarser_within(self):
        self.imported()
        even = self.filled("--fill", "body-centred", "--spacing", 0.006)
        told = self.done("inside", self.project, "--fill", "graded", "--spacing", 0.006)
        graded = self.filled("--fill", "graded", "--spacing", 0.006)
        self.assertEqual(graded["detail"]["lattice"], "graded")
        self.assertLess(graded["nodes"], 0.95 * even["nodes"])
        self.assertAlmostEqual(told["nodes"] / graded["nodes"], 1, delta=0.1)
        self.assertAlmostEqual(graded["mass"], even["mass"], places=12)
        package = self.file("organ.glb")
        self.done("export", self.project, "--to", "glb", "-o", package)
        for model in (self.project, package):
            self.assertTrue(self.done("validate", model)["valid"])
            self.assertEqual(self.done("info", model)["detail"], graded["detail"])
        subprocess.run([sys.executable, READER, package, "--project", self.project], check=True, stdout=subprocess.DEVNULL)

    def test_a_poke_dents_it_and_package_and_project_move_alike(self):
        self.imported("--fill", "body-centred", "--spacing", 0.015)
        package = self.file("organ.glb")
        self.done("export", self.project, "--to", "glb", "-o", package)
        scene = self.file("poke.json", {
            "duration": 0.2, "record": {"every": 0.1},
            "tethers": [{"every": 1, "spring_constant": 5, "viscosity": 1}],
            "instrument": {"shape": "sphere", "radius": 0.015, "path": [[0, 0, 0, 0.08], [0.2, 0, 0, 0.055]]}})
        ends = []
        for model in (self.project, package):
            out, drawn = self.file("nodes.csv"), self.file("drawn.csv")
            self.done("simulate", model, "--scene", scene, "-o", out, "--surface", drawn)
            with open(drawn, encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            ends.append([[float(row[axis]) for axis in "xyz"] for row in rows if abs(float(row["time"]) - 0.2) < 1e-9])
        self.assertLess(max(z for x, y, z in ends[0] if max(abs(x), abs(y)) < 0.006), 0.044)
        for there, here in zip(*ends):
            self.assertLess(max(abs(a - b) for a, b in zip(there, here)), 1e-5)

    def test_what_cannot_be_filled_is_refused_and_stays_as_it_was(self):
        self.imported()
        before = self.project.read_bytes()
        line = ["inside", self.project, "-o", self.project, "--fill", "body-centred", "--spacing"]
        self.assertIn("wider than the organ", self.fails(1, *line, 1, naming="organ.esm"))
        self.assertRegex(self.fails(1, *line, 0.0001, naming="organ.esm"), r"million nodes and .* GB of memory")
        self.assertEqual(self.project.read_bytes(), before)
        lines = surface().splitlines()
        opened = self.file("open.obj", "\n".join(lines[:-1]) + "\n")
        self.assertIn("open", self.fails(1, "import", opened, "--fill", "cubic", "-o", self.file("out.esm"), naming="open.obj"))
        self.assertFalse(self.file("out.esm").exists())

    def test_a_surface_that_runs_through_itself_is_filled_where_that_is_small(self):
        lines = surface().splitlines()
        tip = [float(number) for number in lines[11 * 48].split()[1:]]
        lines[11 * 48] = "v %r %r %r" % tuple(1.1 * x for x in tip)
        lines[11 * 48 + 4] = "v %r %r %r" % tuple(1.045 * x for x in tip)
        mesh = self.file("crossed.obj", "\n".join(lines) + "\n")
        self.project = self.file("organ.esm")
        done = self.done("import", mesh, "-o", self.project, "--fill", "body-centred", "--spacing", 0.01)
        self.assertEqual(done["crossings"]["places"], 1)
        self.assertLess(done["crossings"]["width"], 0.005)
        self.assertEqual(self.filled("--fill", "body-centred", "--spacing", 0.01)["crossings"], done["crossings"])
        self.assertEqual(self.done("inside", self.project, "--fill", "body-centred", "--spacing", 0.01)["crossings"], done["crossings"])
        self.assertNotIn("crossings", self.filled("--fill", "none"))
        told = self.fails(1, "inside", self.project, "--fill", "body-centred", "--spacing", 0.001, naming="organ.esm")
        self.assertRegex(told, r"runs through itself: .* choose a spacing of [0-9.]+ mm or more")

    def test_options_that_contradict_are_refused(self):
        mesh, out = self.file("organ.obj", surface()), self.file("out.esm")
        self.fails(2, "import", mesh, "-o", out, "--fill", "cubic", "--detail", 200)
        self.fails(2, "import", mesh, "-o", out, "--spacing", 0.01)
        self.imported()
        self.fails(2, "inside", self.project, "-o", out)
        self.fails(2, "inside", self.project, "--fill", "none")


if __name__ == "__main__":
    unittest.main()
