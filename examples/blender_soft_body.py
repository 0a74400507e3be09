"""Makes a soft body in Blender of a model package (.glb) of the Elastodynamic Shape Modeler.

    blender --python blender_soft_body.py -- ORGAN.glb
    blender --background --python blender_soft_body.py -- ORGAN.glb --frames 50 --save ORGAN.blend

Tried with Blender 3.4.1. It reads the package itself, as importers before 3.6 leave out the attributes _ESM_MASS and so
on, and joins what is drawn into one vertex per vertex of the surface, by _ESM_VERTEX.

What becomes of the tissue. Blender counts time in frames: a frame at speed 1 is sqrt(0.001) s, since gravity is 0.001 of
its value there. A point's mass has no effect below 0.01 kg, so all masses and forces are multiplied by one factor; that
changes no motion.
- mass: as it is, by the vertex group "mass".
- spring constant: Blender's edge pulls with iks/length, where iks = pull/(1 - pull) times the fourth power of the mean of
  its ends' weights in the vertex group "springs". Edges get the nearest that weights of vertices can say; the script says
  how near, as the root of the mean square. Edges that are drawn and are no springs get the least of them.
- fixed nodes: pinned, goal 1. Tethers: the goal's spring.

What Blender's soft body cannot carry:
- damping of the whole relative velocity: it damps along edges alone, by one number for all, at most 50. What is damped
  more in the package moves more freely here; the script says by how much.
- rest lengths other than the surface's own, biphasic springs, hinges, fluids and pressures, regions' viscosities.
- the inside: of a filled body the surface alone is soft here, and bends freely.
- fewer nodes under a finer surface: every vertex of the surface is a node here, of the mean of the tissue that carries it.
"""
import argparse
import json
import math
import struct
import sys

import bpy

FRAME = math.sqrt(0.001)  # s, at speed 1
LEAST_MASS, MOST_PULL, MOST_DAMPING = 0.01, 0.999, 50.0
FORMS = {5125: "I", 5126: "f"}  # by glTF's componentType


class Package:
    def __init__(self, path):
        with open(path, "rb") as stream:
            data = stream.read()
        magic, _, _, length = struct.unpack_from("<4sIII", data)
        if magic != b"glTF":
            sys.exit(f"{path}: is no binary glTF file")
        self.gltf = json.loads(data[20:20 + length])
        self.binary = memoryview(data)[28 + length:]
        try:
            self.model = self.gltf["extensions"]["ESM_spring_mass"]
        except KeyError:
            sys.exit(f"{path}: is no model package")
        primitives = [self.gltf["meshes"][part["mesh"]]["primitives"][part["primitive"]] for part in self.model["drawn"]]
        if any("_ESM_VERTEX" not in primitive["attributes"] for primitive in primitives):
            sys.exit(f"{path}: draws no surface, or was exported by an older program; export it again")
        self.join(primitives)

    def array(self, place, components=1):
        accessor = self.gltf["accessors"][place]
        view = self.gltf["bufferViews"][accessor["bufferView"]]
        form = f"<{accessor['count'] * components}{FORMS[accessor['componentType']]}"
        return struct.unpack_from(form, self.binary, view.get("byteOffset", 0) + accessor.get("byteOffset", 0))

    def join(self, primitives):
        """One vertex for each that the primitives draw, and triangles over these."""
        count = self.model["surface"]["vertexCount"]
        self.positions, self.faces = [(0, 0, 0)] * count, []
        self.tissue = {name: [0.0] * count for name in ("MASS", "SPRING_CONSTANT", "FIXED")}
        for primitive in primitives:
            attributes = primitive["attributes"]
            vertices = [int(number) for number in self.array(attributes["_ESM_VERTEX"])]
            places = self.array(attributes["POSITION"], 3)
            for name, values in self.tissue.items():
                for vertex, value in zip(vertices, self.array(attributes["_ESM_" + name])):
                    values[vertex] = value
            for i, vertex in enumerate(vertices):
                x, y, z = places[3 * i:3 * i + 3]
                self.positions[vertex] = (x, -z, y)  # Blender's z points up, glTF's y
            corners = [vertices[index] for index in self.array(primitive["indices"])]
            self.faces += [corners[i:i + 3] for i in range(0, len(corners), 3)]
        # Nodes may be fewer or more than vertices; together these weigh what the organ weighs.
        weight = sum(self.array(self.model["nodes"]["mass"])) / sum(self.tissue["MASS"])
        self.tissue["MASS"] = [weight * mass for mass in self.tissue["MASS"]]

    def edge_constants(self, edges):
        """N/m of edges between vertices: of their springs; where vertices are no nodes, the mean of both ends."""
        of_vertices = self.tissue["SPRING_CONSTANT"]
        if "binding" in self.model:
            return [(of_vertices[a] + of_vertices[b]) / 2 for a, b in edges]
        group, nodes = self.model["springs"], self.array(self.model["surface"]["vertexNodes"])
        ends, constants = self.array(group["nodes"]), self.array(group["springConstant"])
        springs = {frozenset(ends[2 * i:2 * i + 2]): constant for i, constant in enumerate(constants)}
        return [springs.get(frozenset((nodes[a], nodes[b])), 0.0) for a, b in edges]

    def tethers(self, key):
        """Of each vertex; where vertices are no nodes, all tethers shared out by mass."""
        group = self.model["tethers"]
        of_nodes = [0.0] * self.model["nodes"]["count"]
        if group["count"]:
            for node, value in zip(self.array(group["nodes"]), self.array(group[key])):
                of_nodes[node] += value
        if "binding" not in self.model:
            return [of_nodes[node] for node in self.array(self.model["surface"]["vertexNodes"])]
        per_mass = sum(of_nodes) / sum(self.tissue["MASS"])
        return [per_mass * mass for mass in self.tissue["MASS"]]


def weigh(thing, name, weights):
    group = thing.vertex_groups.new(name=name)
    for vertex, weight in enumerate(weights):
        group.add([vertex], weight, "REPLACE")
    return name


def spring_weights(count, edges, stiffness):
    """iks of the stiffest edge, and weights of vertices whose means to the fourth power come near all edges'.

    Least squares of the fourth roots, by steps half the way to what a vertex' edges ask for while its neighbours stay.
    """
    most = max(stiffness) or 1.0
    roots = [(value / most) ** 0.25 for value in stiffness]
    weights, degrees = [0.5] * count, [0] * count
    for edge in edges:
        for vertex in edge:
            degrees[vertex] += 1
    for _ in range(60):
        asked = [0.0] * count
        for (a, b), root in zip(edges, roots):
            asked[a] += 2 * root - weights[b]
            asked[b] += 2 * root - weights[a]
        weights = [min(1.0, max(0.0, (weight + total / max(1, degree)) / 2))
                   for weight, total, degree in zip(weights, asked, degrees)]
    off = [((weights[a] + weights[b]) / 2) ** 4 - value / most for (a, b), value in zip(edges, stiffness)]
    return most, weights, math.sqrt(sum(x * x for x in off) / sum((value / most) ** 2 for value in stiffness))


def soften(thing, package):
    """Gives the object a soft body; how much of the tissue it could take comes back."""
    mesh, tissue = thing.data, package.tissue
    factor = LEAST_MASS / min(tissue["MASS"])
    force = FRAME**2 * factor  # of a N, or of a N/m
    places, edges = package.positions, [tuple(edge.vertices) for edge in mesh.edges]
    stiffness = [force * constant * math.dist(places[a], places[b])
                 for (a, b), constant in zip(edges, package.edge_constants(edges))]
    body = thing.modifiers.new("Soft body", "SOFT_BODY").settings
    masses = [factor * mass for mass in tissue["MASS"]]
    body.mass = max(masses)
    body.vertex_group_mass = weigh(thing, "mass", [mass / body.mass for mass in masses])
    iks, weights, off = spring_weights(len(places), edges, stiffness)
    body.use_edges = True
    body.pull = body.push = min(MOST_PULL, iks / (1 + iks))
    body.vertex_group_spring = weigh(thing, "springs", weights)
    springs = package.model["springs"]
    viscosity = sum(package.array(springs["viscosity"])) / springs["count"] if springs["count"] else 0.0
    damping = 100 * FRAME * factor * viscosity
    body.damping = min(MOST_DAMPING, damping)
    hold(thing, package, body, factor)
    body.friction = body.bend = 0.0
    fps = bpy.context.scene.render.fps / bpy.context.scene.render.fps_base
    body.speed = 1 / (fps * FRAME)
    body.step_min, body.step_max, body.error_threshold = 20, 30000, 0.001
    return {"mass_factor": factor, "edges_off": off, "damping_kept": body.damping / damping if damping else 1.0,
            "pull_kept": body.pull / (1 - body.pull) / iks if iks else 1.0}


def hold(thing, package, body, factor):
    """Fixed vertices and tethers are Blender's goal: its weight to the fourth power is what it holds with."""
    springs = [FRAME**2 * factor * constant for constant in package.tethers("springConstant")]
    shares = [spring / (1 + spring) for spring in springs]
    body.use_goal = True
    body.goal_min, body.goal_max, body.goal_default = 0.0, 1.0, 1.0
    body.goal_spring = min(MOST_PULL, max(max(shares) / 0.99, 1e-6))
    fixed = package.tissue["FIXED"]
    goals = [1.0 if held == 1 else min(0.997, (share / body.goal_spring) ** 0.25)  # 1 would pin
             for held, share in zip(fixed, shares)]
    body.vertex_group_goal = weigh(thing, "goal", goals)
    mean = sum(package.tethers("viscosity")) / len(goals)
    body.goal_friction = min(MOST_DAMPING, 100 * FRAME * factor * mean)


def main():
    parser = argparse.ArgumentParser(prog="blender_soft_body.py")
    parser.add_argument("package")
    parser.add_argument("--frames", type=int, default=0, help="play so many, and print where the vertices are, as JSON")
    parser.add_argument("--save", help="a .blend file to write")
    arguments = parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else ["-h"])
    package = Package(arguments.package)
    mesh = bpy.data.meshes.new(package.model["name"])
    mesh.from_pydata(package.positions, [], package.faces)
    thing = bpy.data.objects.new(package.model["name"], mesh)
    bpy.context.scene.collection.objects.link(thing)
    report = soften(thing, package)
    cache = thing.modifiers[0].point_cache
    cache.frame_start, cache.frame_end = 1, max(250, 1 + arguments.frames)
    for frame in range(1, 2 + arguments.frames):
        bpy.context.scene.frame_set(frame)
    report.update(vertices=len(mesh.vertices), edges=len(mesh.edges), mass=sum(package.tissue["MASS"]))
    if arguments.frames:
        now = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
        report["positions"] = [(vertex.co.x, vertex.co.z, -vertex.co.y) for vertex in now]
    print(json.dumps(report))
    if arguments.save:
        bpy.ops.wm.save_as_mainfile(filepath=arguments.save)


main()
