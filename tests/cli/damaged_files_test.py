"""Files of every kind, damaged at random: the program refuses them in a line, or makes something sound of them."""

import io
import math
import random
import re
import struct
import unittest
import zipfile

from esmc import PROJECTOR, Case, command, rounds_of, seed_of

EXTREMES = [b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\x00\x00\x00\x80", b"\x00\x00\x00\x00",
            struct.pack("<f", math.nan), struct.pack("<f", math.inf), struct.pack("<d", 1e308)]
NUMBERS = [b"nan", b"-inf", b"1e999", b"-1", b"0", b"4294967296", b"18446744073709551616", b"1e-320", b"", b"x", b"[]"]


def grid(points, faces):
    """Vertices and triangles of a bent square sheet, as lines of text."""
    size = range(5)
    corners = [(x, y) for x in range(4) for y in range(4)]
    vertices = "".join(points.format(x / 10, y / 10, x * y / 100) for x in size for y in size)
    triangles = [(5 * x + y, 5 * x + y + 5, 5 * x + y + 1) for x, y in corners]
    triangles += [(5 * x + y + 1, 5 * x + y + 5, 5 * x + y + 6) for x, y in corners]
    return vertices, "".join(faces.format(*triangle) for triangle in triangles)


def damaged(content, chance):
    """The content after one to four mishaps."""
    content = bytearray(content)
    for _ in range(chance.randint(1, 4)):
        if not content:
            break
        place = chance.randrange(len(content))
        mishap = chance.randrange(6)
        if mishap == 0:
            content[place] ^= 1 << chance.randrange(8)
        elif mishap == 1:
            extreme = chance.choice(EXTREMES)
            content[place:place + len(extreme)] = extreme
        elif mishap == 2:
            del content[place:]
        elif mishap == 3:
            del content[place:place + chance.randint(1, 64)]
        elif mishap == 4:
            content[place:place] = content[place:place + chance.randint(1, 64)]
        else:
            numbers = list(re.finditer(rb"-?\d+(\.\d+)?(e-?\d+)?", content))
            if numbers:
                start, end = chance.choice(numbers).span()
                content[start:end] = chance.choice(NUMBERS)
    return bytes(content)


def damaged_entry(archive, chance):
    """The archive with one of its entries damaged, and packed as if it were not."""
    with zipfile.ZipFile(io.BytesIO(archive)) as old:
        entries = {name: old.read(name) for name in old.namelist()}
    struck = chance.choice(sorted(entries))
    result = io.BytesIO()
    with zipfile.ZipFile(result, "w") as new:
        for name, content in entries.items():
            new.writestr(name, damaged(content, chance) if name == struck else content)
    return result.getvalue()


class DamagedFilesTest(Case):
    def refused_or_sound(self, name, content, *line, makes=None, damage=damaged):
        """Runs `line` on damaged copies of the file, `FILE` in it being the copy's path."""
        for number in range(rounds_of(4, 1000)):
            seed = seed_of(number)
            with self.subTest(f"{name}, seed {seed}"):
                file = self.file(f"damaged-{name}", damage(content, random.Random(f"{name} {seed}")))
                self.try_one([file if word == "FILE" else word for word in line], makes)

    def try_one(self, line, makes):
        process = command(*line)
        self.assertIn(process.returncode, (0, 1), process.stderr)
        if process.returncode == 1:
            if line[0] != "validate" or not process.stdout:
                self.assertRegex(process.stderr, r"\Aesmc: [^\n]+\n\Z")
                self.assertNotRegex(process.stderr, "the decoder failed|makes no sense|the system ended")
        elif makes:
            self.assertEqual(command("validate", makes).returncode, 0, "what was read can be opened")
            makes.unlink()

    def test_surfaces(self):
        out = self.file("out.esm")
        vertices, faces = grid("v {} {} {}\n", "f {} {} {}\n")
        counts = (vertices.count("\n"), faces.count("\n"))
        rows, triangles = grid("{} {} {}\n", "3 {} {} {}\n")
        sizes = "element vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face {}\n".format(*counts)
        stl = b" " * 80 + struct.pack("<I", 2) + 2 * struct.pack("<12fH", 0, 0, 1, 0, 0, 0, .1, 0, 0, 0, .1, 0, 0)
        surfaces = {
            "a.obj": vertices + re.sub(r"\d+", lambda index: str(int(index[0]) + 1), faces),
            "a.off": "OFF\n{} {} 0\n".format(*counts) + rows + triangles,
            "a.ply": f"ply\nformat ascii 1.0\n{sizes}property list uchar int vertex_indices\nend_header\n{rows}{triangles}",
            "a.vtk": "# vtk DataFile Version 3.0\nsheet\nASCII\nDATASET POLYDATA\nPOINTS {} float\n".format(counts[0]) +
                     rows + "POLYGONS {} {}\n".format(counts[1], 4 * counts[1]) + triangles,
            "a.stl": stl,
        }
        for name, content in surfaces.items():
            whole = content if isinstance(content, bytes) else content.encode()
            self.done("import", self.file(name, whole), "-o", out)
            self.refused_or_sound(name, whole, "import", "FILE", "-o", out, makes=out)

    def test_packages(self):
        package = self.file("tube.glb")
        self.done("export", self.sample("tube"), "--to", "glb", "-o", package)
        whole = package.read_bytes()
        self.refused_or_sound("tube.glb", whole, "validate", "FILE")
        out = self.file("out.esm")
        self.refused_or_sound("surface.glb", whole, "import", "FILE", "-o", out, makes=out)

    def test_projects(self):
        whole = self.sample("tube").read_bytes()
        self.refused_or_sound("tube.esm", whole, "info", "FILE")
        self.refused_or_sound("entry.esm", whole, "info", "FILE", damage=damaged_entry)

    def test_texts_beside_a_project(self):
        project, out = self.sample("tube"), self.file("out.esm")
        scene = (b'{"duration": 0.1, "gravity": [0, 0, -9.81], "fixed": [{"nodes": [1, 2, 3]}],\n'
                 b' "forces": [{"node": 5, "force": [0, 0, 0.1], "from": 0.01, "to": 0.05}],\n'
                 b' "record": {"every": 0.01, "nodes": "all"}}\n')
        self.refused_or_sound("a.json", scene, "scene", project, "--scene", "FILE", "-o", out, makes=out)
        fcl, fll = self.file("a.fcl"), self.file("a.fll")
        for system in (fcl, fll):
            self.done("fuzzy", "convert", "robo-sim", system)
            self.refused_or_sound(system.name, system.read_bytes(), "fuzzy", "convert", "FILE", self.file("copy.json"))

    def test_photos(self):
        project, out, photo = self.sample("tube"), self.file("out.esm"), self.file("a.png")
        projector = self.file("projector.json", PROJECTOR)
        self.done("sample", "serosa", "-o", photo)
        self.refused_or_sound("a.png", photo.read_bytes()[:20000], "texture", "photo", project, "--photo", "FILE",
                              "--projector", projector, "-o", out, makes=out)
        self.refused_or_sound("p.json", projector.read_bytes(), "texture", "photo", project, "--photo", photo,
                              "--projector", "FILE", "-o", out, makes=out)


if __name__ == "__main__":
    unittest.main()
