"""How `esmc render` looks at an organ: projection, parts, colours and cuts."""

import csv
import unittest

from esmc import Case


class LookTest(Case):
    def rendered(self, project, *options):
        """What the report says, and the picture's bytes."""
        picture = self.file("picture.png")
        report = self.done("render", project, "-o", picture, "--size", "160x120", *options)
        return report, picture.read_bytes()

    def test_each_way_to_look_is_another_picture(self):
        project = self.sample("liver")
        ways = ([], ["--orthographic"], ["--show", "surface,wireframe"], ["--show", "wireframe"], ["--show", "nodes"],
                ["--show", "springs"], ["--colour-by", "mass"], ["--colour-by", "region"], ["--cut", "viewer:0.4"],
                ["--cut", "+x:0.5"], ["--cut", "-x:0.5"])
        pictures = [self.rendered(project, *way)[1] for way in ways]
        self.assertEqual(len(set(pictures)), len(ways))
        self.assertEqual(self.rendered(project, "--cut", "+y:0")[1], pictures[0])
        self.assertEqual(self.rendered(project, "--cut", "+y:1")[1], self.rendered(project, "--cut", "viewer:1")[1])

    def test_the_legend_says_what_colours_mean(self):
        project = self.sample("liver")
        self.assertNotIn("legend", self.rendered(project)[0])
        legend = self.rendered(project, "--colour-by", "spring-constant")[0]["legend"]
        self.assertEqual((legend["title"], legend["unit"]), ("Spring constant", "N/m"))
        self.assertLess(legend["minimum"], legend["maximum"])
        self.assertEqual(legend, self.rendered(project, "--show", "springs")[0]["legend"])
        regions = self.rendered(project, "--colour-by", "region")[0]["legend"]["regions"]
        self.assertTrue(regions and all(len(region["colour"]) == 3 for region in regions))
        package = self.file("liver.glb")
        self.done("export", project, "--to", "glb", "-o", package)
        of_package = self.rendered(package, "--colour-by", "spring-constant")[0]["legend"]
        self.assertAlmostEqual(of_package["maximum"] / legend["maximum"], 1, delta=1e-5)

    def test_strain_and_speed_are_those_of_the_trajectory(self):
        project = self.sample("tube")
        scene = self.file("poke.json", {"duration": 0.2, "forces": [{"node": 20, "force": [0, 0, -2]}],
                                        "record": {"every": 0.05, "nodes": "all"}})
        motion = self.file("poke.csv")
        self.done("simulate", project, "--scene", scene, "-o", motion)
        at = lambda time: self.rendered(project, "--motion", motion, "--at", time, "--colour-by", "speed")[0]["legend"]
        places = {}
        with open(motion) as rows:
            for row in csv.DictReader(rows):
                places.setdefault(float(row["time"]), []).append([float(row[axis]) for axis in "xyz"])
        times = sorted(places)
        fastest = max(sum((a - b) ** 2 for a, b in zip(now, before)) ** 0.5
                      for now, before in zip(places[times[2]], places[times[1]])) / (times[2] - times[1]) * 1000
        maximum = at(times[2] + 1e-6)["maximum"]
        self.assertTrue(maximum >= fastest * (1 - 1e-9) and (maximum < 2.5 * fastest * (1 + 1e-9) or maximum == 1), (maximum, fastest))
        strain = self.rendered(project, "--motion", motion, "--colour-by", "strain", "--show", "springs")[0]["legend"]
        self.assertEqual((strain["unit"], strain["minimum"]), ("%", 0))
        self.assertIn("no frame before", self.fails(1, "render", project, "--motion", motion, "--at", 0, "--colour-by", "speed",
                                                    "-o", self.file("picture.png")))
        self.assertIn("--motion", self.fails(2, "render", project, "--colour-by", "strain", "-o", self.file("picture.png")))


if __name__ == "__main__":
    unittest.main()
