import unittest

from reader_case import FORCE, HEAVIER, HELD, KEPT, LIGHT, OVERDAMPED, PULLED, CSharpCase, ReaderCase, esm_package, largest_difference, size_of


class PythonReaderTest(ReaderCase):
    def agrees(self, file, time_step, steps, within, integrator="euler", **scene):
        """That both move alike, to a part of the organ's size, and move at all."""
        nodes, surface = self.simulated(file, time_step, steps, integrator, **scene)
        package = esm_package.read_package(file)
        motion = esm_package.Motion(package, integrator)
        for _ in range(steps):
            motion.step(time_step, {PULLED: FORCE})
        size = size_of(package)
        self.assertGreater(largest_difference(package.nodes["restPosition"], nodes), 1e-4 * size)
        self.assertLess(largest_difference(motion.positions, nodes), within * size)
        self.assertLess(largest_difference(esm_package.carried(package, motion.positions), surface), within * size)

    def test_reads_every_kept_package(self):
        self.assertGreater(len(KEPT), 10)
        for file in KEPT:
            package, info = esm_package.read_package(file), self.done("info", file)
            self.assertEqual((len(package.nodes["mass"]), len(package.springs["restLength"])), (info["nodes"], info["springs"]), file)
            self.assertEqual(len(package.surface["triangles"]), 3 * info["triangles"], file)

    def test_moves_light_tissue_as_we_do(self):
        self.agrees(self.light_tube(), 3e-4, 1000, 1e-12)

    def test_moves_a_wall_that_bends_as_we_do(self):
        project = self.sample("tube")
        self.done("tissue", project, "--bending", "0.002", "-o", project)
        self.agrees(self.exported(*LIGHT, project=project), 2e-4, 100, 1e-12)

    def test_moves_springs_that_stiffen_as_we_do(self):
        self.agrees(self.light_tube("--biphasic", "0.01", "8"), 1e-4, 1000, 1e-12)

    def test_moves_overdamped_tissue_as_we_do(self):
        self.agrees(self.exported(*OVERDAMPED), 5e-3, 40, 1e-10, "split")

    def test_moves_a_surface_over_fewer_nodes_as_we_do(self):
        project = self.file("coarse.esm")
        self.done("import", self.data("meshes/sks-liver-coloured.ply"), "--unit", "mm", "--detail", "200", "-o", project)
        package = self.exported(*HEAVIER, project=project)
        self.agrees(package, 2e-4, 300, 1e-12)

    def test_moves_a_filled_body_as_we_do(self):
        project = self.file("solid.esm")
        self.done("import", self.data("meshes/sofa-liver-coarse.obj"), "--unit", "cm", "--fill", "body-centred", "--spacing", "0.006",
                  "-o", project)
        self.agrees(self.exported(*HEAVIER, project=project), 1e-4, 200, 1e-12)

    def test_leads_nodes_as_we_do(self):
        file, steps, time_step = self.light_tube(), 200, 3e-4
        way = [0.002, 0, -0.001]
        nodes, _ = self.simulated(file, time_step, steps, moves=[{"node": PULLED, "path": [[0, 0, 0, 0], [steps * time_step, *way]]}])
        package = esm_package.read_package(file)
        motion, rest = esm_package.Motion(package), package.nodes["restPosition"][3 * PULLED:3 * PULLED + 3]
        for step in range(1, steps + 1):
            motion.step(time_step, led={PULLED: [a + step / steps * b for a, b in zip(rest, way)]})
        self.assertLess(largest_difference(motion.positions, nodes), 1e-12 * size_of(package))

    def test_moves_fluid_as_we_do(self):
        project = self.file("closed.esm")
        self.done("import", self.data("meshes/sofa-liver-coarse.obj"), "--unit", "cm", "-o", project)
        fluid = {"fillings": [{"part": 0, "stiffness": 2000}]}
        file = self.exported(*HEAVIER, project=project, scene={**HELD, **fluid})
        self.agrees(file, 5e-5, 300, 1e-12, **fluid)

    def test_as_numpy_it_is_the_same_memory(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("NumPy is not here")
        package = esm_package.read_package(KEPT[0])
        rest = esm_package.shaped(package.nodes["restPosition"], 3)
        self.assertEqual(rest.shape, (len(package.nodes["mass"]), 3))
        rest[1, 2] = 7
        self.assertEqual(package.nodes["restPosition"][5], 7)


class CSharpReaderTest(CSharpCase):
    def test_reads_every_kept_package(self):
        for file in KEPT:
            info, hinges, done = self.done("info", file), esm_package.read_package(file).hinges, self.read(file)
            self.assertEqual((done.returncode, done.stderr), (0, ""), file)
            count = len(hinges.get("stiffness", ()))
            self.assertEqual(done.stdout, f"{info['nodes']} nodes, {info['springs']} springs, {count} hinges\n")

    def agrees(self, file, time_step, steps):
        nodes, surface = self.simulated(file, time_step, steps)
        done = self.read(file, steps, time_step, PULLED, *FORCE)
        self.assertEqual(done.stderr, "")
        found = [[float(number) for number in line.split()] for line in done.stdout.splitlines()[1:]]
        size = size_of(esm_package.read_package(file))
        self.assertLess(largest_difference(found[0], nodes), 1e-12 * size)
        self.assertLess(largest_difference(found[1], surface), 1e-12 * size)

    def test_moves_light_tissue_as_we_do(self):
        self.agrees(self.light_tube(), 3e-4, 1000)

    def test_moves_a_wall_that_bends_and_stiffens_as_we_do(self):
        project = self.sample("tube")
        self.done("tissue", project, "--bending", "0.002", "-o", project)
        self.agrees(self.exported(*LIGHT, "--biphasic", "0.01", "2", project=project), 1e-4, 300)

    def test_moves_a_surface_over_fewer_nodes_as_we_do(self):
        project = self.file("coarse.esm")
        self.done("import", self.data("meshes/sks-liver-coloured.ply"), "--unit", "mm", "--detail", "200", "-o", project)
        self.agrees(self.exported(*HEAVIER, project=project), 2e-4, 300)


if __name__ == "__main__":
    unittest.main()
