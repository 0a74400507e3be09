#!/usr/bin/env python3
"""Checks a model package with the standard library alone, by docs/model-package.md and the glTF 2.0 rules.

    read_package.py PACKAGE.glb [--project PROJECT.esm] [--tissue TISSUE.json] [--carry NODES.csv]

Checks the rules of glTF and of ESM_spring_mass; with --project, that every array is the project's rounded to
float32; with --tissue, that the evaluated tissue is the one given (lists mass, spring_constant, viscosity, tethers,
fixed, stiffening). With --carry, prints where a trajectory of the nodes carries the vertices of the surface, frame by
frame, as JSON. Else prints every problem and exits 1, or prints the counts as one JSON object and exits 0.
"""
import argparse
import csv
import json
import math
import struct
import sys
import zipfile
import zlib
from pathlib import Path

sys.dont_write_bytecode = True  # beside the reader, in the folder of the sources
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples" / "readers"))
import esm_package  # noqa: E402: its folder is known only now

FLOAT, UNSIGNED = 5126, 5125
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
FORMATS = {FLOAT: "f", UNSIGNED: "I"}
problems = []


def check(condition, problem):
    if not condition:
        problems.append(problem)
    return condition


def float32(values):
    return list(struct.unpack("<%df" % len(values), struct.pack("<%df" % len(values), *values)))


def read_glb(content):
    magic, version, length = struct.unpack_from("<III", content, 0)
    check(magic == 0x46546C67 and version == 2, "no glTF 2 header")
    check(length == len(content), "the header speaks of %d bytes, the file has %d" % (length, len(content)))
    chunks, place = [], 12
    while place < length:
        size, kind = struct.unpack_from("<II", content, place)
        check(size % 4 == 0, "the chunk at %d is not padded to 4 bytes" % place)
        chunks.append((kind, content[place + 8:place + 8 + size]))
        place += 8 + size
    check([kind for kind, _ in chunks] == [0x4E4F534A, 0x004E4942], "the chunks are not JSON and BIN")
    return chunks[0][1], chunks[1][1]


class Gltf:
    def __init__(self, content):
        self.text, self.binary = read_glb(content)
        self.json = json.loads(self.text.decode("utf-8"))
        self.arrays = {}

    def view(self, index):
        view = self.json["bufferViews"][index]
        check(view["buffer"] == 0, "bufferView %d is of another buffer" % index)
        offset, size = view.get("byteOffset", 0), view["byteLength"]
        check(size > 0 and offset + size <= len(self.binary), "bufferView %d is out of bounds" % index)
        return offset, size

    def file(self, index):
        offset, size = self.view(index)
        return self.binary[offset:offset + size]

    def array(self, index):
        """The numbers of an accessor, flat."""
        if index in self.arrays:
            return self.arrays[index]
        accessor = self.json["accessors"][index]
        kind, components = accessor["componentType"], COMPONENTS[accessor["type"]]
        view_offset, view_size = self.view(accessor["bufferView"])
        offset, count = accessor.get("byteOffset", 0), accessor["count"] * components
        check(accessor["count"] > 0, "accessor %d is empty" % index)
        check(kind in FORMATS, "accessor %d is neither float nor unsigned int" % index)
        check((view_offset + offset) % 4 == 0, "accessor %d is not aligned" % index)
        check(offset + 4 * count <= view_size, "accessor %d reaches beyond its bufferView" % index)
        values = list(struct.unpack_from("<%d%s" % (count, FORMATS[kind]), self.binary, view_offset + offset))
        if kind == FLOAT:
            check(all(math.isfinite(value) for value in values), "accessor %d is not finite" % index)
        for key, extreme in (("min", min), ("max", max)):
            if key in accessor:
                true = [extreme(values[i::components]) for i in range(components)]
                check(accessor[key] == true, "accessor %d: %s is not true" % (index, key))
        self.arrays[index] = values
        return values


def check_png(content, size, name):
    if not check(content[:8] == b"\x89PNG\r\n\x1a\n", name + " is no PNG"):
        return
    place, chunks = 8, {}
    while place < len(content):
        length, kind = struct.unpack_from(">I4s", content, place)
        body = content[place + 8:place + 8 + length]
        crc, = struct.unpack_from(">I", content, place + 8 + length)
        check(crc == zlib.crc32(kind + body), name + " has a damaged chunk")
        chunks[kind] = chunks.get(kind, b"") + body
        place += 12 + length
    width, height = struct.unpack_from(">II", chunks[b"IHDR"])
    check((width, height) == (size, size), "%s is %d x %d" % (name, width, height))
    channels = {2: 3, 6: 4}[chunks[b"IHDR"][9]]
    check(len(zlib.decompress(chunks[b"IDAT"])) == height * (1 + channels * width), name + " is not whole")


def check_jpeg(content, size, name):
    if not check(content[:2] == b"\xff\xd8" and content[-2:] == b"\xff\xd9", name + " is no JPEG"):
        return
    place = 2
    while content[place + 1] not in (0xC0, 0xC1, 0xC2):
        place += 2 + struct.unpack_from(">H", content, place + 2)[0]
    depth, height, width, channels = struct.unpack_from(">BHHB", content, place + 4)
    check((width, height) == (size, size), "%s is %d x %d" % (name, width, height))
    check((depth, channels) == (8, 3), name + " is not of 8 bits and three channels")


def check_primitive(gltf, primitive, name):
    attributes = primitive["attributes"]
    accessors = gltf.json["accessors"]
    positions = accessors[attributes["POSITION"]]
    check("min" in positions and "max" in positions, name + ": POSITION has no min and max")
    for attribute, accessor in attributes.items():
        check(accessors[accessor]["count"] == positions["count"], "%s: %s is of another length" % (name, attribute))
        check(accessors[accessor]["componentType"] == FLOAT, "%s: %s is not float" % (name, attribute))
    for attribute, kind in (("POSITION", "VEC3"), ("NORMAL", "VEC3"), ("TEXCOORD_0", "VEC2")):
        if attribute in attributes:
            check(accessors[attributes[attribute]]["type"] == kind, "%s: %s is not %s" % (name, attribute, kind))
            gltf.array(attributes[attribute])
    if "NORMAL" in attributes:
        normals = gltf.array(attributes["NORMAL"])
        lengths = [math.hypot(*normals[i:i + 3]) for i in range(0, len(normals), 3)]
        check(all(abs(length - 1) < 5e-4 for length in lengths), name + ": a normal is not of unit length")
    if "TEXCOORD_0" in attributes:
        check(all(0 <= value <= 1 for value in gltf.array(attributes["TEXCOORD_0"])), name + ": texture place")
    if "indices" in primitive:
        indices = gltf.array(primitive["indices"])
        check(accessors[primitive["indices"]]["type"] == "SCALAR", name + ": indices are not scalars")
        check(max(indices) < positions["count"], name + ": an index is out of range")
        corners = {0: 1, 1: 2, 4: 3}[primitive.get("mode", 4)]
        check(len(indices) % corners == 0, name + ": indices do not make whole triangles or lines")


def check_checksums(gltf):
    """CRC-32 of each buffer view; in the place of the last view, which holds the sums, that of the JSON part."""
    place = gltf.json["extensions"]["ESM_spring_mass"].get("checksums")
    if place is None:
        return
    sums, views = gltf.array(place), len(gltf.json["bufferViews"])
    check(len(sums) == views, "there are %d check sums for %d bufferViews" % (len(sums), views))
    check(gltf.json["accessors"][place]["bufferView"] == views - 1, "the check sums are not in the last bufferView")
    for index in range(views - 1):
        check(zlib.crc32(gltf.file(index)) == sums[index], "bufferView %d has another check sum" % index)
    check(zlib.crc32(gltf.text) == sums[-1], "the JSON has another check sum")


XMP = "KHR_xmp_json_ld"


def check_provenance(document):
    """The same is said in the extension and, where it goes beyond the program, as XMP."""
    provenance = document["extensions"]["ESM_spring_mass"].get("provenance")
    if provenance is None:
        return
    check(provenance["program"] == document["asset"]["generator"], "another program than the generator")
    if "source" in provenance:
        check(len(bytes.fromhex(provenance["source"]["sha256"])) == 32, "no SHA-256")
    if set(provenance) == {"program"}:
        check(XMP not in document["extensionsUsed"], "an XMP packet that says nothing")
        return
    packet = document["extensions"][XMP]["packets"][document["asset"]["extensions"][XMP]["packet"]]
    check(XMP in document["extensionsUsed"], "extensionsUsed does not name " + XMP)
    told = {"title": packet.get("dc:title", {}).get("rdf:_1", {}).get("@value"),
            "author": packet.get("dc:creator", {}).get("@list", [None])[0], "date": packet.get("xmp:CreateDate"),
            "licence": packet.get("dc:rights", {}).get("rdf:_1", {}).get("@value"),
            "source": packet.get("dc:source"), "program": packet["xmp:CreatorTool"]}
    here = dict(provenance, source=provenance.get("source", {}).get("file"))
    check(told == {key: here.get(key) for key in told}, "XMP says otherwise than the package")
    prefixes = {key.split(":")[0] for key in packet if ":" in key}
    check(prefixes < set(packet["@context"]), "an XMP prefix is not in the context")


def check_gltf(gltf):
    document = gltf.json
    check(document["asset"]["version"] == "2.0", "asset.version is not 2.0")
    check("generator" in document["asset"], "no asset.generator")
    check("ESM_spring_mass" in document["extensionsUsed"], "extensionsUsed does not name ESM_spring_mass")
    check("extensionsRequired" not in document, "extensionsRequired is there")
    check(len(document["buffers"]) == 1 and "uri" not in document["buffers"][0], "the buffer is not the BIN chunk")
    check(0 <= len(gltf.binary) - document["buffers"][0]["byteLength"] <= 3, "the buffer is not as long as BIN")
    for key in ("accessors", "bufferViews", "nodes", "scenes", "meshes", "materials", "textures", "images", "samplers"):
        check(document.get(key) != [], key + " is an empty list")
    for index in range(len(document["bufferViews"])):
        gltf.view(index)
    for index in range(len(document["accessors"])):
        gltf.array(index)
    for node in document["nodes"]:
        check(not {"matrix", "translation", "rotation", "scale"} & set(node), "a node has a transform")
    for image in document.get("images", []):
        check("uri" not in image, "a picture lies outside the file")
    for m, mesh in enumerate(document.get("meshes", [])):
        for p, primitive in enumerate(mesh["primitives"]):
            check_primitive(gltf, primitive, "mesh %d primitive %d" % (m, p))
            if "material" in primitive:
                check(document["materials"][primitive["material"]]["doubleSided"] is True, "a material is one-sided")
    for texture in document.get("textures", []):
        sampler = document["samplers"][texture["sampler"]]
        check(sampler["minFilter"] == 9729, "a texture has mip-maps, which mix neighbouring patches")
        image = document["images"][texture["source"]]
        size = document["extensions"]["ESM_spring_mass"]["texture"]["size"]
        check_picture = {"image/png": check_png, "image/jpeg": check_jpeg}[image["mimeType"]]
        check_picture(gltf.file(image["bufferView"]), size, "texture page %d" % texture["source"])
    preview = document["extensions"]["ESM_spring_mass"].get("preview")
    if preview is not None:
        check_png(gltf.file(document["images"][preview]["bufferView"]), 512, "the preview picture")


def threes(values, size=3):
    return [values[i:i + size] for i in range(0, len(values), size)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def is_extended(system):
    """Whether it has norms, weights or conditions that readers of version 3 do not know."""
    words = " ".join(system["rules"]).upper().replace("(", " ").split()
    return "norms" in system or any(word in words for word in ("NOT", "OR", "WITH"))


class Package:
    """The arrays of ESM_spring_mass by the names of the specification."""

    def __init__(self, gltf, readable):
        self.gltf, self.readable = gltf, readable
        self.json = gltf.json["extensions"]["ESM_spring_mass"]
        extended = any(map(is_extended, self.json["fuzzySystems"]))
        soft = any("rim" in region for region in self.json["regions"])
        needed = 5 if soft else 4 if extended else 3 if "stiffening" in self.json else 2 if "binding" in self.json else 1
        if "starts" in self.json.get("binding", {}):
            needed = 6
        self.is_stretched = "layout" in self.json.get("texture", {})
        is_of_later_kind = self.json.get("lattice", {}).get("kind") in ("prisms", "graded")
        known = (9,) if "fillings" in self.json or is_of_later_kind else (8,) if "lattice" in self.json else (7,) if self.is_stretched else (needed, 6)  # 6: springs of their own
        check(self.json["version"] in known, "another version of the extension")
        check(not self.is_stretched or self.json["texture"]["layout"] in ("charts", "own"), "an unknown layout")
        check(self.json["damping"] == "isotropic", "another damping")
        self.nodes, self.springs = self.json["nodes"], self.json["springs"]
        self.node_count, self.spring_count = self.nodes["count"], self.springs["count"]
        self.stiffening = self.json.get("stiffening")
        check(self.stiffening == self.json["base"].get("stiffening"), "the springs are stiffer than the tissue says")
        if self.stiffening:
            check(set(self.stiffening) == {"strain", "factor"}, "a biphasic law of other parts")
            check(all(0 < value <= 1e30 for value in self.stiffening.values()), "no biphasic law")

    def array(self, group, key, count, components=1):
        if group.get("count", 1) == 0 or key not in group:
            check(count == 0, "%s is missing" % key)
            return []
        values = self.gltf.array(group[key])
        check(len(values) == count * components, "%s has %d numbers, not %d" % (key, len(values), count * components))
        return values

    def check(self):
        group = self.nodes
        self.rest = self.array(group, "restPosition", self.node_count, 3)
        self.mass, self.node_c, self.node_d = (
            self.array(group, key, self.node_count) for key in ("mass", "springConstant", "viscosity"))
        check(all(mass > 0 for mass in self.mass), "a mass is not above 0")
        check(all(value >= 0 for value in self.node_c + self.node_d), "a parameter is below 0")
        group = self.springs
        self.ends = self.array(group, "nodes", self.spring_count, 2)
        check(all(end < self.node_count for end in self.ends), "a spring's node is out of range")
        self.lengths = self.array(group, "restLength", self.spring_count)
        for key, of_nodes in (("springConstant", self.node_c), ("viscosity", self.node_d)):
            for i, value in enumerate(self.array(group, key, self.spring_count)):
                check(value >= 0, "a spring's parameter is below 0")
                if self.json["version"] >= 6:
                    continue
                mean = (of_nodes[self.ends[2 * i]] + of_nodes[self.ends[2 * i + 1]]) / 2
                check(abs(value - mean) <= 1e-6 * mean + 1e-37, "%s of spring %d is not its ends' mean" % (key, i))
        group = self.json["tethers"]
        self.tethers = [self.array(group, key, group["count"]) for key in ("nodes", "springConstant", "viscosity")]
        group = self.json["fixedNodes"]
        self.fixed = self.array(group, "nodes", group["count"])
        check(all(node < self.node_count for node in self.tethers[0] + self.fixed), "a tied node is out of range")
        check(sorted(set(self.fixed)) == self.fixed, "fixed nodes are not sorted, each once")
        surface = self.json["surface"]
        self.vertices = self.array(surface, "restPosition", surface["vertexCount"], 3)
        self.vertex_nodes = self.array(surface, "vertexNodes", surface["vertexCount"])
        self.triangles = self.array(surface, "triangles", surface["triangleCount"], 3)
        check(all(node < self.node_count for node in self.vertex_nodes), "a vertex's node is out of range")
        check(all(vertex < surface["vertexCount"] for vertex in self.triangles), "a triangle's vertex is out of range")
        for region in self.json["regions"]:
            check(region.get("fuzzySystem", -1) < len(self.json["fuzzySystems"]), "a region's fuzzy system is missing")
        self.binding = self.json.get("binding")
        if self.binding:
            self.check_binding()
        if "lattice" in self.json:
            self.check_lattice()
        if "material" in self.json:
            self.check_material()
        if "pressures" in self.json:
            self.check_pressures()
        self.check_drawn()

    def check_lattice(self):
        group = self.json["lattice"]
        check(group["kind"] in ("cubic", "body-centred", "graded", "diamond", "bare-diamond", "prisms"), "an unknown kind of lattice")
        if group["kind"] == "prisms":
            check(group["wallThickness"] > 0 and 1 <= group["layers"] <= 8, "a wall without thickness or layers")
        else:
            check(group["spacing"] > 0, "a lattice without spacing")
        tetrahedra = threes(self.array(group, "tetrahedra", group["tetrahedronCount"], 4), 4)
        surface = threes(self.array(group, "triangles", group["triangleCount"], 3))
        shares = self.array(group, "springShares", self.spring_count)
        check(all(share > 0 for share in shares), "a spring without a share")
        check(all(node < self.node_count for nodes in tetrahedra + surface for node in nodes),
              "a lattice's node is out of range")
        outer = set()
        for a, b, c, d in tetrahedra:
            for face in ((a, c, b), (a, b, d), (a, d, c), (b, c, d)):
                outer ^= {tuple(sorted(face))}
        check(outer == {tuple(sorted(face)) for face in surface}, "the lattice's surface is not that of its tetrahedra")

        if "kind" in self.springs:
            edges = {frozenset(edge) for face in surface for edge in zip(face, face[1:] + face[:1])}
            kinds = [int(frozenset(ends) not in edges) for ends in threes(self.ends, 2)]
            check(self.array(self.springs, "kind", self.spring_count) == kinds, "springs of another kind")

    def check_material(self):
        """A modulus of the wall that the springs' constant means; densities that weigh what the nodes weigh."""
        group, base = self.json["material"], self.json["base"]
        modulus, density = (self.array(group, key, self.node_count) for key in ("youngsModulus", "density"))
        check(0 <= group["poissonsRatio"] <= 0.5, "no Poisson's ratio")
        thickness = base.get("wallThickness", 0.003)
        for constant, value in zip(self.node_c, modulus):
            check(abs(value - 2 / 3**0.5 * constant / thickness) <= 1e-6 * value, "another modulus than the springs'")
        if "lattice" in self.json:
            volumes, rest = [0] * self.node_count, threes(self.rest)
            for nodes in threes(self.array(self.json["lattice"], "tetrahedra", self.json["lattice"]["tetrahedronCount"], 4), 4):
                a, b, c, d = (rest[node] for node in nodes)
                volume = sum(x * y for x, y in zip(cross(minus(b, a), minus(c, a)), minus(d, a))) / 6
                for node in nodes:
                    volumes[node] += volume / 4
            weight = sum(volume * value for volume, value in zip(volumes, density))
            check(abs(weight - sum(self.mass)) <= 1e-4 * weight, "the densities weigh %g kg" % weight)
        check(all(value > 0 for value in density), "no density")

    def check_pressures(self):
        for pressure in self.json["pressures"]:
            times = [time for time, _ in pressure["path"]]
            check(pressure["part"] >= 0 and times and times == sorted(set(times)), "a pressure without a path in time")

    def check_binding(self):
        group, count = self.binding, self.json["surface"]["vertexCount"]
        starts = self.array(group, "starts", count + 1) if "starts" in group else range(0, 3 * count + 1, 3)
        nodes, shares = self.array(group, "nodes", starts[-1]), self.array(group, "shares", starts[-1])
        check(starts[0] == 0 and all(a < b for a, b in zip(starts, starts[1:])), "the rows' starts do not rise from 0")
        triangles = self.array(group, "triangles", group["triangleCount"], 3)
        lines = self.array(group, "lines", group["lineCount"], 2)
        check(all(node < self.node_count for node in nodes + triangles + lines), "a carrying node is out of range")
        least, most = (-4, 4) if "lattice" in self.json else (0, 1)
        check(all(least <= share <= most for share in shares), "a share is not of %d to %d" % (least, most))
        check(all(first != second for first, second in threes(lines, 2)), "a line has one end")
        self.starts = list(starts) if "starts" in group else None
        self.carriers, self.shares = ([values[a:b] for a, b in zip(starts, starts[1:])] for values in (nodes, shares))
        self.simulated, self.lines = threes(triangles), threes(lines, 2)
        for vertex, (row, parts) in enumerate(zip(self.carriers, self.shares)):
            check(abs(sum(parts) - 1) <= 1e-6, "the shares in vertex %d are not one" % vertex)
            most = [node for node, share in zip(row, parts) if share > max(parts) - 1e-6]
            check(self.vertex_nodes[vertex] in most, "vertex %d has another main node" % vertex)
        self.check_carried()

    def check_carried(self):
        """At rest every vertex is where it is drawn; a rigid motion of the nodes takes the vertices along."""
        size = max(max(abs(number) for number in self.rest + self.vertices), 1e-30)

        def turned(places):
            return [number for x, y, z in threes(places)
                    for number in (0.6 * x - 0.8 * z + size, y - 2 * size, 0.8 * x + 0.6 * z)]

        motions = [(self.rest, self.vertices)]
        if not self.lines:  # a line's turn about itself is nothing that its nodes tell
            motions.append((turned(self.rest), turned(self.vertices)))
        for now, there in motions:
            found = esm_package.carried(self.readable, now)
            off = max(math.dist(x, y) for x, y in zip(threes(found), threes(there)))
            check(off <= 1e-5 * size, "vertices are carried %g m away" % off)

    def check_drawn(self):
        shown = []
        for part in self.json["drawn"]:
            primitive = self.gltf.json["meshes"][part["mesh"]]["primitives"][part["primitive"]]
            positions = self.gltf.array(primitive["attributes"]["POSITION"])
            nodes = self.gltf.array(part["vertexNodes"])
            check(3 * len(nodes) == len(positions), "a drawn vertex has no node")
            check(all(node < self.node_count for node in nodes), "a drawn vertex's node is out of range")
            vertices = self.gltf.array(part["vertices"]) if self.binding else None
            self.check_attributes(primitive["attributes"], nodes)
            check(not self.binding or len(vertices) == len(nodes), "a drawn vertex is no vertex of the surface")
            if "triangles" not in part:
                continue
            triangles, indices = self.gltf.array(part["triangles"]), self.gltf.array(primitive["indices"])
            shown += triangles
            self.check_sharing(primitive["attributes"], len(positions) // 3, len(triangles))
            check(len(indices) == 3 * len(triangles), "a drawn triangle belongs to no triangle of the surface")
            for i, drawn in enumerate(indices):
                vertex = self.triangles[3 * triangles[i // 3] + i % 3]
                check(positions[3 * drawn:3 * drawn + 3] == self.vertices[3 * vertex:3 * vertex + 3],
                      "corner %d is drawn elsewhere" % i)
                check(nodes[drawn] == self.vertex_nodes[vertex], "corner %d follows another node" % i)
                check(not self.binding or vertices[drawn] == vertex, "corner %d is another vertex" % i)
        check(sorted(shown) == list(range(len(self.triangles) // 3)), "not every triangle is drawn once")

    def check_attributes(self, attributes, nodes):
        """Tissue of each drawn vertex, as programs have it that know glTF alone."""
        if "_ESM_MASS" not in attributes:
            return
        held = set(self.fixed)
        fixed = [float(node in held) for node in range(self.node_count)]
        numbers = nodes
        if "_ESM_VERTEX" in attributes:
            numbers = [int(number) for number in self.gltf.array(attributes["_ESM_VERTEX"])]
            places, positions = self.vertices, self.gltf.array(attributes["POSITION"])
            check(threes(positions) == [places[3 * n:3 * n + 3] for n in numbers], "_ESM_VERTEX is another vertex")
        else:
            check(not self.triangles, "the surface's vertices have no _ESM_VERTEX")
        for name, of_nodes in (("_ESM_MASS", self.mass), ("_ESM_SPRING_CONSTANT", self.node_c),
                               ("_ESM_VISCOSITY", self.node_d), ("_ESM_FIXED", fixed)):
            for number, node, value in zip(numbers, nodes, self.gltf.array(attributes[name])):
                row, shares = (self.carriers[number], self.shares[number]) if self.binding else ([node], [1])
                ours = [of_nodes[n] for n, share in zip(row, shares) if share]
                mean = min(max(sum(share * of_nodes[n] for n, share in zip(row, shares)), min(ours)), max(ours))
                if not check(abs(value - mean) <= 2e-6 * max(map(abs, ours)), "%s of vertex %d" % (name, number)):
                    break

    def check_sharing(self, attributes, vertices, triangles):
        """Places of their own for all corners, or one vertex for all corners that are alike."""
        if "TEXCOORD_0" not in attributes:
            return
        places, positions = self.gltf.array(attributes["TEXCOORD_0"]), self.gltf.array(attributes["POSITION"])
        tangents = self.gltf.array(attributes["TANGENT"]) if "TANGENT" in attributes else [1] * 4 * vertices
        alike = {(*positions[3 * i:3 * i + 3], *places[2 * i:2 * i + 2], tangents[4 * i + 3]) for i in range(vertices)}
        if self.is_stretched:
            check(len(alike) == vertices, "a drawn vertex is there twice")
        else:
            check(vertices == 3 * triangles, "a triangle shares vertices")

    def counts(self):
        return {"nodes": self.node_count, "springs": self.spring_count, "triangles": len(self.triangles) // 3,
                "tethers": len(self.tethers[0]), "fixed": len(self.fixed), "regions": len(self.json["regions"]),
                "textures": len(self.gltf.json.get("textures", [])), "mass": sum(self.mass)}


def project_array(archive, manifest, entry):
    content = archive.read(entry)
    form = {"f64": "d", "u32": "I"}[entry.rsplit(".", 1)[1]]
    return list(struct.unpack("<%d%s" % (manifest["arrays"][entry], form), content))


def compare(name, package, project):
    check(package == project, "%s is not the project's" % name)


def compare_project(package, file):
    with zipfile.ZipFile(file) as archive:
        manifest = json.loads(archive.read("manifest.json").decode("utf-8"))
        arrays = {entry: project_array(archive, manifest, entry) for entry in manifest["arrays"]}
    for name, values, entry in (("rest positions of nodes", package.rest, "network/nodes.f64"),
                                ("rest lengths", package.lengths, "network/rest-lengths.f64"),
                                ("rest positions of vertices", package.vertices, "mesh/vertices.f64")):
        compare(name, values, float32(arrays[entry]))
    if package.binding:
        compare("starts of carrying nodes", package.starts, arrays.get("binding/starts.u32"))
        compare("carrying nodes", [n for row in package.carriers for n in row], arrays["binding/nodes.u32"])
        compare("shares", [n for row in package.shares for n in row], float32(arrays["binding/shares.f64"]))
        compare("simulated surface", [n for three in package.simulated for n in three], arrays["binding/surface.u32"])
        compare("lines", [n for two in package.lines for n in two], arrays["binding/lines.u32"])
    for name, values, entry in (("springs", package.ends, "network/springs.u32"),
                                ("node of vertex", package.vertex_nodes, "network/vertex-nodes.u32"),
                                ("triangles", package.triangles, "mesh/triangles.u32")):
        compare(name, values, arrays[entry])
    for key in ("name", "base", "regions", "fuzzySystems"):
        compare(key, package.json[key], manifest[key])


def compare_tissue(package, file):
    with open(file, encoding="utf-8") as stream:
        tissue = json.load(stream)
    compare("mass", package.mass, float32(tissue["mass"]))
    compare("spring constant", package.node_c, float32(tissue["spring_constant"]))
    compare("viscosity", package.node_d, float32(tissue["viscosity"]))
    compare("stiffening", package.stiffening, tissue["stiffening"])
    compare("tethered nodes", package.tethers[0], [tether[0] for tether in tissue["tethers"]])
    compare("spring constant of tethers", package.tethers[1], float32([tether[1] for tether in tissue["tethers"]]))
    compare("viscosity of tethers", package.tethers[2], float32([tether[2] for tether in tissue["tethers"]]))
    compare("fixed nodes", package.fixed, tissue["fixed"])


def carry(package, file):
    """The surface's vertices for every frame of a trajectory, one after the other."""
    with open(file, encoding="utf-8") as stream:
        numbers = [float(row[key]) for row in csv.DictReader(stream) for key in "xyz"]
    frames = threes(numbers, len(package.rest))
    return [place for frame in frames for place in threes(esm_package.carried(package.readable, frame))]


def readable(file):
    """The package as the reader of the examples has it, which must take what we write."""
    try:
        return esm_package.read_package(file)
    except esm_package.PackageError as problem:
        sys.exit("the reader of the examples refuses it: %s" % problem)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("package")
    parser.add_argument("--project")
    parser.add_argument("--tissue")
    parser.add_argument("--carry")
    arguments = parser.parse_args()
    with open(arguments.package, "rb") as stream:
        gltf = Gltf(stream.read())
    check_gltf(gltf)
    check_checksums(gltf)
    check_provenance(gltf.json)
    package = Package(gltf, readable(arguments.package))
    package.check()
    if arguments.project:
        compare_project(package, arguments.project)
    if arguments.tissue:
        compare_tissue(package, arguments.tissue)
    for problem in problems[:50]:
        print(problem, file=sys.stderr)
    if arguments.carry:
        print(json.dumps(carry(package, arguments.carry)))
    elif not problems:
        print(json.dumps(package.counts()))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
