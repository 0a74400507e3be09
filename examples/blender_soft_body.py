"""Makes a soft body in Blender of a model package (.glb) of the Elastodynamic Shape Modeler.

    blender --python blender_soft_body.py -- ORGAN.glb
    blender --background --python blender_soft_body.py -- ORGAN.glb ORGAN.blend

Tried with Blender 3.4.1 and NumPy 1.24. readers/esm_package.py reads, since Blender's importer splits vertices where the
texture has borders.

A frame at speed 1 is sqrt(0.001) s, since gravity is 0.001 of its value there. A point's mass has no effect below 0.01 kg,
so all masses and forces are multiplied by one factor; that changes no motion. Edges pull with iks/length, where iks =
pull/(1 - pull) times the fourth power of the mean of their ends' weights. What this cannot carry is told in
docs/simulators.md, under Blender.
"""
import json
import math
import sys
from pathlib import Path

import bpy

try:
    import numpy as np
except ImportError:
    sys.exit("NumPy is not in the Python that Blender uses; install it there, in Debian as python3-numpy")

sys.path.insert(0, str(Path(__file__).resolve().parent / "readers"))
from esm_package import PackageError, need, read_package, shaped, spring_values  # noqa: E402: its folder is known only now

FRAME = math.sqrt(0.001)  # s, at speed 1
LEAST_MASS, MOST_PULL, MOST_DAMPING = 0.01, 0.999, 50.0


def at_vertices(package, of_nodes):
    """What nodes hold, at the vertices of the surface; where several nodes carry one, the mean by their shares."""
    if not package.binding:
        return of_nodes[np.array(package.surface["vertexNodes"])]
    firsts, shares = package.binding["starts"][:-1], np.array(package.binding["shares"])
    values = of_nodes[package.binding["nodes"]]
    # A share may be below 0; no vertex has more or less than its nodes.
    least = np.minimum.reduceat(np.where(shares == 0, np.inf, values), firsts)
    most = np.maximum.reduceat(np.where(shares == 0, -np.inf, values), firsts)
    return np.clip(np.add.reduceat(shares * values, firsts), least, most)


def shared_out(package, of_nodes):
    """What all nodes have together, at the vertices, which may be more or fewer."""
    of_vertices = at_vertices(package, of_nodes)
    return of_vertices * (of_nodes.sum() / (of_vertices.sum() or 1.0))


def tethers(package, key):
    return shared_out(package, np.bincount(package.tethers["nodes"], package.tethers[key], len(package.nodes["mass"])))


def edge_constants(package, constants, edges):
    """N/m of edges between vertices: of their springs; where vertices are no nodes, the mean of both ends."""
    if package.binding:
        return at_vertices(package, np.array(package.nodes["springConstant"]))[edges].mean(axis=1)
    ends = shaped(package.springs["nodes"], 2)
    springs = dict(zip(map(frozenset, ends.tolist()), constants))
    pairs = np.array(package.surface["vertexNodes"])[edges].tolist()
    return np.array([springs.get(frozenset(pair), 0.0) for pair in pairs])


def weigh(thing, name, weights):
    group = thing.vertex_groups.new(name=name)
    for vertex, weight in enumerate(weights):
        group.add([vertex], weight, "REPLACE")
    return name


def spring_weights(count, edges, stiffness):
    """iks of the stiffest edge, weights of vertices whose means to the fourth power come near all edges', and how far off they are.

    Least squares of the fourth roots, by steps half the way to what a vertex' edges ask for while its neighbours stay.
    """
    most = stiffness.max() or 1.0
    wanted = stiffness / most
    weights, degrees = np.full(count, 0.5), np.maximum(1, np.bincount(edges.ravel(), minlength=count))
    for _ in range(60):
        asked = 2 * wanted[:, None] ** 0.25 - weights[edges[:, ::-1]]
        weights = np.clip((weights + np.bincount(edges.ravel(), asked.ravel(), count) / degrees) / 2, 0, 1)
    off = weights[edges].mean(axis=1) ** 4 - wanted
    return most, weights, math.sqrt((off**2).sum() / ((wanted**2).sum() or 1.0))


def soften(thing, package, edges):
    """Gives the object a soft body; how much of the tissue it could take comes back."""
    constants, viscosities = spring_values(package)
    mass, places = shared_out(package, np.array(package.nodes["mass"])), shaped(package.surface["restPosition"], 3)
    factor = LEAST_MASS / mass.min()
    lengths = np.linalg.norm(places[edges[:, 0]] - places[edges[:, 1]], axis=1)
    stiffness = FRAME**2 * factor * edge_constants(package, constants, edges) * lengths
    body = thing.modifiers.new("Soft body", "SOFT_BODY").settings
    body.mass = factor * mass.max()
    body.vertex_group_mass = weigh(thing, "mass", mass / mass.max())
    iks, weights, off = spring_weights(len(places), edges, stiffness)
    body.use_edges = body.use_goal = True
    body.pull = body.push = min(MOST_PULL, iks / (1 + iks))
    body.vertex_group_spring = weigh(thing, "springs", weights)
    damping = 100 * FRAME * factor * np.mean(viscosities or [0.0])
    body.damping = min(MOST_DAMPING, damping)
    hold(thing, package, body, factor)
    body.friction = body.bend = 0.0
    fps = bpy.context.scene.render.fps / bpy.context.scene.render.fps_base
    body.speed = 1 / (fps * FRAME)
    body.step_min, body.step_max, body.error_threshold = 20, 30000, 0.001
    return {"mass": mass.sum(), "mass_factor": factor, "edges_off": off, "damping_kept": body.damping / damping if damping else 1.0,
            "pull_kept": body.pull / (1 - body.pull) / iks}


def hold(thing, package, body, factor):
    """Fixed vertices and tethers are Blender's goal: its weight to the fourth power is what it holds with."""
    springs = FRAME**2 * factor * tethers(package, "springConstant")
    shares = springs / (1 + springs)
    body.goal_min, body.goal_max, body.goal_default = 0.0, 1.0, 1.0
    body.goal_spring = min(MOST_PULL, max(shares.max() / 0.99, 1e-6))
    is_fixed = np.bincount(package.fixedNodes["nodes"], minlength=len(package.nodes["mass"]))
    goals = np.minimum(0.997, (shares / body.goal_spring) ** 0.25)  # 1 would pin
    body.vertex_group_goal = weigh(thing, "goal", np.where(at_vertices(package, is_fixed) > 1 - 1e-5, 1.0, goals))
    body.goal_friction = min(MOST_DAMPING, 100 * FRAME * factor * tethers(package, "viscosity").mean())


def soft_body(package):
    """A new object in the scene; what it could take of the tissue comes back. In Blender z points up, here y."""
    places = [(x, -z, y) for x, y, z in shaped(package.surface["restPosition"], 3).tolist()]
    mesh = bpy.data.meshes.new(package.name)
    mesh.from_pydata(places, [], shaped(package.surface["triangles"], 3).tolist())
    thing = bpy.data.objects.new(package.name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    edges = np.array([tuple(edge.vertices) for edge in mesh.edges])
    return {"vertices": len(places), "edges": len(edges), **soften(thing, package, edges)}


def main():
    files = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(files) not in (1, 2):
        sys.exit(__doc__)
    try:
        package = read_package(files[0])
        need(package.surface["triangles"], "has springs alone and no surface", "choose an organ with a surface")
    except (PackageError, OSError) as problem:
        sys.exit(f"{files[0]}: {problem}")
    print(json.dumps(soft_body(package)))
    for file in files[1:]:
        bpy.ops.wm.save_as_mainfile(filepath=file)


main()
