# SPDX-License-Identifier: Apache-2.0
"""MORPHING: two flags in the wind, a glass drop and a ball that breathe, by morph targets."""

import math

from . import shapes, vector
from .gltf import Document
from .mesh import Mesh

LOOP = 4.0


def paints(doc):
    """The materials by name."""
    return {"cloth": doc.material("cloth", (0.75, 0.12, 0.10), 0.85, double_sided=True),
            "pole": doc.material("pole", (0.85, 0.80, 0.70), 0.25, 1.0),
            "floor": doc.material("floor", (0.55, 0.56, 0.58), 0.8),
            "plinth": doc.material("plinth", (0.35, 0.33, 0.32), 0.7),
            "glass": doc.material("glass", (0.85, 0.96, 0.93), 0.0, transmission=1.0, ior=1.4, thickness=0.6),
            "rubber": doc.material("rubber", (0.10, 0.30, 0.62), 0.35)}


def by_displacement(mesh, move, step=1e-4):
    """For each corner what `move` adds to its position and to its normal."""
    def shifted(p):
        return vector.add(p, move(p))

    out = []
    for p, n, _ in mesh.corners:
        side = vector.unit(vector.cross(n, (0.3, 0.9, 0.2)))
        up = vector.cross(n, side)
        along = [vector.sub(shifted(vector.add(p, vector.mul(d, step))), shifted(vector.sub(p, vector.mul(d, step))))
                 for d in (side, up)]
        normal = vector.unit(vector.cross(along[0], along[1]))
        out.append((move(p), vector.sub(normal, n)))
    return out


def flag(doc, paint):
    """A cloth with two targets, a quarter of a wave apart: their weights make any phase."""
    width, height, columns, rows = 1.5, 0.9, 32, 12
    points = [[(width * c / columns, height * (r / rows - 0.5), 0.0) for c in range(columns + 1)]
              for r in range(rows + 1)]
    cloth = shapes.grid(points, [[(0.0, 0.0, 1.0)] * (columns + 1)] * (rows + 1))

    def ripple(phase):
        def move(p):
            angle = 2 * math.pi * (p[0] / 0.85 - 0.18 * p[1] + phase)
            reach = 0.16 * min(1.0, p[0] / width * 1.4)
            return (0.0, 0.25 * reach * math.cos(angle), reach * math.sin(angle))
        return move
    targets = [by_displacement(cloth, ripple(phase)) for phase in (0.0, 0.25)]
    return doc.morphing_mesh("flag", cloth, paint["cloth"], targets, (1.0, 0.0))


def rounded_targets(mesh):
    """Wider and lower, and with a waist."""
    def squash(p):
        return (0.28 * p[0], -0.36 * p[1], 0.28 * p[2])

    def waist(p):
        pinch = -0.45 * math.exp(-(p[1] / 0.16) ** 2)
        return (pinch * p[0], 0.1 * p[1], pinch * p[2])
    return [by_displacement(mesh, move) for move in (squash, waist)]


def turning(cycles, phase, steps=24):
    """Times and the weights of two targets a quarter apart."""
    times = [LOOP * i / steps for i in range(steps + 1)]
    angles = [2 * math.pi * (cycles * t / LOOP + phase) for t in times]
    return times, [(x,) for a in angles for x in (math.cos(a), -math.sin(a))]


def breathing(cycles, phase, reach=1.0):
    """Times and spline rows of two weights that swing from 0 to `reach`."""
    steps = 8 * cycles
    times = [LOOP * i / steps for i in range(steps + 1)]
    rate = 2 * math.pi * cycles / LOOP
    rows = []
    for t in times:
        value = [reach * (0.5 - 0.5 * math.cos(rate * t + p)) for p in (phase, phase + 2.0)]
        slope = [reach * 0.5 * rate * math.sin(rate * t + p) for p in (phase, phase + 2.0)]
        rows += [(x,) for x in slope + value + slope]
    return times, rows


def poles(doc, paint, mesh, channels):
    """Two flags that share a mesh, each with weights of its own."""
    pole = shapes.lathe([(0.05, 0), (0.05, 0.04), (0.024, 0.06), (0.020, 2.4), (0.05, 2.42), (0.05, 2.47),
                         (0, 2.5)], 20, 40)
    pole_mesh = doc.mesh("pole", pole, paint["pole"])
    for name, at, phase in (("near", (-1.7, 0, 0.1), 0.0), ("far", (0.1, 0, -1.3), 0.4)):
        stand = doc.node(name + " pole", pole_mesh, at=at)
        cloth = doc.node(name + " flag", mesh, parent=stand, at=(0.02, 1.92, 0),
                         weights=[round(math.cos(2 * math.pi * phase), 6), round(-math.sin(2 * math.pi * phase), 6)])
        channels.append((cloth, "weights", "LINEAR", *turning(3, phase)))


def build():
    """The finished document."""
    doc = Document()
    paint = paints(doc)
    channels = []
    doc.camera("camera", (0.5, 1.75, 4.6), (0.0, 1.1, -0.3), 42)
    floor = shapes.lathe([(4.2, -0.2), (4.1, 0), (0, 0)], 64, 20)
    doc.node("floor", doc.mesh("floor", floor, paint["floor"]))
    poles(doc, paint, flag(doc, paint), channels)
    plinth = doc.mesh("plinth", shapes.bevel_box(0.6, 0.5, 0.6, 0.03).moved(0, 0.25, 0), paint["plinth"])
    ball = shapes.sphere(0.36, 48, 28)
    targets = rounded_targets(ball)
    glass = doc.morphing_mesh("drop", ball, paint["glass"], targets, (0.0, 0.0))
    rubber = doc.morphing_mesh("ball", Mesh(ball.corners), paint["rubber"], targets, (0.3, 0.0))
    for name, mesh, at, phase in (("drop", glass, (0.55, 0, 0.9), 0.0), ("ball", rubber, (1.65, 0, 0.0), 1.0)):
        stand = doc.node(name + " plinth", plinth, at=at)
        node = doc.node(name, mesh, parent=stand, at=(0, 0.88, 0))
        channels.append((node, "weights", "CUBICSPLINE", *breathing(2, phase)))
    doc.animation("wind and breath", channels)
    doc.light("sun", "directional", 2.6, (1.0, 0.95, 0.85), direction=(-0.4, -0.9, -0.5))
    doc.light("lamp", "point", 18, (0.8, 0.9, 1.0), at=(2.2, 2.6, 2.4))
    return doc
