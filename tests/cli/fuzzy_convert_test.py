import json
import unittest

from esmc import Case, command


class FuzzyConvertTest(Case):
    def test_a_preset_goes_through_every_language_and_comes_back(self):
        first, last = self.file("first.json"), self.file("last.json")
        files = [first, self.file("a.fcl"), self.file("b.FLL"), self.file("c.fcl"), last]
        report = self.done("fuzzy", "convert", "robo-sim", first)
        self.assertEqual(report, {"rules": 14, "domains": 5, "warnings": []})
        for source, target in zip(files, files[1:]):
            self.assertEqual(self.done("fuzzy", "convert", source, target), report)
        self.assertEqual(json.loads(last.read_text()), json.loads(first.read_text()))
        words = ["--set", "consistency=soft", "--set", "sensitiveness=3.3", "--set", "shiftability=5"]
        outputs = self.done("fuzzy", "eval", "robo-sim", *words)["outputs"]
        for file in files:
            self.assertEqual(self.done("fuzzy", "eval", file, *words)["outputs"], outputs)
        self.assertIn("FUNCTION_BLOCK robo_sim", files[1].read_text())
        self.assertIn("Engine: robo_sim", files[2].read_text())

    def test_says_what_was_not_taken_wherever_a_file_is_read(self):
        file = self.file("copy.fll")
        self.done("fuzzy", "convert", "susilap-g", file)
        file.write_text(file.read_text().replace("Centroid 200", "Bisector 200", 1))
        warning = "Bisector"
        self.assertIn(warning, self.done("fuzzy", "convert", file, self.file("copy.json"))["warnings"][0])
        self.assertIn(warning, self.done("fuzzy", "eval", file, "--set", "consistency=3")["warnings"][0])
        report = self.done("tissue", self.sample("tube"), "-o", self.file("soft.esm"), "--system", file,
                           "--set", "consistency=3")
        self.assertIn(warning, report["warnings"][0])
        text = command("fuzzy", "convert", file, self.file("copy.json")).stdout
        self.assertRegex(text, r"line \d+, column 16: the defuzzifier Bisector")

    def test_names_the_place_and_leaves_the_target_alone(self):
        target = self.file("target.json", "old")
        for name, content in [("a.fcl", "FUNCTION_BLOCK x\nVAR_INPUT\n"), ("b.fll", "Engine: x\nrange: 0 1\n"),
                              ("c.fcl", "FUNCTION_BLOCK x".encode("utf-16")), ("d.fll", b"\x7fELF\x01\x00\x00"),
                              ("e.fll", "")]:
            message = self.fails(1, "fuzzy", "convert", self.file(name, content), target, naming=name)
            self.assertRegex(message, r"line \d+, column \d+: ")
        self.assertEqual(target.read_text(), "old")
        self.fails(1, "fuzzy", "convert", self.file("none.fcl"), target, naming="none.fcl")
        self.fails(2, "fuzzy", "convert", "susilap-g", self.file("a.txt"), naming=".fll")


if __name__ == "__main__":
    unittest.main()
