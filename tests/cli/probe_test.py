import csv
import unittest

from detail_test import surface
from esmc import Case, command


class ProbeTest(Case):
    def organ(self, name="organ.esm", *options):
        """A closed organ on tethers."""
        project = self.file(name)
        self.done("import", self.file("organ.obj", surface()), "-o", project, *options)
        self.top = max((tuple(map(float, line.split()[1:4])) for line in surface().splitlines() if line.startswith("v ")),
                       key=lambda place: place[2])
        return project

    def at(self):
        return " ".join(map(str, self.top))

    def test_a_finger_tells_how_firm_an_organ_is(self):
        organ = self.organ("organ.esm", "--fill", "body-centred", "--spacing", 0.012)
        chart, table = self.file("press.svg"), self.file("press.csv")
        report = self.done("probe", organ, "--at", self.at(), "--depth", 0.002, "--steps", 4, "--plot", chart, "--csv", table)
        self.assertEqual([point["depth"] for point in report["curve"]], [0, 0.0005, 0.001, 0.0015, 0.002])
        forces = [point["force"] for point in report["curve"]]
        self.assertEqual(forces, sorted(forces))
        self.assertEqual(report["force"], forces[-1])
        self.assertGreater(report["youngs_modulus"], 100)
        self.assertEqual(report["poissons_ratio"], 0.25)
        self.assertIn("depth, mm", chart.read_text())
        with table.open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["force_n"]) for row in rows], forces)
        again = self.done("-j", 1, "probe", organ, "--at", self.at(), "--depth", 0.002, "--steps", 4)
        self.assertEqual(again["curve"], report["curve"])

    def test_two_organs_are_compared(self):
        organ = self.organ("organ.esm", "--fill", "body-centred", "--spacing", 0.012)
        firm = self.file("firm.esm")
        self.done("tissue", organ, "-o", firm, "--override", "spring_constant=200")
        report = self.done("probe", organ, "--at", self.at(), "--depth", 0.001, "--steps", 1, "--with", firm)
        self.assertGreater(report["with"]["force"], report["force"])

    def test_a_strip_tells_how_firm_a_wall_is(self):
        organ = self.organ()
        chart, table = self.file("strip.png"), self.file("strip.csv")
        options = ["--at", self.at(), "--strip", "0.04 0.02", "--steps", 2]
        report = self.done("probe", organ, *options, "--stretch", 0.1, "--plot", chart, "--csv", table)
        self.assertEqual([point["elongation"] for point in report["curve"]], [0, 0.002, 0.004])
        self.assertGreater(report["force"], 0)
        self.assertAlmostEqual(report["youngs_modulus"], report["membrane_stiffness"] / 0.003, places=6)
        self.assertEqual(chart.read_bytes()[:4], b"\x89PNG")
        with table.open() as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([float(row["force_n"]) for row in rows], [point["force"] for point in report["curve"]])
        package = self.file("organ.glb")
        self.done("export", organ, "--to", "glb", "-o", package)
        packed = self.done("probe", package, *options, "--stretch", 0.1)
        self.assertIsNone(packed["youngs_modulus"], "it does not say how thick the wall is")
        self.assertAlmostEqual(packed["membrane_stiffness"], report["membrane_stiffness"], delta=1e-4 * report["membrane_stiffness"])
        solid = self.organ("solid.esm", "--fill", "body-centred", "--spacing", 0.008)
        filled = self.done("probe", solid, *options)
        self.assertIsNone(filled["membrane_stiffness"])
        self.assertGreater(filled["youngs_modulus"], 100)
        self.assertGreater(self.done("probe", organ, *options, "--with", solid)["with"]["force"], 0)

    def test_an_organ_under_a_pressure_is_pressed_as_it_stands_under_it(self):
        organ = self.organ()
        options = ["--at", self.at(), "--depth", 0.002, "--steps", 2]
        limp = self.done("probe", organ, *options)
        self.assertNotIn("inflated", limp)
        tethers = {"every": 1, "spring_constant": 2, "viscosity": 0.1}

        def under(name, path):
            scene = {"duration": 1, "tethers": [tethers], "pressures": [{"part": 0, "path": path}]}
            self.done("scene", organ, "--scene", self.file("scene.json", scene), "-o", self.file(name))
            return self.file(name)

        tense = under("tense.esm", [[0, 60]])
        report = self.done("probe", tense, *options, "--creep", 0.05, "--creep-time", 2)
        part, = report["inflated"]
        self.assertEqual((part["part"], part["pressure"]), (0, 60))
        self.assertGreater(part["volume"], 1.02 * part["at_rest"])
        self.assertGreater(report["force"], limp["force"])
        self.assertGreater(report["creep"]["end"]["depth"], 0)
        self.assertIn("of its volume at rest", command("probe", str(tense), *map(str, options)).stdout)
        # What presses later in the scene takes no part.
        later = self.done("probe", under("later.esm", [[0, 60], [1, 500]]), *options)
        self.assertAlmostEqual(later["force"], self.done("probe", tense, *options)["force"], delta=1e-9)
        self.fails(1, "probe", under("burst.esm", [[0, 1e5]]), *options, naming="bursts part 1")
        strip = ["--at", self.at(), "--strip", "0.04 0.02", "--steps", 2]
        self.assertEqual(self.done("probe", tense, *strip)["force"], self.done("probe", organ, *strip)["force"])

    def test_what_cannot_be_stretched_is_said(self):
        organ = self.organ()
        for options, what in [(["--strip", "3 0.02"], "choose a smaller strip"), (["--strip", "0.04 1e-6"], "nodes lie"),
                              (["--strip", "0.04 0.02", "--along", "0 0 1"], "along the organ's surface")]:
            self.fails(1, "probe", organ, "--at", self.at(), *options, naming=what)
        self.assertEqual(command("probe", str(organ), "--at", self.at(), "--along", "1 0 0").returncode, 2)
        self.assertEqual(command("probe", str(organ), "--at", self.at(), "--strip", "0.04 0.02", "--depth", "1").returncode, 2)

    def test_what_cannot_be_pressed_is_said(self):
        organ = self.organ()
        for options, what in [(["--at", "9 9 9"], "off the organ's surface"), (["--at", self.at(), "--depth", 0.15], "thick"),
                              (["--at", self.at(), "--depth", 5], "press less deep"), (["--at", self.at(), "--radius", 1e-30], "radius"),
                              (["--at", self.at(), "--radius", 1e30], "radius"),
                              (["--node", 10**6], "there is no node"), (["--node", -1], "there is no node")]:
            self.fails(1, "probe", organ, *options, naming=what)
        self.assertEqual(command("probe", str(organ)).returncode, 2)
        self.fails(1, "probe", self.sample("uterus"), "--at", "0 0 0", naming="no surface")


if __name__ == "__main__":
    unittest.main()
