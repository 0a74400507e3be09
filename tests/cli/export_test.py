"""Handing an organ over: what is told beforehand, what is written, what is refused."""
import unittest
import xml.etree.ElementTree as ElementTree

from esmc import Case, command


class ExportTest(Case):
    def setUp(self):
        super().setUp()
        self.tube = self.sample("tube")

    def test_what_will_differ_is_told_without_writing(self):
        folder = self.file("organ.sofa")
        told = self.done("export", self.tube, "--to", "sofa", "-o", folder, "--dry-run")
        self.assertFalse(folder.exists())
        self.assertNotIn("files", told)
        self.assertTrue(any("instruments" in difference["what"] for difference in told["differences"]))
        self.assertIsNone(told["largest_step"])
        written = self.done("export", self.tube, "--to", "sofa", "-o", folder)
        self.assertEqual(written["differences"], told["differences"])

    def test_an_axial_scene_is_stepped_within_its_limit(self):
        folder = self.file("organ.sofa")
        told = self.done("export", self.tube, "--to", "sofa", "-o", folder, "--damping", "axial")
        self.assertTrue(any("along the springs alone" in difference["what"] for difference in told["differences"]))
        limit = self.done("stability", self.tube, "--damping", "axial")["critical_dt"]["euler"]
        self.assertLessEqual(told["largest_step"], limit * 1.01)
        step = float(ElementTree.parse(folder / "organ.scn").getroot().get("dt"))
        self.assertLess(step, told["largest_step"])
        late = self.done("export", self.tube, "--to", "sofa", "-o", self.file("late.sofa"), "--damping", "axial",
                         "--dt", "0.01", "--dry-run")
        self.assertTrue(any("blow up" in warning for warning in late["warnings"]))
        self.assertFalse(any("blow up" in warning for warning in told.get("warnings", [])))

    def test_warns_of_stable_steps_that_are_too_few_for_the_scene(self):
        folder = self.file("organ.sofa")
        told = self.done("export", self.tube, "--to", "sofa", "-o", folder, "--dt", "0.7", "--dry-run")
        self.assertTrue(any("far from that here" in warning for warning in told["warnings"]), told)
        told = self.done("export", self.tube, "--to", "sofa", "-o", folder, "--dry-run")
        self.assertNotIn("warnings", told)

    def test_what_is_refused_is_told_no_steps(self):
        liver = self.file("liver.esm")
        self.done("sample", "liver", "-o", liver)
        self.done("inside", liver, "--fill", "cubic", "--spacing", "0.006", "-o", liver)
        model = self.file("organ.mjcf")
        told = command("export", liver, "--to", "mjcf", "-o", model, "--dry-run").stdout
        self.assertIn("cannot be handed over", told)
        self.assertNotIn("stable step", told)
        self.fails(1, "export", liver, "--to", "mjcf", "-o", model, naming=model)
        self.assertFalse(model.exists())

    def test_a_folder_says_all_that_it_holds(self):
        folder = self.file("organ.sofa")
        written = self.done("export", self.tube, "--to", "sofa", "-o", folder)
        files = sorted(folder.iterdir())
        self.assertEqual(written["files"], [str(file) for file in files])
        self.assertEqual(written["bytes"], sum(file.stat().st_size for file in files))

    def test_the_same_organ_gives_the_same_files(self):
        for name in ("one.sofa", "two.sofa"):
            self.done("export", self.tube, "--to", "sofa", "-o", self.file(name))
        for file in self.file("one.sofa").iterdir():
            self.assertEqual(file.read_bytes(), (self.file("two.sofa") / file.name).read_bytes(), file.name)

    def test_mujoco_gets_a_model_that_says_its_step(self):
        folder = self.file("organ.mjcf")
        written = self.done("export", self.tube, "--to", "mjcf", "-o", folder)
        self.assertEqual(written["files"], [str(folder / "organ.xml")])
        model = ElementTree.parse(folder / "organ.xml").getroot()
        self.assertEqual(float(model.find("option").get("timestep")), written["dt"])
        self.assertLess(written["dt"], written["largest_step"])
        self.assertTrue(any("armature" in difference["instead"] for difference in written["differences"]))
        self.assertEqual(len(model.find("worldbody")), 170)

    def test_mujoco_is_given_no_more_than_it_has_room_for(self):
        mesh = self.file("long.obj")
        with mesh.open("w") as file:
            for i in range(2501):
                file.write(f"v {i} {i % 2 * 30} {i % 3}\n")
            for i in range(2499):
                file.write(f"f {i + 1} {i + 2} {i + 3}\n")
        project, folder = self.file("long.esm"), self.file("organ.mjcf")
        self.done("import", mesh, "-o", project, "--unit", "mm")
        message = self.fails(1, "export", project, "--to", "mjcf", "-o", folder, naming=folder)
        self.assertIn("a detail of 2500", message)
        self.assertFalse(folder.exists())
        for step in ([], ["--dt", "0.001"]):
            told = self.done("export", project, "--to", "mjcf", "-o", folder, "--dry-run", *step)
            self.assertIn("2500", told["refusal"])
            self.assertNotIn("dt", told)

    def test_what_is_there_is_never_touched(self):
        folder = self.file("organ.sofa")
        folder.mkdir()
        (folder / "notes.txt").write_text("mine")
        message = self.fails(1, "export", self.tube, "--to", "sofa", "-o", folder, naming=folder)
        self.assertIn("not empty", message)
        self.assertEqual([file.name for file in folder.iterdir()], ["notes.txt"])
        file = self.file("file.sofa", "mine")
        self.fails(1, "export", self.tube, "--to", "sofa", "-o", file, naming=file)
        self.assertEqual(file.read_text(), "mine")
        self.fails(1, "export", self.tube, "--to", "sofa", "-o", self.file("missing") / "organ.sofa",
                   naming=self.file("missing") / "organ.sofa")


if __name__ == "__main__":
    unittest.main()
