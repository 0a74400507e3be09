import json
import math
import unittest
import zipfile

from detail_test import surface
from esmc import Case

SCENE = {"duration": 0.3, "fillings": [{"part": 0, "stiffness": 20000}],
         "pressures": [{"part": 0, "path": [[0, 0], [0.1, 400]]}], "record": {"every": 0.1}}


def opened(obj):
    """The same surface without its last triangle."""
    return obj.rstrip("\n").rpartition("\n")[0] + "\n"


class FluidTest(Case):
    def imported(self, obj=surface(), *options):
        self.project = self.file("organ.esm")
        return self.done("import", self.file("organ.obj", obj), "-o", self.project, *options)

    def simulated(self, scene, model=None):
        return self.done("simulate", model or self.project, "--scene", self.file("scene.json", scene), "-o",
                         self.file("out.csv"))

    def refused(self, scene, *words, model=None):
        said = self.fails(1, "simulate", model or self.project, "--scene", self.file("scene.json", scene), "-o",
                           self.file("out.csv"))
        for word in words:
            self.assertIn(word, said)

    def test_a_pressure_blows_the_organ_up_and_its_fluid_holds_against_it(self):
        self.imported()
        report = self.simulated(SCENE)
        (volume,) = report["volumes"]
        self.assertEqual((volume["part"], len(volume["times"])), (0, 4))
        growth = [v / volume["at_rest"] - 1 for v in volume["volumes"]]
        self.assertAlmostEqual(growth[0], 0, delta=1e-9)
        self.assertGreater(growth[-1], 0.001)
        for time, grown, pressure in zip(volume["times"], growth, volume["pressures"]):
            self.assertAlmostEqual(pressure, min(400, 4000 * time) - 20000 * grown, delta=0.01)
        free = self.simulated({**SCENE, "fillings": []})["volumes"][0]
        self.assertGreater(free["volumes"][-1], volume["volumes"][-1])

    def test_project_and_package_hold_the_fluid(self):
        self.imported()
        plain = self.project.read_bytes()
        self.done("scene", self.project, "--scene", self.file("scene.json", SCENE), "-o", self.project)
        with zipfile.ZipFile(self.project) as file:
            manifest = json.loads(file.read("manifest.json"))
        self.assertEqual(manifest["version"], 13)
        self.assertEqual(manifest["scene"]["fillings"], SCENE["fillings"])
        self.assertEqual(manifest["scene"]["pressures"], SCENE["pressures"])
        self.assertEqual(self.done("info", self.project)["fillings"], SCENE["fillings"])
        package = self.file("organ.glb")
        self.done("export", self.project, "--to", "glb", "-o", package)
        self.assertEqual(self.done("info", package)["fillings"], SCENE["fillings"])
        self.assertTrue(self.done("validate", package)["valid"])
        ends = [self.simulated(SCENE, model)["volumes"][0]["volumes"][-1] for model in (self.project, package)]
        self.assertAlmostEqual(ends[0] / ends[1], 1, delta=1e-4)
        stored = self.done("simulate", package, "-o", self.file("out.csv"))
        volume = stored["volumes"][0]
        grown = volume["volumes"][-1] / volume["at_rest"] - 1
        self.assertGreater(grown, 0.001, "the package's own pressure blows it up")
        self.assertAlmostEqual(volume["pressures"][-1], 400 - 20000 * grown, delta=0.01)
        emptied = self.simulated({"duration": 0.01}, package)
        self.assertNotIn("volumes", emptied)
        self.assertTrue(any("names no fillings" in warning for warning in emptied["warnings"]))
        self.project.write_bytes(plain)
        self.assertEqual(self.done("info", self.project)["fillings"], [])

    def test_fewer_nodes_are_filled_as_well(self):
        self.imported(surface(), "--detail", 200)
        volume = self.simulated(SCENE)["volumes"][0]
        self.assertGreater(volume["volumes"][-1] / volume["at_rest"], 1.001)

    def test_what_cannot_hold_a_fluid_is_refused_with_words(self):
        self.imported(opened(surface()))
        self.refused(SCENE, "fillings[0]", "part 0 of the surface is open", "3 open edges")
        self.imported()
        self.refused({**SCENE, "fillings": [{"part": 1, "stiffness": 1}]}, "fillings[0]", "no part 1")
        self.refused({**SCENE, "fillings": [{"part": 0, "stiffness": 0}]}, "fillings[0].stiffness", "above 0")
        self.refused({**SCENE, "pressures": [{"part": 0, "path": [[0, 0], [0, 5]]}]}, "pressures[0]", "not later")
        self.refused({**SCENE, "pressures": [{"part": 0, "path": [[0, 2e30]]}]}, "pressures[0]", "beyond")
        self.refused({**SCENE, "pressures": [{"part": 0, "path": [[0, 0, 1]]}]}, "pressures[0].path[0]")
        self.imported(surface(), "--fill", "body-centred", "--spacing", 0.015)
        self.refused(SCENE, "fillings[0]", "a lattice fills this organ")
        self.imported(surface(), "--fill", "prisms", "--wall-thickness", 0.002)
        self.refused(SCENE, "fillings[0]", "within a wall of prisms a fluid is not computed yet")

    def test_a_fluid_stays_where_detail_changes_and_a_lattice_is_refused(self):
        self.imported()
        self.done("scene", self.project, "--scene", self.file("scene.json", SCENE), "-o", self.project)
        before = self.project.read_bytes()
        said = self.fails(1, "inside", self.project, "--fill", "cubic", "--spacing", 0.015, "-o", self.project)
        self.assertIn("leaves no room for a fluid", said)
        self.assertEqual(self.project.read_bytes(), before)

    def test_a_burst_is_said_and_the_run_stopped(self):
        self.imported()
        process_scene = {"duration": 5, "pressures": [{"part": 0, "path": [[0, 0], [5, 1e5]]}], "record": {"every": 0.1}}
        said = self.fails(1, "simulate", self.project, "--scene", self.file("scene.json", process_scene), "-o",
                           self.file("out.csv"))
        self.assertIn("the pressure bursts part 1 of the surface (number 0 in files)", said)
        self.assertNotIn("nan", self.file("out.csv").read_text().lower())
        self.assertTrue(math.isfinite(float(self.file("out.csv").read_text().split(",")[-1])))


if __name__ == "__main__":
    unittest.main()
