import json
import math
import os
import shutil
import subprocess
import unittest
from pathlib import Path

from detail_test import surface
from esmc import Case

SCRIPT = Path(__file__).parents[2] / "examples/blender_soft_body.py"
FRAMES, RATE = 48, 24
HANGING = {"duration": FRAMES / RATE, "gravity": [0, -9.81, 0], "record": {"every": 1 / RATE},
           "fixed": [{"ellipsoid": {"centre": [0, 0.05, 0], "radii": [0.03, 0.02, 0.03]}}]}
# Plays the soft body, and prints where its vertices are then, with y up.
PLAY = f"""
import bpy, json
for frame in range(1, {FRAMES} + 2):
    bpy.context.scene.frame_set(frame)
thing = next(thing for thing in bpy.context.scene.objects if thing.modifiers)
now = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
print(json.dumps([(vertex.co.x, vertex.co.z, -vertex.co.y) for vertex in now]))
"""


@unittest.skipUnless(shutil.which("blender"), "Blender is not here")
class BlenderTest(Case):
    def softened(self, package, *options, scripts=()):
        """What the script prints; then what others print that run after it."""
        # Blender's Python takes modules from beside the first python3 on the PATH; NumPy is Debian's.
        environment = {**os.environ, "PATH": "/usr/bin:/bin"}
        python = [word for script in (SCRIPT, *scripts) for word in ("--python", script)]
        run = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", *python, "--", package, *options],
                             capture_output=True, text=True, env=environment)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return [json.loads(line) for line in run.stdout.splitlines() if line.startswith(("{", "["))]

    def ball(self, *options):
        project, package = self.file("ball.esm"), self.file("ball.glb")
        self.done("import", self.file("ball.obj", surface(12, 24)), "-o", project, "--mass", 0.05, *options)
        self.done("tissue", project, "--override", "viscosity=0.01", "-o", project)
        self.done("scene", project, "--scene", self.file("scene.json", HANGING), "-o", project)
        return project, package

    def test_an_organ_hangs_as_deep_in_blender(self):
        project, package = self.ball()
        self.done("export", project, "--to", "glb", "-o", package)
        body, positions = self.softened(package, scripts=[self.file("play.py", PLAY)])
        self.assertEqual((body["vertices"], body["edges"]), (266, 792))
        self.assertAlmostEqual(body["mass"], 0.05, delta=1e-6)
        self.assertAlmostEqual(body["damping_kept"], 1, delta=1e-6)
        self.done("simulate", project, "--integrator", "implicit", "--dt", 0.002, "-o", self.file("out.csv"))
        rows = [line.split(",") for line in self.file("out.csv").read_text().splitlines()[1:]]
        rest, ours = ([list(map(float, row[2:])) for row in part] for part in (rows[:266], rows[-266:]))
        moved = [[math.dist(a, b) for a, b in zip(rest, now)] for now in (ours, positions)]
        for mine, theirs in zip(*moved):
            if mine == 0:
                self.assertLess(theirs, 1e-6, "a fixed vertex has moved")
        means = [sum(distances) / 266 for distances in moved]
        self.assertGreater(means[0], 0.01)
        self.assertAlmostEqual(means[1] / means[0], 1, delta=0.15)

    def test_what_lies_thrice_in_the_texture_is_one_vertex(self):
        project, package = self.ball("--detail", 60)
        self.done("texture", "photo", project, "--photo", self.photo(), "--projector", self.file("pose.json", {
            "pose": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1], "width": 0.2, "height": 0.2, "kind": "parallel"}),
            "-o", project)
        self.done("export", project, "--to", "glb", "-o", package)
        saved = self.file("ball.blend")
        body, = self.softened(package, saved)
        self.assertEqual((body["vertices"], body["edges"]), (266, 792))
        self.assertAlmostEqual(body["mass"], 0.05, delta=1e-6)
        self.assertGreater(saved.stat().st_size, 10000)

    def photo(self):
        self.done("sample", "vessels", "-o", self.file("photo.png"))
        return self.file("photo.png")


if __name__ == "__main__":
    unittest.main()
