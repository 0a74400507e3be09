#!/usr/bin/env python3
"""The loop of a simulator, from Python: a force pulls at an organ, and sixty times a second the tissue is as far as the clock.

    realtime.py ORGAN.glb|ORGAN.esm [SECONDS]

Where the machine is too slow for the step, tissue falls behind the clock instead of holding up the pictures.
"""
import sys
import time

import numpy

import esm

FRAME = 1 / 60  # s


def loaded(file):
    return esm.load_project(file).evaluate() if file.endswith(".esm") else esm.load_package(file)


def pulled_node(tissue):
    """The node that lies farthest from all that is held."""
    rest, held = tissue.rest_positions, tissue.rest_positions[tissue.fixed_nodes]
    middle = held.mean(axis=0) if len(held) else rest.mean(axis=0)
    return int(numpy.argmax(numpy.linalg.norm(rest - middle, axis=1)))


def main():
    tissue, seconds = loaded(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 1.0
    simulation, node = esm.Simulation(tissue), pulled_node(tissue)
    print(f"{tissue.name}: {len(tissue.masses)} nodes, {simulation.integrator} in steps of {simulation.time_step:g} s")
    force = 0.1 * tissue.masses.sum() * 9.81
    begin, farthest = time.monotonic(), 0.0
    for picture in range(1, int(seconds / FRAME) + 1):
        due = begin + picture * FRAME
        simulation.set_forces([node], [[0, 0, -force if picture * FRAME < seconds / 2 else 0]])
        while simulation.time + simulation.time_step <= picture * FRAME and time.monotonic() < due:
            simulation.step()
        # A renderer uploads these vertices, and works out the normals of tissue.triangles.
        vertices = simulation.vertices()
        if len(vertices):
            farthest = max(farthest, numpy.linalg.norm(vertices - tissue.vertices, axis=1).max())
        time.sleep(max(0, due - time.monotonic()))
    print(f"{100 * simulation.time / seconds:.0f} % of real time, {1000 * farthest:.3g} mm moved at most")


if __name__ == "__main__":
    main()
