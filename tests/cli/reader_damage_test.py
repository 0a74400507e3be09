"""The readers in examples/readers refuse what is damaged, in a line that says what and where, and never break."""

import random
import struct
import unittest

from esmc import rounds_of, seed_of
from reader_case import KEPT, CSharpCase, ReaderCase, changed, esm_package, json_of, with_number, without_sums

SUMMED = next(file for file in KEPT if "checksums" in json_of(file.read_bytes())[0]["extensions"]["ESM_spring_mass"])
OTHER_VALUES = [None, True, -1, 0, 1, 10 ** 9, 1 << 40, 1.5, float("inf"), float("nan"), "", "SCALAR", [], [{}], {}]


def damaged(content, random):
    """Bytes that were changed, in the JSON or behind it, or an end that was cut off; mostly without check sums, which would notice all of it."""
    content = bytearray(changed(content, without_sums) if random.random() < 0.8 else content)
    if random.random() < 0.2:
        return bytes(content[:random.randrange(len(content))])
    begin = 20 + struct.unpack_from("<I", content, 12)[0]
    for _ in range(random.randrange(1, 20)):
        content[random.randrange(begin) if random.random() < 0.5 else random.randrange(begin, len(content))] = random.randrange(256)
    return bytes(content)


def places_in(json, way=()):
    """The way to each value that another holds."""
    for key, value in (json.items() if isinstance(json, dict) else enumerate(json) if isinstance(json, list) else ()):
        yield (*way, key)
        yield from places_in(value, (*way, key))


def change_json(model, gltf, random):
    """Takes a value out of a package, or puts another in its place, mostly without check sums, which would notice all of it."""
    if random.random() < 0.7:
        without_sums(model, gltf)
    holder = random.choice([model, gltf])
    *way, last = random.choice(list(places_in(holder)))
    for key in way:
        holder = holder[key]
    if random.random() < 0.3:
        del holder[last]
    else:
        holder[last] = random.choice(OTHER_VALUES)


def with_changed_json(round):
    source = random.Random(seed_of(round))
    return changed(source.choice(KEPT).read_bytes(), lambda model, gltf: change_json(model, gltf, source))


def with_damage(round):
    source = random.Random(seed_of(round))
    return damaged(source.choice(KEPT).read_bytes(), source)


def positions_of_indices(model, gltf):
    primitive = gltf["meshes"][0]["primitives"][0]
    place = primitive["attributes"]["POSITION"]
    gltf["accessors"][place] = {**gltf["accessors"][place], "componentType": 5125}


def starts_of_float(model, gltf):
    gltf["accessors"][model["binding"]["starts"]]["componentType"] = 5126


def draws_nothing(model, gltf):
    """A primitive of no vertices: of arrays without a number, which this reader bears."""
    primitive = gltf["meshes"][0]["primitives"][0]
    for place in (model["drawn"][0]["vertexNodes"], model["drawn"][0]["triangles"], primitive["indices"], *primitive["attributes"].values()):
        gltf["accessors"][place]["count"] = 0


def carries_nothing(model, gltf):
    """A binding of a surface that has no vertices, nor does what is drawn."""
    draws_nothing(model, gltf)
    model["surface"].update(vertexCount=0, triangleCount=0)
    for place in (model["binding"]["nodes"], model["binding"]["shares"], model["drawn"][0]["vertices"]):
        gltf["accessors"][place]["count"] = 0


def with_flipped_bit(content):
    """In the first number of the first array."""
    content = bytearray(content)
    content[20 + struct.unpack_from("<I", content, 12)[0] + 8 + 2] ^= 1
    return bytes(content)


# What is refused, and in which words both readers say it.
CHANGES = (
    ("version 10, newer", lambda model, _: model.update(version=10)),
    ("damps", lambda model, _: model.update(damping="axial")),
    ("no springs", lambda model, _: model.pop("springs")),
    ("no count at springs.count", lambda model, _: model["springs"].update(count=-1)),
    ("elements", lambda model, _: model["nodes"].update(count=7)),
    ("mean", lambda model, _: model["springs"].update(springConstant=model["springs"]["restLength"])),
    ("has nothing at accessors/1000000000", lambda model, _: model["nodes"].update(mass=10 ** 9)),
    ("accessors", lambda model, _: model["nodes"].update(mass="two\nlines")),
    ("of unsigned int", lambda model, _: model["drawn"][0].update(triangles=model["nodes"]["mass"])),
    ("of unsigned int", lambda model, gltf: gltf["accessors"][model["drawn"][0]["vertexNodes"]].update(componentType=5126)),
    ("springs.nodes should be of unsigned int", lambda model, gltf: gltf["accessors"][model["springs"]["nodes"]].update(componentType=5126)),
    ("drawn.POSITION should be of float", positions_of_indices),
    ("drawn.triangles are not as many as", lambda model, _: model["drawn"][0].update(triangles=model["springs"]["nodes"])),
    ("object at sheet", lambda model, _: model.update(sheet=7)),
    ("no drawn.vertexNodes", lambda model, _: model["drawn"][0].pop("vertexNodes")),
    ("fillings name a part twice", lambda model, _: model.update(fillings=[{"part": 0, "stiffness": 1}] * 2)),
    ("pressures name a part twice", lambda model, _: model.update(pressures=[{"part": 0, "path": [[0, 1]]}] * 2)),
    ("times rising", lambda model, _: model.update(pressures=[{"part": 0, "path": [[0, 1], [0, 2]]}])),
    ("times rising", lambda model, _: model.update(pressures=[{"part": 0, "path": [[0, 1], [1, "2"]]}])),
    ("times rising", lambda model, _: model.update(pressures=[{"part": 0, "path": []}])),
    ("stiffness 0", lambda model, _: model.update(fillings=[{"part": 0, "stiffness": 0}])),
    ("beyond", lambda _, gltf: gltf["bufferViews"][0].update(byteLength=1 << 30)))


def kept(name):
    return next(file for file in KEPT if file.stem == name).read_bytes()


def numbers_that_cannot_be():
    """Packages with one such number, each with what both readers say."""
    plain, filled = kept("version-1-finish"), kept("version-8-filled")

    def tetrahedra(model, _):
        return model["lattice"]["tetrahedra"]

    return [("springs.restLength: number 5 is -1, but must be from 0 to 1e30; export the package again",
             with_number(plain, lambda model, _: model["springs"]["restLength"], 5, "<f", -1)),
            ("nodes.mass: number 3 is 0, but must be from 1e-30 to 1e30; export the package again",
             with_number(plain, lambda model, _: model["nodes"]["mass"], 3, "<f", 0)),
            ("surface.triangles names vertex 48, but there are 48, counted from 0; export the package again",
             with_number(plain, lambda model, _: model["surface"]["triangles"], 7, "<I", 48)),
            ("drawn.POSITION: number 4 is nan, but must be from -1e30 to 1e30; export the package again",
             with_number(plain, lambda _, gltf: gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"], 4, "<f", float("nan"))),
            ("drawn.triangles names triangle 96, but there are 96, counted from 0; export the package again",
             with_number(plain, lambda model, _: model["drawn"][0]["triangles"], 7, "<I", 96)),
            ("primitive 0 of drawn has index 288, but 288 vertices, counted from 0; export the package again",
             with_number(plain, lambda _, gltf: gltf["meshes"][0]["primitives"][0]["indices"], 7, "<I", 288)),
            ("lattice.tetrahedra: the nodes of number 0 should differ; export the package again",
             with_number(with_number(filled, tetrahedra, 0, "<I", 3), tetrahedra, 1, "<I", 3))]


def with_overlapping_views(model, gltf):
    """Each of the whole file: summing them all would take as many times as long as there are views."""
    for view in gltf["bufferViews"][:-1]:
        view.update(byteOffset=0, byteLength=gltf["buffers"][0]["byteLength"])


class DamagedPackageTest(ReaderCase):
    def refused(self, content):
        """The message of the reader that refuses it; None where it can be read."""
        try:
            esm_package.read_package(self.file("package.glb", content))
        except esm_package.PackageError as problem:
            self.assertNotIn("\n", str(problem))
            return str(problem)

    def test_names_what_is_wrong(self):
        source = kept("version-1-finish")
        self.assertIn("cut off", self.refused(source[:-4]))
        self.assertIn("glTF", self.refused(b"a text that is no package at all"))
        self.assertIn("accessors/'two\\nlines'", self.refused(changed(source, lambda model, _: model["nodes"].update(mass="two\nlines"))))
        for word, change in CHANGES:
            message = self.refused(changed(source, change)) or "was read"
            self.assertIn(word, message)
            self.assertRegex(message, "; (export the package again|take a newer reader)$")

    def test_says_which_number_cannot_be(self):
        for message, content in numbers_that_cannot_be():
            self.assertEqual(self.refused(content), message)
        self.assertIn("should be of unsigned int", self.refused(changed(kept("version-6-wide-binding"), starts_of_float)) or "was read")

    def test_takes_a_primitive_of_nothing(self):
        self.assertIsNone(self.refused(changed(kept("version-1-finish"), draws_nothing)))
        self.assertIsNone(self.refused(changed(kept("version-2"), carries_nothing)))

    def test_notices_a_flipped_bit(self):
        source = SUMMED.read_bytes()
        self.assertIn("check sum", self.refused(with_flipped_bit(source)) or "was read")
        self.assertIn("no bufferViews", self.refused(changed(source, lambda _, gltf: gltf.pop("bufferViews"))) or "was read")

    def test_sums_no_byte_twice(self):
        message = self.refused(changed(SUMMED.read_bytes(), with_overlapping_views))
        self.assertEqual(message, "bufferViews overlap, which check sums do not allow; export the package again")

    def test_never_breaks_on_damage(self):
        refused = [self.refused(with_damage(round)) for round in range(rounds_of(200, 5000))]
        self.assertGreater(len(refused) - refused.count(None), len(refused) / 4)
        self.assertLess(sum("check sum" in (message or "") for message in refused), len(refused) / 10)

    def test_never_breaks_on_changed_json(self):
        refused = [self.refused(with_changed_json(round)) for round in range(rounds_of(200, 5000))]
        self.assertGreater(len(refused) - refused.count(None), len(refused) / 4)


class CSharpDamageTest(CSharpCase):
    def refused(self, contents):
        """What the reader says of each that it refuses, None of others."""
        files = [self.file(f"{place}.glb", content) for place, content in enumerate(contents)]
        messages = []
        for file, line in zip(files, self.said(files)):
            is_refused = line.startswith(f"{file}: ")
            self.assertTrue(is_refused or " nodes, " in line, line)
            messages.append(line[len(f"{file}: "):] if is_refused else None)
        return messages

    def test_names_what_is_wrong(self):
        source = kept("version-1-finish")
        for (word, _), message in zip(CHANGES, self.refused([changed(source, change) for _, change in CHANGES])):
            self.assertIn(word, message or "was read")

    def test_says_which_number_cannot_be(self):
        messages, contents = zip(*numbers_that_cannot_be())
        self.assertEqual([message.replace("NaN", "nan") for message in self.refused(contents)], list(messages))
        message, = self.refused([changed(kept("version-6-wide-binding"), starts_of_float)])
        self.assertIn("should be of unsigned int", message or "was read")

    def test_notices_a_flipped_bit(self):
        source = SUMMED.read_bytes()
        flipped, without_views = self.refused([with_flipped_bit(source), changed(source, lambda _, gltf: gltf.pop("bufferViews"))])
        self.assertIn("check sum", flipped)
        self.assertIn("bufferViews", without_views)

    def test_sums_no_byte_twice(self):
        message, = self.refused([changed(SUMMED.read_bytes(), with_overlapping_views)])
        self.assertEqual(message, "bufferViews overlap, which check sums do not allow; export the package again")

    def test_never_breaks_on_damage(self):
        refused = self.refused([with_damage(round) for round in range(rounds_of(60, 1000))])
        self.assertGreater(len(refused) - refused.count(None), len(refused) / 4)

    def test_refuses_the_same_changed_json_as_the_reader_in_python(self):
        contents = [with_changed_json(round) for round in range(rounds_of(200, 2000))]
        for round, (content, message) in enumerate(zip(contents, self.refused(contents))):
            in_python = DamagedPackageTest.refused(self, content)
            self.assertEqual(message is None, in_python is None, f"seed {seed_of(round)}: {message} and {in_python}")


if __name__ == "__main__":
    unittest.main()
