# SPDX-License-Identifier: Apache-2.0
"""GLASS: thin panes, and thick glass that bends what lies behind it."""

import math

from . import shapes
from .gltf import Document
from .mesh import Mesh
from .texture import png


def checks(x, y):
    """A checkered picture, blue-grey and cream."""
    return (226, 220, 204) if (x // 8 + y // 8) % 2 else (46, 66, 96)


def stripes(x, y):
    """Upright coloured stripes."""
    colours = ((214, 60, 48), (240, 236, 226), (30, 110, 150), (240, 236, 226),
               (236, 170, 36), (240, 236, 226), (60, 140, 84), (240, 236, 226))
    return colours[x // 8 % 8]


def tiled(width, height, repeat):
    """A rectangle in the xy plane whose picture repeats every repeat metres."""
    mesh = shapes.rectangle(width, height)
    return mesh.with_uv(lambda p, n, t: (t[0] * width / repeat, t[1] * height / repeat))


def lens(radius, curve, rim, sides=64, rings=12):
    """A biconvex lens about the z axis: two caps of radius curve on a rim."""
    reach = math.asin(radius / curve)
    depth = curve * math.cos(reach)
    cap = [(curve * math.sin(reach * i / rings), curve * math.cos(reach * i / rings) - depth)
           for i in range(rings, -1, -1)]
    lower = [(r, -y - rim / 2) for r, y in reversed(cap)]
    upper = [(r, y + rim / 2) for r, y in cap]
    return shapes.lathe(lower + upper, sides, 30).turned("x", 90)


def ring(radius, thickness):
    """A torus about the z axis."""
    points = [(radius * math.cos(a), radius * math.sin(a), 0.0)
              for a in (2 * math.pi * i / 64 for i in range(64))]
    return shapes.sweep(points, thickness, 12, closed=True)


def pane_frame(width, height, bar):
    """A foot and two posts that hold a pane."""
    mesh = shapes.bevel_box(width + 2 * bar, bar, 0.16, 0.008).moved(0, bar / 2, 0)
    for x in (-1, 1):
        post = shapes.bevel_box(bar, height + bar, bar, 0.008)
        mesh += post.moved(x * (width + bar) / 2, height / 2 + bar, 0)
    return mesh


def room(doc):
    """The table top, the striped wall and the coloured things before it."""
    pictures = [doc.texture("checks", png(16, 16, checks)),
                doc.texture("stripes", png(64, 8, stripes))]
    table = doc.material("checkered table", (1, 1, 1), 0.5, texture=pictures[0])
    wall = doc.material("striped wall", (0.9, 0.9, 0.9), 0.9, texture=pictures[1])
    doc.node("table", doc.mesh("table", tiled(6.6, 3.3, 0.3).turned("x", -90), table, True),
             at=(0, 0, 0.2))
    doc.node("wall", doc.mesh("wall", tiled(6.6, 2.4, 1.28), wall, True), at=(0, 1.2, -1.4))
    ball = shapes.sphere(0.16, 32, 16).moved(0, 0.16, 0)
    block = shapes.bevel_box(0.26, 0.26, 0.26, 0.02).moved(0, 0.13, 0)
    cone = shapes.lathe([(0, 0), (0.17, 0), (0.02, 0.44), (0, 0.45)], 32)
    things = (("red ball", ball, (0.85, 0.08, 0.06), (-1.25, 0, -0.75)),
              ("yellow block", block, (0.95, 0.70, 0.05), (-0.55, 0, -0.85)),
              ("green cone", cone, (0.10, 0.60, 0.20), (0.10, 0, -0.95)),
              ("blue ball", ball, (0.08, 0.20, 0.80), (0.62, 0, -0.75)),
              ("violet block", block, (0.50, 0.12, 0.65), (1.30, 0, -0.80)))
    for name, mesh, colour, at in things:
        doc.node(name, doc.mesh(name, mesh, doc.material(name, colour, 0.4)), at=at)


def thick_glass(doc):
    """Lens, sphere, prism and block; each is closed and refracts."""
    clear = doc.material("thick glass", (1, 1, 1), 0.0, transmission=1.0, ior=1.5,
                         thickness=0.3)
    green = doc.material("green glass", (0.45, 0.9, 0.65), 0.0, transmission=1.0, ior=1.52,
                         thickness=0.3)
    brass = doc.material("brass", (0.90, 0.68, 0.30), 0.25, 1.0)
    doc.node("lens", doc.mesh("lens", lens(0.34, 0.75, 0.02), clear), at=(-0.42, 0.60, 0.10))
    stand = ring(0.355, 0.022)
    stand += shapes.cylinder(0.02, 0.2, 16).moved(0, -0.565, 0)
    stand += shapes.lathe([(0, 0), (0.17, 0), (0.17, 0.02), (0.03, 0.06), (0, 0.06)],
                          32).moved(0, -0.60, 0)
    doc.node("lens stand", doc.mesh("lens stand", stand, brass), at=(-0.42, 0.60, 0.10))
    doc.node("sphere", doc.mesh("sphere", shapes.sphere(0.26, 64, 32), clear),
             at=(0.36, 0.285, 0.35))
    holder = ring(0.12, 0.025).turned("x", 90).moved(0, 0.025, 0)
    doc.node("sphere stand", doc.mesh("sphere stand", holder, brass), at=(0.36, 0, 0.35))
    outline = [(-0.2, 0.0), (0.2, 0.0), (0.0, 0.346)]
    prism = shapes.prism(outline, 0.5).moved(0, 0, -0.25)
    doc.node("prism", doc.mesh("prism", prism, clear), at=(-0.15, 0.002, 0.85), turn=(
        0, math.sin(0.6), 0, math.cos(0.6)))
    block = shapes.rounded_box(0.34, 0.44, 0.26, 0.02, 3)
    doc.node("block", doc.mesh("block", block, green), at=(0.98, 0.222, 0.15), turn=(
        0, math.sin(0.2), 0, math.cos(0.2)))


def thin_glass(doc):
    """Upright panes without thickness, seen through unbent."""
    wood = doc.material("wood", (0.42, 0.25, 0.13), 0.5)
    frame = doc.mesh("pane frame", pane_frame(0.46, 0.74, 0.035), wood)
    pane = shapes.rectangle(0.46, 0.74).moved(0, 0.405, 0)
    panes = (("clear pane", (0.97, 0.98, 0.98), (-1.12, 0, 0.30), 14),
             ("amber pane", (0.98, 0.60, 0.12), (-1.05, 0, -0.20), 4),
             ("cyan pane", (0.25, 0.75, 0.90), (1.52, 0, -0.05), -14),
             ("rose pane", (0.95, 0.35, 0.50), (0.66, 0, -0.40), -6))
    for name, colour, at, degrees in panes:
        material = doc.material(name, colour, 0.0, transmission=1.0, ior=1.5,
                                double_sided=True)
        stand = doc.node(name + " stand", frame, at=at, turn=(
            0, math.sin(math.radians(degrees / 2)), 0, math.cos(math.radians(degrees / 2))))
        doc.node(name, doc.mesh(name, Mesh(pane.corners), material), parent=stand)


def build():
    """The finished document."""
    doc = Document()
    room(doc)
    thick_glass(doc)
    thin_glass(doc)
    doc.light("key light", "point", 11.0, (1.0, 0.95, 0.88), at=(-1.3, 2.3, 0.9))
    doc.light("fill light", "point", 7.0, (0.85, 0.92, 1.0), at=(1.5, 2.1, 0.5))
    doc.camera("camera", (0.1, 0.95, 2.55), (0.06, 0.36, -0.1), 40)
    return doc
