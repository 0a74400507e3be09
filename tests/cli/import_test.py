import unittest

from esmc import CUBE, Case, command

IMPORT_KEYS = {"nodes": int, "springs": int, "triangles": int, "components": int, "boundary_edges": int,
               "non_manifold_edges": int, "merged_vertices": int, "removed_triangles": int, "size": list,
               "centre": list, "mass": float, "warnings": list, "boundary_edges_final": int,
               "non_manifold_edges_final": int, "closed_slit_edges": int, "filled_holes": int, "filled_hole_edges": int, "refused_holes": int,
              "dropped_part_edges": int, "boundary_edges_found": int, "loose_border_edges": int, "open_borders": list}


def slit_box(gap):
    """Both halves of a box of 4 x 2 x 2 as they come to lie when the box is sawn in two, `gap` apart."""
    lines, faces = [], []
    for shift, flipped in ((0, False), (2 + gap, True)):
        first = len(lines) + 1
        lines += [f"v {x + shift} {y} {z}" for x in (0, 2) for y in (0, 2) for z in (0, 2)]
        sides = [(1, 2, 4, 3), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4), (5, 7, 8, 6)]
        faces += ["f " + " ".join(str(first - 1 + corner) for corner in side)
                  for number, side in enumerate(sides) if number != (0 if flipped else 5)]
    return "\n".join(lines + faces) + "\n"


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

    def test_closes_slits_in_millimetres_of_the_final_size(self):
        for unit, gap in {"mm": 0.1, "cm": 0.01, "m": 0.0001}.items():
            mesh = slit_box(gap)
            report = self.imported("--unit", unit, mesh=mesh)
            self.assertEqual([report[key] for key in ("components", "boundary_edges_final", "closed_slit_edges")], [2, 8, 0])
            self.assertEqual(self.imported("--unit", unit, "--close", "0.09", mesh=mesh)["boundary_edges_final"], 8)
            closed = self.imported("--unit", unit, "--close", "0.1", mesh=mesh)
            self.assertEqual([closed[key] for key in ("components", "boundary_edges_final", "closed_slit_edges")], [1, 0, 8])
            self.assertEqual(closed["open_borders"], [])
            self.assertIn("8 border edges of slits closed", closed["warnings"])

    def test_fills_holes_and_tells_of_open_borders(self):
        lidless = CUBE.replace("f 2 6 8 4\n", "")
        open_border, = self.imported(mesh=lidless)["open_borders"]
        self.assertEqual(open_border, {"edges": 4, "length": 4, "gap": 1})
        filled = self.imported("--fill-holes", "4", mesh=lidless)
        self.assertEqual((filled["filled_holes"], filled["boundary_edges_final"], filled["mass"]), (1, 0, 1000))
        self.assertEqual((filled["boundary_edges_found"], filled["filled_hole_edges"]), (4, 4))
        self.assertEqual(self.imported("--fill-holes", "3", mesh=lidless)["filled_holes"], 0)

    def test_tells_of_border_edges_around_no_hole(self):
        flap = CUBE + "v 0.5 -1 -1\nf 1 2 9\n"
        report = self.imported("--fill-holes", "500", mesh=flap)
        self.assertEqual([report[key] for key in ("loose_border_edges", "boundary_edges_final", "open_borders", "filled_holes")],
                         [2, 2, [], 0])
        text = command("import", self.file("flap.obj", flap), "-o", self.file("flap.esm")).stdout
        self.assertIn("2 border edges around no hole", text)

    def test_refuses_slits_wider_than_a_tenth_of_the_surface_in_one_line(self):
        message = self.fails(1, "import", self.file("cube.obj", CUBE), "--unit", "cm", "--close", "1.5", "-o",
                             self.file("cube.esm"))
        self.assertIn("--close: 1.5 mm is more than a tenth of the surface's size, 1 mm", message)

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
        for word in ("8 nodes", "merged", "split", "removed", "turned", "slits closed", "filled", "kg"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
