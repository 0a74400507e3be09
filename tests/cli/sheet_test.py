import unittest

from detail_test import surface
from esmc import Case


class SheetTest(Case):
    def test_import_makes_an_even_sheet(self):
        organ = self.file("organ.esm")
        self.assertTrue(self.done("import", self.file("organ.obj", surface()), "-o", organ)["even_sheet"])
        self.assertTrue(self.done("info", organ)["even_sheet"])
        self.assertTrue(self.done("validate", organ)["valid"])

    def test_a_project_becomes_one_and_is_none_again(self):
        plain, even, again = self.file("plain.esm"), self.file("even.esm"), self.file("again.esm")
        before = self.done("import", self.file("organ.obj", surface()), "-o", plain, "--springs", "alike")
        self.assertFalse(before["even_sheet"])
        after = self.done("sheet", plain, "--springs", "even", "-o", even)
        self.assertTrue(after["even_sheet"])
        for key in ("nodes", "springs", "triangles", "size", "detail"):
            self.assertEqual(after[key], before[key], key)
        self.assertAlmostEqual(after["mass"], before["mass"], places=12)
        self.done("sheet", even, "--springs", "alike", "-o", again)
        self.assertEqual(again.read_bytes(), plain.read_bytes())

    def test_its_package_says_what_each_spring_takes(self):
        organ, package = self.file("organ.esm"), self.file("organ.glb")
        self.done("import", self.file("organ.obj", surface()), "-o", organ)
        self.done("export", organ, "--to", "glb", "-o", package)
        self.assertTrue(self.done("validate", package)["valid"])
        self.assertTrue(self.done("info", package)["even_sheet"])

    def test_fewer_nodes_and_hollowed_organs_are_even_too(self):
        organ = self.file("organ.esm")
        fewer = self.done("import", self.file("organ.obj", surface()), "-o", organ, "--detail", 60)
        self.assertTrue(fewer["even_sheet"])
        self.done("import", self.file("organ.obj", surface()), "-o", organ, "--fill", "cubic", "--spacing", 0.015)
        self.assertTrue(self.done("inside", organ, "--fill", "none", "-o", organ)["even_sheet"])

    def test_what_is_no_surface_of_springs_is_refused(self):
        organ, out = self.file("organ.esm"), self.file("out.esm")
        for how in (["--fill", "cubic", "--spacing", 0.015], ["--detail", "rigid"]):
            self.done("import", self.file("organ.obj", surface()), "-o", organ, *how)
            self.assertIn("no surface of springs", self.fails(1, "sheet", organ, "--springs", "even", "-o", out))
            self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
