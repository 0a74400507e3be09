import json
import resource
import struct
import unittest
import zipfile
import zlib
from pathlib import Path

from esmc import CUBE, PROJECTOR, Case, command

TRIANGLE_STL = b" " * 80 + struct.pack("<I", 1) + struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
MESHES = {
    "empty.obj": b"", "empty.stl": b"", "empty.ply": b"", "empty.off": b"", "empty.glb": b"", "empty.vtk": b"",
    "text.obj": b"Dear reader, this is a letter.\n", "text.stl": b"Dear reader", "text.ply": b"Dear reader",
    "text.off": b"Dear reader", "text.glb": b"Dear reader", "text.vtk": b"Dear reader",
    "points.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "lines.obj": b"v 0 0 0\nv 1 0 0\nl 1 2\n",
    "nan.obj": b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "inf.off": b"OFF\n3 1 0\ninf 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    "nan.stl": TRIANGLE_STL[:96] + struct.pack("<f", float("nan")) + TRIANGLE_STL[100:],
    "nan.ply": b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               b"element face 1\nproperty list uchar int vertex_indices\nend_header\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    "flat.obj": b"v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n",
    "index.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
    "lying.stl": TRIANGLE_STL[:80] + struct.pack("<I", 4_000_000_000) + TRIANGLE_STL[84:],
    "lying.ply": b"ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\n"
                 b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\0\0\0\0",
    "lying.vtk": b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4000000000 float\n0 0 0\n",
    "volume.nrrd": b"NRRD0004\n", "model.docx": b"PK\3\4",
}
TRUNCATED = ["VH_F_Fallopian_Tube_L.glb", "sks-liver-H07.ply", "sks-liver-downsample.stl", "sofa-aneurysm.off",
             "GCA-00020-transverse-colon-open.vtk", "sks-prostate-phantom.vtk"]


class BadMeshTest(Case):
    def refused(self, mesh):
        out = self.file("out.esm", b"what was here before")
        message = self.fails(1, "import", mesh, "-o", out, naming=mesh)
        self.assertEqual(out.read_bytes(), b"what was here before")
        self.assertEqual([path.name for path in self.folder.glob("out*")], ["out.esm"])
        self.assertNotRegex(message.replace(str(self.folder), ""), r"(?i)exception|assert|std::|0x")

    def test_bad_files_are_named_and_change_nothing(self):
        for name, content in MESHES.items():
            with self.subTest(name):
                self.refused(self.file(name, content))

    def test_what_is_no_file_is_refused(self):
        for name in ("none.obj", ".", "/dev/null", "/dev/full"):
            with self.subTest(name):
                self.refused(self.folder / name if name[0] != "/" else Path(name))

    def test_half_files_are_refused(self):
        for name in TRUNCATED:
            whole = self.data(f"meshes/{name}").read_bytes()
            for part in (0.01, 0.5, 0.999):
                with self.subTest(f"{name} {part}"):
                    self.refused(self.file(f"half-{name}", whole[:int(len(whole) * part)]))


class WrongFileThatOpensTest(Case):
    def check(self, file, naming):
        self.fails(1, "validate", file, naming=naming)
        process = command("validate", file, "--json")
        self.assertEqual(process.returncode, 1)
        self.assertFalse(json.loads(process.stdout)["valid"])
        warnings = self.done("info", file)["warnings"]
        self.assertEqual(len([w for w in warnings if naming in w and str(file) in w]), 1, warnings)
        self.assertTrue(command("info", file).stdout.startswith(f"warning: {file}: "))

    def soft_region_of_version(self, version):
        def change(manifest):
            manifest["version"] = version
            manifest["regions"].append({"name": "soft", "colour": [1, 2, 3], "rim": 0.01, "inputs": [],
                                        "ellipsoid": {"centre": [0, 0, 0], "radii": [1, 1, 1]},
                                        "held": {"springConstant": 5}})
            return manifest
        return self.changed_manifest(f"soft-{version}.esm", change)

    def test_projects_of_too_low_a_version(self):
        self.assertTrue(self.done("validate", self.soft_region_of_version(5))["valid"])
        project = self.soft_region_of_version(1)
        self.check(project, "version should be 5")
        report = self.done("texture", "pack", project, "--size", "256", "-o", project)
        self.assertIn("version should be 5", report["warnings"][0])
        self.assertTrue(self.done("validate", project)["valid"], "saved again")

    def test_packages_that_viewers_show_elsewhere(self):
        package = self.file("organ.glb")
        self.done("export", self.sample("tube"), "--to", "glb", "-o", package)
        self.assertTrue(self.done("validate", package)["valid"])
        content = package.read_bytes()
        length = struct.unpack_from("<I", content, 12)[0]
        gltf, rest = json.loads(content[20:20 + length]), content[20 + length:]
        gltf["nodes"][0]["scale"] = [2, 2, 2]
        del gltf["extensions"]["ESM_spring_mass"]["checksums"]  # as who changes a package is to do
        text = json.dumps(gltf).encode()
        text += b" " * (-len(text) % 4)
        package.write_bytes(struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A) +
                            text + rest)
        self.check(package, "nodes[0] should have no scale")


class BadProjectTest(Case):
    def refused_everywhere(self, bad):
        out, scene, pose = self.file("out"), self.file("s.json", {"duration": 1}), self.file("p.json", PROJECTOR)
        before = bad.read_bytes() if bad.is_file() else None
        for line in (["info", bad], ["tissue", bad, "-o", bad], ["simulate", bad, "--scene", scene, "-o", out],
                     ["scene", bad, "--scene", scene, "-o", bad], ["texture", "pack", bad, "-o", bad],
                     ["texture", "photo", bad, "--photo", "x.png", "--projector", pose, "-o", bad],
                     ["texture", "bake", bad, "-o", out], ["export", bad, "-o", out, "--to", "glb"],
                     ["render", bad, "-o", out]):
            with self.subTest(line):
                self.fails(1, *line, naming=bad)
        process = command("validate", bad)
        self.assertEqual((process.returncode, process.stderr.count("\n")), (1, 1))
        if process.stdout:
            self.assertNotIn(process.stdout.strip(), process.stderr, "a problem is told once")
        process = command("validate", bad, "--json")
        self.assertEqual(process.returncode, 1)
        if process.stdout:
            report = json.loads(process.stdout)
            self.assertTrue(report["valid"] is False and report["problems"])
        self.assertFalse(out.exists())
        if before is not None:
            self.assertEqual(bad.read_bytes(), before)

    def test_missing_empty_and_foreign_projects(self):
        self.refused_everywhere(self.file("none.esm"))
        self.refused_everywhere(self.file("empty.esm", b""))
        self.refused_everywhere(self.file("text.esm", "Dear reader"))
        with zipfile.ZipFile(self.file("other.esm"), "w") as archive:
            archive.writestr("hello.txt", "hello")
        self.refused_everywhere(self.file("other.esm"))

    def test_a_truncated_project(self):
        whole = self.sample("liver").read_bytes()
        self.refused_everywhere(self.file("cut.esm", whole[:len(whole) // 2]))

    def test_a_project_of_a_newer_version(self):
        newer = self.changed_manifest("newer.esm", lambda manifest: {**manifest, "version": 99})
        self.refused_everywhere(newer)
        self.assertIn("newer", self.fails(1, "info", newer).replace(str(newer), ""))

    def test_bytes_changed_anywhere_never_crash(self):
        whole = self.sample("tube").read_bytes()
        for place in range(0, len(whole), max(1, len(whole) // 60)):
            spoiled = bytearray(whole)
            spoiled[place] ^= 0xFF
            process = command("info", self.file("spoiled.esm", bytes(spoiled)))
            self.assertIn(process.returncode, (0, 1), f"byte {place}: {process.stderr}")

    def test_packages_are_checked_too(self):
        package = self.file("tube.glb")
        self.done("export", self.sample("tube"), "-o", package, "--to", "glb")
        self.assertEqual(self.done("validate", package), {"valid": True, "problems": []})
        whole = package.read_bytes()
        for bad in (b"", b"glTF", whole[:100], whole[:len(whole) // 2], whole[:-1]):
            process = command("validate", self.file("bad.glb", bad), "--json")
            self.assertEqual(process.returncode, 1)
            self.assertRegex(process.stderr, r"\Aesmc: [^\n]+\n\Z")
        self.fails(1, "info", self.file("bad.glb"), naming="bad.glb")


def picture(size):
    """A black PNG."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes(size * (1 + 3 * size)))) + chunk(b"IEND", b""))


class BadOutputTest(Case):
    def setUp(self):
        super().setUp()
        self.project = self.sample("tube")
        self.scene = self.file("still.json", {"duration": 0.1, "record": {"every": 0.001}})
        self.pose = self.file("pose.json", PROJECTOR)
        self.file("photo.png", picture(4))  # decodes to less than what a full disk still takes

    def writers(self, out):
        project = self.project
        return [["import", self.file("cube.obj", CUBE), "-o", out], ["sample", "tube", "-o", out],
                ["tissue", project, "-o", out], ["scene", project, "--scene", self.scene, "-o", out],
                ["simulate", project, "--scene", self.scene, "-o", out], ["texture", "pack", project, "-o", out],
                ["texture", "photo", project, "--photo", self.file("photo.png"), "--projector", self.pose, "-o", out],
                ["export", project, "-o", out, "--to", "glb"], ["render", project, "-o", out]]

    def test_what_is_no_regular_file_is_refused(self):
        for out in ("/dev/full", "/dev/null", self.folder, self.folder / "none" / "out"):
            for line in self.writers(out):
                with self.subTest(line):
                    self.fails(1, *line, naming=out)
        for device in ("/dev/full", "/dev/null"):
            self.assertTrue(Path(device).is_char_device())
        self.fails(1, "texture", "bake", self.project, "-o", "/dev/full", naming="/dev/full")

    def test_a_full_disk_leaves_the_old_file(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500))
        for line in self.writers(self.file("out", b"what was here before")):
            with self.subTest(line):
                self.fails(1, *line, naming="out", preexec_fn=limit)
                self.assertEqual(self.file("out").read_bytes(), b"what was here before")
        self.assertEqual(len(list(self.folder.glob("out*"))), 1)

    def test_the_input_may_be_the_output(self):
        for line in self.writers(self.project):
            if line[0] in ("tissue", "scene", "texture"):
                self.done(*line)
        after = self.done("info", self.project)
        self.assertEqual((len(after["regions"]), len(after["photos"]), after["textures"]), (2, 1, 1))
        self.assertEqual(self.done("validate", self.project), {"valid": True, "problems": []})

    def test_a_link_to_nothing_is_refused(self):
        out = self.folder / "link"
        out.symlink_to("nowhere")
        for line in [*self.writers(out), ["texture", "bake", self.project, "-o", out]]:
            with self.subTest(line):
                self.fails(1, *line, naming=out)
                self.assertTrue(out.is_symlink())
                self.assertFalse((self.folder / "nowhere").exists())

    def test_a_link_stays_a_link(self):
        link = self.folder / "link.esm"
        link.symlink_to(self.project.name)
        self.done("tissue", link, "-o", link, "--name", "through the link")
        self.assertTrue(link.is_symlink())
        self.assertEqual(self.done("info", self.project)["regions"][-1]["name"], "through the link")


if __name__ == "__main__":
    unittest.main()
