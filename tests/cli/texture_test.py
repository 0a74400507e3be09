import json
import math
import re
import resource
import struct
import subprocess
import time
import unittest
import zipfile
import zlib
from pathlib import Path

from esmc import ESMC, PROJECTOR, Case, command


def read_png(path):
    """Width, height, channels and rows of bytes of a PNG of 8 or 16 bits that is not interlaced."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        assert zlib.crc32(kind + body) == struct.unpack(">I", data[place + 8 + length:place + 12 + length])[0]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        place += 12 + length
    channels = {0: 1, 2: 3, 6: 4}[colour]
    pixel = channels * depth // 8
    return width, height, channels, unfiltered(zlib.decompress(packed), width * pixel, height, pixel)


def unfiltered(raw, stride, height, pixel):
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride) if kind else ():
            left = line[i - pixel] if i >= pixel else 0
            corner = above[i - pixel] if i >= pixel else 0
            line[i] = (line[i] + predicted(kind, left, above[i], corner)) & 255
        rows.append(bytes(line))
        above = rows[-1]
    return rows


def predicted(kind, left, up, corner):
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    return min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]


def black_png(width, height):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    rows = zlib.compress(bytes(height * (1 + 3 * width)))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", rows) + chunk(b"IEND", b"")


def thread_name(task):
    """The name of a running thread by its folder in /proc; empty once the thread has ended."""
    try:
        return (task / "comm").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return ""


class TextureTest(Case):
    def photographed(self, project, *options, **changes):
        photo, pose = self.file("photo.png"), self.file("projector.json", {**PROJECTOR, **changes})
        self.done("sample", "vessels", "-o", photo)
        return self.done("texture", "photo", project, "--photo", photo, "--projector", pose, *options, "-o", project)

    def test_prepares_photos(self):
        project, photo = self.sample("liver"), self.file("photo.png")
        pose = self.file("projector.json", PROJECTOR)
        lens = self.file("lens.json", {"kind": "pinhole", "fx": 900, "fy": 900, "cx": 256, "cy": 256,
                                       "coefficients": [-0.1, 0, 0, 0, 0]})
        self.done("sample", "serosa", "-o", photo)
        given = ("texture", "photo", project, "--photo", photo, "--projector", pose)
        plain = self.done(*given, "-o", self.file("plain.esm"))
        prepared = self.file("prepared.esm")
        report = self.done(*given, "--round-field", "--fill-highlights", "--white-balance", "--even-light", "0.5",
                           "--match-colours", "--lens", lens, "--crop", "0 0 64 64", "-o", prepared)
        self.assertIsNone(report["field"])
        self.assertTrue(0 <= report["highlights_filled"] < 1)
        self.assertIn("white_balance", report)
        self.assertIn("colour_match", report)
        matched = self.done(*given, "--match-colours", "-o", self.file("matched.esm"))
        self.assertEqual(len(matched["colour_match"]["scale"]), 3)
        self.assertLess(report["texels"], plain["texels"])
        self.assertEqual(self.done("validate", prepared)["problems"], [])
        report = self.done(*given, "--field", "--mask-overlays", "--highlights", "0.8", "--white-like", photo, "-o", prepared)
        self.assertEqual((report["field"], report["overlays_masked"]), (None, 0))
        self.assertEqual([round(gain, 6) for gain in report["white_balance"]], [1, 1, 1])
        self.assertEqual(self.done("validate", prepared)["problems"], [])
        self.assertIn("white_balance", self.done(*given, "--white-spot", "200 200", "-o", self.file("spot.esm")))
        self.fails(2, *given, "--white-spot", "200 200", "--white-balance", "-o", project, naming="--white-balance")
        self.fails(2, *given, "--crop", "0 0 64", "-o", project, naming="--crop")
        self.fails(2, *given, "--even-light", "2", "-o", project, naming="--even-light")
        self.fails(1, *given, "--crop", "0 0 64 99999", "-o", project, naming="crop")
        bad = self.file("bad.json", {"kind": "mirror"})
        self.fails(1, *given, "--lens", bad, "-o", project, naming="pinhole")

    def test_adjusts_the_colours_of_a_photo(self):
        project, pages = self.sample("liver"), {}
        def photographed(name, *options):
            out = self.file(f"{name}.esm")
            self.done("sample", "vessels", "-o", self.file("photo.png"))
            self.done("texture", "photo", project, "--photo", self.file("photo.png"), "--projector",
                      self.file("projector.json", PROJECTOR), *options, "-o", out)
            self.done("texture", "pack", out, "--size", "256", "-o", out)
            self.done("texture", "bake", out, "-o", self.file(name))
            pages[name] = next(self.file(name).glob("*.png")).read_bytes()
            return self.done("validate", out)["problems"]
        self.assertEqual(photographed("plain"), [])
        self.assertEqual(photographed("neutral", "--levels", "0 255 1", "--hue", "0", "--saturation", "1"), [])
        self.assertEqual(photographed("turned", "--levels", "10 240 1.2", "--contrast", "1.1", "--hue", "-40"), [])
        self.assertEqual(pages["plain"], pages["neutral"])
        self.assertNotEqual(pages["plain"], pages["turned"])

    def test_replaces_a_photo(self):
        project, photo = self.sample("liver"), self.file("other.png")
        self.photographed(project, "--name", "Polyp", "--crop", "0 0 256 256")
        self.done("sample", "serosa", "-o", photo)
        given = ("texture", "replace", project, "--layer", "Polyp", "--photo", photo)
        report = self.done(*given, "-o", self.file("replaced.esm"))
        self.assertEqual((report["layer"], report["same_shape"], report["warnings"]), ("Polyp", True, []))
        self.assertGreater(report["texels"], 0)
        self.assertEqual(self.done("validate", self.file("replaced.esm"))["problems"], [])
        photo.write_bytes(black_png(300, 200))
        report = self.done(*given, "-o", project)
        self.assertFalse(report["same_shape"])
        self.assertIn("another shape", report["warnings"][0])
        self.fails(2, *given[:3], "--layer", "Liver", "--photo", photo, "-o", project, naming='"Polyp"')
        self.photographed(project, "--name", "Polyp")
        self.fails(2, *given, "-o", project, naming="several")

    def test_shines_as_said(self):
        organ, wet, dry = self.sample("liver"), self.file("wet.esm"), self.file("dry.esm")
        self.file("black.png", black_png(256, 256))
        self.done("texture", "photo", organ, "--photo", self.file("black.png"), "--projector",
                  self.file("pose.json", PROJECTOR), "--name", "above", "-o", organ)
        report = self.done("texture", "finish", organ, "--preset", "mucosa", "--roughness", "0.2", "-o", wet)
        self.assertEqual((report["roughness"], report["wetness"]), (0.2, 1))
        report = self.done("texture", "finish", wet, "--layer", "above", "--relief", "1", "-o", wet)
        self.assertIn("of one colour", report["warnings"][0])
        self.done("texture", "finish", wet, "--layer", "above", "--remove", "-o", wet)
        self.done("texture", "finish", wet, "--remove", "-o", dry)
        pictures = []
        for project in (organ, dry, wet):
            self.done("render", project, "--size", "96x96", "-o", self.file("seen.png"))
            pictures.append(self.file("seen.png").read_bytes())
        self.assertEqual(pictures[0], pictures[1])
        self.assertNotEqual(pictures[0], pictures[2])
        self.fails(2, "texture", "finish", organ, "-o", wet, naming="--preset")
        self.fails(2, "texture", "finish", organ, "--relief", "1", "-o", wet, naming="name it with --layer")
        self.fails(2, "texture", "finish", organ, "--layer", "no", "--remove", "-o", wet, naming='there are "above"')

    def test_bakes_what_is_no_colour_beside_the_pages(self):
        organ, folder = self.sample("liver"), self.file("pages")
        self.done("sample", "vessels", "-o", self.file("photo.png"))
        self.done("texture", "photo", organ, "--photo", self.file("photo.png"), "--projector",
                  self.file("pose.json", PROJECTOR), "--name", "above", "-o", organ)
        self.done("texture", "finish", organ, "--layer", "above", "--preset", "mucosa", "--relief", "1", "-o", organ)
        report = self.done("texture", "finish", organ, "--occlusion", "20", "-o", organ)
        self.assertEqual(report["occlusion_reach"], 0.02)
        self.assertNotIn("roughness", report)
        self.done("texture", "bake", organ, "-o", folder)
        names = ["texture-1.png"] + [f"texture-1-{part}.png" for part in ("normals", "occlusion", "wetness-roughness")]
        self.assertEqual(sorted(path.name for path in folder.iterdir()), sorted(names))
        self.done("texture", "finish", organ, "--occlusion", "0", "-o", organ)
        warnings = self.done("texture", "bake", organ, "-o", folder)["warnings"]
        self.assertIn("texture-1-occlusion.png is of an earlier bake", warnings[0])
        self.fails(2, "texture", "finish", organ, "--layer", "above", "--occlusion", "5", "-o", organ,
                   naming="leave out --layer")

    def test_bad_pictures_leave_the_project_as_it_was(self):
        def chunk(kind, body):
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        project, pose, good = self.sample("liver"), self.file("projector.json", PROJECTOR), self.file("good.png")
        self.done("sample", "serosa", "-o", good)
        header = chunk(b"IHDR", struct.pack(">IIBBBBB", 60000, 60000, 8, 2, 0, 0, 0))
        before = project.read_bytes()
        for name, content, naming in (
                ("text.png", b"text", "not a PNG, JPEG, BMP or TIFF"),
                ("none.jpg", b"", "empty"),
                ("cut.png", good.read_bytes()[:5000], "ends before the picture does"),
                ("huge.png", b"\x89PNG\r\n\x1a\n" + header + chunk(b"IEND", b""), "268 megapixels"),
                ("moving.gif", b"GIF89a" + bytes(20), "convert it to PNG or JPEG")):
            picture = self.file(name)
            picture.write_bytes(content)
            self.fails(1, "texture", "photo", project, "--photo", picture, "--projector", pose, "-o", project,
                       naming=naming)
            self.assertEqual(project.read_bytes(), before)

    def test_packs(self):
        project = self.sample("liver")
        report = self.done("texture", "pack", project, "--size", "512", "--pages", "2", "--gap", "3", "-o", project)
        self.assertKeys(report, {"utilisation": float, "texels_per_metre": float, "pages": int, "gap": int})
        self.assertEqual((report["pages"], report["gap"]), (2, 3))
        self.assertTrue(0.2 < report["utilisation"] < 1)
        self.assertEqual(self.done("info", project)["textures"], 2)

    def test_packs_surfaces_of_less_than_a_micrometre(self):
        corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
        mesh = "".join("v %g %g %g\n" % tuple(4e-7 * x for x in corner) for corner in corners)
        mesh += "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
        project = self.file("small.esm")
        self.done("import", self.file("small.obj", mesh), "-o", project)
        report = self.done("texture", "pack", project, "-o", project)
        self.assertGreater(report["texels_per_metre"], 1e9)
        self.assertTrue(self.done("validate", project)["valid"])
        self.assertEqual(self.done("info", project)["textures"], 1)

    def test_packs_denser_where_patches_are_matched(self):
        project, uses = self.sample("liver"), []
        for layout in ("rows", "matched_rows", "unfolded_groups"):
            report = self.done("texture", "pack", project, "--layout", layout, "-o", project)
            self.assertEqual(report["layout"], layout)
            uses.append(report["utilisation"])
        self.assertGreater(uses[1], 1.05 * uses[0])
        self.fails(2, "texture", "pack", project, "--layout", "spiral", "-o", project, naming="rows")

    def test_numbers_are_decimal_whatever_their_zeros(self):
        report = self.done("texture", "pack", self.sample("tube"), "--size", "0512", "--gap", "010", "-o", self.file("a.esm"))
        self.assertEqual((report["size"], report["gap"]), (512, 10))

    def test_an_impossible_size_is_refused_with_one_that_fits(self):
        project = self.sample("liver")
        for code, size in ((1, "64"), (2, "0"), (2, "-5")):
            message = self.fails(code, "texture", "pack", project, "--size", size, "-o", self.file("b.esm"))
            smallest = int(re.search(r"the smallest size that fits is (\d+)", message)[1])
            self.done("texture", "pack", project, "--size", smallest, "-o", self.file("b.esm"))

    def test_lays_a_photo_and_bakes_it(self):
        project = self.sample("liver")
        report = self.photographed(project)
        self.assertKeys(report, {"layer": str, "texels": int, "triangles": int})
        self.assertTrue(report["texels"] > report["triangles"] > 0)
        self.assertEqual([photo["file"] for photo in self.done("info", project)["photos"]], ["photo.png"])
        baked = self.done("texture", "bake", project, "-o", self.file("textures"))
        self.assertKeys(baked, {"files": list, "seam_error": float, "seam_errors": list})
        width, height, _, rows = read_png(self.folder / baked["files"][0])
        self.assertEqual((width, height, len(rows)), (2048, 2048, 2048))
        self.assertGreater(len({row[i:i + 3] for row in rows[::64] for i in range(0, len(row) - 3, 256)}), 20)

    def test_lays_a_photo_in_perspective(self):
        project = self.sample("liver")
        report = self.photographed(project, kind="perspective", fov=40)
        self.assertTrue(report["texels"] > report["triangles"] > 0)
        self.assertEqual(self.done("validate", project)["problems"], [])
        measured = {"fx": 700, "fy": 700, "cx": 256, "cy": 256}
        self.photographed(project, kind="perspective", intrinsics=measured, falloff=True)
        self.assertEqual(self.done("validate", project)["problems"], [])
        self.assertEqual(len(self.done("info", project)["photos"]), 2)

    def baked(self, project):
        return read_png(self.folder / self.done("texture", "bake", project, "-o", self.file("textures"))["files"][0])

    def test_blends_a_photo_as_asked_for(self):
        bare = self.sample("liver")
        self.done("texture", "pack", bare, "--size", "256", "-o", bare)
        pages = {"none": self.baked(bare)[3]}
        for blending in ("normal", "multiply", "screen", "overlay", "colour", "multi-band"):
            project = self.file(blending + ".esm")
            project.write_bytes(bare.read_bytes())
            self.photographed(project, "--blending", blending)
            self.assertEqual([photo["blending"] for photo in self.done("info", project)["photos"]], [blending])
            pages[blending] = self.baked(project)[3]
        self.assertEqual(len({b"".join(rows) for rows in pages.values()}), 7)
        # No product of two colours is brighter than either of them.
        for before, after in zip(pages["none"], pages["multiply"]):
            self.assertTrue(all(a <= b for a, b in zip(after, before)))
        for before, after in zip(pages["none"], pages["screen"]):
            self.assertTrue(all(a >= b for a, b in zip(after, before)))
        # In bands a photo comes nearer to what lies beneath it.
        change = {kind: sum(abs(a - b) for before, after in zip(pages["none"], pages[kind])
                            for a, b in zip(after, before)) for kind in ("normal", "multi-band")}
        self.assertLess(change["multi-band"], change["normal"])

    def test_an_unknown_blending_is_refused_with_those_there_are(self):
        project = self.sample("liver")
        before = project.read_bytes()
        self.fails(2, "texture", "photo", project, "--photo", "p.png", "--projector", "p.json", "--blending", "lighten",
                   "-o", project, naming="multi-band")
        self.assertEqual(project.read_bytes(), before)

    def test_a_photo_that_misses_the_organ_is_kept_with_a_warning(self):
        project = self.sample("tube")
        pose = list(PROJECTOR["pose"])
        pose[3] = 50
        report = self.photographed(project, pose=pose)
        self.assertEqual((report["texels"], report["triangles"], len(report["warnings"])), (0, 0, 1))

    def test_bakes_smaller_pages_as_far_as_the_gap_allows(self):
        project, folder = self.sample("tube"), self.file("textures")
        self.done("texture", "pack", project, "--size", "512", "--gap", "8", "-o", project)
        for bits in ("8", "16"):
            files = self.done("texture", "bake", project, "-o", folder, "--smaller", "--bits", bits)["files"]
            self.assertEqual([Path(file).name for file in files],
                             ["texture-1.png", "texture-1-256.png", "texture-1-128.png"])
            self.assertEqual([read_png(self.folder / file)[0] for file in files], [512, 256, 128])
        self.assertIn("texture-1-128.png", self.done("texture", "bake", project, "-o", folder)["warnings"][0])

    def test_pages_of_an_earlier_bake_are_named(self):
        project, folder = self.sample("tube"), self.file("textures")
        self.done("texture", "pack", project, "--size", "128", "--pages", "3", "-o", project)
        self.assertEqual(self.done("texture", "bake", project, "-o", folder)["warnings"], [])
        self.done("texture", "pack", project, "--size", "128", "-o", project)
        report = self.done("texture", "bake", project, "-o", folder)
        self.assertEqual(report["files"], [str(folder / "texture-1.png")])
        self.assertIn(f"{folder / 'texture-2.png'}, {folder / 'texture-3.png'}", report["warnings"][0])

    def test_a_page_that_cannot_be_written_leaves_all_as_they_were(self):
        project, folder = self.sample("tube"), self.file("textures")
        self.done("texture", "pack", project, "--size", "128", "--pages", "3", "-o", project)
        folder.mkdir()
        first = self.file("textures/texture-1.png", b"what was here before")
        self.file("textures/texture-2.png").mkdir()
        self.fails(1, "texture", "bake", project, "-o", folder, naming="texture-2.png")
        self.assertEqual(first.read_bytes(), b"what was here before")
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["texture-1.png", "texture-2.png"])

    def test_a_bake_that_fails_leaves_no_folder(self):
        project, out = self.sample("tube"), self.file("new")
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500))
        for folder in (out, out / "deep" / "er"):
            self.fails(1, "texture", "bake", project, "-o", folder, naming="texture-1.png", preexec_fn=limit)
            self.assertEqual([path.name for path in self.folder.iterdir()], ["tube.esm"])
        self.done("texture", "bake", project, "-o", out / "deep" / "er")
        self.assertEqual([path.name for path in (out / "deep" / "er").iterdir()], ["texture-1.png"])

    def test_bake_without_a_photo_is_the_base_colour(self):
        project = self.sample("liver")
        self.done("texture", "pack", project, "--size", "256", "-o", project)
        baked = self.done("texture", "bake", project, "-o", self.file("textures"))
        self.assertEqual(baked["seam_error"], 0)

    def test_tells_the_seams_of_every_size_that_the_gap_allows(self):
        project = self.sample("liver")
        for gap, sizes in ((2, 1), (4, 2), (8, 3)):
            self.done("texture", "pack", project, "--size", "1024", "--gap", str(gap), "-o", project)
            baked = self.done("texture", "bake", project, "-o", self.file("textures"))
            self.assertEqual(baked["seam_errors"], [0] * sizes)

    def test_bakes_16_bits_that_round_to_the_8(self):
        project = self.sample("liver")
        self.photographed(project)
        self.done("texture", "pack", project, "--size", "256", "-o", project)
        rows = {}
        for bits in 8, 16:
            baked = self.done("texture", "bake", project, "--bits", str(bits), "-o", self.file("textures"))
            header = Path(baked["files"][0]).read_bytes()[:33]
            self.assertEqual(header[24], bits)
            rows[bits] = read_png(self.folder / baked["files"][0])[3]
        channels = [(value, int.from_bytes(deep[2 * i:2 * i + 2], "big"))
                    for row, deep in zip(rows[8], rows[16]) for i, value in enumerate(row)]
        self.assertTrue(all(abs(deep / 257 - value) <= 0.501 for value, deep in channels))
        self.assertTrue(any(deep % 257 for value, deep in channels))
        self.fails(2, "texture", "bake", project, "--bits", "12", "-o", self.file("textures"))

    # Two squares beside each other, each on a half of the picture, the second one upside down.
    OWN = ("v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nv 0.2 0 0\nv 0.2 0.1 0\nvt 0 0\nvt 0.5 0\nvt 0.5 1\nvt 0 1\nvt 1 0\nvt 1 1\n"
           "f 1/1 2/2 3/3 4/4\nf 2/6 5/3 6/2 3/5\n")

    def imported(self, content):
        project = self.file("own.esm")
        self.done("import", self.file("own.obj", content), "-o", project)
        return project

    def test_lays_out_in_charts_and_hands_them_over(self):
        project, package = self.sample("liver"), self.file("charts.glb")
        def packed(layout):
            return self.done("texture", "pack", project, "--layout", layout, "--size", "512", "-o", project)
        unfolded, charts = packed("unfolded_groups"), packed("charts")
        self.assertEqual(charts["layout"], "charts")
        self.assertLess(charts["seam_share"], unfolded["seam_share"] / 2)
        self.assertLess(charts["seam_length_share"], unfolded["seam_length_share"] / 2)
        self.assertAlmostEqual(unfolded["distortion"]["angle"]["worst"], 1)
        self.assertTrue(1 < charts["distortion"]["angle"]["mean"] < 1.15)
        self.assertLess(charts["distortion"]["area"]["percentile_95"], 1.5)
        self.photographed(project, width=0.5, height=0.5)
        self.assertEqual(self.done("validate", project)["problems"], [])
        self.done("export", project, "--to", "glb", "-o", package)
        self.assertEqual(self.done("validate", package)["problems"], [])

    def test_lays_out_by_the_meshs_own_coordinates_and_hands_them_over(self):
        project, package = self.imported(self.OWN), self.file("own.glb")
        self.assertIs(self.done("info", project)["own_layout"], True)
        packed = self.done("texture", "pack", project, "--layout", "own", "--size", "256", "-o", project)
        self.assertEqual((packed["layout"], packed["utilisation"], packed["warnings"]), ("own", 1, []))
        self.assertAlmostEqual(packed["texels_per_metre"], 256 / math.sqrt(0.02))
        self.assertAlmostEqual(packed["seam_share"], 1 / 3)
        self.assertAlmostEqual(packed["distortion"]["angle"]["worst"], 2)
        self.assertAlmostEqual(packed["distortion"]["area"]["worst"], 1)
        self.assertEqual((packed["distortion"]["flipped"], packed["distortion"]["collapsed"]), (0, 0))
        self.photographed(project, width=0.5, height=0.5)
        self.assertEqual(self.done("validate", project)["problems"], [])
        self.done("export", project, "--to", "glb", "-o", package)
        self.assertEqual(self.done("validate", package)["problems"], [])
        again = self.file("again.esm")  # glTF counts v from the top: read back, it must come out the same
        self.done("import", package, "-o", again)
        with zipfile.ZipFile(project) as ours, zipfile.ZipFile(again) as theirs:
            self.assertEqual(ours.read("mesh/texture-coordinates.f64"), theirs.read("mesh/texture-coordinates.f64"))

    def test_coordinates_that_cannot_be_painted_are_refused_with_what_to_do(self):
        cases = {self.OWN.replace("vt 1 1", "vt 1.5 1"): "2 triangles whose texture coordinates leave the picture",
                 self.OWN.replace("2/6 5/3 6/2 3/5", "2/1 5/2 6/3 3/4"): "lie over each other on 50.0 % of the area",
                 re.sub("/[0-9]", "", self.OWN): "brought no texture coordinates"}
        for content, message in cases.items():
            project = self.imported(content)
            before = project.read_bytes()
            said = self.fails(1, "texture", "pack", project, "--layout", "own", "-o", project, naming="--layout matched_rows")
            self.assertIn(message, said)
            self.assertEqual(project.read_bytes(), before)
        self.assertIs(self.done("info", project)["own_layout"], False)
        half = self.OWN.replace("2/6 5/3 6/2 3/5", "2 5 6 3")
        dropped = self.done("import", self.file("own.obj", half), "-o", project)["warnings"]
        self.assertIn("dropped: 2 of 4 triangles have none", " ".join(dropped))

    def test_bakes_and_hands_over_jpegs(self):
        project, folder = self.sample("liver"), self.file("textures")
        self.photographed(project)
        self.done("texture", "pack", project, "--size", "512", "--gap", "4", "-o", project)
        exact = self.done("texture", "bake", project, "-o", folder)
        sizes = {}
        for quality in ("50", "92"):
            baked = self.done("texture", "bake", project, "-o", folder, "--pictures", "jpeg", "--quality", quality, "--smaller")
            self.assertEqual([Path(file).name for file in baked["files"]], ["texture-1.jpg", "texture-1-256.jpg"])
            self.assertEqual(baked["warnings"], [f"{folder / 'texture-1.png'} is of an earlier bake and no part of this texture; remove or rename"])
            content = Path(baked["files"][0]).read_bytes()
            self.assertEqual((content[:3], content[-2:]), (b"\xff\xd8\xff", b"\xff\xd9"))
            self.assertGreater(baked["seam_error"], exact["seam_error"])
            package = self.file("liver.glb")
            handed = self.done("export", project, "--to", "glb", "--pictures", "jpeg", "--quality", quality, "-o", package)
            self.assertEqual(handed["bytes"], package.stat().st_size)
            self.assertEqual(self.done("validate", package)["problems"], [])
            sizes[quality] = handed["bytes"]
        self.assertLess(sizes["50"], sizes["92"])
        self.assertLess(sizes["92"], self.done("export", project, "--to", "glb", "-o", package)["bytes"])

    def test_what_jpeg_cannot_be_is_said(self):
        project, out = self.sample("tube"), self.file("out")
        for line, message in ((["texture", "bake", project, "--pictures", "jpeg", "--bits", "16"], "16 go with --pictures png"),
                              (["texture", "bake", project, "--quality", "80"], "goes with --pictures jpeg"),
                              (["export", project, "--to", "glb", "--quality", "80"], "goes with --pictures jpeg"),
                              (["export", project, "--to", "vtp", "--pictures", "jpeg"], "a .vtp holds no PNG or JPEG")):
            self.assertIn(message, self.fails(2, *line, "-o", out))
        self.assertFalse(out.exists())

    def test_does_not_depend_on_the_threads(self):
        project = self.sample("liver")
        self.photographed(project)
        pages = []
        for threads in (1, 2):
            self.done("texture", "bake", project, "-o", self.file(f"t{threads}"), "-j", threads)
            pages.append(next(self.file(f"t{threads}").iterdir()).read_bytes())
        self.assertEqual(*pages)

    def test_a_damaged_photo_is_one_line(self):
        self.done("sample", "vessels", "-o", self.file("good.png"))
        good, place, damaged = self.file("good.png").read_bytes(), 8, b""
        while place < len(good):
            length = struct.unpack(">I", good[place:place + 4])[0]
            chunk = bytearray(good[place + 4:place + 8 + length])
            if chunk[:4] == b"IDAT":
                chunk[50::97] = bytes(255 - value for value in chunk[50::97])
            damaged += struct.pack(">I", length) + chunk + struct.pack(">I", zlib.crc32(chunk))
            place += 12 + length
        photo = self.file("damaged.png", good[:8] + damaged)
        self.fails(1, "texture", "photo", self.sample("tube"), "--photo", photo, "--projector",
                   self.file("pose.json", PROJECTOR), "-o", self.file("o.esm"), naming="damaged.png")

    def test_an_unreadable_photo_or_projector_changes_nothing(self):
        project = self.sample("liver")
        before = project.read_bytes()
        pose = self.file("pose.json", PROJECTOR)
        good = self.file("good.png")
        self.done("sample", "vessels", "-o", good)
        for name, content in {"empty.png": b"", "text.png": b"no picture", "cut.png": good.read_bytes()[:500]}.items():
            self.fails(1, "texture", "photo", project, "--photo", self.file(name, content), "--projector", pose,
                       "-o", project, naming=name)
        for name, content in {"a.json": "", "b.json": "[1, 2]", "c.json": {**PROJECTOR, "pose": [0] * 16},
                              "d.json": {**PROJECTOR, "width": -1}, "e.json": {**PROJECTOR, "kind": "fisheye"},
                              "f.json": {**PROJECTOR, "kind": "perspective", "fov": 180}}.items():
            self.fails(1, "texture", "photo", project, "--photo", good, "--projector", self.file(name, content),
                       "-o", project, naming=name)
        self.assertEqual(project.read_bytes(), before)


LANDMARKS = [(-.04, .03, .02), (.05, .02, -.01), (.01, -.04, .03), (-.03, -.02, -.02), (.03, .04, .04), (0, 0, .05),
             (-.05, 0, .01), (.02, -.01, -.04), (.045, -.035, .015), (-.02, .045, -.03)]


class FitTest(Case):
    """An eye 0.3 m before the organ that looks along -z, and a photo of 512 × 512 pixels."""

    def pairs(self, count, focal=600, shift=lambda i: (0, 0), mirrored=False):
        text = "photo_x,photo_y,x,y,z\n"
        for i, (x, y, z) in enumerate(LANDMARKS[:count]):
            u, v = 256 + focal * x / (.3 - z) + shift(i)[0], 256 - focal * y / (.3 - z) + shift(i)[1]
            text += f"{512 - u if mirrored else u!r},{v!r},{x!r},{y!r},{z!r}\n"
        return self.file("pairs.csv", text)

    def line(self, pairs, *options):
        project, photo = self.sample("liver"), self.file("photo.png")
        self.done("sample", "vessels", "-o", photo)
        self.assertEqual(read_png(photo)[:2], (512, 512))
        return ["texture", "fit", project, "--photo", photo, "--pairs", pairs, *options]

    def assertStandsBefore(self, projector, delta=1e-5):
        expected = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, .3, 0, 0, 0, 1]
        for found, true in zip(projector["pose"], expected):
            self.assertAlmostEqual(found, true, delta=delta)

    def test_finds_the_pose_and_writes_it(self):
        pose = self.file("pose.json")
        line = self.line(self.pairs(8), "--intrinsics", "600,600,256,256", "-o", pose)
        report = self.done(*line)
        self.assertKeys(report, {"projector": dict, "reprojection_error_px": float, "errors_px": list, "outliers": list})
        self.assertStandsBefore(report["projector"])
        self.assertLess(report["reprojection_error_px"], .1)
        self.assertEqual((len(report["errors_px"]), report["outliers"], report["focal_length"]), (8, [], "given"))
        self.assertEqual(report["projector"]["intrinsics"], {"fx": 600, "fy": 600, "cx": 256, "cy": 256})
        self.assertEqual(json.loads(pose.read_text()), report["projector"])
        self.done("texture", "photo", line[2], "--photo", line[4], "--projector", pose, "-o", line[2])
        self.assertEqual(self.done(*line), report)

    def test_says_the_pose_in_words(self):
        process = command(*self.line(self.pairs(8), "--intrinsics", "600,600,256,256"))
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertNotRegex(process.stdout, r"[\[\]{}\"]")
        for words in ("the eye is at 0, 0, 0.3 m", "it looks along 0, 0, -1", "up in the photograph is 0, 1, 0",
                      "focal lengths 600, 600 pixels (given)", "line of sight through 256, 256 pixels"):
            self.assertIn(words, process.stdout)
        unsure = command(*self.line(self.pairs(4))).stdout
        self.assertRegex(unsure, r"true eye is within [1-9]\d mm of it, and the true turn within \d\.\d+ degrees")
        self.assertIn("vertical field of view 46.27 degrees (measured), line of sight in the middle (assumed)", unsure)

    def test_finds_the_camera_from_six_pairs(self):
        report = self.done(*self.line(self.pairs(6, focal=450)))
        self.assertStandsBefore(report["projector"])
        self.assertAlmostEqual(report["projector"]["fov"], 2 * math.degrees(math.atan(256 / 450)), places=2)
        self.assertKeys(report, {"eye_within": float, "turn_within": float, "click_noise_px": float, "weak": list})
        self.assertEqual(report["focal_length"], "measured")
        self.assertIn(report["hangs_on"], (None, "principal_point"))
        self.assertEqual(report["weak"], [])

    def test_says_what_four_pairs_leave_open(self):
        report = self.done(*self.line(self.pairs(4)))
        self.assertEqual((report["principal_point"], report["hangs_on"]), ("assumed", "principal_point"))
        self.assertGreater(report["eye_within"], .01)
        self.assertIn("line of sight", report["warnings"][0])

    def test_says_that_a_photo_is_stretched(self):
        """It is 512 pixels wide and shows what one of 410 would with square ones."""
        lines = self.pairs(10).read_text().splitlines()
        rows = [line.split(",") for line in lines[1:]]
        squeezed = [",".join([repr(256 + .8 * (float(u) - 256)), *rest]) for u, *rest in rows]
        report = self.done(*self.line(self.file("pairs.csv", "\n".join([lines[0], *squeezed]) + "\n")))
        self.assertStandsBefore(report["projector"], delta=1e-4)
        self.assertEqual(report["pixel_aspect"], "measured")
        self.assertIn("stretched: it is 0.8 times as wide", " ".join(report["warnings"]))

    def test_names_the_pairs_that_do_not_belong(self):
        wrong = {2: (30, -20), 6: (-15, 25)}
        pairs = self.pairs(10, shift=lambda i: wrong.get(i, (0, 0)))
        report = self.done(*self.line(pairs, "--intrinsics", "600,600,256,256"))
        self.assertEqual(report["outliers"], [3, 7])
        self.assertAlmostEqual(report["errors_px"][2], math.hypot(30, 20), delta=.1)
        self.assertStandsBefore(report["projector"])

    def test_refuses_what_tells_no_pose_and_writes_nothing(self):
        pose, header = self.file("pose.json"), "photo_x,photo_y,x,y,z\n"
        on_a_line = header + "".join(f"{i * 10},{i * 20},{i / 100},0,{i / 50}\n" for i in range(6))
        for pairs, problem in ((3, "4 or more"), (header, "4 or more"), (on_a_line, "line"),
                               (10, "mirrored"), (header + "1,2,3,4\n", "line 2"),
                               (header + "1,2,3,4,5\n1,2,x,4,5\n", "line 3"), ("1,2,3,4,5\n", "line 1")):
            pairs = self.pairs(pairs, mirrored=pairs == 10) if isinstance(pairs, int) else self.file("pairs.csv", pairs)
            with self.subTest(problem):
                message = self.fails(1, *self.line(pairs, "--intrinsics", "600,600,256,256", "-o", pose), naming=pairs)
                self.assertIn(problem, message)
        for intrinsics in ("1,2,3", "0,1,1,1", "1,-1,0,0", "a,b,c,d", "1,1,nan,1", "1e300,1,0,0"):
            self.fails(2, *self.line(self.pairs(8), f"--intrinsics={intrinsics}", "-o", pose))
        self.assertFalse(pose.exists())


class RenderTest(Case):
    def rendered(self, project, *options):
        picture = self.file("picture.png")
        report = self.done("render", project, "-o", picture, "--size", "120x90", *options)
        self.assertEqual(report["size"], [120, 90])
        width, height, channels, rows = read_png(picture)
        self.assertEqual((width, height), (120, 90))
        return [[row[i:i + 3] for i in range(0, len(row), channels)] for row in rows]

    def test_draws_the_organ_in_the_middle(self):
        pixels = self.rendered(self.sample("liver"))
        red, _, blue = pixels[45][60]
        self.assertGreater(red, blue)
        self.assertLess(sum(pixels[0][0]), 3 * 70)

    def test_a_size_is_decimal(self):
        report = self.done("render", self.sample("tube"), "-o", self.file("p.png"), "--size", "0120x0090")
        self.assertEqual(report["size"], [120, 90])

    def test_projectors_of_a_package_are_missed_aloud(self):
        package = self.file("tube.glb")
        self.done("export", self.sample("tube"), "-o", package, "--to", "glb")
        for shown, warnings in (("surface", 0), ("surface,projectors", 1)):
            report = self.done("render", package, "-o", self.file("p.png"), "--size", "40x30", "--show", shown)
            self.assertEqual(len(report["warnings"]), warnings)

    def test_draws_with_no_more_threads_than_it_may(self):
        project, line = self.sample("liver"), ["-o", self.file("p.png"), "--size", "2000x2000"]
        self.assertEqual(self.drawing_threads("render", project, *line, "-j", "1"), 0)
        self.assertEqual(self.drawing_threads("render", project, *line, "-j", "2"), 2)

    def drawing_threads(self, *line):
        """The most threads of the drawing library that were seen while the program ran."""
        most = 0
        with subprocess.Popen([ESMC, *map(str, line)], stdout=subprocess.DEVNULL) as process:
            while process.poll() is None:
                names = [thread_name(task) for task in Path(f"/proc/{process.pid}/task").glob("*")]
                most = max(most, sum(name.startswith("llvmpipe-") for name in names))
                time.sleep(0.002)
        self.assertEqual(process.returncode, 0)
        return most

    def test_every_view_and_part_makes_another_picture(self):
        project = self.sample("liver")
        self.done("tissue", project, "--ellipsoid", "0 0 0 .05 .05 .05", "-o", project)
        options = [["--view", view] for view in ("front", "back", "left", "right", "top", "bottom", "0.1 0.2 0.5 0 0 0")]
        options += [["--show", "springs"], ["--show", "surface,regions"], ["--unlit"]]
        pictures = [str(self.rendered(project, *line)) for line in options]
        self.assertEqual(len(set(pictures)), len(options))

    def test_a_camera_stands_at_its_pose_and_looks_along_minus_z(self):
        size = self.done("info", self.sample("tube"))["size"]
        x, y, z = self.done("info", self.file("tube.esm"))["centre"]
        distance = 3 * max(size)
        pose = [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z + distance, 0, 0, 0, 1]
        camera = lambda **changes: self.file("camera.json", {"kind": "perspective", "pose": pose, "fov": 40, **changes})
        drawn = self.rendered(self.file("tube.esm"), "--camera", camera())
        background = self.rendered(self.file("tube.esm"), "--camera", camera(pose=pose[:3] + [x + 9] + pose[4:]))
        columns = [i for i in range(120) if any(drawn[j][i] != background[j][i] for j in range(90))]
        lines = [j for j in range(90) if drawn[j] != background[j]]
        self.assertAlmostEqual((columns[0] + columns[-1]) / 2, 59.5, delta=3)
        self.assertAlmostEqual((lines[0] + lines[-1]) / 2, 44.5, delta=3)

    def test_a_camera_by_intrinsics_sees_as_one_by_its_field_of_view(self):
        project, focal = self.sample("tube"), 45 / math.tan(math.radians(20))
        pose = PROJECTOR["pose"]
        intrinsics = {"fx": focal, "fy": focal, "cx": 60, "cy": 45}
        seen = [self.rendered(project, "--camera", self.file("camera.json", {"pose": pose, **camera}))
                for camera in ({"fov": 40}, {"intrinsics": intrinsics}, {"intrinsics": {**intrinsics, "cx": 80}})]
        self.assertEqual(seen[0], seen[1])
        self.assertNotEqual(seen[0], seen[2])

    def test_a_bad_camera_is_named_with_each_problem_once(self):
        project = self.sample("tube")
        good = {"kind": "perspective", "pose": PROJECTOR["pose"], "fov": 40}
        for changes, problem in (({"fov": 0}, "fov"), ({"fov": "wide"}, "fov"), ({"fov": None}, "fov"),
                                 ({"pose": [1, 2]}, "pose"), ({"pose": None}, "pose"), ({"kind": "parallel"}, "kind"),
                                 ({"pose": [2, *PROJECTOR["pose"][1:]]}, "pose"), ({"foc": 40}, "foc"),
                                 ({"intrinsics": {"fx": 900, "fy": 900, "cx": 320, "cy": 240}}, "intrinsics"),
                                 ({"fov": None, "intrinsics": {"fx": 900, "fy": 900, "cx": 320}}, "intrinsics")):
            with self.subTest(changes):
                camera = self.file("camera.json", {**good, **changes})
                message = self.fails(1, "render", project, "-o", self.file("p.png"), "--camera", camera, naming=camera)
                said = message.split("camera.json: ")[1]
                self.assertTrue(said.startswith(problem), said)
                self.assertEqual(said.count(problem), 1, said)
        width = self.file("camera.json", {**good, "width": 1, "height": 1, "occlusion": False})
        self.done("render", project, "-o", self.file("p.png"), "--size", "40x30", "--camera", width)

    def test_a_package_looks_as_its_project(self):
        project, package = self.sample("liver"), self.file("liver.glb")
        self.done("sample", "vessels", "-o", self.file("photo.png"))
        self.done("texture", "photo", project, "--photo", self.file("photo.png"), "--projector",
                  self.file("pose.json", PROJECTOR), "-o", project)
        self.done("texture", "finish", project, "--layer", "photo", "--preset", "serosa", "--relief", "0.3", "-o", project)
        self.done("export", project, "-o", package, "--to", "glb")
        ours, theirs = ([value for row in self.rendered(file) for pixel in row for value in pixel]
                        for file in (project, package))
        self.assertLessEqual(max(abs(a - b) for a, b in zip(ours, theirs)), 4)

    def test_a_motion_model_without_surface_shows_its_springs(self):
        pixels = self.rendered(self.sample("uterus"))
        self.assertGreater(len({pixel for row in pixels for pixel in row}), 50)


if __name__ == "__main__":
    unittest.main()
