import json
import re
import subprocess
import unittest
from pathlib import Path

from esmc import ESMC, Case, command

COMMANDS = ["import", "sample", "info", "fuzzy", "tissue", "scale", "inside", "sheet", "scene", "simulate", "stability", "probe", "extremes", "tradeoff",
            "texture", "export", "validate", "render", "fuzzy eval", "fuzzy convert", "texture pack", "texture photo", "texture replace", "texture fit", "texture finish", "texture bake"]


class HelpTest(Case):
    def test_every_command_explains_itself_and_tells_the_version(self):
        version = command("--version").stdout
        self.assertRegex(version, r"\d+\.\d+\.\d+")
        for name in ["", *COMMANDS]:
            with self.subTest(name):
                help_text = command(*name.split(), "--help")
                self.assertEqual((help_text.returncode, help_text.stderr), (0, ""))
                self.assertIn("--help", help_text.stdout)
                self.assertEqual(command(*name.split(), "--version").stdout, version)

    def test_wrong_usage_ends_with_two_and_one_line(self):
        project = self.sample("uterus")
        out = self.file("out")
        for line in [[], ["frobnicate"], ["learn", project], ["texture"], ["texture", "fit", project],
                     ["fuzzy", "convert", "a", "b"], ["info"], ["info", project, "more"], ["info", "--frob", project],
                     ["-j", "0", "info", project], ["-j", "two", "info", project], ["sample", "spleen", "-o", out],
                     ["import", "a.obj"], ["import", "a.obj", "-o", out, "--unit", "inch"],
                     ["import", "a.obj", "-o", out, "--mass", "0"], ["import", "a.obj", "-o", out, "--mass", "nan"],
                     ["import", "a.obj", "-o", out, "--weld", "-1"], ["import", "a.obj", "-o", out, "--up", "w"],
                     ["import", "a.obj", "-o", out, "--detail", "3"], ["import", "a.obj", "-o", out, "--detail", "half"], ["import", "a.obj", "-o", out, "--keep", "x"],
                     ["import", "a.obj", "-o", out, "--unit", "0"], ["import", "a.obj", "-o", out, "--unit", "7"],
                     ["import", "a.obj", "-o", out, "--up", "1"], ["import", "a.obj", "-o", out, "--keep", "1"],
                     ["import", "a.obj", "-o", out, "--weld", "nan"], ["import", "a.obj", "-o", out, "--weld", "inf"],
                     ["texture", "photo", project, "--photo", "a.png", "--projector", "b.json", "--blend", "nan", "-o", out],
                     ["fuzzy", "eval", "susilap-g", "--set", "consistency"],
                     ["fuzzy", "eval", "susilap-g", "--set", "consistency=tough"],
                     ["fuzzy", "eval", "susilap-g", "--set", "consistency=nan"],
                     ["tissue", project, "-o", out, "--ellipsoid", "1 2 3"],
                     ["tissue", project, "-o", out, "--ellipsoid", "0 0 0 1 0 1"],
                     ["tissue", project, "-o", out, "--override", "colour=1"],
                     ["tissue", project, "-o", out, "--override", "mass=-1"],
                     ["tissue", project, "-o", out, "--set", "consistency=3"],
                     ["tissue", project, "-o", out, "--biphasic", "0.2"],
                     ["tissue", project, "-o", out, "--biphasic", "0", "5"],
                     ["tissue", project, "-o", out, "--biphasic", "-0.2", "5"],
                     ["tissue", project, "-o", out, "--biphasic", "nan", "5"],
                     ["tissue", project, "-o", out, "--biphasic", "0.2", "0"],
                     ["tissue", project, "-o", out, "--biphasic", "0.2", "inf"],
                     ["tissue", project, "-o", out, "--biphasic", "0.2", "5", "--linear"],
                     ["simulate", project, "-o", out, "--integrator", "leapfrog"],
                     ["simulate", project, "-o", out, "--dt", "nan"], ["simulate", project, "-o", out, "--dt", "-1"],
                     ["stability", project, "--damping", "none"], ["tradeoff", project, "--max-error", "0"],
                     ["tradeoff", project, "--plot", "chart.gif"], ["tradeoff", project, "--real-time", "nan"],
                     ["tradeoff", project, "--real-time", "1e-320"], ["tradeoff", project, "--max-error", "1e-300"],
                     ["tradeoff", project, "--max-seconds", "-1"],
                     ["tradeoff", project, "--damping", "axial", "-o", out], ["tradeoff", "organ.glb", "-o", "q.esm"],
                     ["tradeoff", project, "--save", "best", "-o", "q.esm"], ["simulate", project, "-o", out, "--max-error", "0"],
                     ["simulate", project, "-o", out, "--integrator", "split", "--damping", "axial"],
                     ["simulate", project, "-o", out, "--dt", "0"], ["simulate", project, "-o", out, "--dt", "fast"],
                     ["simulate", project, "-o", out, "--precision", "half"],
                     ["simulate", project, "-o", out, "--integrator", "split", "--precision", "float"],
                     ["export", project, "-o", out, "--to", "stl"],
                     ["export", project, "-o", out, "--to", "glb", "--sofa", "26.06"],
                     ["export", project, "-o", out, "--to", "glb", "--dt", "0.01"],
                     ["export", project, "-o", out, "--to", "sofa", "--sofa", "22.06"],
                     ["render", project, "-o", out, "--size", "0x10"], ["render", project, "-o", out, "--size", "10"],
                     ["render", project, "-o", out, "--size", "10x99999"],
                     ["render", project, "-o", out, "--view", "behind"],
                     ["render", project, "-o", out, "--view", "0 0 0 0 0 0"],
                     ["render", project, "-o", out, "--show", "bones"],
                     ["render", project, "-o", out, "--size", "0x0"], ["render", project, "-o", out, "--size", "x"],
                     ["texture", "pack", project, "-o", out, "--size", "big"],
                     ["texture", "pack", project, "-o", out, "--size", "0x100"],
                     ["texture", "pack", project, "-o", out, "--pages", "2.5"]]:
            with self.subTest(line):
                self.fails(2, *line)
        self.assertFalse(out.exists())

    def test_an_ending_that_says_another_kind_of_file_is_refused(self):
        project = self.sample("tube")
        for ending, line in [(".png", ["render", project, "-o", "x.jpg"]),
                             (".png", ["sample", "vessels", "-o", "x.esm"]),
                             (".esm", ["sample", "tube", "-o", "x.png"]), (".esm", ["import", "a.obj", "-o", "x.glb"]),
                             (".esm", ["tissue", project, "-o", "x.json"]),
                             (".esm", ["scene", project, "--scene", "s.json", "-o", "x.glb"]),
                             (".esm", ["texture", "pack", project, "-o", "x.png"]),
                             (".glb", ["export", project, "--to", "glb", "-o", "x.esm"]),
                             (".glb", ["export", project, "--to", "glb", "-o", "x.vtp"]),
                             (".vtp", ["export", project, "--to", "vtp", "-o", "x.glb"]),
                             (".csv", ["simulate", project, "-o", "x.json"])]:
            with self.subTest(line):
                name, out = line[-1], self.file(line[-1])
                self.assertIn(f"does not end in {ending}", self.fails(2, *line[:-1], out, naming=name))
                self.assertFalse(out.exists())
        self.done("sample", "vessels", "-o", self.file("X.PNG"))

    def test_an_ending_that_says_no_kind_of_file_belongs_to_the_name(self):
        for name in ["tube.v2", "tube.2026-11-21", "tube"]:
            with self.subTest(name):
                self.done("sample", "tube", "-o", self.file(name))
                self.assertTrue(self.file(name).exists())

    def test_a_command_that_is_not_there_names_those_that_are(self):
        message = self.fails(2, "learn", "a.esm", "--scene", "b.json")
        for name in COMMANDS[:14]:
            self.assertIn(name, message)
        self.assertIn("pack, photo, replace, fit, finish, bake", self.fails(2, "texture", "warp", "a.esm"))

    def test_json_and_threads_stand_before_or_after_the_command(self):
        project = self.sample("tube")
        before = command("--json", "-j", "1", "info", project)
        after = command("info", project, "-j", "2", "--json")
        self.assertEqual(json.loads(before.stdout), json.loads(after.stdout))

    def test_text_is_for_people(self):
        process = command("info", self.sample("tube"))
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertIn("170 nodes, 340 springs", process.stdout)

    def test_output_that_cannot_be_written_is_an_error(self):
        project = self.sample("tube")
        with open("/dev/full", "w") as full:
            process = subprocess.run([ESMC, "info", project, "--json"], stdout=full, stderr=subprocess.PIPE, text=True,
                                     timeout=60)
        self.assertEqual(process.returncode, 1)
        self.assertRegex(process.stderr, r"\Aesmc: standard output[^\n]+\n\Z")


    def test_the_docs_list_the_formats_that_export_offers(self):
        described = re.search(r"--to .*?(?=-o,)", command("export", "--help").stdout, re.S)[0]
        offered = re.findall(r"\b([a-z]+): ", described)
        page = (Path(__file__).parents[2] / "docs/command-line.md").read_text()
        table = page[page.index("### `export"):page.index("### `validate")]
        self.assertEqual(re.findall(r"^\| `([a-z]+)` \| (?:folder )?`\.", table, re.M), offered)


if __name__ == "__main__":
    unittest.main()
