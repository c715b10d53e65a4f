# SPDX-License-Identifier: Apache-2.0
"""MATERIALS: car paint, coloured glass, cloth, a thin film, turned steel and a leaf."""

import math

from . import shapes, vector
from .gltf import Document
from .mesh import Mesh
from .texture import png


def tiles(x, y):
    """A picture of warm and dark tiles."""
    return (188, 180, 168) if (x // 8 + y // 8) % 2 else (112, 106, 102)


def paint(doc):
    """A clear coat over dark red."""
    return doc.material("car paint", (0.55, 0.01, 0.015), 0.5, 0.3, extensions={
        "KHR_materials_clearcoat": {"clearcoatFactor": 1.0, "clearcoatRoughnessFactor": 0.0}})


def honey(doc):
    """Glass that takes blue first, then green."""
    return doc.material("honey glass", (1, 1, 1), 0.0, transmission=1.0, ior=1.45,
                        thickness=0.3, extensions={"KHR_materials_volume": {
                            "thicknessFactor": 0.3, "attenuationDistance": 0.25,
                            "attenuationColor": [0.95, 0.55, 0.12]}})


def velvet(doc):
    """Dark blue cloth whose rim shines."""
    return doc.material("velvet", (0.03, 0.05, 0.2), 1.0, extensions={
        "KHR_materials_sheen": {"sheenColorFactor": [0.5, 0.6, 1.0],
                                "sheenRoughnessFactor": 0.4}})


def film(doc):
    """Something dark under a thin film."""
    return doc.material("film", (0.25, 0.25, 0.27), 0.25, 1.0, extensions={
        "KHR_materials_iridescence": {"iridescenceFactor": 1.0, "iridescenceIor": 1.8,
                                      "iridescenceThicknessMaximum": 420.0}})


def steel(doc):
    """Turned steel: its highlight is a fan."""
    return doc.material("turned steel", (0.72, 0.70, 0.68), 0.3, 1.0, double_sided=True,
                        extensions={"KHR_materials_anisotropy": {"anisotropyStrength": 0.8}})


def leaf(doc):
    """Thin and green, brighter where light comes through."""
    return doc.material("leaf", (0.10, 0.30, 0.05), 0.6, double_sided=True, extensions={
        "KHR_materials_diffuse_transmission": {
            "diffuseTransmissionFactor": 0.6,
            "diffuseTransmissionColorFactor": [0.45, 0.85, 0.10]}})


def turned_disc(radius, sides=96, rings=8):
    """A disc in the xy plane with a small hole."""
    mesh = Mesh()
    for i in range(sides):
        for j in range(rings):
            corners = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
            points = []
            for a, b in corners:
                angle, far = 2 * math.pi * a / sides, radius * (b + 0.5) / (rings + 0.5)
                points.append((far * math.cos(angle), far * math.sin(angle), 0.0))
            mesh.quad(points, [(0.0, 0.0, 1.0)] * 4)
    return mesh


def outwards(point):
    """Roughness is larger across the grooves, which run around."""
    return vector.unit((point[0], point[1], 0.0))


def blade(length, width, steps=16):
    """A leaf along y that bends towards z at its end."""
    rows = []
    for i in range(steps + 1):
        t = i / steps
        half = width / 2 * math.sin(math.pi * min(max(t, 0.02), 0.98)) ** 0.8
        rows.append([(x * half, t * length, 0.25 * length * t * t + 0.12 * abs(x) * half)
                     for x in (-1, -0.5, 0, 0.5, 1)])
    mesh = Mesh()
    for low, high in zip(rows, rows[1:]):
        for i in range(4):
            mesh.quad([low[i], low[i + 1], high[i + 1], high[i]])
    return mesh.smooth()


def room(doc):
    """A tiled table, and a wall behind it."""
    picture = doc.texture("tiles", png(16, 16, tiles))
    table = doc.material("table", (1, 1, 1), 0.6, texture=picture)
    wall = doc.material("wall", (0.30, 0.33, 0.38), 0.95)
    plane = shapes.rectangle(6, 4).with_uv(lambda p, n, t: (t[0] * 10, t[1] * 6.6667))
    doc.node("table", doc.mesh("table", plane.turned("x", -90), table, True))
    doc.node("wall", doc.mesh("wall", shapes.rectangle(6, 3), wall), at=(0, 1.5, -1.3))


def build():
    """The finished document."""
    doc = Document()
    room(doc)
    ball = shapes.sphere(0.26, 64, 32)
    doc.node("paint", doc.mesh("paint", ball, paint(doc)), at=(-0.98, 0.26, 0.05))
    doc.node("honey", doc.mesh("honey", shapes.rounded_box(0.3, 0.5, 0.3, 0.04, 4), honey(doc)),
             at=(-0.36, 0.252, 0.28), turn=(0, math.sin(0.3), 0, math.cos(0.3)))
    knot = [(0.2 * math.cos(2 * a) * (1 + 0.35 * math.cos(3 * a)),
             0.09 * math.sin(3 * a),
             0.2 * math.sin(2 * a) * (1 + 0.35 * math.cos(3 * a)))
            for a in (2 * math.pi * i / 160 for i in range(160))]
    doc.node("velvet", doc.mesh("velvet", shapes.sweep(knot, 0.065, 24, closed=True), velvet(doc)),
             at=(0.24, 0.16, 0.30))
    doc.node("film", doc.mesh("film", ball, film(doc)), at=(0.86, 0.26, 0.05))
    doc.node("steel", doc.mesh("steel", turned_disc(0.36), steel(doc), tangent=outwards),
             at=(0.1, 0.42, -0.65), turn=(math.sin(-0.12), 0, 0, math.cos(-0.12)))
    green = doc.mesh("leaf", blade(0.62, 0.24), leaf(doc))
    for name, x, degrees in (("left", -0.74, 24), ("middle", -0.62, -6), ("right", -0.5, -30)):
        half = math.radians(degrees / 2)
        doc.node(name + " leaf", green, at=(x, 0.0, -0.6), turn=(0, 0, math.sin(half),
                                                                 math.cos(half)))
    doc.light("key light", "point", 12.0, (1.0, 0.95, 0.88), at=(-1.2, 2.2, 1.6))
    doc.light("fill light", "point", 7.0, (0.85, 0.92, 1.0), at=(1.7, 1.8, 1.0))
    doc.light("back light", "point", 5.0, (1.0, 0.98, 0.92), at=(-0.3, 1.7, -1.1))
    doc.camera("camera", (0.0, 1.05, 2.75), (-0.05, 0.30, -0.05), 36)
    return doc
