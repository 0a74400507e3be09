import unittest

from reader_case import (FORCE, HEAVIER, KEPT, LIGHT, OVERDAMPED, PULLED, CSharpCase, ReaderCase, changed, esm_package, largest_difference,
                         size_of, without_sums)


FIXED, WAY = 3, (0.002, 0, -0.001)
LEADING = ("euler", LIGHT, 3e-4, 200), ("split", OVERDAMPED, 5e-3, 40)
PRESSING = ("euler", HEAVIER, 1e-4), ("split", OVERDAMPED, 5e-3)


def moves(duration):
    """A free node and a fixed one that are led along `WAY`."""
    return [{"node": node, "path": [[0, 0, 0, 0], [duration, *WAY]]} for node in (PULLED, FIXED)]


def pressure_path(time_step):
    """Rising, even, falling, and past its end within forty steps; Pa. Corners lie between steps, which our program would cut there."""
    return [[2 * time_step, 0], [12 * time_step, 400], [20 * time_step, 400], [31 * time_step, -100]]


def opened(model, gltf):
    """Without the surface's last triangle."""
    model["surface"]["triangleCount"] -= 1
    gltf["accessors"][model["surface"]["triangles"]]["count"] -= 3
    model["drawn"][0].pop("triangles")


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
        for integrator, values, time_step, steps in LEADING:
            file = self.exported(*values)
            nodes, _ = self.simulated(file, time_step, steps, integrator, moves=moves(steps * time_step))
            package = esm_package.read_package(file)
            motion, rest = esm_package.Motion(package, integrator), package.nodes["restPosition"]
            for step in range(1, steps + 1):
                places = {node: [rest[3 * node + axis] + step / steps * WAY[axis] for axis in range(3)] for node in (PULLED, FIXED)}
                motion.step(time_step, led=places)
            self.assertLess(largest_difference(motion.positions, nodes), 1e-10 * size_of(package))
            self.assertEqual(motion.positions[3 * FIXED:3 * FIXED + 3], list(rest[3 * FIXED:3 * FIXED + 3]))

    def test_moves_fluid_as_we_do(self):
        file, fluids = self.filled()
        self.agrees(file, 5e-5, 300, 1e-12, **fluids)

    def test_moves_under_a_pressure_as_we_do(self):
        for integrator, values, time_step in PRESSING:
            file, fluids = self.filled(*values, pressures=[{"part": 0, "path": pressure_path(time_step)}])
            self.agrees(file, time_step, 40, 1e-10, integrator, **fluids)

    def test_numbers_parts_as_we_do(self):
        file, fluids = self.with_part_on_one_node()
        self.agrees(file, 5e-5, 40, 1e-12, **fluids)

    def test_fills_closed_parts_alone(self):
        file, _ = self.filled()
        content = changed(file.read_bytes(), without_sums)
        for word, change in (("part 1 of 1", lambda model, _: model["fillings"][0].update(part=1)), ("open", opened)):
            package = esm_package.read_package(self.file("changed.glb", changed(content, change)))
            with self.assertRaisesRegex(esm_package.PackageError, word):
                esm_package.Motion(package)

    def test_says_when_a_step_is_too_long(self):
        motion = esm_package.Motion(esm_package.read_package(KEPT[1]), "split")
        with self.assertRaisesRegex(esm_package.PackageError, "did not converge; take a shorter step"):
            motion.step(1e308, {5: FORCE})
        self.assertEqual(motion.positions, list(motion.rest))
        motion.step(1e-3, {5: FORCE})
        self.assertNotEqual(motion.positions, list(motion.rest))

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

    def agrees(self, file, time_step, steps, integrator="euler", way=("force", PULLED, *FORCE), within=1e-12, **scene):
        nodes, surface = self.simulated(file, time_step, steps, integrator, **scene)
        done = self.read(file, integrator.capitalize(), steps, time_step, *way)
        self.assertEqual(done.stderr, "")
        found = [[float(number) for number in line.split()] for line in done.stdout.splitlines()[1:]]
        package = esm_package.read_package(file)
        self.assertGreater(largest_difference(package.nodes["restPosition"], nodes), 1e-4 * size_of(package))
        self.assertLess(largest_difference(found[0], nodes), within * size_of(package))
        self.assertLess(largest_difference(found[1], surface), within * size_of(package))

    def test_moves_light_tissue_as_we_do(self):
        self.agrees(self.light_tube(), 3e-4, 1000)

    def test_moves_overdamped_tissue_as_we_do(self):
        self.agrees(self.exported(*OVERDAMPED), 5e-3, 40, "split", within=1e-10)

    def test_leads_nodes_as_we_do(self):
        way = [word for node in (PULLED, FIXED) for word in ("lead", node, *WAY)]
        for integrator, values, time_step, steps in LEADING:
            self.agrees(self.exported(*values), time_step, steps, integrator, way, 1e-10, moves=moves(steps * time_step))

    def test_moves_under_fluid_and_pressure_as_we_do(self):
        for integrator, values, time_step in PRESSING:
            file, fluids = self.filled(*values, pressures=[{"part": 0, "path": pressure_path(time_step)}])
            self.agrees(file, time_step, 40, integrator, within=1e-10, **fluids)

    def test_moves_fluid_as_we_do(self):
        file, fluids = self.filled()
        self.agrees(file, 5e-5, 300, **fluids)

    def test_numbers_parts_as_we_do(self):
        file, fluids = self.with_part_on_one_node()
        self.agrees(file, 5e-5, 40, **fluids)

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
