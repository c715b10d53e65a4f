# SPDX-License-Identifier: Apache-2.0
"""CORNELL: an object between six mirrors, 800 triangles."""

import math

from . import shapes, vector
from .gltf import Document
from .mesh import Mesh

HALF = 2.0
MIRRORS = (
    ("mirror right", (0.55, 0.95, 0.60), (1, 0, 0)),
    ("mirror left", (0.97, 0.55, 0.50), (-1, 0, 0)),
    ("mirror ceiling", (0.95, 0.95, 0.95), (0, 1, 0)),
    ("mirror floor", (0.78, 0.80, 0.84), (0, -1, 0)),
    ("mirror front", (0.97, 0.86, 0.50), (0, 0, 1)),
    ("mirror back", (0.55, 0.72, 0.98), (0, 0, -1)),
)
BANDS = (("coral", (0.90, 0.22, 0.16)), ("amber", (0.95, 0.62, 0.08)),
         ("teal", (0.05, 0.55, 0.52)), ("violet", (0.38, 0.18, 0.68)))


def mirror(outward):
    """One wall of the room, facing inwards."""
    for u, v, w in shapes.CUBE_FACES:
        if w == outward:
            mesh = Mesh()
            mesh.quad([vector.mul(shapes.frame(u, v, w, a, b, 1), HALF)
                       for a, b in ((-1, 1), (1, 1), (1, -1), (-1, -1))])
            return mesh
    raise ValueError(outward)


def knot():
    """A trefoil knot with six flat sides."""
    points = []
    for i in range(64):
        a = 2 * math.pi * i / 64
        r = 0.50 + 0.21 * math.cos(3 * a)
        points.append((r * math.cos(2 * a), r * math.sin(2 * a), 0.24 * math.sin(3 * a)))
    return shapes.sweep(points, 0.125, 6, closed=True, flat=True)


def pedestal():
    """A six-sided foot without its underside."""
    rows = [[(0.42 * math.cos(a), -2, -0.42 * math.sin(a)),
             (0.30 * math.cos(a), -1.0, -0.30 * math.sin(a))]
            for a in (math.pi * i / 3 for i in range(6))]
    mesh = Mesh()
    for i in range(6):
        here, after = rows[i], rows[(i + 1) % 6]
        mesh.quad([here[0], after[0], after[1], here[1]])
    for i in range(1, 5):
        mesh.triangle([rows[0][1], rows[i][1], rows[i + 1][1]])
    return mesh


def lamp():
    """A six-sided plate just below the ceiling that shines downwards."""
    rim = [(0.35 * math.cos(math.pi * i / 3), 1.97, 0.35 * math.sin(math.pi * i / 3))
           for i in range(6)]
    mesh = Mesh()
    for i in range(1, 5):
        mesh.triangle([rim[0], rim[i], rim[i + 1]])
    return mesh


def build():
    """The finished document."""
    doc = Document()
    for name, colour, outward in MIRRORS:
        material = doc.material(name, colour, 0.0, 1.0, double_sided=True)
        doc.node(name, doc.mesh(name, mirror(outward), material))
    corners = knot().corners
    share = len(corners) // len(BANDS)
    for i, (name, colour) in enumerate(BANDS):
        band = Mesh(corners[i * share:(i + 1) * share])
        material = doc.material(name, colour, 0.35)
        doc.node("knot " + name, doc.mesh("knot " + name, band, material), at=(0, -0.2, 0))
    stone = doc.material("stone", (0.75, 0.73, 0.70), 0.7)
    doc.node("pedestal", doc.mesh("pedestal", pedestal(), stone))
    glow = doc.material("lamp", (0, 0, 0), 1.0, emissive=(1.0, 0.95, 0.85))
    doc.node("lamp", doc.mesh("lamp", lamp(), glow))
    doc.light("lamp light", "point", 14.0, (1.0, 0.96, 0.9), at=(0.0, 1.9, 0.0))
    doc.light("fill light", "point", 8.0, (0.9, 0.95, 1.0), at=(1.5, 0.5, 1.75))
    doc.light("back light", "point", 6.0, (1.0, 0.9, 0.85), at=(-1.5, -0.6, -1.2))
    doc.camera("camera", (1.15, 0.30, 1.9), (-0.15, -0.32, 0), 58, near=0.02, far=100.0)
    return doc
