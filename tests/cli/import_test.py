import unittest

from esmc import CUBE, Case, command

IMPORT_KEYS = {"nodes": int, "springs": int, "triangles": int, "components": int, "boundary_edges": int,
               "non_manifold_edges": int, "merged_vertices": int, "removed_triangles": int, "size": list,
               "centre": list, "mass": float, "warnings": list, "boundary_edges_final": int,
               "non_manifold_edges_final": int}


class ImportTest(Case):
    def imported(self, *options, mesh=CUBE):
        return self.done("import", self.file("cube.obj", mesh), "-o", self.file("cube.esm"), *options)

    def test_reports_what_became_of_a_cube(self):
        report = self.imported()
        self.assertKeys(report, IMPORT_KEYS)
        self.assertEqual([report[key] for key in ("nodes", "springs", "triangles", "components")], [8, 18, 12, 1])
        self.assertEqual((report["size"], report["centre"]), ([1, 1, 1], [0.5, 0.5, 0.5]))
        self.assertAlmostEqual(report["mass"], 1000)

    def test_size_and_mass_follow_the_unit(self):
        for unit, metres in {"mm": 1e-3, "cm": 1e-2, "m": 1}.items():
            report = self.imported("--unit", unit)
            self.assertAlmostEqual(report["size"][0], metres, places=12)
            self.assertAlmostEqual(report["mass"] / (1000 * metres ** 3), 1, places=9)

    def test_doubts_a_size_no_organ_has_and_names_the_unit_that_fits(self):
        large = "".join(line.replace("1", "200") if line[0] == "v" else line for line in CUBE.splitlines(True))
        warnings = " ".join(self.imported(mesh=large)["warnings"])
        self.assertIn("the model is 200 m large; with --unit mm it would be 0.2 m (the likeliest), with --unit cm it would be 2 m",
                      warnings)
        self.assertEqual(self.imported("--unit", "mm", mesh=large)["warnings"], self.imported()["warnings"])

    def test_turns_z_up_into_y_up(self):
        tower = CUBE.replace(" 1\n", " 3\n")
        self.assertEqual(self.imported(mesh=tower)["size"], [1, 1, 3])
        self.assertEqual(self.imported("--up", "z", mesh=tower)["size"], [1, 3, 1])

    def test_an_open_surface_weighs_as_a_wall_of_three_millimetres(self):
        lidless = CUBE.replace("f 2 6 8 4\n", "")
        report = self.imported(mesh=lidless)
        self.assertAlmostEqual(report["mass"], 5 * 0.003 * 1000)
        self.assertEqual(report["boundary_edges"], 4)

    def test_takes_the_mass_it_is_given(self):
        self.assertAlmostEqual(self.imported("--mass", "0.25")["mass"], 0.25)

    def test_welds_within_metres_and_keeps_the_largest_part(self):
        near = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1.0001 0 0\nv 0 1.0001 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n"
        self.assertEqual(self.imported(mesh=near)["components"], 2)
        welded = self.imported("--weld", "0.001", mesh=near)
        self.assertEqual((welded["components"], welded["merged_vertices"], welded["nodes"]), (1, 2, 4))
        parts = CUBE + "v 9 9 9\nv 8 9 9\nv 9 8 9\nf 9 10 11\n"
        self.assertEqual(self.imported("--keep", "largest", mesh=parts)["triangles"], 12)
        self.assertEqual(self.imported("--keep", "all", mesh=parts)["components"], 2)

    def test_nodes_are_numbered_by_the_first_use_of_the_faces(self):
        mesh = "v 9 9 9\nv 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nf 5 3 2\nf 5 2 4\n"
        self.imported(mesh=mesh)
        scene = self.file("still.json", {"duration": 0.01})
        self.done("simulate", self.file("cube.esm"), "--scene", scene, "-o", self.file("out.csv"))
        rows = self.file("out.csv").read_text().splitlines()[1:5]
        self.assertEqual([tuple(map(float, row.split(",")[2:])) for row in rows],
                         [(1, 1, 0), (0, 1, 0), (0, 0, 0), (1, 0, 0)])

    def test_info_repeats_the_import(self):
        report = self.imported()
        info = self.done("info", self.file("cube.esm"))
        self.assertEqual({key: info[key] for key in report}, report)

    def test_the_result_does_not_depend_on_the_threads(self):
        mesh = self.data("meshes/VH_F_Uterus.glb")
        for threads in (1, 2):
            self.done("import", mesh, "-o", self.file(f"{threads}.esm"), "-j", threads)
        self.assertEqual(self.file("1.esm").read_bytes(), self.file("2.esm").read_bytes())

    def test_text_names_every_repair(self):
        text = command("import", self.file("cube.obj", CUBE), "-o", self.file("cube.esm")).stdout
        for word in ("8 nodes", "merged", "split", "removed", "turned", "kg"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
