"""Which exit code a wrong word on the line, or a wrong file, ends with: for every command and every option."""

import re
import unittest

from esmc import CUBE, PROJECTOR, Case, command

NUMBER = ["x", "nan", "1e31", ""]
POSITIVE, AMOUNT = NUMBER + ["0", "-1"], NUMBER + ["-1"]
WHOLE = ["x", "1.5", "99999999999", ""]
ELLIPSOID = ["x", "1 2 3", "0 0 0 1 1 0", "0 0 0 1 1 -1", "0 0 0 1 1 nan", "0 0 0 1 1 1e31", "1e31 0 0 1 1 1",
             "0 0 0 1 1 1 0 0 0 9", ""]
FILE, TO_PROJECT = [""], ["-", "out.png", ""]

# A line of every command that is right but for what is put in: the file it is about, and its options, each with the
# values that are wrong whatever the files hold. Every option of a command's help must be here.
COMMANDS = {
    "import cube.obj": {"mesh": FILE, "-o": TO_PROJECT, "--unit": ["inch", "0", "MM", ""], "--weld": AMOUNT,
                        "--keep": ["some", "1", ""], "--mass": POSITIVE + ["1e-31"], "--up": ["w", "-y", "1", ""],
                        "--close": AMOUNT, "--fill-holes": WHOLE + ["1", "2", "-3", "501"],
                        "--fill": ["foam", ""], "--spacing": POSITIVE, "--springs": ["some", ""],
                        "--bending": POSITIVE + ["1.5", "None"],
                        "--wall-thickness": POSITIVE + ["1.5"], "--layers": WHOLE + ["0", "9"],
                        "--detail": ["3", "-5", "half", "2.5", "99999999999", ""]},
    "sample tube": {"name": ["spleen", ""], "-o": TO_PROJECT},
    "sample vessels": {"name": ["spleen", ""], "-o": ["-", "out.esm", ""]},
    "info organ.esm": {"file": FILE},
    "fuzzy eval susilap-g": {"system": FILE, "--set": ["x", "=1", "wind=3", "consistency=tough", "consistency=nan",
                                                       "consistency=1e31", ""]},
    "fuzzy convert susilap-g system.fll": {"from": FILE, "to": ["-", "system", "system.txt", ""]},
    "tissue organ.esm": {"project": FILE, "-o": TO_PROJECT, "--preset": ["tonsil", ""], "--system": FILE, "--wall-thickness": POSITIVE + ["1.5"],
                         "--set": ["consistency=3", "x", ""], "--ellipsoid": ELLIPSOID,
                         "--rim": AMOUNT + ["0.1"], "--name": [""],
                         "--override": ["x", "colour=1", "mass=0", "mass=-1", "mass=1e31", "mass=1e-31", "mass=",
                                        "spring_constant=-1", "spring_constant=1e31", "viscosity=-1", "viscosity=nan",
                                        "viscosity=1e31", "youngs_modulus=-1", "relaxation_time=nan", ""],
                         "--biphasic": [["0.2"], ["0", "5"], ["-1", "5"], ["nan", "5"], ["0.2", "0"], ["0.2", "1e31"],
                                        ["1e31", "5"], ["", "5"]],
                         "--linear": [["--biphasic", "0.2", "5"]],
                         "--bending": POSITIVE + ["1.5", "None"]},
    "scale organ.esm": {"project": FILE, "-o": TO_PROJECT, "--factor": POSITIVE, "--keep": ["volume", ""],
                        "--points": ["x", "1 2 3", "0 0 0 0 0 0", "nan 0 0 1 1 1", ""], "--length": POSITIVE},
    "inside organ.esm --fill cubic": {"project": FILE, "-o": TO_PROJECT, "--fill": ["foam", "Cubic", ""], "--spacing": POSITIVE,
                                        "--wall-thickness": POSITIVE + ["1.5"], "--layers": WHOLE + ["0", "9"]},
    "sheet organ.esm --springs even": {"project": FILE, "-o": TO_PROJECT, "--springs": ["some", "Even", ""]},
    "scene organ.esm --scene scene.json": {"project": FILE, "--scene": FILE, "-o": TO_PROJECT},
    "simulate organ.esm --scene scene.json": {
        "model": FILE, "--scene": FILE, "-o": ["-", "out.esm", ""], "--integrator": ["leapfrog", "EULER", ""],
        "--dt": POSITIVE + ["AUTO"], "--precision": ["half", ""], "--damping": ["none", ""],
        "--rest-tolerance": AMOUNT, "--max-error": POSITIVE + ["1e-300"],
        "--surface": ["-", "out.esm", "out.csv", ""], "--forces": ["-", "out.esm", "out.csv", ""]},
    "stability organ.esm": {"model": FILE, "--scene": FILE, "--damping": ["none", ""]},
    "tradeoff organ.esm": {"model": FILE, "--scene": FILE, "--max-error": POSITIVE + ["1e-300"],
                           "--real-time": POSITIVE + ["1e-300"], "--max-seconds": POSITIVE,
                           "--plot": ["-", "chart.gif", "chart", ""], "--csv": ["-", "out.esm", ""],
                           "--damping": ["none", ""], "-o": TO_PROJECT,
                           "--save": ["best", ""]},
    "probe organ.esm --at 0,0,0": {"model": FILE, "--at": ["x", "1 2", "nan 0 0", ""], "--node": None,
                                   "--direction": ["x", "1 2", "nan 0 0", ""], "--radius": POSITIVE,
                                   "--depth": POSITIVE, "--steps": WHOLE + ["0", "1001"], "--relax": POSITIVE,
                                   "--creep": POSITIVE, "--creep-time": POSITIVE, "--with": FILE,
                                   "--strip": None, "--along": None, "--stretch": None,
                                   "--csv": ["-", "out.esm", ""], "--plot": ["-", "chart.gif", "chart", ""]},
    "probe organ.esm --at 0,0,0 --strip 0.04,0.01": {
        "model": FILE, "--at": ["x", "1 2", "nan 0 0", ""], "--node": None, "--direction": None, "--radius": None,
        "--depth": None, "--steps": None, "--relax": None, "--creep": None, "--creep-time": None, "--with": None,
        "--csv": None, "--plot": None, "--strip": ["x", "1", "1 2 3", "nan 1", "0 1", "-1 1", ""],
        "--along": ["x", "1 2", "nan 0 0"], "--stretch": POSITIVE + ["1.5"]},
    "extremes": {"-o": ["-", "out.esm", ""]},
    "texture pack organ.esm": {
        "project": FILE, "-o": TO_PROJECT, "--size": WHOLE + ["0", "-5", "16385"], "--pages": WHOLE + ["0", "-1", "65"],
        "--gap": WHOLE + ["-1", "16385"], "--texels-per-metre": AMOUNT + ["1e10"], "--layout": ["spiral", ""]},
    "texture photo organ.esm --photo photo.png --projector pose.json": {
        "project": FILE, "--photo": FILE, "--projector": FILE, "-o": TO_PROJECT, "--blend": AMOUNT,
        "--blending": ["lighten", "Screen", ""], "--name": [""], "--field": None,
        "--mask-overlays": None, "--fill-highlights": None, "--highlights": AMOUNT + ["1.01"],
        "--white-spot": ["x", "1", "1 2 3", "-1 5", "nan 5", "1e9 5", ""], "--white-like": FILE,
        "--even-light": AMOUNT + ["1.01"], "--white-balance": None, "--match-colours": None, "--lens": FILE,
        "--levels": ["x", "10 200", "0 255 0", "0 255 11", "-1 255 1", "0 256 1", "100 100.5 1", "0 nan 1", ""],
        "--contrast": AMOUNT + ["2.01"], "--saturation": AMOUNT + ["2.01"], "--hue": NUMBER + ["-181", "181"],
        "--crop": ["x", "1 2 3", "0 0 -1 5", "0.5 0 5 5", "0 0 0 5", "0 0 5 0", "0 0 5 nan", ""]},
    "texture replace organ.esm --layer photo --photo photo.png": {
        "project": FILE, "--layer": ["nobody", ""], "--photo": FILE, "-o": TO_PROJECT},
    "texture fit organ.esm --photo photo.png --pairs pairs.csv": {
        "project": FILE, "--photo": FILE, "--pairs": FILE, "-o": ["-", "out.png", ""], "--refine": None,
        "--intrinsics": ["x", "1,2,3", "0,1,1,1", "1,-1,0,0", "1,1,nan,1", "1e8,1,0,0", "1,1,1e8,0", ""]},
    "texture finish organ.esm --layer photo --preset fat": {
        "project": FILE, "-o": TO_PROJECT, "--layer": ["nobody", ""], "--preset": ["bone", ""],
        "--roughness": AMOUNT + ["1.01"], "--wetness": AMOUNT + ["1.01"], "--wet-at-highlights": AMOUNT + ["1.01"],
        "--relief": AMOUNT + ["5.01"], "--colour": ["red", ""],
        "--occlusion": AMOUNT + ["100.1"], "--remove": None},
    "texture bake organ.esm": {"project": FILE, "-o": ["-", ""], "--bits": ["7", "x", ""], "--smaller": None,
                               "--pictures": ["gif", "PNG", ""], "--quality": WHOLE + ["0", "101", "50"]},
    "export organ.esm --to glb": {"project": FILE, "-o": ["-", "out.esm", ""], "--to": ["stl", "GLB", ""],
                               "--pictures": ["gif", "PNG", ""], "--quality": WHOLE + ["0", "101", "50"],
                               "--dt": ["0", "-1", "x", "nan", "auto", ""], "--damping": ["none", "AXIAL", ""],
                               "--sofa": ["22.06", "26", ""], "--dry-run": None,
                               "--title": ["", "t" * 1001, "two\nlines"], "--author": [""], "--licence": [""],
                               "--date": ["today", "26", "2026-13", "2026-02-30", "2026-5-1", "2026-05-17T10:00", ""]},
    "validate organ.esm": {"file": FILE},
    "render organ.esm": {
        "project": FILE, "-o": ["-", "out.jpg", ""], "--size": ["x", "10", "10x", "0x10", "10x99999", "1e2x9", ""],
        "--view": ["behind", "FRONT", "1 2 3", "0 0 0 0 0 0", "nan 0 0 0 0 0", "1e31 0 0 0 0 0", ""], "--camera": FILE,
        "--orthographic": None, "--colour-by": ["beauty", "Mass", "strain", "speed", ""],
        "--cut": ["x", "viewer", "viewer:", "x:0.5", "+x:1.1", "+x:-0.1", "+x:nan", "+x:0.5 0.5", ""],
        "--show": ["bones", "surface,", ",", ""], "--motion": FILE, "--at": ["1"], "--unlit": None,
        "--light": ["sun", ""]},
}
OUTPUTS = {"simulate": "out.csv", "texture fit": "out.json", "texture bake": "pages", "export": "out.glb",
           "render": "out.png", "extremes": "out.md"}


def options_of(name):
    """The options and positionals that a command's help lists, each by the first of its names."""
    text = command(*name.split(), "--help").stdout
    names = re.findall(r"^  (-{0,2}[a-z][-a-z]*)\b", text, re.MULTILINE)
    return set(names) - {"-h"}


class OptionValueTest(Case):
    def setUp(self):
        super().setUp()
        self.done("sample", "tube", "-o", self.file("organ.esm"))
        self.done("sample", "vessels", "-o", self.file("photo.png"))
        self.file("cube.obj", CUBE)
        self.file("pose.json", PROJECTOR)
        self.file("scene.json", {"duration": 0.01})
        self.file("pairs.csv", "photo_x,photo_y,x,y,z\n")

    def words(self, name):
        return [str(self.file(word)) if re.search(r"\.[a-z]+$", word) else word for word in name.split()]

    def command_of(self, name):
        first = name.split()[:2]
        return " ".join(first) if first[0] in ("fuzzy", "texture") else first[0]

    def with_value(self, name, option, value):
        """The line with a wrong value in place of, or beside, what is right."""
        line, output = self.words(name), OUTPUTS.get(self.command_of(name), "out.esm")
        if option.startswith("-") and option in line:
            line[line.index(option) + 1] = value
        elif option.startswith("-"):
            line += [option, *(value if isinstance(value, list) else [value])]
        else:
            place = len(self.command_of(name).split())
            line[place + (option == "to")] = value
        if option != "-o" and self.command_of(name) not in ("info", "fuzzy eval", "fuzzy convert", "probe", "stability",
                                                                      "validate"):
            line += ["-o", str(self.file(output))]
        return line

    def test_every_option_is_looked_at(self):
        for name, options in COMMANDS.items():
            self.assertEqual(set(options), options_of(self.command_of(name)), name)

    def test_a_line_without_a_wrong_value_is_none(self):
        for name in COMMANDS:
            if name.startswith("probe"):
                self.assertNotEqual(command(*self.words(name)).returncode, 2, name)

    def test_a_wrong_value_is_wrong_usage(self):
        before = sorted(self.folder.rglob("*"))
        for name, options in COMMANDS.items():
            for option, values in options.items():
                for value in values or []:
                    line = self.with_value(name, option, value)
                    with self.subTest(line):
                        message = self.fails(2, *line, cwd=self.folder)
                        self.assertIn(f"see esmc {self.command_of(name)} --help", message)
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_a_right_value_that_does_not_suit_the_file_is_work_that_failed(self):
        organ, out = self.file("organ.esm"), self.file("out.esm")
        photo = ["texture", "photo", organ, "--photo", self.file("photo.png"), "--projector", self.file("pose.json")]
        for line in (["texture", "pack", organ, "--size", "16"], ["texture", "pack", organ, "--texels-per-metre", "1e9"],
                     photo + ["--crop", "0 0 512 513"], ["import", self.file("cube.obj"), "--weld", "100"]):
            with self.subTest(line):
                self.fails(1, *line, "-o", out)
        self.assertFalse(out.exists())

    def test_what_a_file_holds_is_never_wrong_usage(self):
        organ, bad = self.file("organ.esm"), self.file("bad")
        photo, pose = self.file("photo.png"), self.file("pose.json")
        lens = ["texture", "photo", organ, "--photo", photo, "--projector", pose, "-o", organ, "--lens", bad]
        for line in (["import", bad, "-o", organ], ["info", bad], ["fuzzy", "eval", bad], ["tissue", organ, "--system", bad, "-o", organ],
                     ["fuzzy", "convert", bad, self.file("out.fcl")],
                     ["scene", organ, "--scene", bad, "-o", organ], ["simulate", organ, "--scene", bad, "-o", self.file("out.csv")],
                     ["simulate", bad, "-o", self.file("out.csv")], ["stability", organ, "--scene", bad], ["tradeoff", bad],
                     ["texture", "photo", organ, "--photo", bad, "--projector", pose, "-o", organ],
                     ["texture", "photo", organ, "--photo", photo, "--projector", bad, "-o", organ], lens,
                     ["texture", "fit", organ, "--photo", photo, "--pairs", bad], ["export", bad, "--to", "glb", "-o", self.file("out.glb")],
                     ["validate", bad], ["render", organ, "--camera", bad, "-o", self.file("out.png")],
                     ["render", organ, "--motion", bad, "-o", self.file("out.png")]):
            for content in ("", "Dear reader", "{}", '{"duration": -1, "width": "x", "colour": 3}'):
                self.file("bad", content)
                with self.subTest(f"{line} {content}"):
                    self.fails(1, *line, naming=bad)

    def test_a_format_that_is_not_there_is_named_before_its_ending(self):
        for output in ("organ.stl", "organ.glb", "organ"):
            message = self.fails(2, "export", self.file("organ.esm"), "--to", "stl", "-o", self.file(output))
            self.assertIn("--to: 'stl' is not one of glb, vtp", message)


if __name__ == "__main__":
    unittest.main()
