import csv
import json
import math
import unittest

from esmc import CUBE, DATA, Case, command


class FuzzyTest(Case):
    def evaluated(self, *pairs, system="susilap-g"):
        return self.done("fuzzy", "eval", system, *(part for pair in pairs for part in ("--set", pair)))

    def test_gives_the_published_values(self):
        outputs = self.evaluated("consistency=5.5")["outputs"]
        self.assertAlmostEqual(outputs["spring_const"] / 16.2606, 1, delta=2e-4)
        self.assertAlmostEqual(outputs["viscosity"] / 2.87713, 1, delta=2e-4)

    def test_reproduces_the_samples(self):
        for name in ("susilap-g", "robo-sim"):
            system = self.data(f"fuzzy/{name}.json")
            with open(DATA / f"fuzzy/{name}.csv") as table:
                rows = [{key: float(value) for key, value in row.items() if key != "note"}
                        for row in csv.DictReader(table)]
            for row in rows[::6]:
                outputs = set(self.evaluated(system=system)["outputs"])
                pairs = [f"{key}={value!r}" for key, value in row.items() if key not in outputs and value == value]
                report = self.evaluated(*pairs, system=system)
                for output in outputs:
                    with self.subTest(f"{name} {pairs} {output}"):
                        if math.isnan(row[output]):
                            self.assertIsNone(report["outputs"][output])
                        else:
                            self.assertAlmostEqual(report["outputs"][output] / row[output], 1, delta=1e-9)

    def test_takes_a_term_for_the_middle_of_its_core(self):
        system = json.loads(self.data("fuzzy/susilap-g.json").read_text())
        terms = system["inputs"]["consistency"]["terms"]
        for name, (_, b, c, _) in terms.items():
            with self.subTest(name):
                self.assertEqual(self.evaluated(f"consistency={name}"), self.evaluated(f"consistency={(b + c) / 2!r}"))
        message = self.fails(2, "fuzzy", "eval", "susilap-g", "--set", "consistency=tough", naming="tough")
        for name in terms:
            self.assertIn(name, message)
        for value in ("red", "1"):
            self.fails(2, "fuzzy", "eval", "susilap-g", "--set", f"colour={value}", naming="consistency")

    def test_without_inputs_no_rule_fires(self):
        report = self.evaluated()
        self.assertEqual(set(report["outputs"].values()), {None})
        self.assertEqual(report["firing"], [0] * 7)
        self.assertEqual(report["inputs"]["consistency"]["range"], [0, 12])
        self.assertIn("input left out: consistency, 0 to 12: very_soft, soft, medium",
                      command("fuzzy", "eval", "susilap-g").stdout)
        self.assertNotIn("left out", command("fuzzy", "eval", "susilap-g", "--set", "consistency=3").stdout)

    def test_rules_may_say_not_or_and_have_weights_and_norms(self):
        system = {"inputs": {"zeal": {"range": [0, 1], "terms": {"much": [0, 1, 1, 1]}},
                             "age": {"range": [0, 10], "terms": {"old": [0, 10, 10, 10]}}},
                  "outputs": {"y": {"range": [0, 4], "terms": {"low": [0, 0, 2, 2], "high": [2, 2, 4, 4]}}},
                  "norms": {"conjunction": "product", "disjunction": "probabilistic-sum"},
                  "rules": ["IF zeal IS much OR age IS old THEN y IS low",
                            "if zeal is not much and (age is old) then y is high with 0.5"]}
        file = self.file("trial.json", system)
        report = self.evaluated("zeal=0.5", "age=5", system=file)
        self.assertEqual(report["firing"], [0.75, 0.125])
        self.assertAlmostEqual(report["outputs"]["y"], (0.75 * 1 + 0.125 * 3) / 0.875, delta=1e-12)
        self.assertIsNone(self.evaluated("zeal=0.5", system=file)["outputs"]["y"])
        text = command("fuzzy", "eval", file, "--set", "zeal=0.5", "--set", "age=5").stdout
        self.assertIn("IF zeal IS NOT much AND age IS old THEN y IS high WITH 0.5", text)
        wrong = self.file("wrong.json", {**system, "norms": {"conjunction": "prod"}, "rules": []})
        self.assertIn("minimum, product", self.fails(1, "fuzzy", "eval", wrong, naming="norms.conjunction"))
        wrong = self.file("rule.json", {**system, "rules": ["IF zeal IS much XOR age IS old THEN y IS low"]})
        self.assertIn("AND, OR or THEN", self.fails(1, "fuzzy", "eval", wrong, naming="rules[0], column 17"))

    def test_warns_out_of_range(self):
        self.assertEqual(self.evaluated("consistency=3")["warnings"], [])
        self.assertIn("consistency", self.evaluated("consistency=13")["warnings"][0])

    def test_warns_of_what_is_odd_about_the_system(self):
        system = {"inputs": {"age": {"range": [0, 9], "terms": {"young": [0, 0, 2, 4], "old": [5, 6, 9, 9]}}},
                  "outputs": {"y": {"range": [0, 4], "terms": {"low": [0, 0, 2, 2], "high": [2, 2, 4, 4]}}},
                  "rules": ["IF age IS old THEN y IS low", "IF age IS NOT young THEN y IS high"]}
        warnings = self.evaluated("age=1", system=self.file("odd.json", system))["warnings"]
        self.assertEqual(warnings, [
            "Rules 1 and 2 contradict each other where age is from 6 to 9: y is low by rule 1 and high by rule 2.",
            "Where age is from 4 to 5 it belongs to no term.",
            "No rule fires where age is from 0 to 2."])

    def test_a_presets_name_means_the_preset_wherever_the_program_runs(self):
        self.file("susilap-g").mkdir()
        self.assertEqual(self.done("fuzzy", "eval", "susilap-g", cwd=self.folder), self.evaluated())

    def test_names_what_it_does_not_know(self):
        for name in ("a.fcl", "b.fll"):
            message = self.fails(1, "fuzzy", "eval", self.file(name, "FUNCTION_BLOCK x"), naming=name)
            self.assertIn("line 1, column ", message)
        self.fails(2, "fuzzy", "eval", "susilap-g", "--set", "colour=3", naming="colour")
        self.assertIn("robo-sim", self.fails(1, "fuzzy", "eval", "susilap-x"))
        self.fails(1, "fuzzy", "eval", self.file("none.json"), naming="none.json")
        self.fails(1, "fuzzy", "eval", self.file("bad.json", "{"), naming="bad.json")


class TissueTest(Case):
    def test_the_whole_organ_takes_what_the_words_say(self):
        project = self.sample("tube")
        report = self.done("tissue", project, "--system", "susilap-g", "--set", "consistency=5.5", "-o", project)
        self.assertKeys(report, {"region": str, "nodes": int, "springs": int, "spring_constant": float,
                                 "viscosity": float, "warnings": list})
        self.assertEqual((report["nodes"], report["springs"], report["mass"]), (170, 340, None))
        self.assertAlmostEqual(report["spring_constant"], 16.2606, delta=0.004)
        self.assertEqual(self.done("info", project)["fuzzy_systems"], ["susilap-g"])

    def test_an_ellipsoid_takes_its_nodes_alone_and_overrides_win(self):
        project = self.sample("liver")
        info = self.done("info", project)
        x, y, z = info["centre"]
        radius = max(info["size"]) / 4
        report = self.done("tissue", project, "--ellipsoid", f"{x + info['size'][0] / 2} {y} {z} {radius} {radius} {radius}",
                           "--name", "lobe", "--override", "spring_constant=50", "--override", "mass=0.2",
                           "-o", self.file("b.esm"))
        self.assertTrue(0 < report["nodes"] < info["nodes"])
        self.assertEqual((report["region"], report["spring_constant"], report["viscosity"], report["mass"]),
                         ("lobe", 50, None, 0.2))
        after = self.done("info", self.file("b.esm"))
        outside = info["mass"] * (1 - report["nodes"] / info["nodes"])
        self.assertAlmostEqual(after["mass"], outside + 0.2, places=9)
        self.assertEqual([region["name"] for region in after["regions"]],
                         [region["name"] for region in info["regions"]] + ["lobe"])
        self.assertEqual(self.done("info", project), info)

    def test_a_turned_ellipsoid_holds_other_nodes(self):
        project = self.sample("tube")
        size, centre = (self.done("info", project)[key] for key in ("size", "centre"))
        long = max(range(3), key=lambda axis: size[axis])
        radii = [size[axis] if axis == long else 1e-3 + min(size) for axis in range(3)]
        text = " ".join(map(str, centre + radii))
        axis = [0, 0, 0]
        axis[(long + 1) % 3] = 1
        turned = " ".join(map(str, [*axis, 90]))
        count = lambda ellipsoid: self.done("tissue", project, "--ellipsoid", ellipsoid, "-o", self.file("b.esm"))["nodes"]
        self.assertEqual(count(text), 170)
        self.assertLess(count(f"{text} {turned}"), 170)

    def test_a_soft_rim_fades_and_keeps_the_mass(self):
        project, soft = self.sample("liver"), self.file("soft.esm")
        info = self.done("info", project)
        self.assertEqual([region["rim"] for region in info["regions"]], [0] * len(info["regions"]))
        where = " ".join(map(str, [*info["centre"], *(size / 4 for size in info["size"])]))
        lobe = ("tissue", project, "--ellipsoid", where, "--override", "mass=0.2", "--name", "lobe")
        sharp = self.done(*lobe, "-o", self.file("sharp.esm"))
        faded = self.done(*lobe, "--rim", "0.03", "-o", soft)
        self.assertEqual((sharp["rim_nodes"], sharp["rim_springs"]), (0, 0))
        self.assertEqual([faded[key] for key in ("nodes", "springs")], [sharp[key] for key in ("nodes", "springs")])
        self.assertTrue(faded["rim_nodes"] > 0 and faded["rim_springs"] > 0)
        self.assertEqual(self.done("info", soft)["regions"][-1]["rim"], 0.03)
        self.assertIn("soft rim 0.03 m", command("info", soft).stdout)
        total = lambda rim: self.done(*lobe, "--rim", rim, "-o", soft) and self.done("info", soft)["mass"]
        self.assertLess(total("0.03"), total("0"))
        self.assertAlmostEqual(total("1e6"), 0.2, places=9)
        self.fails(2, "tissue", project, "--rim", "0.01", "--override", "mass=1", "-o", soft, naming="--ellipsoid")
        for rim in ("-1", "nan", "wide"):
            self.fails(2, *lobe, "--rim", rim, "-o", soft, naming="--rim")

    def test_a_region_without_a_node_is_stored_with_a_warning(self):
        project = self.sample("tube")
        report = self.done("tissue", project, "--ellipsoid", "9 9 9 .1 .1 .1", "--override", "viscosity=1", "-o", project)
        self.assertEqual(report["nodes"], 0)
        self.assertTrue(report["warnings"])
        self.assertEqual(self.done("info", project)["regions"][-1]["name"], report["region"])

    def test_an_input_out_of_range_is_evaluated_with_a_warning(self):
        project = self.sample("tube")
        report = self.done("tissue", project, "--system", "susilap-g", "--set", "consistency=12.5", "-o", project)
        self.assertIn("consistency", " ".join(report["warnings"]))

    def test_the_region_takes_a_word(self):
        project = self.sample("tube")
        said, typed = (self.done("tissue", project, "--system", "susilap-g", "--set", f"consistency={value}", "-o",
                                 self.file("b.esm")) for value in ("flexible", "5.65"))
        self.assertEqual(said, typed)

    def test_an_unknown_input_changes_nothing(self):
        project = self.sample("tube")
        before = project.read_bytes()
        self.fails(2, "tissue", project, "--system", "susilap-g", "--set", "colour=1", "-o", project, naming="colour")
        self.assertEqual(project.read_bytes(), before)


class PresetTest(Case):
    def test_gives_the_whole_organ_tissue_mass_and_tethers(self):
        project = self.sample("liver")
        report = self.done("tissue", project, "--preset", "tube", "-o", project)
        self.assertEqual((report["preset"], report["mass"], report["warnings"]), ("tube", 0.01, []))
        self.assertEqual(report["tethers"], (report["nodes"] + 2) // 3)
        self.assertAlmostEqual(report["spring_constant"] / 16.2606, 1, delta=2e-4)
        self.assertAlmostEqual(self.done("info", project)["mass"], 0.01, places=12)
        heavier = self.done("tissue", project, "--preset", "uterus", "--override", "mass=0.7",
                            "--override", "viscosity=5", "-o", self.file("b.esm"))
        self.assertEqual((heavier["mass"], heavier["viscosity"], heavier["tethers"]), (0.7, 5, report["tethers"]))
        self.assertIn("appendix C.1", command("tissue", project, "--preset", "bowel", "-o", project).stdout)

    def test_a_part_takes_the_tissue_alone(self):
        project = self.sample("tube")
        before = self.done("info", project)
        report = self.done("tissue", project, "--preset", "tube", "--ellipsoid", "0 0 0 .02 .02 .02", "-o", project)
        self.assertIsNone(report["mass"])
        self.assertRegex(report["warnings"][0], "0.01 kg, and its tethers are of the whole organ")
        self.assertEqual(self.done("info", project)["mass"], before["mass"])

    def test_tethers_alone_add_no_region(self):
        project = self.sample("ventricle")
        before = self.done("info", project)
        report = self.done("tissue", project, "--preset", "tube-tethers", "-o", project)
        self.assertIsNone(report["region"])
        self.assertEqual(report["tethers"], (report["nodes"] + 2) // 3)
        self.assertEqual(self.done("info", project)["regions"], before["regions"])
        self.fails(2, "tissue", project, "--preset", "tube-tethers", "--ellipsoid", "0 0 0 1 1 1", "-o", project,
                   naming="--ellipsoid")

    def test_names_the_presets_there_are(self):
        message = self.fails(2, "tissue", "x.esm", "--preset", "tonsil", "-o", "y.esm", naming="tonsil")
        self.assertIn("tube-tethers", message)
        self.fails(2, "tissue", "x.esm", "--preset", "tube", "--system", "robo-sim", "-o", "y.esm", naming="--system")


class ClinicalUnitsTest(Case):
    def spring_constant(self, pascal, wall):
        return math.sqrt(3) / 2 * wall * pascal

    def test_a_modulus_and_a_time_become_spring_constant_and_viscosity(self):
        project = self.sample("tube")
        report = self.done("tissue", project, "--override", "youngs_modulus=4000", "--override", "relaxation_time=0.25",
                           "-o", project)
        self.assertAlmostEqual(report["spring_constant"], self.spring_constant(4000, 0.003), places=9)
        self.assertAlmostEqual(report["viscosity"], 0.25 * report["spring_constant"], places=9)
        self.assertAlmostEqual(report["youngs_modulus"], 4000, places=6)
        self.assertAlmostEqual(report["relaxation_time"], 0.25, places=9)
        region = self.done("info", project)["regions"][-1]
        self.assertAlmostEqual(region["youngs_modulus"], 4000, places=6)

    def test_measured_tissue_is_what_was_measured_on_a_wall_of_any_thickness(self):
        project, package = self.sample("liver"), self.file("liver.glb")
        for wall in (0.003, 0.005):
            self.done("tissue", project, "--wall-thickness", wall, "-o", project)
            report = self.done("tissue", project, "--preset", "liver", "-o", project)
            self.assertAlmostEqual(report["youngs_modulus"], 5490, delta=1)
            self.assertAlmostEqual(report["spring_constant"], self.spring_constant(report["youngs_modulus"], wall), places=6)
            self.assertEqual(self.done("info", project)["wall_thickness"], wall)
        self.done("export", project, "--to", "glb", "-o", package)
        self.assertTrue(self.done("validate", package)["valid"])
        self.assertAlmostEqual(self.done("info", package)["regions"][-1]["youngs_modulus"], 5490, delta=1)

    def test_a_time_alone_needs_a_spring_constant(self):
        project = self.sample("tube")
        before = project.read_bytes()
        self.fails(2, "tissue", project, "--override", "relaxation_time=0.1", "-o", project, naming="relaxation_time")
        self.assertEqual(project.read_bytes(), before)


class WallTest(Case):
    def test_a_wall_resists_bending_and_bends_freely_again(self):
        project = self.sample("tube")
        before, bytes_before = self.done("info", project), project.read_bytes()
        self.assertIsNone(before["bending_thickness"])
        wall = self.file("wall.esm")
        report = self.done("tissue", project, "--bending", "0.003", "-o", wall)
        self.assertEqual((report["region"], report["bending_thickness"]), (None, 0.003))
        self.assertEqual(self.done("info", wall)["bending_thickness"], 0.003)
        self.assertIn("bending: resisted as by a wall of 3 mm", command("info", wall).stdout)
        self.assertIsNone(self.done("tissue", wall, "--bending", "none", "-o", wall)["bending_thickness"])
        self.assertEqual(wall.read_bytes(), bytes_before)

    def test_import_makes_a_wall(self):
        self.file("cube.obj", CUBE)
        project = self.file("cube.esm")
        self.done("import", self.file("cube.obj"), "--bending", "0.002", "-o", project)
        self.assertEqual(self.done("info", project)["bending_thickness"], 0.002)

    def test_what_is_filled_or_rigid_has_no_wall(self):
        self.file("cube.obj", CUBE)
        project = self.file("cube.esm")
        self.fails(2, "import", self.file("cube.obj"), "--detail", "rigid", "--bending", "0.002", "-o", project,
                   naming="only a hollow organ has a wall")
        self.done("import", self.file("cube.obj"), "--detail", "rigid", "-o", project)
        before = project.read_bytes()
        self.fails(2, "tissue", project, "--bending", "0.002", "-o", project, naming="hollow")
        self.assertEqual(project.read_bytes(), before)

    def test_a_flap_keeps_its_form_that_else_hangs_down(self):
        """A strip held at one end under gravity: as a wall of 20 mm it stays up, as a skin it hangs."""
        rows, lines = 9, []
        for x in range(rows):
            lines += [f"v {0.01 * x} 0 0\n", f"v {0.01 * x} 0.01 0\n"]
        for x in range(rows - 1):
            a = 2 * x + 1
            lines += [f"f {a} {a + 2} {a + 3}\n", f"f {a} {a + 3} {a + 1}\n"]
        mesh, project = self.file("strip.obj", "".join(lines)), self.file("strip.esm")
        scene = self.file("hang.json", {"duration": 3, "gravity": [0, 0, -9.81], "fixed": [{"nodes": [0, 1, 2, 3]}],
                                        "tethers": [], "record": {"every": 3}})
        sag = {}
        for thickness in ("none", "0.02"):
            self.done("import", mesh, "--mass", "0.0002", "--bending", thickness, "-o", project)
            self.done("tissue", project, "--override", "spring_constant=20", "--override", "viscosity=0.01",
                      "-o", project)
            frames = self.file(f"{thickness}.csv")
            self.done("simulate", project, "--scene", scene, "-o", frames)
            with open(frames) as table:
                rows_of_nodes = list(csv.reader(table))[-2 * rows:]
            sag[thickness] = -min(float(row[4]) for row in rows_of_nodes)
        self.assertGreater(sag["none"], 0.05)
        self.assertLess(sag["0.02"], 0.02)


class BiphasicTest(Case):
    LAW = {"strain": 0.2, "factor": 5}

    def test_all_springs_take_the_law_and_lose_it_again(self):
        project = self.sample("tube")
        before, bytes_before = self.done("info", project), project.read_bytes()
        self.assertIsNone(before["stiffening"])
        stiff = self.file("stiff.esm")
        report = self.done("tissue", project, "--biphasic", "0.2", "5", "-o", stiff)
        self.assertEqual((report["region"], report["nodes"], report["springs"], report["stiffening"]),
                         (None, 170, 340, self.LAW))
        after = self.done("info", stiff)
        self.assertEqual((after["stiffening"], after["regions"]), (self.LAW, before["regions"]))
        self.assertIn("5 times as stiff once lengthened by more than 20 %", command("info", stiff).stdout)
        for integrator in ("euler", "split"):
            self.assertLess(after["critical_dt"][integrator], before["critical_dt"][integrator])
        self.assertIsNone(self.done("tissue", stiff, "--linear", "-o", stiff)["stiffening"])
        self.assertEqual(stiff.read_bytes(), bytes_before)

    def test_a_region_may_come_with_the_law(self):
        project = self.sample("tube")
        report = self.done("tissue", project, "--biphasic", "0.5", "2", "--override", "spring_constant=9", "-o", project)
        self.assertEqual((report["region"], report["spring_constant"]), ("whole organ", 9))
        again = self.done("tissue", project, "--override", "viscosity=1", "-o", project)
        self.assertEqual(again["stiffening"], {"strain": 0.5, "factor": 2})

    def test_a_law_beyond_all_numbers_changes_nothing(self):
        project = self.sample("tube")
        before = project.read_bytes()
        self.fails(1, "tissue", project, "--biphasic", "0.2", "1e30", "-o", project, naming="stretched springs")
        self.assertEqual(project.read_bytes(), before)

    def test_a_pulled_organ_gives_way_as_the_law_says(self):
        """Three nodes, two of them fixed: a force on the third lengthens two springs alike, far past the strain."""
        foot, height, pulled = 0.02, 0.05, 0.09
        self.file("tent.obj", f"v {-foot} 0 0\nv {foot} 0 0\nv 0 {height} 0\nf 1 2 3\n")
        project, package = self.file("tent.esm"), self.file("tent.glb")
        self.done("import", self.file("tent.obj"), "-o", project, "--springs", "alike")
        self.done("tissue", project, "--override", "spring_constant=30", "--override", "viscosity=0.3", "-o", project)
        self.done("tissue", project, "--biphasic", "0.2", "5", "-o", project)
        rest, length = math.hypot(foot, height), math.hypot(foot, pulled)
        self.assertGreater(length, 1.5 * rest)
        tension = 30 * 0.2 * rest + 5 * 30 * (length - 1.2 * rest)
        scene = self.file("pull.json", {
            "duration": 0.5, "fixed": [{"nodes": [0, 1]}], "record": {"every": 0.5},
            "forces": [{"node": 2, "force": [0, 2 * tension * pulled / length, 0], "from": 0, "to": 9}]})
        self.done("export", project, "--to", "glb", "-o", package)
        every_kind = ["rk4", "propagation", "implicit", "bdf2", "projective", "split2"]
        for model, integrators in ((project, every_kind), (package, ["auto"])):
            for integrator in integrators:
                with self.subTest(f"{model.name} {integrator}"):
                    report = self.done("simulate", model, "--scene", scene, "--integrator", integrator,
                                       "-o", self.file("pull.csv"))
                    self.assertTrue(report["stable"], report["outcome"])
                    with open(self.file("pull.csv")) as table:
                        *_, last = csv.reader(table)
                    self.assertAlmostEqual(float(last[3]), pulled, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
