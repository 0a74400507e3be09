import csv
import json
import math
import shutil
import struct
import subprocess
import sys
import unittest
import zipfile
from decimal import Decimal
from pathlib import Path
from xml.etree import ElementTree

from esmc import Case, command

STILL = {"duration": 0.05}
TUBE_POKE = {"duration": 0.5, "tethers": [{"every": 3, "spring_constant": 2.41327, "viscosity": 10.6875}],
             "forces": [{"node": 85, "force": [0, 0, -1], "from": 0, "to": 1}], "record": {"every": 0.1}}


READER = Path(__file__).with_name("read_package.py")


def sphere_obj(rings=12, around=16, radius=0.05):
    """A closed surface of a radius in metres."""
    text, last = f"v 0 {radius} 0\n", (rings - 1) * around + 2
    for ring in range(1, rings):
        height, circle = radius * math.cos(math.pi * ring / rings), radius * math.sin(math.pi * ring / rings)
        for i in range(around):
            angle = 2 * math.pi * i / around
            text += f"v {circle * math.cos(angle)!r} {height!r} {circle * math.sin(angle)!r}\n"
    text += f"v 0 {-radius} 0\n"
    corner = lambda ring, i: 2 + (ring - 1) * around + i % around
    for i in range(around):
        text += f"f 1 {corner(1, i + 1)} {corner(1, i)}\nf {last} {corner(rings - 1, i)} {corner(rings - 1, i + 1)}\n"
        for ring in range(1, rings - 1):
            text += f"f {corner(ring, i)} {corner(ring, i + 1)} {corner(ring + 1, i + 1)} {corner(ring + 1, i)}\n"
    return text


def digits(number):
    """What a number's text says, whichever way it writes its exponent: "1e-3" and "0.001" are the same."""
    return Decimal(number).normalize().as_tuple()


class SimulateTest(Case):
    def simulated(self, project, scene, *options):
        report = self.done("simulate", project, "--scene", self.file("scene.json", scene), "-o", self.file("out.csv"),
                           *options)
        with open(self.file("out.csv")) as table:
            return report, list(csv.DictReader(table))

    def test_reports_the_run(self):
        report, rows = self.simulated(self.sample("tube"), TUBE_POKE)
        self.assertKeys(report, {"integrator": str, "dt": float, "steps": int, "wall_s": float, "setup_s": float, "factorisation_s": float,
                                 "simulated_s": float, "real_time_factor": float, "stable": bool, "outcome": str,
                                 "active_fraction": float, "energy": dict, "warnings": list})
        self.assertTrue(report["stable"])
        self.assertIn(report["integrator"], ("split", "split2"))
        self.assertTrue(0 < report["factorisation_s"] < report["setup_s"])
        self.assertAlmostEqual(report["simulated_s"], 0.5)
        self.assertEqual(list(rows[0]), ["time", "node", "x", "y", "z"])
        self.assertEqual(len(rows), 6 * 170)
        self.assertEqual(sorted({round(float(row["time"]), 6) for row in rows}), [0, 0.1, 0.2, 0.3, 0.4, 0.5])
        self.assertEqual([int(row["node"]) for row in rows[:170]], list(range(170)))

    def test_a_force_moves_its_node_that_way_and_the_numbers_read_back(self):
        _, rows = self.simulated(self.sample("tube"), TUBE_POKE)
        first, last = (next(row for row in part if row["node"] == "85") for part in (rows, rows[-170:]))
        self.assertLess(float(last["z"]) - float(first["z"]), -1e-4)
        for row in rows:
            for key in ("time", "x", "y", "z"):
                self.assertEqual(digits(row[key]), digits(repr(float(row[key]))), "not the shortest text that reads back")

    def test_a_run_without_a_step_has_no_speed(self):
        scene = self.file("scene.json", {"duration": 1e-300})
        process = command("simulate", self.sample("tube"), "--scene", scene, "-o", self.file("out.csv"))
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertNotIn("nan", process.stdout)

    def test_float_follows_double(self):
        scene = {**TUBE_POKE, "duration": 0.01, "record": {"every": 0.01}}
        ends = [self.simulated(self.sample("tube"), scene, "--integrator", "rk4", "--precision", precision)[1][-170:]
                for precision in ("double", "float")]
        for one, other in zip(*ends):
            for axis in "xyz":
                self.assertAlmostEqual(float(one[axis]), float(other[axis]), delta=1e-5)

    def test_leaves_out_what_rests(self):
        euler = ("--integrator", "euler", "--dt", "1e-6")
        whole, rows = self.simulated(self.sample("tube"), STILL, *euler)
        part, same = self.simulated(self.sample("tube"), STILL, *euler, "--rest-tolerance", "1e-6")
        self.assertEqual(whole["active_fraction"], 1)
        self.assertLess(part["active_fraction"], 0.1)
        self.assertEqual(rows, same)
        chosen, _ = self.simulated(self.sample("tube"), STILL, "--rest-tolerance", "1e-6")
        self.assertEqual(chosen["integrator"], "euler")
        process = command("simulate", self.sample("tube"), "--scene", self.file("scene.json", STILL),
                          "--rest-tolerance", "-1", "-o", self.file("none.csv"))
        self.assertEqual(process.returncode, 2)
        self.assertIn("--rest-tolerance", process.stderr)

    def test_predicts_stable_steps(self):
        project = self.sample("tube")
        scene = self.file("scene.json", TUBE_POKE)
        report = self.done("stability", project, "--scene", scene)
        self.assertKeys(report, {"omega_max": float, "critical_dt": dict, "critical_dt_any_deformation": dict})
        self.assertIsNone(report["critical_dt"]["implicit"])
        self.assertIn("implicit: no limit", report["critical_dt"]["note"])
        for integrator, step in report["critical_dt"].items():
            if integrator == "note" or step is None:
                continue
            self.assertLessEqual(report["critical_dt_any_deformation"][integrator], 1.002 * step, integrator)
        for factor, stable in ((0.95, True), (1.05, False)):
            process = command("simulate", project, "--scene", scene, "--integrator", "euler", "--dt",
                              factor * report["critical_dt"]["euler"], "-o", self.file("out.csv"))
            self.assertEqual(process.returncode == 0, stable, process.stderr)

    def test_measures_error_against_cost(self):
        scene = self.file("scene.json", {**TUBE_POKE, "record": {"every": 0.05, "nodes": "all"}})
        report = self.done("tradeoff", self.sample("tube"), "--scene", scene, "--max-error", "0.02", "--max-seconds", "1",
                           "--plot", self.file("chart.SVG"))
        self.assertKeys(report, {"reference": dict, "runs": list, "pareto": list, "recommended": dict, "left_out": list})
        for run in report["runs"]:
            if not run["stable"]:
                continue
            self.assertKeys(run, {"integrator": str, "dt": float, "precision": str, "detail": int, "stable": bool, "error": float,
                                  "wall_per_simulated_s": float, "real_time_factor": float})
            margin = 1 if run["error_is_bound"] else 10
            self.assertGreaterEqual(run["error"], margin * report["reference"]["estimated_error"])
        self.assertLessEqual(report["recommended"]["max_error"]["error"], 0.02)
        chart = ElementTree.parse(self.file("chart.SVG")).getroot()
        self.assertGreaterEqual(len(chart.findall("{*}circle")), len(report["runs"]))
        words = [text.text for text in chart.findall("{*}text")]
        self.assertEqual([1, 1, 1], [words.count(name) for name in ("viscous split, second order", "single precision", "real time")])
        errors = [run["error"] for run in report["pareto"]]
        self.assertEqual(errors, sorted(errors, reverse=True))

    def test_measures_a_gentle_pull_where_nothing_moves(self):
        report = self.done("tradeoff", self.sample("tube"), "--scene", self.file("scene.json", {"duration": 0.1}),
                           "--max-seconds", "0.02")
        self.assertIn("gentle pull", report["warnings"][0])
        self.assertTrue(report["runs"])

    def test_says_of_what_it_measured_what_is_not_as_its_name_promises(self):
        led = {"duration": 0.02, "moves": [{"node": 85, "path": [[0, 0, 0, 0], [1, 0, 0, 0.1]]}], "record": {"every": 0.01}}
        report = self.done("tradeoff", self.sample("tube"), "--scene", self.file("led.json", led))
        self.assertIn("adams-moulton", {run["integrator"] for run in report["runs"]})
        self.assertEqual(1, sum("what it gives is rk4's" in warning for warning in report["warnings"]))

    def test_draws_error_over_cost_as_a_picture(self):
        scene = self.file("scene.json", {**TUBE_POKE, "duration": 0.05, "record": {"every": 0.025}})
        chart = self.file("chart.png")
        self.done("tradeoff", self.sample("tube"), "--scene", scene, "--max-seconds", "0.02", "--plot", chart)
        for option, name in (("--plot", "chart.svg"), ("--csv", "runs.csv"), ("-o", "organ.esm")):
            self.fails(1, "tradeoff", self.sample("tube"), "--max-seconds", "1000", option, self.file("missing") / name,
                       naming="make it first")
        self.assertEqual(chart.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_writes_every_run_as_a_row_of_a_table(self):
        scene = self.file("scene.json", {**TUBE_POKE, "duration": 0.05, "record": {"every": 0.025}})
        report = self.done("tradeoff", self.sample("tube"), "--scene", scene, "--max-seconds", "0.02", "--csv",
                           self.file("runs.csv"))
        with open(self.file("runs.csv"), newline="", encoding="ascii") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([(run["integrator"], run["dt"], run["detail"]) for run in report["runs"]],
                         [(row["integrator"], float(row["step_s"]), int(row["nodes"])) for row in rows])
        self.assertEqual(len(report["pareto"]), sum(row["unbeaten"] == "yes" for row in rows))

    def test_steps_as_was_measured_and_saved(self):
        scene = {**TUBE_POKE, "record": {"every": 0.05}}
        project = self.sample("tube")
        report = self.done("tradeoff", project, "--scene", self.file("scene.json", scene), "--max-error", "0.05",
                           "--max-seconds", "0.05", "-o", project)
        saved = report["saved"]
        self.assertEqual(saved, report["recommended"]["max_error"])
        run, _ = self.simulated(project, scene)
        self.assertEqual((run["integrator"], run["dt"]), (saved["integrator"], saved["dt"]))
        self.done("export", project, "--to", "glb", "-o", self.file("tube.glb"))
        run, _ = self.simulated(self.file("tube.glb"), scene)
        self.assertEqual((run["integrator"], run["dt"]), (saved["integrator"], saved["dt"]))
        for file in (project, self.file("tube.glb")):
            told = self.done("info", file)["stepping"]
            self.assertEqual({**{key: saved[key] for key in told if key in saved}, "tissue_changed": False}, told)
        run, _ = self.simulated(project, scene, "--integrator", "bdf2", "--dt", "0.003")
        self.assertEqual((run["integrator"], run["dt"]), ("bdf2", 0.003))
        self.assertEqual(self.simulated(project, scene)[0]["warnings"], [])
        self.done("tissue", project, "--override", "viscosity=2.9", "-o", project)
        self.assertTrue(self.done("info", project)["stepping"]["tissue_changed"])
        for report in (self.simulated(project, scene)[0],
                       self.done("export", project, "--to", "glb", "-o", self.file("tube.glb"))):
            self.assertRegex(report["warnings"][0], "tissue has changed since .* measure again")

    def test_steps_as_auto_says_where_the_tissue_has_outgrown_the_saved_step(self):
        stepping = {"integrator": "euler", "timeStep": 1e-6, "precision": "double", "error": 0.01,
                    "wallPerSimulatedSecond": 1}
        project = self.changed_manifest("stepped.esm", lambda manifest: {**manifest, "stepping": stepping})
        scene = {"duration": 0.001, "tethers": TUBE_POKE["tethers"]}
        run, _ = self.simulated(project, scene)
        self.assertEqual((run["integrator"], run["dt"], run["warnings"]), ("euler", 1e-6, []))
        self.done("tissue", project, "--override", "spring_constant=1e9", "-o", project)
        run, _ = self.simulated(project, scene)
        self.assertTrue(run["stable"])
        self.assertNotEqual((run["integrator"], run["dt"]), ("euler", 1e-6))
        self.assertRegex(run["warnings"][0], "too long for euler .* measure again")

    def test_saves_nothing_that_is_not_reached(self):
        scene = self.file("scene.json", {**TUBE_POKE, "duration": 0.05, "record": {"every": 0.025}})
        project = self.sample("tube")
        before = project.read_bytes()
        message = self.fails(1, "tradeoff", project, "--scene", scene, "--max-seconds", "0.02", "--real-time", "1e9",
                             "--save", "real_time", "-o", project)
        self.assertIn("nothing was saved", message)
        self.assertEqual(project.read_bytes(), before)

    def test_shortens_the_step_to_the_error_that_is_wanted(self):
        rough, _ = self.simulated(self.sample("tube"), TUBE_POKE, "--max-error", "0.05")
        fine, rows = self.simulated(self.sample("tube"), TUBE_POKE, "--max-error", "1e-6")
        self.assertLessEqual(fine["estimated_error"], 1e-6)
        self.assertLess(fine["dt"], rough["dt"])
        self.assertEqual(len(rows), 6 * 170)

    def test_a_scene_that_records_no_node_has_no_error_to_tell(self):
        scene = self.file("scene.json", {**TUBE_POKE, "record": {"nodes": []}})
        for command_line in (["simulate", self.sample("tube"), "-o", "out.csv"], ["tradeoff", self.sample("tube")]):
            self.fails(1, *command_line, "--scene", scene, naming="records no node")
        self.assertFalse(self.file("out.csv").exists())

    def test_says_which_swings_an_estimated_error_leaves_out(self):
        project = self.sample("tube")
        self.assertFalse(self.simulated(project, TUBE_POKE, "--max-error", "0.05")[0]["hides_swings"])
        self.done("tissue", project, "--override", "viscosity=0", "--override", "spring_constant=1e15", "-o", project)
        report, _ = self.simulated(project, {**TUBE_POKE, "duration": 0.1}, "--integrator", "projective", "--dt", "0.01",
                                   "--max-error", "0.5")
        self.assertTrue(report["hides_swings"])
        self.assertIn("projective damps them away", report["warnings"][0])

    def test_says_where_an_integrator_is_not_what_its_name_promises(self):
        def warned(scene, integrator):
            report, _ = self.simulated(self.sample("tube"), scene, "--integrator", integrator, "--dt", "2e-6")
            return "\n".join(report["warnings"])

        pushed = {"duration": 1e-4, "forces": [{"node": 85, "force": [0, 0, 0.1]}]}
        led = {"duration": 1e-4, "moves": [{"node": 85, "path": [[0, 0, 0, 0], [1, 0, 0, 0.1]]}]}
        self.assertIn("what it gives is rk4's", warned(led, "adams-moulton"))
        self.assertNotIn("rk4's", warned(pushed, "adams-moulton"))
        self.assertNotIn("rk4's", warned(led, "rk4"))
        self.assertIn("projective lags behind", warned(pushed, "projective"))
        self.assertNotIn("lags behind", warned(pushed, "implicit"))

    def test_integrators_agree(self):
        project = self.sample("tube")
        ends = {}
        for integrator, step in {"split": "0.001", "split2": "0.005", "euler": "auto", "verlet": "auto", "heun": "auto",
                                 "rk4": "auto", "adams-moulton": "auto", "propagation": "auto", "implicit": "0.0001",
                                 "bdf2": "0.0005", "projective": "0.0001", "trapezoid": "0.0005"}.items():
            scene = {**TUBE_POKE, "duration": 0.02, "record": {"every": 0.02, "nodes": [85]}}
            report, rows = self.simulated(project, scene, "--integrator", integrator, "--dt", step)
            self.assertEqual(report["integrator"], integrator)
            ends[integrator] = float(rows[-1]["z"]) - float(rows[0]["z"])
        for integrator in ends:
            self.assertAlmostEqual(ends[integrator] / ends["euler"], 1, delta=0.05)

    def test_does_not_depend_on_the_threads(self):
        project = self.sample("liver")
        scene = {"duration": 0.1, "gravity": [0, -9.81, 0], "fixed": [{"nodes": [0, 1, 2]}]}
        outputs = []
        for threads in (1, 2):
            self.simulated(project, scene, "-j", threads)
            outputs.append(self.file("out.csv").read_bytes())
        self.assertEqual(*outputs)

    def test_records_chosen_nodes_and_keeps_fixed_ones(self):
        scene = {**TUBE_POKE, "fixed": [{"nodes": [7]}], "gravity": [0, -9.81, 0], "record": {"every": 0.5, "nodes": [7, 3]}}
        _, rows = self.simulated(self.sample("tube"), scene)
        self.assertEqual([row["node"] for row in rows], ["7", "3", "7", "3"])
        self.assertEqual([rows[0][key] for key in "xyz"], [rows[2][key] for key in "xyz"])
        self.assertNotEqual(rows[1]["y"], rows[3]["y"])

    def test_a_move_leads_a_node_from_its_rest(self):
        scene = {"duration": 0.5, "moves": [{"node": 12, "path": [[0, 0, 0, 0], [0.5, 0, 0, -0.01]]}],
                 "tethers": TUBE_POKE["tethers"], "record": {"every": 0.5, "nodes": [12]}}
        _, rows = self.simulated(self.sample("tube"), scene)
        self.assertAlmostEqual(float(rows[-1]["z"]) - float(rows[0]["z"]), -0.01, places=6)

    def test_a_step_that_is_too_long_ends_with_the_last_good_frames(self):
        project, scene, out = self.sample("tube"), self.file("scene.json", TUBE_POKE), self.file("out.csv")
        process = command("simulate", project, "--scene", scene, "--integrator", "euler", "--dt", "0.01", "-o", out, "--json")
        self.assertEqual(process.returncode, 1)
        self.assertRegex(process.stderr, r"\Aesmc: [^\n]+\n\Z")
        report = json.loads(process.stdout)
        self.assertFalse(report["stable"])
        self.assertTrue(report["outcome"])
        with open(out) as table:
            rows = list(csv.DictReader(table))
        self.assertGreaterEqual(len(rows), 170)
        self.assertTrue(all(math.isfinite(float(row[key])) for row in rows for key in ("time", "x", "y", "z")))

    def test_the_stored_scene_runs_until_another_is_named(self):
        project = self.sample("tube")
        report = self.done("scene", project, "--scene", self.file("poke.json", {**TUBE_POKE, "fixed": [{"nodes": [0, 1]}]}),
                           "-o", project)
        self.assertEqual(report, {"fixed": 2, "tethers": 57, "duration": 0.5, "warnings": []})
        info = self.done("info", project)
        self.assertEqual((info["fixed"], info["tethers"], info["instrument"]), (2, 57, False))
        stored = self.done("simulate", project, "-o", self.file("a.csv"))
        self.assertAlmostEqual(stored["simulated_s"], 0.5)
        other, _ = self.simulated(project, STILL)
        self.assertAlmostEqual(other["simulated_s"], 0.05)

    def test_says_what_a_scene_leaves_out_of_what_is_stored(self):
        project, package = self.sample("tube"), self.file("tube.glb")
        held = self.file("held.json", {**STILL, "fixed": [{"nodes": [0, 1]}], "tethers": TUBE_POKE["tethers"]})
        self.done("scene", project, "--scene", held, "-o", project)
        self.done("export", project, "--to", "glb", "-o", package)
        loose, out = self.file("loose.json", STILL), self.file("out.csv")
        told = ["the scene names no fixed nodes: those stored (2) do not hold in this run",
                "the scene names no tethers: those stored (57) do not hold in this run"]
        for model in (project, package):
            for scene, expected in ((loose, told), (held, [])):
                self.assertEqual(self.done("simulate", model, "--scene", scene, "-o", out)["warnings"], expected)
                self.assertEqual(self.done("stability", model, "--scene", scene)["warnings"], expected)
            self.assertEqual(self.done("simulate", model, "-o", out)["warnings"], [])
        measured = self.done("tradeoff", project, "--scene", loose, "--max-seconds", "0.02")
        self.assertEqual(measured["warnings"][-2:], told)

    def test_warns_of_entries_without_effect(self):
        project = self.sample("tube")
        scene = {**STILL, "fixed": [{"nodes": [7]}, {"ellipsoid": {"centre": [9, 9, 9], "radii": [1, 1, 1]}}],
                 "moves": [{"node": 7, "path": [[0, 0, 0, 0.01]]}]}
        report, _ = self.simulated(project, scene)
        stored = self.done("scene", project, "--scene", self.file("scene.json", scene), "-o", project)
        for warnings in (report["warnings"], stored["warnings"]):
            self.assertEqual([warning.split(":")[0] for warning in warnings][:2], ["fixed[1]", "moves[0]"])

    def test_says_that_all_are_of_the_first_order_under_an_instrument(self):
        touched = {"duration": 0.02, "instrument": {"shape": "sphere", "radius": 0.02, "path": [[0, 0, 0, 0.01], [1, 0, 0, 0]]}}
        for integrator, dt, is_warned in (("rk4", "2e-6", True), ("split", "auto", False), ("auto", "auto", False)):
            report, _ = self.simulated(self.sample("tube"), touched, "--integrator", integrator, "--dt", dt)
            said = "\n".join(report["warnings"])
            self.assertNotIn("never touches", said)
            self.assertEqual("of the first order alone" in said, is_warned, integrator)

    def test_says_when_the_instrument_never_touches(self):
        project = self.sample("liver")
        _, rest = self.simulated(project, {"duration": 1e-6}, "--dt", "1e-6")
        front = max(rest, key=lambda row: float(row["z"]))
        x, y, z = (float(front[key]) for key in "xyz")
        for height, warned in ((0.03, True), (0.018, False)):
            path = [[0, x, y, z + 0.05], [0.1, x, y, z + height]]
            report, _ = self.simulated(project, {"duration": 0.1, "instrument": {"shape": "sphere", "radius": 0.02, "path": path}})
            self.assertEqual(any("never touches" in warning for warning in report["warnings"]), warned, height)

    def test_writes_the_forces_on_each_instrument(self):
        project, forces = self.sample("liver"), self.file("forces.csv")
        _, rest = self.simulated(project, {"duration": 1e-6}, "--dt", "1e-6")
        front = max(rest, key=lambda row: float(row["z"]))
        x, y, z = (float(front[key]) for key in "xyz")
        scene = {"duration": 0.1, "record": {"every": 0.02}, "instruments": [
            {"name": "shaft", "shape": "capsule", "radius": 0.005, "length": 0.1,
             "path": [[0, x, y, z + 0.01, 1, 0, 1, 0], [0.1, x, y, z - 0.01, 1, 0, 1, 0]]},
            {"shape": "sphere", "radius": 0.005, "path": [[0, x, y, z + 1]]}]}
        report, _ = self.simulated(project, scene, "--integrator", "split", "--forces", forces)
        with open(forces, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["instrument"] for row in rows[:4]], ["shaft", "instrument 1"] * 2)
        self.assertEqual(len(rows), 12)
        self.assertEqual([float(rows[0][key]) for key in ("time", "fx", "fy", "fz")], [0, 0, 0, 0])
        self.assertGreater(float(rows[-2]["fz"]), 0, "the tissue pushes back")
        shaft, far = report["instruments"]
        sizes = [sum(float(row[key]) ** 2 for key in ("fx", "fy", "fz")) ** 0.5 for row in rows[::2]]
        self.assertEqual((shaft["name"], shaft["touched"], far["touched"], far["peak_force"]), ("shaft", True, False, 0))
        self.assertAlmostEqual(shaft["peak_force"], max(sizes), delta=1e-9 * max(sizes))
        self.assertTrue(any('"instrument 1" never touches' in warning for warning in report["warnings"]))
        still = self.file("none.json", {"duration": 0.1})
        self.fails(1, "simulate", project, "--scene", still, "-o", self.file("o.csv"), "--forces", forces, naming="no instrument")
        self.fails(2, "simulate", project, "--scene", still, "-o", forces, "--forces", forces, naming="name another")

    def test_splits_the_organ_while_it_moves(self):
        octahedron = ("v 0 0 .05\nv .05 0 0\nv 0 .05 0\nv -.05 0 0\nv 0 -.05 0\nv 0 0 -.05\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n"
                      "f 6 3 2\nf 6 4 3\nf 6 5 4\nf 6 2 5\n")
        project = self.file("ball.esm")
        self.done("import", self.file("ball.obj", octahedron), "--unit", "m", "--mass", "0.1", "--springs", "alike", "-o", project)
        scene = {"duration": 0.1, "forces": [{"node": 0, "force": [0, 0, 1]}, {"node": 5, "force": [0, 0, -1]}],
                 "split": [{"time": 0.045, "edges": [[1, 2], [2, 3], [3, 4], [4, 1]]}], "record": {"every": 0.02}}
        surface = self.file("surface.csv")
        report, rows = self.simulated(project, scene, "--integrator", "verlet", "--surface", surface)
        self.assertEqual(report["splits"], [{"split": 0, "time": 0.045, "nodes": [
            {"node": 6 + i, "of": 1 + i, "authored": 1 + i} for i in range(4)]}])
        counts = {}
        for row in rows:
            counts[float(row["time"])] = counts.get(float(row["time"]), 0) + 1
        self.assertEqual([count for _, count in sorted(counts.items())], [6, 6, 6, 10, 10, 10])
        last = {int(row["node"]): float(row["z"]) for row in rows if float(row["time"]) == max(counts)}
        for ring in range(1, 5):
            self.assertGreater(abs(last[ring] - last[ring + 5]), 0.01)
        with open(surface) as table:
            self.assertEqual(len(list(csv.DictReader(table))), 3 * 6 + 3 * 10)
        stored = self.file("stored.esm")
        self.done("scene", project, "--scene", self.file("scene.json", scene), "-o", stored)
        with zipfile.ZipFile(stored) as archive:
            manifest = json.loads(archive.read("manifest.json"))
        self.assertEqual((manifest["version"], manifest["scene"]["split"]), (9, scene["split"]))
        picture = self.file("split.png")
        for at in ("0.02", "0.1"):
            self.done("render", stored, "--motion", self.file("out.csv"), "--at", at, "--show", "surface,springs", "-o", picture)
        self.fails(1, "render", project, "--motion", self.file("out.csv"), "-o", picture, naming="store it in the project first")
        scene["split"][0]["edges"] = [[0, 1]]
        self.fails(1, "simulate", project, "--scene", self.file("one.json", scene), "-o", self.file("o.csv"), naming="parts nothing by itself")

    def test_refuses_more_steps_than_can_be_run_and_takes_any_time_between_frames(self):
        project = self.sample("tube")
        endless, out = self.file("endless.json", {"duration": 1e25}), self.file("no.csv")
        self.fails(1, "simulate", project, "--scene", endless, "-o", out, naming="steps")
        self.fails(1, "simulate", project, "--scene", self.file("still.json", STILL), "--dt", "1e-300", "-o", out,
                   naming="steps")
        self.assertFalse(out.exists())
        _, rows = self.simulated(project, {**STILL, "record": {"every": 1e25}})
        self.assertEqual(len(rows), 2 * 170)

    def surface_of(self, model, scene, *options):
        """Rows of the nodes and of the surface."""
        report = self.done("simulate", model, "--scene", self.file("scene.json", scene), "-o", self.file("out.csv"),
                           "--surface", self.file("surface.csv"), *options)
        self.assertEqual(report["files"], [str(self.file("out.csv")), str(self.file("surface.csv"))])
        with open(self.file("out.csv")) as nodes, open(self.file("surface.csv")) as surface:
            return list(csv.DictReader(nodes)), list(csv.DictReader(surface))

    def test_the_surface_goes_where_its_nodes_go(self):
        project, scene = self.sample("tube"), {**TUBE_POKE, "record": {"every": 0.25}}
        nodes, surface = self.surface_of(project, scene)
        with zipfile.ZipFile(project) as archive:
            carriers = struct.unpack("<170I", archive.read("network/vertex-nodes.u32"))
        self.assertEqual(list(surface[0]), ["time", "vertex", "x", "y", "z"])
        self.assertEqual([int(row["vertex"]) for row in surface], 3 * list(range(170)))
        for frame in range(3):
            for vertex, node in enumerate(carriers):
                shown, carried = surface[170 * frame + vertex], nodes[170 * frame + node]
                self.assertEqual(shown["time"], carried["time"])
                for key in "xyz":
                    self.assertAlmostEqual(float(shown[key]), float(carried[key]), delta=1e-15)

    def test_a_reader_of_the_package_carries_the_surface_as_written(self):
        mesh, project, package = self.file("organ.obj"), self.file("organ.esm"), self.file("organ.glb")
        mesh.write_text(sphere_obj())
        wide = Path(__file__).parents[1] / "data/packages/version-6-wide-binding.glb"
        for detail in ("60", "rigid", None):
            if detail is None:
                shutil.copy(wide, package)
            else:
                self.done("import", mesh, "--detail", detail, "-o", project)
                self.done("export", project, "--to", "glb", "-o", package)
            scene = {"duration": 0.2, "forces": [{"node": 1, "force": [0.3, 0.2, 0.1], "from": 0, "to": 1}],
                     "tethers": [{"every": 3, "spring_constant": 20, "viscosity": 5}], "fixed": [{"nodes": [2, 3, 4, 5, 6, 7]}],
                     "record": {"every": 0.1}}
            nodes, surface = self.surface_of(package, scene)
            reader = subprocess.run([sys.executable, READER, package, "--carry", self.file("out.csv")],
                                    capture_output=True, text=True, check=True)
            places = json.loads(reader.stdout)
            shown = [[float(row[key]) for key in "xyz"] for row in surface]
            self.assertEqual(len(places), len(shown))
            farthest = max(math.dist(place, other) for place, other in zip(places, shown))
            self.assertLess(farthest, 1e-6)
            rest = shown[:len(shown) // 3]
            self.assertGreater(max(math.dist(a, b) for a, b in zip(rest, shown[-len(rest):])), 1e-3)

    def test_the_surface_takes_all_nodes_and_a_file_of_its_own(self):
        project, out = self.sample("tube"), self.file("out.csv")
        one = self.file("one.json", {**STILL, "record": {"every": 0.01, "nodes": [3]}})
        self.fails(1, "simulate", project, "--scene", one, "-o", out, "--surface", self.file("s.csv"), naming="all nodes")
        still = self.file("still.json", STILL)
        for same in (out, self.folder / "." / "out.csv"):
            self.fails(2, "simulate", project, "--scene", still, "-o", out, "--surface", same, naming="--surface")
        self.fails(1, "simulate", project, "--scene", still, "-o", out, "--surface", self.folder, naming=self.folder)
        self.assertFalse(out.exists() or self.file("s.csv").exists())

    def test_a_package_moves_as_its_project(self):
        project, package = self.sample("tube"), self.file("tube.glb")
        self.done("export", project, "-o", package, "--to", "glb")
        scene = {**TUBE_POKE, "record": {"every": 0.5, "nodes": [85]}}
        _, from_project = self.simulated(project, scene, "--dt", "0.01")
        _, from_package = self.simulated(package, scene, "--dt", "0.01")
        for key in "xyz":
            self.assertAlmostEqual(float(from_project[-1][key]), float(from_package[-1][key]), delta=1e-6)

    def test_a_scene_that_names_a_missing_node_is_refused_before_anything_is_written(self):
        project = self.sample("tube")
        for scene in ({**STILL, "fixed": [{"nodes": [170]}]}, {**STILL, "forces": [{"node": 999, "force": [0, 0, 1]}]},
                      {"duration": -1}, {"gravity": [0, 0, 0]}, {**STILL, "gravty": [0, 0, 0]}, {**STILL, "record": {"every": 0}}):
            with self.subTest(scene):
                file = self.file("bad.json", scene)
                self.fails(1, "simulate", project, "--scene", file, "-o", self.file("no.csv"), naming="bad.json")
                self.fails(1, "scene", project, "--scene", file, "-o", self.file("no.esm"), naming="bad.json")
        self.assertFalse(self.file("no.csv").exists() or self.file("no.esm").exists())


if __name__ == "__main__":
    unittest.main()
