# SPDX-License-Identifier: Apache-2.0
"""WALKING: a skinned person who walks a round in front of a mirror, and a smaller one who waves."""

import math

from . import figure, shapes
from .gltf import Document
from .mesh import Mesh
from .vector import turn

LOOP = 6.0


def paints(doc):
    """The materials by name."""
    table = (("skin", (0.80, 0.55, 0.42), 0.6, 0), ("shirt", (0.72, 0.16, 0.12), 0.8, 0),
             ("trousers", (0.10, 0.17, 0.34), 0.85, 0), ("hair", (0.13, 0.07, 0.04), 0.7, 0),
             ("dark", (0.05, 0.05, 0.06), 0.5, 0), ("stone", (0.62, 0.60, 0.55), 0.85, 0),
             ("tile", (0.36, 0.40, 0.42), 0.7, 0), ("plaster", (0.78, 0.74, 0.66), 0.9, 0),
             ("wood", (0.42, 0.26, 0.14), 0.6, 0), ("mirror", (0.93, 0.94, 0.95), 0.0, 1))
    return {name: doc.material(name, colour, roughness, float(metal))
            for name, colour, roughness, metal in table}


def yard(doc, paint):
    """Floor, a wall with a mirror, and a fountain's rim to walk around."""
    floor = shapes.lathe([(5, -0.25), (4.9, 0), (0, 0)], 64, 20)
    doc.node("floor", doc.mesh("floor", floor, paint["tile"]))
    rim = shapes.lathe([(0.55, 0), (0.52, 0.30), (0.58, 0.34), (0.58, 0.40), (0.40, 0.40), (0.40, 0.12),
                        (0, 0.12)], 48, 30)
    doc.node("basin", doc.mesh("basin", rim, paint["stone"]))
    doc.node("ball", doc.mesh("ball", shapes.sphere(0.26, 40, 24), paint["mirror"]), at=(0, 0.52, 0))
    wall = shapes.bevel_box(5.2, 2.6, 0.16, 0.03).moved(0, 1.3, -2.3)
    doc.node("wall", doc.mesh("wall", wall, paint["plaster"]))
    frame = Mesh()
    for x in (-1.28, 1.28):
        frame += shapes.bevel_box(0.10, 2.16, 0.09, 0.02).moved(x, 1.16, -2.18)
    for y in (0.12, 2.20):
        frame += shapes.bevel_box(2.66, 0.10, 0.09, 0.02).moved(0, y, -2.18)
    doc.node("frame", doc.mesh("frame", frame, paint["wood"]))
    glass = shapes.rectangle(2.5, 2.02).moved(0, 1.16, -2.19)
    doc.node("mirror", doc.mesh("mirror", glass, paint["mirror"]))


def build():
    """The finished document."""
    doc = Document()
    paint = paints(doc)
    walking, waving = [], []
    doc.camera("camera", (2.1, 1.75, 3.7), (-0.05, 0.92, -0.2), 38)
    yard(doc, paint)
    mesh = figure.person_mesh(doc, paint)
    round_trip = doc.node("round")
    times = [LOOP * i / 24 for i in range(25)]
    walking.append((round_trip, "rotation", "LINEAR", times, [turn((0, 1, 0), 15 * i) for i in range(25)]))
    walker = doc.node("walker", parent=round_trip, at=(1.15, 0, 0), turn=turn((0, 1, 0), 180))
    nodes, skin = figure.skeleton(doc, "walker", walker)
    doc.node("walker body", mesh, skin=skin)
    figure.walk(walking, nodes, LOOP, 1)
    child = doc.node("child", at=(-1.5, 0, -0.9), turn=turn((0, 1, 0), 40), scale=(0.66, 0.66, 0.66))
    nodes, skin = figure.skeleton(doc, "child", child)
    doc.node("child body", mesh, skin=skin)
    figure.greet(waving, nodes, LOOP / 2)
    doc.animation("walk", walking)
    doc.animation("wave", waving)
    doc.light("sun", "directional", 2.6, (1.0, 0.93, 0.82), direction=(-0.55, -0.9, -0.55))
    doc.light("sky", "directional", 0.8, (0.66, 0.8, 1.0), direction=(0.6, -0.7, -0.3))
    return doc
