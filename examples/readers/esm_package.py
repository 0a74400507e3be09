#!/usr/bin/env python3
"""Reads a model package of the Elastodynamic Shape Modeler, and moves it: by docs/model-package.md alone.

    esm_package.py ORGAN.glb        says what it holds, as JSON, or in one line what is wrong with it

One file to copy, for Python 3.8 or later, with the standard library alone. What is read has the names of the specification:

    package = read_package("liver.glb")
    package.springs["restLength"]                    array of float, m
    shaped(package.nodes["restPosition"], 3)         the same with a row for each node, where NumPy is installed
    motion = Motion(package)
    motion.step(1e-4, forces={12: (0, 0, -1)})       s, and N by node
    motion.positions                                 x, y, z of every node, m
    carried(package, motion.positions)               x, y, z of every drawn vertex, m
"""
import json
import math
import struct
import sys
import zlib
from array import array
from dataclasses import dataclass, field

EXTENSION, NEWEST = "ESM_spring_mass", 9
FLOAT, UNSIGNED = 5126, 5125
SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
LARGEST = 1e30

# What a group holds: key, what it is counted by, numbers for each of these, type of the accessor, and what a number may be.
# Counts with a dot are another group's.
ARRAYS = {
    "nodes": (("restPosition", "count", 3, "VEC3", "number"), ("mass", "count", 1, "SCALAR", "mass"),
              ("springConstant", "count", 1, "SCALAR", "amount"), ("viscosity", "count", 1, "SCALAR", "amount")),
    "springs": (("nodes", "count", 2, "SCALAR", "node"), ("restLength", "count", 1, "SCALAR", "amount"),
                ("springConstant", "count", 1, "SCALAR", "amount"), ("viscosity", "count", 1, "SCALAR", "amount")),
    "tethers": (("nodes", "count", 1, "SCALAR", "node"), ("springConstant", "count", 1, "SCALAR", "amount"),
                ("viscosity", "count", 1, "SCALAR", "amount")),
    "fixedNodes": (("nodes", "count", 1, "SCALAR", "node"),),
    "surface": (("restPosition", "vertexCount", 3, "VEC3", "number"), ("vertexNodes", "vertexCount", 1, "SCALAR", "node"),
                ("triangles", "triangleCount", 3, "SCALAR", "vertex")),
    "hinges": (("nodes", "count", 4, "SCALAR", "node"), ("stiffness", "count", 1, "SCALAR", "amount"),
               ("viscosity", "count", 1, "SCALAR", "amount")),
    "binding": (("triangles", "triangleCount", 3, "SCALAR", "node"), ("lines", "lineCount", 2, "SCALAR", "node")),
    "sheet": (("springShares", "springs.count", 1, "SCALAR", "positive"), ("nodeShares", "nodes.count", 1, "SCALAR", "positive")),
    "lattice": (("tetrahedra", "tetrahedronCount", 4, "SCALAR", "node"), ("springShares", "springs.count", 1, "SCALAR", "positive"),
                ("triangles", "triangleCount", 3, "SCALAR", "node")),
}
ATTRIBUTES = {"POSITION": "VEC3", "NORMAL": "VEC3", "TEXCOORD_0": "VEC2", "TANGENT": "VEC4"}
ALWAYS = ("nodes", "springs", "tethers", "fixedNodes", "surface")
ALLOWED = {"number": (lambda x: abs(x) <= LARGEST, "from -1e30 to 1e30"), "amount": (lambda x: 0 <= x <= LARGEST, "from 0 to 1e30"),
           "positive": (lambda x: 0 < x <= LARGEST, "above 0, up to 1e30"),
           "mass": (lambda x: 1 / LARGEST <= x <= LARGEST, "from 1e-30 to 1e30")}
AGAIN = "export the package again"


class PackageError(ValueError):
    """What is wrong with a package and what to do, in one line."""


def need(condition, problem, remedy=AGAIN):
    if not condition:
        raise PackageError("%s; %s" % (problem, remedy))


def shown(value):
    """What a file says, in few words on one line."""
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def refuse_constant(word):
    raise ValueError("%s is no number" % word)


def is_number(value):
    """Of JSON; neither infinite nor none."""
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= LARGEST


def is_count(value):
    return is_number(value) and isinstance(value, int) and value >= 0


@dataclass
class Package:
    """Arrays of `array.array`, flat, by the keys of the specification; a group that the package lacks is empty."""
    name: str
    version: int
    nodes: dict
    springs: dict
    tethers: dict
    fixedNodes: dict
    surface: dict
    hinges: dict
    binding: dict
    sheet: dict
    lattice: dict
    drawn: list      # of each primitive: mode, material, its attributes, indices, vertexNodes, vertices, triangles
    pictures: list   # name, mimeType, and bytes as they lie in the file
    json: dict       # the extension, for all that are no arrays
    stiffening: dict = field(default=None)  # strain and factor; None where springs are linear
    fillings: list = field(default_factory=list)
    pressures: list = field(default_factory=list)


class Container:
    """The two chunks of a binary glTF file, and what its accessors hold."""

    def __init__(self, content):
        need(len(content) >= 20 and content[:4] == b"glTF", "is no binary glTF file (.glb)", "choose a package")
        version, length = struct.unpack_from("<II", content, 4)
        need(version == 2, "is glTF of version %d, not 2" % version)
        need(length == len(content), "is cut off or damaged: its header speaks of %d bytes, but it has %d" % (length, len(content)))
        chunks, place = [], 12
        while place + 8 <= length:
            size, kind = struct.unpack_from("<II", content, place)
            need(place + 8 + size <= length, "is damaged: its part at byte %d reaches beyond its end" % place)
            chunks.append((kind, content[place + 8:place + 8 + size]))
            place += 8 + size
        need(chunks and chunks[0][0] == 0x4E4F534A, "is damaged: its first part is not JSON")
        self.text, self.binary = chunks[0][1], next((body for kind, body in chunks[1:] if kind == 0x004E4942), b"")
        try:
            self.json = json.loads(chunks[0][1].decode("utf-8"), parse_constant=refuse_constant)
        except (ValueError, RecursionError) as reason:
            raise PackageError("holds no JSON that can be read: %s; %s" % (reason, AGAIN)) from None
        need(isinstance(self.json, dict), "its JSON is no object")

    def element(self, kind, place):
        elements = self.json.get(kind)
        need(isinstance(elements, list) and is_count(place) and place < len(elements) and isinstance(elements[place], dict),
             "has nothing at %s/%s" % (kind, shown(place)))
        return elements[place]

    def view(self, place):
        view = self.element("bufferViews", place)
        offset, size = view.get("byteOffset", 0), view.get("byteLength")
        need(is_count(offset) and is_count(size) and offset + size <= len(self.binary) and view.get("buffer") == 0,
             "is damaged: bufferViews/%d reaches beyond the file's binary data" % place)
        need("byteStride" not in view, "bufferViews/%d should have no byteStride" % place)
        return offset, size

    def bytes(self, place):
        offset, size = self.view(place)
        return self.binary[offset:offset + size]

    def check_sums(self, place):
        """That no bit has flipped, by the accessor with the check sums of all views; in its own view's place, the last, that of the JSON."""
        views = self.json.get("bufferViews")
        need(isinstance(views, list) and views, "has no bufferViews")
        summed = sum(self.view(view)[1] for view in range(len(views)))
        need(summed <= len(self.binary), "bufferViews overlap, which check sums do not allow")
        *sums, of_json = self.indices(place, len(views))
        need(zlib.crc32(self.text) == of_json, "is damaged: its JSON does not have the check sum that it should")
        for view, wanted in enumerate(sums):
            need(zlib.crc32(self.bytes(view)) == wanted, "is damaged: bufferViews/%d does not have the check sum that it should" % view)

    def indices(self, place, count=None):
        values = self.numbers(place, "SCALAR", count)
        need(values.typecode == "I", "accessors/%s should be of unsigned int" % place)
        return values

    def numbers(self, place, type, count=None):
        """Of an accessor, flat. `count`: elements that there should be; any without."""
        accessor, name = self.element("accessors", place), "accessors/%s" % place
        found, kind, offset = accessor.get("count"), accessor.get("componentType"), accessor.get("byteOffset", 0)
        need(accessor.get("type") == type, "%s should be of type %s" % (name, type))
        need(kind in (FLOAT, UNSIGNED) and not accessor.get("normalized") and "sparse" not in accessor,
             "%s is neither of float nor of unsigned int" % name)
        need(is_count(found) and found == (found if count is None else count),
             "%s should have %s elements, but has %s" % (name, "some" if count is None else count, shown(found)))
        start, size = self.view(accessor.get("bufferView"))
        length = 4 * found * SIZES[type]
        need(is_count(offset) and offset % 4 == 0 and offset + length <= size, "%s reaches beyond its bufferView" % name)
        values = array("f" if kind == FLOAT else "I", self.binary[start + offset:start + offset + length])
        if sys.byteorder == "big":
            values.byteswap()
        return array("d", values) if kind == FLOAT else values


class Reader:
    """Goes through the extension; every number is checked before another part counts on it."""

    def __init__(self, container):
        self.container = container
        extensions = container.json.get("extensions")
        self.json = extensions.get(EXTENSION) if isinstance(extensions, dict) else None
        need(isinstance(self.json, dict), "is glTF, but no model package: it has no " + EXTENSION,
             "export the organ as a model package")
        self.version = self.json.get("version")
        need(is_count(self.version) and self.version >= 1, "says no version of its model")
        need(self.version <= NEWEST, "is of version %s, newer than this reader, which knows up to %d" % (shown(self.version), NEWEST),
             "take a newer reader")
        need(self.json.get("damping") == "isotropic", "damps in a way that this reader does not know", "take a newer reader")
        if "checksums" in self.json:
            container.check_sums(self.json["checksums"])

    def count(self, name):
        group, _, key = name.rpartition(".")
        holder = self.json.get(group)
        found = holder.get(key) if isinstance(holder, dict) else None
        need(is_count(found), "has no count at %s" % name)
        return found

    def array(self, group, row):
        key, counted, each, type, allowed = row
        holder = self.json[group]
        need(isinstance(holder, dict), "has no object at %s" % group)
        count = self.count(counted if "." in counted else "%s.%s" % (group, counted))
        if count == 0:
            return array("d" if allowed in ALLOWED else "I")
        values = self.container.numbers(holder.get(key), type, count * each // SIZES[type])
        self.check(values, allowed, "%s.%s" % (group, key))
        return values

    def check(self, values, allowed, name):
        limit = {"node": "nodes.count", "vertex": "surface.vertexCount", "triangle": "surface.triangleCount"}.get(allowed)
        need((values.typecode == "I") == (limit is not None), "%s should be of %s" % (name, "unsigned int" if limit else "float"))
        if limit:
            largest, count = max(values, default=-1), self.count(limit)
            need(largest < count, "%s names %s %d, but there are %d, counted from 0" % (name, allowed, largest, count))
            return
        is_allowed, range_of_it = ALLOWED[allowed]
        bad = next((place for place in enumerate(values) if not is_allowed(place[1])), None)
        need(not bad, bad and "%s: number %d is %g, but must be %s" % (name, *bad, range_of_it))

    def group(self, name):
        if name not in self.json:
            need(name not in ALWAYS, "has no " + name)
            return {}
        return {row[0]: self.array(name, row) for row in ARRAYS[name]}

    def binding(self):
        arrays, vertices = self.group("binding"), self.count("surface.vertexCount")
        if not arrays:
            return arrays
        json, numbers = self.json["binding"], self.container.numbers
        starts = self.container.indices(json["starts"], vertices + 1) if "starts" in json else array("I", range(0, 3 * vertices + 1, 3))
        need(starts[0] == 0 and all(a < b for a, b in zip(starts, starts[1:])), "binding.starts do not rise from 0")
        nodes = numbers(json.get("nodes"), "SCALAR", starts[-1])
        shares = numbers(json.get("shares"), *(("SCALAR", starts[-1]) if "starts" in json else ("VEC3", vertices)))
        self.check(nodes, "node", "binding.nodes")
        self.check(shares, "number", "binding.shares")
        for vertex, (begin, end) in enumerate(zip(starts, starts[1:])):
            row = shares[begin:end]
            need(abs(sum(row) - 1) <= 1e-6 and all(-4 <= share <= 4 for share in row),
                 "binding.shares: those in vertex %d should be from -4 to 4 and make 1" % vertex)
        return {**arrays, "starts": starts, "nodes": nodes, "shares": shares}

    def drawn(self):
        entries = self.json.get("drawn")
        need(isinstance(entries, list) and all(isinstance(entry, dict) for entry in entries), "has no list of objects at drawn")
        return [self.primitive(entry) for entry in entries]

    def attribute(self, place, key):
        values = self.container.numbers(place, ATTRIBUTES[key])
        self.check(values, "number", "drawn." + key)
        return values

    def primitive(self, entry):
        primitives = self.container.element("meshes", entry.get("mesh")).get("primitives")
        place, indices = entry.get("primitive"), self.container.indices
        need(isinstance(primitives, list) and is_count(place) and place < len(primitives),
             "drawn names primitive %s, which is not there" % shown(place))
        primitive, name = primitives[place], "primitive %d of drawn" % place
        attributes = primitive.get("attributes") if isinstance(primitive, dict) else None
        need(isinstance(attributes, dict) and "POSITION" in attributes, name + " has no POSITION")
        part = {key: self.attribute(attributes[key], key) for key in ATTRIBUTES if key in attributes}
        count = len(part["POSITION"]) // 3
        need("vertexNodes" in entry, "has no drawn.vertexNodes")
        for key, allowed in (("vertexNodes", "node"), ("vertices", "vertex")):
            if key in entry:
                part[key] = indices(entry[key], count)
                self.check(part[key], allowed, "drawn." + key)
        if "indices" in primitive:
            part["indices"] = indices(primitive["indices"])
            largest = max(part["indices"], default=-1)
            need(largest < count, "%s has index %d, but %d vertices, counted from 0" % (name, largest, count))
        if "triangles" in entry:
            part["triangles"] = indices(entry["triangles"])
            self.check(part["triangles"], "triangle", "drawn.triangles")
            need(len(part.get("indices", ())) == 3 * len(part["triangles"]), "drawn.triangles are not as many as %s draws" % name)
        return {**part, "mode": primitive.get("mode", 4), "material": primitive.get("material")}

    def pictures(self):
        images = self.container.json.get("images", [])
        need(isinstance(images, list) and all(isinstance(image, dict) for image in images), "has no list of objects at images")
        return [{"name": image.get("name", ""), "mimeType": image.get("mimeType"), "bytes": self.container.bytes(image.get("bufferView"))}
                for image in images]

    def law(self):
        law = self.json.get("stiffening")
        if law is not None:
            good = isinstance(law, dict) and all(is_number(law.get(key)) and law[key] > 0 for key in ("strain", "factor"))
            need(good, "stiffening should have a strain and a factor above 0, up to 1e30")
        return law

    def fillings(self):
        fillings = self.of_parts("fillings")
        for place, filling in enumerate(fillings):
            need(is_number(filling.get("stiffness")) and filling["stiffness"] > 0, "fillings: stiffness %d should be above 0, up to 1e30 Pa" % place)
        return fillings

    def pressures(self):
        pressures = self.of_parts("pressures")
        for path in (pressure.get("path") for pressure in pressures):
            good = isinstance(path, list) and path and all(isinstance(row, list) and len(row) == 2 and all(map(is_number, row)) for row in path)
            need(good and all(a[0] < b[0] for a, b in zip(path, path[1:])), "pressures: a path should be a list of [s, Pa], the times rising")
        return pressures

    def of_parts(self, name):
        """A list of objects that name a part each, and no part twice."""
        found = self.json.get(name, [])
        need(isinstance(found, list) and all(isinstance(of_part, dict) and is_count(of_part.get("part")) for of_part in found),
             "has no list of parts at %s" % name)
        need(len({of_part["part"] for of_part in found}) == len(found), "%s name a part twice" % name)
        return found


def read_package(path):
    """@raises PackageError: damaged, no model package, of a newer version; OSError: no such file"""
    with open(path, "rb") as stream:
        reader = Reader(Container(stream.read()))
    need(isinstance(reader.json.get("name"), str), "has no name")
    groups = {name: reader.group(name) for name in ARRAYS if name != "binding"}
    package = Package(reader.json["name"], reader.version, binding=reader.binding(), drawn=reader.drawn(), pictures=reader.pictures(),
                      json=reader.json, stiffening=reader.law(), fillings=reader.fillings(), pressures=reader.pressures(),
                      **groups)
    check_model(package)
    return package


def rows(values, size):
    return zip(*[iter(values)] * size)


def shaped(values, size):
    """A NumPy array with rows of `size`, which shares the numbers with `values`."""
    import numpy
    return numpy.frombuffer(values, dtype=values.typecode).reshape(-1, size)


def check_model(package):
    """What arrays must be to each other."""
    need(package.nodes["mass"], "has no nodes")
    for group, key, size in (("springs", "nodes", 2), ("hinges", "nodes", 4), ("binding", "lines", 2), ("lattice", "tetrahedra", 4)):
        for place, ends in enumerate(rows(getattr(package, group).get(key, ()), size)):
            need(len(set(ends)) == size, "%s.%s: the nodes of number %d should differ" % (group, key, place))
    fixed = package.fixedNodes["nodes"]
    need(all(a < b for a, b in zip(fixed, fixed[1:])), "fixedNodes.nodes do not rise")
    if package.version < 6:
        for key in ("springConstant", "viscosity"):
            need(are_means(package, key), "springs.%s is not the mean of its nodes', as version %d has it" % (key, package.version))


def means(package, key):
    at = package.nodes[key]
    return array("d", ((at[a] + at[b]) / 2 for a, b in rows(package.springs["nodes"], 2)))


def are_means(package, key):
    at, ends = package.nodes[key], rows(package.springs["nodes"], 2)
    return all(abs(value - (at[a] + at[b]) / 2) <= 1e-6 * max(at[a], at[b]) for value, (a, b) in zip(package.springs[key], ends))


def spring_values(package):
    """Spring constants and viscosities. Where all are the mean of their nodes', that mean, not rounded as the file has it."""
    keys = ("springConstant", "viscosity")
    is_rounded = all(are_means(package, key) for key in keys)
    return [means(package, key) if is_rounded else package.springs[key] for key in keys]


def simulated_triangles(package):
    """Three nodes each: what instruments touch, and fluid fills."""
    if package.lattice:
        return list(rows(package.lattice["triangles"], 3))
    if package.binding:
        return list(rows(package.binding["triangles"], 3))
    nodes = package.surface["vertexNodes"]
    triangles = (tuple(nodes[corner] for corner in corners) for corners in rows(package.surface["triangles"], 3))
    return [triangle for triangle in triangles if len(set(triangle)) == 3]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(number, a):
    return (number * a[0], number * a[1], number * a[2])


def combined(weights, vectors):
    return tuple(sum(weight * vector[axis] for weight, vector in zip(weights, vectors)) for axis in range(3))


def at(values, place):
    return tuple(values[3 * place:3 * place + 3])


def parts_of(triangles):
    """The connected parts, by their first triangles."""
    leader = {}

    def first(node):
        while leader.setdefault(node, node) != node:
            leader[node] = node = leader[leader[node]]
        return node

    for a, b, c in triangles:
        leader[first(b)] = first(a)
        leader[first(c)] = first(a)
    parts = {}
    for triangle in triangles:
        parts.setdefault(first(triangle[0]), []).append(triangle)
    return list(parts.values())


def pressure_at(path, time):
    """Pa: even between the rows of a path, before and after them as at its ends."""
    for (begin, first), (end, last) in zip(path, path[1:]):
        if time < end:
            return first + max(time - begin, 0) / (end - begin) * (last - first)
    return path[-1][1]


def wall_of(parts, place, rest):
    """The triangles of a closed part, facing outwards, and what it encloses at rest, m³."""
    need(place < len(parts), "fills part %d of %d, counted from 0" % (place, len(parts)))
    turns_at = {}
    for a, b, c in parts[place]:
        for first, second in ((a, b), (b, c), (c, a)):
            edge = min(first, second), max(first, second)
            turns_at[edge] = turns_at.get(edge, 0) + (1 if first < second else -1)
    need(not any(turns_at.values()), "fills part %d, which is open" % place)
    enclosed = volume(parts[place], rest)
    need(enclosed, "fills part %d, which encloses nothing" % place)
    return parts[place] if enclosed > 0 else [(a, c, b) for a, b, c in parts[place]], abs(enclosed)


def volume(triangles, positions):
    """m³. Measured from a corner, which keeps numbers small far from the origin."""
    origin = at(positions, triangles[0][0])
    corners = ([minus(at(positions, node), origin) for node in triangle] for triangle in triangles)
    return sum(dot(a, cross(b, c)) for a, b, c in corners) / 6


class Hinge:
    """Two triangles that resist being bent about their edge."""

    def __init__(self, nodes, stiffness, viscosity, rest):
        p = [at(rest, node) for node in nodes]
        u, v, r = minus(p[1], p[0]), minus(p[3], p[2]), minus(p[2], p[0])
        n = cross(u, v)
        need(dot(n, n) > 0 and dot(u, u) > 0, "a hinge has a triangle without area")
        along, across = dot(cross(r, v), n) / dot(n, n), dot(cross(r, u), n) / dot(n, n)
        self.nodes, self.weights, self.curvature = nodes, (along - 1, -along, 1 - across, across), dot(r, n) / dot(n, n)
        t = cross(scaled(1 / math.sqrt(dot(u, u)), u), r)
        opening = combined((self.weights[2], self.curvature), (t, cross(u, t)))
        need(dot(opening, opening) > 0, "a hinge has a triangle without area")
        self.constant, self.damping = stiffness / dot(opening, opening), viscosity / dot(opening, opening)

    def forces(self, positions):
        p = [at(positions, node) for node in self.nodes]
        u, v = minus(p[1], p[0]), minus(p[3], p[2])
        strain = minus(combined(self.weights[1:], [minus(q, p[0]) for q in p[1:]]), scaled(self.curvature, cross(u, v)))
        f = scaled(-self.constant, strain)
        g, h = scaled(-self.curvature, cross(v, f)), scaled(-self.curvature, cross(f, u))
        w = self.weights
        others = [combined((w[1], 1), (f, g)), combined((w[2], -1), (f, h)), combined((w[3], 1), (f, h))]
        return [combined((-1, -1, -1), others)] + others


class Motion:
    """A package that moves, from rest. `integrator`: "euler", semi-implicit, for light tissue and short steps; "split", which takes
    viscosity implicitly, for overdamped tissue and not for parts that fluid fills. Pressures of the package begin at time 0."""

    def __init__(self, package, integrator="euler"):
        need(integrator in ("euler", "split"), "this reader has no integrator %s" % shown(integrator), "take euler or split")
        need(integrator == "euler" or not package.fillings, "this reader steps parts that are filled with fluid by euler alone", "take euler")
        self.integrator, self.time = integrator, 0.0
        self.rest = package.nodes["restPosition"]
        self.mass, self.fixed = package.nodes["mass"], set(package.fixedNodes["nodes"])
        constants, viscosities = spring_values(package)
        ends = [(3 * a, 3 * b) for a, b in rows(package.springs["nodes"], 2)]
        self.springs = [(a, b, *values) for (a, b), *values in zip(ends, package.springs["restLength"], constants)]
        self.dampers = [(a, b, d) for (a, b), d in zip(ends, viscosities)]
        self.tethers = list(zip(*(package.tethers[key] for key in ("nodes", "springConstant", "viscosity"))))
        hinges = package.hinges or {"nodes": (), "stiffness": (), "viscosity": ()}
        self.hinges = [Hinge(nodes, *values, self.rest) for nodes, *values in
                       zip(rows(hinges["nodes"], 4), hinges["stiffness"], hinges["viscosity"])]
        law = package.stiffening or {"strain": math.inf, "factor": 1}
        self.stretch, self.more = 1 + law["strain"], law["factor"] - 1
        self.fluids = self.fluids_of(package)
        self.reset()

    def reset(self):
        self.positions, self.velocities, self.time = list(self.rest), [0.0] * len(self.rest), 0.0

    def fluids_of(self, package):
        """Of each filling and pressure the wall and what it encloses, m³, the fluid's stiffness, Pa, and a pressure's path."""
        presses = [(filling["part"], filling["stiffness"], [(0, 0)]) for filling in package.fillings]
        presses += [(pressure["part"], 0, pressure["path"]) for pressure in package.pressures]
        parts = parts_of(simulated_triangles(package)) if presses else []
        return [(*wall_of(parts, part, self.rest), stiffness, path) for part, stiffness, path in presses]

    def inner_forces(self, begin, end):
        """N, x, y, z of every node: of springs, tethers, hinges and fluids, with the mean of the pressures at two times, s."""
        p, f = self.positions, [0.0] * len(self.rest)
        for a, b, rest, constant in self.springs:
            x, y, z = p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]
            length = math.sqrt(x * x + y * y + z * z)
            if not length:
                continue
            pull = constant * (rest / length - 1)
            if length > self.stretch * rest:
                pull -= self.more * constant * (1 - self.stretch * rest / length)
            for axis, part in enumerate((pull * x, pull * y, pull * z)):
                f[a + axis] += part
                f[b + axis] -= part
        for node, constant, _ in self.tethers:
            for i in range(3 * node, 3 * node + 3):
                f[i] -= constant * (p[i] - self.rest[i])
        for hinge in self.hinges:
            self.add(f, hinge.nodes, hinge.forces(p))
        for wall, enclosed, stiffness, path in self.fluids:
            pressure = stiffness * (enclosed - volume(wall, p)) / enclosed + (pressure_at(path, begin) + pressure_at(path, end)) / 2
            for nodes in wall:
                a, b, c = (at(p, node) for node in nodes)
                self.add(f, nodes, [scaled(pressure / 6, cross(minus(b, a), minus(c, a)))] * 3)
        return f

    @staticmethod
    def add(forces, nodes, parts):
        for node, part in zip(nodes, parts):
            for axis in range(3):
                forces[3 * node + axis] += part[axis]

    def resistance(self, v):
        """N against the velocities, m/s: the constant matrix of all viscosities times them."""
        f = [0.0] * len(v)
        for a, b, viscosity in self.dampers:
            for axis in range(3):
                part = viscosity * (v[a + axis] - v[b + axis])
                f[a + axis] += part
                f[b + axis] -= part
        for node, _, viscosity in self.tethers:
            for i in range(3 * node, 3 * node + 3):
                f[i] += viscosity * v[i]
        for hinge in self.hinges:
            speed = scaled(hinge.damping, combined(hinge.weights, [at(v, node) for node in hinge.nodes]))
            self.add(f, hinge.nodes, [scaled(weight, speed) for weight in hinge.weights])
        return f

    def step(self, h, forces={}, led={}, gravity=(0, 0, 0)):
        """Moves on by `h` s. `forces`: N by node. `led`: by node, the place at the step's end, m; fixed nodes stay. `gravity`: m/s²."""
        p, v = self.positions, self.velocities
        led = {node: place for node, place in led.items() if node not in self.fixed}
        for node, place in led.items():
            for axis in range(3):
                v[3 * node + axis] = (place[axis] - p[3 * node + axis]) / h
        f = self.inner_forces(self.time if self.integrator == "euler" else self.time + h, self.time + h)
        self.add(f, forces.keys(), list(forces.values()))
        given = {3 * node + axis for node in self.fixed | set(led) for axis in range(3)}
        masses = [mass for mass in self.mass for _ in range(3)]
        pull = [f[i] + masses[i] * gravity[i % 3] for i in range(len(v))]
        if self.integrator == "euler":
            damping = self.resistance(v)
            for i in range(len(v)):
                if i not in given:
                    v[i] += h * (pull[i] - damping[i]) / masses[i]
        else:
            self.solve(h, masses, [masses[i] * v[i] + h * pull[i] for i in range(len(v))], given)
        self.positions = [place + h * speed for place, speed in zip(p, self.velocities)]
        for node, place in led.items():
            self.positions[3 * node:3 * node + 3] = place
        self.time += h

    def solve(self, h, masses, right, given):
        """Velocities by (M + h·D)·v = `right`, those that are given left as they are: conjugate gradients, from the last velocities."""
        def times(x):
            return [m * a + h * b for m, a, b in zip(masses, x, self.resistance(x))]

        def free(x):
            return [0.0 if i in given else a for i, a in enumerate(x)]

        def product(x, y):
            return sum(a * b / m for a, b, m in zip(x, y, masses))

        v = self.velocities
        left = free([b - a for a, b in zip(times(v), right)])
        way, size = [a / m for a, m in zip(left, masses)], product(left, left)
        wanted = 1e-30 * max(size, product(free(right), free(right)))
        for _ in range(10 * len(v)):
            if size <= wanted < math.inf:
                self.velocities = v
                return
            change = free(times(way))
            share = size / sum(a * b for a, b in zip(way, change))
            v = [a + share * b for a, b in zip(v, way)]
            left = [a - share * b for a, b in zip(left, change)]
            before, size = size, product(left, left)
            way = [a / m + size / before * b for a, b, m in zip(left, way, masses)]
        need(False, "a step of split did not converge", "take a shorter step")


def smallest_rotation(first, second):
    """The matrix, by rows, that takes the direction of the one to that of the other."""
    unit = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    lengths = math.sqrt(dot(first, first)), math.sqrt(dot(second, second))
    if not all(lengths):
        return unit
    a, b = scaled(1 / lengths[0], first), scaled(1 / lengths[1], second)
    axis, cosine = cross(a, b), dot(a, b)
    if cosine <= -1 + 1e-12:
        return unit
    skew = ((0, -axis[2], axis[1]), (axis[2], 0, -axis[0]), (-axis[1], axis[0], 0))
    squared = [[sum(skew[i][k] * skew[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return [[unit[i][j] + skew[i][j] + squared[i][j] / (1 + cosine) for j in range(3)] for i in range(3)]


def turns(package, positions):
    """For every node the matrix G of the specification, by rows."""
    rest = package.nodes["restPosition"]
    sums, weights = [[[0.0] * 3 for _ in range(3)] for _ in package.nodes["mass"]], [0.0] * len(package.nodes["mass"])

    def add(nodes, matrix, weight):
        for node in nodes:
            weights[node] += weight
            for i in range(3):
                for j in range(3):
                    sums[node][i][j] += matrix[i][j]

    for nodes in rows(package.binding["triangles"], 3):
        p0, p = [at(rest, node) for node in nodes], [at(positions, node) for node in nodes]
        a0, b0, a, b = minus(p0[1], p0[0]), minus(p0[2], p0[0]), minus(p[1], p[0]), minus(p[2], p[0])
        area, now = math.sqrt(dot(cross(a0, b0), cross(a0, b0))), math.sqrt(dot(cross(a, b), cross(a, b)))
        if area:
            n0, n = scaled(1 / area, cross(a0, b0)), scaled(area / now if now else 0, cross(a, b))
            pairs = ((a, cross(b0, n0)), (b, cross(n0, a0)), (n, n0))
            add(nodes, [[sum(x[i] * y[j] for x, y in pairs) for j in range(3)] for i in range(3)], area)
    for one, other in rows(package.binding["lines"], 2):
        add((one, other), smallest_rotation(minus(at(rest, other), at(rest, one)), minus(at(positions, other), at(positions, one))), 1)
    return [[[x / weight for x in row] for row in matrix] if weight else None for matrix, weight in zip(sums, weights)]


def carried(package, positions):
    """x, y, z of every vertex of the surface, m, where nodes at `positions` carry it."""
    rest, vertices = package.nodes["restPosition"], package.surface["restPosition"]
    if not package.binding:
        nodes = package.surface["vertexNodes"]
        return [vertices[3 * i + k] + positions[3 * node + k] - rest[3 * node + k] for i, node in enumerate(nodes) for k in range(3)]
    starts, matrices, places = package.binding["starts"], turns(package, positions), []
    for vertex, (begin, end) in enumerate(zip(starts, starts[1:])):
        place = x0 = at(vertices, vertex)
        for node, share in zip(package.binding["nodes"][begin:end], package.binding["shares"][begin:end]):
            step, arm = minus(at(positions, node), at(rest, node)), minus(x0, at(rest, node))
            turned = tuple(dot(row, arm) for row in matrices[node]) if matrices[node] else arm
            place = combined((1, share, share, -share), (place, step, turned, arm))
        places += place
    return places


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        package = read_package(sys.argv[1])
    except (PackageError, OSError) as problem:
        print("%s: %s" % (sys.argv[1], problem), file=sys.stderr)
        return 1
    groups = ("nodes", "springs", "tethers", "fixedNodes", "surface", "hinges", "binding", "sheet", "lattice")
    counts = {group: {key: len(values) for key, values in getattr(package, group).items()} for group in groups if getattr(package, group)}
    print(json.dumps({"name": package.name, "version": package.version, **counts, "stiffening": package.stiffening,
                      "fillings": len(package.fillings), "pressures": len(package.pressures), "drawn": len(package.drawn),
                      "pictures": len(package.pictures)}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
