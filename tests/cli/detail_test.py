import csv
import math
import subprocess
import sys
import unittest
from pathlib import Path

from esmc import Case, command

READER = Path(__file__).with_name("read_package.py")


def surface(rings=24, segments=48):
    """A closed lumpy ball 10 cm wide, as OBJ."""
    lines = []
    for ring in range(1, rings):
        for segment in range(segments):
            polar, around = math.pi * ring / rings, 2 * math.pi * segment / segments
            radius = 0.05 * (1 + 0.15 * math.sin(3 * polar + around))
            lines.append("v %r %r %r" % (radius * math.sin(polar) * math.cos(around), radius * math.cos(polar),
                                         radius * math.sin(polar) * math.sin(around)))
    lines += ["v 0 0.05 0", "v 0 -0.05 0"]
    top, bottom = (rings - 1) * segments + 1, (rings - 1) * segments + 2
    for segment in range(segments):
        after = (segment + 1) % segments
        lines.append("f %d %d %d" % (top, after + 1, segment + 1))
        for ring in range(rings - 2):
            a, b = ring * segments + segment + 1, ring * segments + after + 1
            lines.append("f %d %d %d %d" % (a, b, b + segments, a + segments))
        last = (rings - 2) * segments
        lines.append("f %d %d %d" % (bottom, last + segment + 1, last + after + 1))
    return "\n".join(lines) + "\n"


class DetailTest(Case):
    def imported(self, *options):
        self.project = self.file("organ.esm")
        return self.done("import", self.file("organ.obj", surface()), "-o", self.project, *options)

    def test_fewer_nodes_carry_the_full_surface(self):
        full, fewer = self.imported(), self.imported("--detail", 200)
        self.assertEqual((full["nodes"], full["vertices"], full["detail"]), (1106, 1106, None))
        self.assertEqual((fewer["nodes"], fewer["vertices"], fewer["detail"]), (200, 1106, 200))
        self.assertAlmostEqual(fewer["springs"], 3 * 200 - 6, delta=6)
        for key in ("triangles", "size", "warnings"):
            self.assertEqual(fewer[key], full[key], key)
        self.assertAlmostEqual(fewer["mass"], full["mass"], places=12)
        info = self.done("info", self.project)
        self.assertEqual({key: info[key] for key in fewer}, fewer)
        self.assertIn("200 nodes carry 1106 drawn vertices", command("info", self.project).stdout)
        self.assertTrue(self.done("validate", self.project)["valid"])

    def test_a_detail_that_the_surface_has_not_is_refused(self):
        mesh = self.file("organ.obj", surface())
        self.assertIn("4 to 1106 nodes, not by 2000",
                      self.fails(1, "import", mesh, "-o", self.file("out.esm"), "--detail", 2000, naming="organ.obj"))
        self.assertFalse(self.file("out.esm").exists())

    def test_a_simulator_gets_the_full_surface_and_how_it_is_carried(self):
        for detail in (200, "rigid"):
            self.imported("--detail", detail)
            package = self.file("organ.glb")
            self.done("export", self.project, "--to", "glb", "-o", package)
            self.assertTrue(self.done("validate", package)["valid"])
            info = self.done("info", package)
            self.assertEqual((info["detail"], info["vertices"]), (detail, 1106))
            subprocess.run([sys.executable, READER, package, "--project", self.project], check=True,
                           stdout=subprocess.DEVNULL)

    def test_a_poke_moves_what_is_drawn(self):
        self.imported("--detail", 300)
        scene = self.file("poke.json", {
            "duration": 0.3, "record": {"every": 0.1},
            "tethers": [{"every": 3, "spring_constant": 2.4, "viscosity": 10.7}],
            "instrument": {"shape": "sphere", "radius": 0.015, "path": [[0, 0, 0, 0.09], [0.3, 0, 0, 0.05]]}})
        trajectory = self.file("poke.csv")
        self.assertEqual(self.done("simulate", self.project, "--scene", scene, "-o", trajectory)["warnings"], [])
        package, shots = self.file("organ.glb"), {}
        self.done("export", self.project, "--to", "glb", "-o", package)
        for name, model, options in (("rest", self.project, []), ("start", self.project, ["--at", 0]),
                                     ("end", self.project, ["--at", 9]), ("package", package, [])):
            motion = [] if name == "rest" else ["--motion", trajectory]
            self.done("render", model, "-o", self.file(f"{name}.png"), "--size", "120x90", *motion, *options)
            shots[name] = self.file(f"{name}.png").read_bytes()
        self.assertEqual(shots["start"], shots["rest"])
        self.assertNotEqual(shots["end"], shots["rest"])
        self.assertNotEqual(shots["package"], shots["rest"])

    def test_a_trajectory_must_be_the_models(self):
        self.imported("--detail", 50)
        shot = ("render", self.project, "-o", self.file("shot.png"), "--motion")
        for content, complaint in (("a,b\n", "time,node,x,y,z"), ("time,node,x,y,z\n", "no frame"),
                                   ("time,node,x,y,z\n0,50,0,0,0\n", "line 2"), ("time,node,x,y,z\n0,x,0,0,0\n", "line 2"),
                                   ("time,node,x,y,z\n0,1,nan,0,0\n", "line 2"), ("time,node,x,y,z\n0,1,0,0,0\n", "node 0")):
            self.assertIn(complaint, self.fails(1, *shot, self.file("motion.csv", content), naming="motion.csv"))
        wild = "time,node,x,y,z\n" + "".join(f"{frame},{node},{9e6 if frame and node == 7 else 0},0,0\n"
                                             for frame in (0, 1) for node in range(50))
        self.assertIn("node 7 at 1 s too far away", self.fails(1, *shot, self.file("motion.csv", wild)))
        self.done(*shot, self.file("motion.csv"), "--at", "0.5")
        self.fails(2, "render", self.project, "-o", self.file("shot.png"), "--at", 1)

    def test_a_stiff_organ_is_moved_by_the_published_springs(self):
        report = self.imported("--detail", "rigid", "--mass", 0.5)
        self.assertEqual([report[key] for key in ("nodes", "springs", "vertices", "detail")], [8, 7, 1106, "rigid"])
        self.assertEqual(report["mass"], 0.5)
        info = self.done("info", self.project)
        self.assertEqual((info["fixed"], info["tethers"]), (6, 0))
        scene = self.file("push.json", {"duration": 0.5, "fixed": [{"nodes": [2, 3, 4, 5, 6, 7]}],
                                        "forces": [{"node": 0, "force": [0, 0, -0.3], "from": 0, "to": 0.5}]})
        self.assertTrue(self.done("simulate", self.project, "--scene", scene, "-o", self.file("push.csv"))["stable"])
        with open(self.file("push.csv")) as rows:
            last = list(csv.DictReader(rows))[-8:]
        self.assertLess(float(last[0]["z"]), -0.0005)
        self.done("render", self.project, "-o", self.file("shot.png"), "--size", "80x60", "--motion", self.file("push.csv"))


if __name__ == "__main__":
    unittest.main()
