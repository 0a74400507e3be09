import gc
import json
import sys
import threading
import unittest
from pathlib import Path

from esmc import Case

try:
    import numpy
except ImportError:
    raise unittest.SkipTest("NumPy is not here (python3-numpy)") from None

import esm

ROOT = Path(__file__).resolve().parents[2]
KEPT = sorted((ROOT / "tests" / "data" / "packages").glob("*.glb"))
sys.path.insert(0, str(ROOT / "examples" / "readers"))
import esm_package  # noqa: E402: its folder is known only now

HELD = {"duration": 0.02, "fixed": [{"nodes": list(range(10))}], "tethers": [{"every": 3, "spring_constant": 2.4, "viscosity": 10.7}]}
PULL = {"forces": [{"node": 85, "force": [0, 0, -1], "from": 0, "to": 1}], "record": {"every": 0.02}}
NAMES = {"rest_positions": ("nodes", "restPosition"), "masses": ("nodes", "mass"), "springs": ("springs", "nodes"),
         "rest_lengths": ("springs", "restLength"), "fixed_nodes": ("fixedNodes", "nodes"), "tether_nodes": ("tethers", "nodes"),
         "tether_spring_constants": ("tethers", "springConstant"), "tether_viscosities": ("tethers", "viscosity"),
         "vertices": ("surface", "restPosition"), "triangles": ("surface", "triangles"), "vertex_nodes": ("surface", "vertexNodes"),
         "tetrahedra": ("lattice", "tetrahedra"), "hinges": ("hinges", "nodes"), "hinge_stiffnesses": ("hinges", "stiffness")}


class ModuleTest(Case):
    def exported(self, *tissue, project=None):
        project = project or self.sample("tube")
        self.done("tissue", project, *tissue, "-o", project)
        self.done("export", project, "--to", "glb", "-o", self.file("organ.glb"))
        return self.file("organ.glb")

    def expect_same(self, tissue, package):
        """That a reader which shares no code finds the same numbers."""
        for name, (group, key) in NAMES.items():
            numbers = getattr(package, group).get(key, ())
            self.assertEqual(getattr(tissue, name).ravel().tolist(), list(numbers), name)
        for name, numbers in zip(("spring_constants", "viscosities"), esm_package.spring_values(package)):
            self.assertEqual(getattr(tissue, name).tolist(), list(numbers), name)
        if package.binding:
            for found, key in zip(tissue.binding, ("starts", "nodes", "shares")):
                self.assertEqual(found.tolist(), list(package.binding[key]), key)

    def test_holds_what_packages_hold(self):
        self.assertGreater(len(KEPT), 10)
        for file in [*KEPT, self.exported("--bending", "0.002", "--biphasic", "0.1", "3")]:
            with self.subTest(file=file.name):
                self.expect_same(esm.load_package(file), esm_package.read_package(file))
        self.assertEqual(esm.load_package(self.file("organ.glb")).stiffening, (0.1, 3))

    def test_shares_memory_that_stays_and_cannot_be_written(self):
        tissue = esm.load_package(KEPT[0])
        for name in NAMES:
            array = getattr(tissue, name)
            self.assertFalse(array.flags.writeable, name)
            self.assertFalse(array.flags.owndata and array.size, name)
        lengths, before = tissue.rest_lengths, tissue.rest_lengths.tolist()
        with self.assertRaises(ValueError):
            lengths[0] = 1
        del tissue
        gc.collect()
        esm.load_package(KEPT[-1])
        self.assertEqual(lengths.tolist(), before)

    def test_evaluates_projects(self):
        project = self.sample("liver")
        self.done("export", project, "--to", "glb", "-o", self.file("liver.glb"))
        opened, packaged = esm.load_project(project), esm.load_package(self.file("liver.glb"))
        tissue = opened.evaluate()
        for name in ("masses", "spring_constants", "viscosities", "rest_positions", "tether_spring_constants"):
            self.assertTrue(numpy.allclose(getattr(tissue, name), getattr(packaged, name), rtol=2e-7, atol=1e-9), name)
        self.assertEqual(tissue.fixed_nodes.tolist(), packaged.fixed_nodes.tolist())
        held = opened.evaluate({"duration": 1, "fixed": [{"nodes": [3, 1]}]})
        self.assertEqual((held.fixed_nodes.tolist(), len(held.tether_nodes)), ([1, 3], 0))
        self.assertEqual(opened.scene["tethers"][0]["every"], 3)
        self.assertEqual([len(region["weights"]) for region in opened.regions], [len(tissue.masses)] * len(opened.regions))

    def test_moves_as_the_command_line_does(self):
        project = self.sample("tube")
        scene = {**HELD, **PULL}
        self.done("simulate", project, "--scene", self.file("scene.json", scene), "--integrator", "split2", "--dt", "1e-3", "-o",
                  self.file("nodes.csv"), "--surface", self.file("surface.csv"))
        simulation = esm.Simulation(esm.load_project(project).evaluate(scene), "split2", 1e-3)
        simulation.set_forces([85], [[0, 0, -1]])
        simulation.step(20)
        for file, found in (("nodes.csv", simulation.positions()), ("surface.csv", simulation.vertices())):
            table = numpy.loadtxt(self.file(file), delimiter=",", skiprows=1)[-len(found):, 2:]
            self.assertEqual(found.tolist(), table.tolist(), file)
        self.assertAlmostEqual(simulation.time, 0.02)
        self.assertEqual((simulation.integrator, simulation.time_step), ("split2", 1e-3))
        simulation.reset()
        self.assertEqual(simulation.positions().tolist(), simulation.tissue.rest_positions.tolist())

    def test_leads_nodes_and_feels_gravity(self):
        tissue = esm.load_package(self.exported())
        simulation = esm.Simulation(tissue, "split", 1e-3)
        there = tissue.rest_positions[5] + [0.001, 0, 0]
        simulation.lead([5], [there])
        simulation.gravity = (0, -9.81, 0)
        simulation.step(5)
        self.assertEqual(simulation.positions()[5].tolist(), there.tolist())
        self.assertLess(numpy.mean(simulation.velocities()[:, 1]), 0)
        self.assertEqual(simulation.gravity, [0, -9.81, 0])

    def test_goes_on_leading_what_it_led_where_a_wish_is_refused(self):
        simulation = esm.Simulation(esm.load_package(KEPT[1]))
        place = simulation.positions()[5] + [0, 0, 0.001]
        simulation.lead([5], [place])
        with self.assertRaises(ValueError):
            simulation.lead([1.9], [[0, 0, 0]])
        simulation.step(3)
        self.assertEqual(simulation.positions()[5].tolist(), place.tolist())

    def test_an_instrument_pushes_and_feels_the_tissue(self):
        tissue = esm.load_package(self.exported())
        simulation, low, high = esm.Simulation(tissue, "split", 1e-3), tissue.rest_positions.min(0), tissue.rest_positions.max(0)
        radius, place = 0.2 * (high - low)[0], (low + high) / 2
        for step in range(100):
            place[0] = high[0] + radius * (1.05 - 0.005 * step)
            simulation.place_instruments([esm.Instrument(radius, place)])
            simulation.step()
        self.assertGreater(numpy.linalg.norm(simulation.vertices() - place, axis=1).min(), 0.99 * radius)
        before = simulation.instrument_impulse()
        self.assertGreater(before[0], 0)
        simulation.step()
        self.assertGreater((simulation.instrument_impulse() - before)[0], 0)
        self.assertEqual(list(simulation.instrument_impulse(1)), [0, 0, 0])

    def test_steps_as_is_recommended(self):
        project = self.sample("tube")
        self.assertIsNone(esm.load_package(self.exported(project=project)).stepping)
        self.done("tradeoff", project, "--scene", self.file("scene.json", {**HELD, **PULL}), "--max-seconds", "0.5", "--max-error",
                  "0.02", "-o", project)
        tissue = esm.load_package(self.exported(project=project))
        run = esm.Simulation(tissue)
        self.assertEqual((run.integrator, run.time_step), (tissue.stepping["integrator"], tissue.stepping["dt"]))
        self.assertNotEqual(esm.Simulation(tissue, "auto").time_step, run.time_step)

    def test_several_run_at_once(self):
        tissue, ends = esm.load_package(self.exported()), {}

        def run(name):
            simulation = esm.Simulation(tissue, "split2", 1e-3)
            simulation.set_forces([85], [[0, 0, -1]])
            simulation.step(200)
            ends[name] = simulation.positions().tolist()

        threads = [threading.Thread(target=run, args=(name,)) for name in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(ends), 3)
        self.assertTrue(all(end == ends[0] for end in ends.values()))

    def test_refuses_other_threads_while_it_steps(self):
        run = esm.Simulation(esm.load_package(self.exported()), "split2", 1e-3)
        asks = (run.positions, run.velocities, run.vertices, run.step, run.reset, lambda: run.time, lambda: run.gravity,
                run.instrument_impulse, lambda: run.place_instruments([]),
                lambda: setattr(run, "gravity", (0, 0, 0)), lambda: run.set_forces([85], [[0, 0, -1]]),
                lambda: run.lead([], numpy.zeros((0, 3))))
        thread = threading.Thread(target=run.step, args=(20000,))
        thread.start()
        while thread.is_alive() and not self.refusal_of(lambda: run.time):
            pass
        refusals = [self.refusal_of(ask) for ask in asks]
        thread.join()
        self.assertEqual(refusals, ["another thread steps this simulation; wait for it, or make one for each thread"] * len(asks))
        self.assertAlmostEqual(run.time, 20)
        self.assertEqual([self.refusal_of(ask) for ask in asks], [""] * len(asks))

    @staticmethod
    def refusal_of(ask):
        try:
            ask()
        except ValueError as refusal:
            return str(refusal)
        return ""

    def test_measures_error_against_cost(self):
        tissue = esm.load_project(self.sample("tube")).evaluate(HELD)
        found = esm.measure(tissue, {**PULL, "duration": 0.02, "record": {"every": 0.005}}, max_error=0.02, max_seconds=0.5)
        self.assertEqual(set(found), {"reference", "runs", "pareto", "recommended"})
        self.assertGreater(len({run["integrator"] for run in found["runs"]}), 3)
        self.assertLessEqual(found["recommended"]["max_error"]["error"], 0.02)
        errors = [run["error"] for run in found["pareto"]]
        self.assertEqual(errors, sorted(errors, reverse=True))

    def test_says_what_is_wrong(self):
        tissue = esm.load_package(KEPT[1])
        simulation, project = esm.Simulation(tissue), esm.load_project(self.sample("tube"))
        torn = self.file("torn.glb", KEPT[1].read_bytes()[:-4])
        for kind, words, work in (
                (OSError, "none.glb", lambda: esm.load_package(self.file("none.glb"))),
                (OSError, "torn.glb", lambda: esm.load_package(torn)),
                (OSError, "torn.glb", lambda: esm.load_project(torn)),
                (ValueError, "leapfrog", lambda: esm.Simulation(tissue, "leapfrog")),
                (ValueError, "half", lambda: esm.Simulation(tissue, precision="half")),
                (ValueError, "step", lambda: esm.Simulation(tissue, "euler", -1)),
                (ValueError, "node 4096", lambda: simulation.set_forces([4096], [[0, 0, 0]])),
                (ValueError, "node -1", lambda: simulation.lead([-1], [[0, 0, 0]])),
                (ValueError, "whole numbers", lambda: simulation.set_forces([1.9], [[0, 0, 1]])),
                (ValueError, "whole numbers", lambda: simulation.lead(["1"], [[0, 0, 1]])),
                (ValueError, "0 or more, not -1", lambda: simulation.step(-1)),
                (ValueError, "not finite", lambda: simulation.set_forces([1], [[0, float("nan"), 0]])),
                (ValueError, "row of three", lambda: simulation.set_forces([1, 2], [[0, 0, 0]])),
                (ValueError, "gravity", lambda: setattr(simulation, "gravity", (0, float("inf"), 0))),
                (ValueError, "durations", lambda: project.evaluate({"durations": 1})),
                (ValueError, "JSON", lambda: project.evaluate("{")),
                (ValueError, "twice", lambda: project.evaluate('{"duration": 1, "duration": 2}')),
                (ValueError, "JSON compliant", lambda: project.evaluate({"duration": float("nan")})),
                (ValueError, "instrument 0: its radius", lambda: simulation.place_instruments([esm.Instrument(-1, (0, 0, 0))])),
                (ValueError, "fixed", lambda: esm.measure(tissue, {"duration": 1, "fixed": [{"nodes": [1]}]}))):
            with self.subTest(words=words), self.assertRaisesRegex(kind, words):
                work()

    def test_takes_any_kind_of_whole_numbers_and_none(self):
        simulation = esm.Simulation(esm.load_package(KEPT[1]))
        for nodes in (numpy.array([1, 2], numpy.uint8), numpy.array([1, 2], numpy.int64), (1, 2)):
            simulation.set_forces(nodes, numpy.zeros((2, 3)))
        simulation.set_forces([], numpy.zeros((0, 3)))
        simulation.step(0)
        self.assertEqual(simulation.time, 0)

    def test_stops_where_motion_runs_wild(self):
        simulation = esm.Simulation(esm.load_package(self.exported()), "euler", 1)
        simulation.set_forces([85], [[0, 0, -1]])
        with self.assertRaises(ArithmeticError):
            simulation.step(1000)
        self.assertTrue(numpy.isfinite(simulation.positions()).all())

    def test_explains_itself(self):
        for thing in (esm, esm.Tissue, esm.Project, esm.Simulation, esm.Instrument, esm.measure, esm.load_package, esm.load_project):
            self.assertTrue(thing.__doc__.strip())


if __name__ == "__main__":
    unittest.main()
