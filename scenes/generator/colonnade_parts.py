# SPDX-License-Identifier: Apache-2.0
"""Columns, arches and the other pieces of the courtyard; +z is the courtyard."""

import math

from . import shapes
from .colonnade_paint import around_axis, planar
from .mesh import Mesh
from .vector import unit

BAY = 3.0
RADIUS = 1.18
THICK = 0.25  # half the thickness of the arcade wall
FLUTES = 16
SIDES = 16


def half_round(radius, height, bulge, steps):
    """Profile of a moulding that bulges outwards, from the bottom up."""
    return [(radius + bulge * math.sin(math.pi * i / steps),
             height[0] + (height[1] - height[0]) * (1 - math.cos(math.pi * i / steps)) / 2)
            for i in range(steps + 1)]


def shaft(bottom, top, radius):
    """A fluted shaft that narrows upwards."""
    mesh = Mesh()
    rings = [(y, radius * scale) for y, scale in
             ((bottom, 1.0), (bottom + (top - bottom) * 0.4, 0.985), (top, 0.85))]
    step = 2 * math.pi / FLUTES
    # (angle within a flute, depth, tilt of the normal) of the narrow land and the hollow.
    land = ((0.0, 0.0, 0.0), (0.22, 0.0, 0.0))
    hollow = ((0.22, 0.0, 0.9), (0.46, 0.11, 0.35), (0.76, 0.11, -0.35), (1.0, 0.0, -0.9))
    for flute in range(FLUTES):
        for strip in (land, hollow):
            rows, normals = [], []
            for y, r in rings:
                angles = [((flute + a) * step, r * (1 - depth), tilt) for a, depth, tilt in strip]
                rows.append([(q * math.cos(a), y, -q * math.sin(a)) for a, q, _ in angles])
                normals.append([(math.cos(a + t), 0.0, -math.sin(a + t)) for a, _, t in angles])
            mesh += shapes.grid(rows, normals)
    return around_axis(mesh, "limestone")


def column(height):
    """A column on a moulded base, with its capital; its foot is at y = 0."""
    r = 0.23
    base = half_round(r + 0.05, (0.14, 0.26), 0.06, 4) + [
        (r + 0.035, 0.28), (r + 0.025, 0.34)] + half_round(r + 0.01, (0.35, 0.43), 0.04, 2)
    neck = r * 0.85
    top = height - 0.14
    capital = [(neck, top - 0.40)] + half_round(neck, (top - 0.38, top - 0.32), 0.025, 2) + [
        (neck, top - 0.20), (neck + 0.02, top - 0.19), (neck + 0.05, top - 0.13),
        (neck + 0.10, top - 0.05), (neck + 0.12, top)]
    mesh = around_axis(shapes.lathe(base, SIDES, 60), "limestone")
    mesh += shaft(0.43, top - 0.39, r)
    mesh += around_axis(shapes.lathe(capital, SIDES, 50), "limestone")
    mesh += planar(shapes.box(0.70, 0.14, 0.70).moved(0, 0.07, 0), "limestone")
    mesh += planar(shapes.bevel_box(0.68, 0.14, 0.68, 0.02).moved(0, height - 0.07, 0),
                   "limestone")
    return mesh


def ring_points(radius, height, z, steps=14):
    """Points over the opening of an arch, from right to left."""
    return [(x, y, z) for x, y in shapes.arc((0, height), radius, 0, 180, steps)]


def strip(first, second):
    """Flat quads between two rows of points; faces (along first) x (to second)."""
    mesh = Mesh()
    for i in range(len(first) - 1):
        mesh.quad([first[i], first[i + 1], second[i + 1], second[i]])
    return mesh


def arch(spring, top):
    """The wall above one bay with its round opening and mouldings on both faces."""
    outer, proud = RADIUS + 0.17, 0.05
    front = Mesh()
    inner_front = ring_points(RADIUS, spring, THICK + proud)
    outer_front = ring_points(outer, spring, THICK + proud)
    outer_back = ring_points(outer, spring, THICK)
    above = [(x, top, z) for x, _, z in outer_back]
    half = BAY / 2
    front += planar(strip(outer_back, above).flipped(), "ashlar")
    front += planar(strip(inner_front, outer_front).flipped(), "limestone")
    radial = [unit((x, y - spring, 0.0)) for x, y, _ in outer_front]
    rim = shapes.grid([outer_back, outer_front], [radial, radial])
    front += planar(rim, "limestone")
    for side in (-1, 1):
        panel = Mesh()
        xs = sorted((side * outer, side * half))
        panel.quad([(xs[0], spring, THICK), (xs[1], spring, THICK),
                    (xs[1], top, THICK), (xs[0], top, THICK)])
        front += planar(panel, "ashlar")
    mesh = front + front.turned("y", 180)
    keystone = shapes.prism([(-0.10, -0.02), (0.10, -0.02), (0.16, 0.30), (-0.16, 0.30)],
                            2 * THICK + 0.2).moved(0, spring + RADIUS, -THICK - 0.1)
    mesh += planar(keystone, "limestone")
    soffit = smooth_soffit(spring)
    for side in (-1, 1):
        under = Mesh()
        xs = sorted((side * RADIUS, side * half))
        under.quad([(xs[0], spring, -THICK), (xs[1], spring, -THICK),
                    (xs[1], spring, THICK), (xs[0], spring, THICK)])
        mesh += planar(under, "limestone")
    return mesh + planar(soffit, "limestone")


def smooth_soffit(spring):
    """The round underside of an arch."""
    depth = THICK + 0.05
    rows = [ring_points(RADIUS, spring, z) for z in (depth, -depth)]
    normals = [[(-x / RADIUS, (spring - y) / RADIUS, 0.0) for x, y, _ in row] for row in rows]
    return shapes.grid(rows, normals)


def corner_block(spring, top):
    """The piece of wall above a column, which closes the corners."""
    block = shapes.box(2 * THICK - 0.01, top - spring, 2 * THICK - 0.01)
    return planar(block.moved(0, (top + spring) / 2, 0), "ashlar")


def cornice(low, high):
    """The painted band and moulding above the arches of one bay."""
    half = BAY / 2 + 0.001
    profile = [(THICK, low), (THICK + 0.06, low + 0.02), (THICK + 0.06, low + 0.07)]
    face = [(THICK + 0.02, low + 0.07), (THICK + 0.02, high - 0.20)]
    crown = [(THICK + 0.02, high - 0.20), (THICK + 0.06, high - 0.18), (THICK + 0.10, high - 0.12),
             (THICK + 0.18, high - 0.08), (THICK + 0.18, high), (-THICK, high)]
    mesh = Mesh()
    for line in (profile, crown):
        piece = strip([(-half, y, z) for z, y in line], [(half, y, z) for z, y in line])
        mesh += planar(piece.flipped(), "limestone")
    for i in range(-1, 2):
        piece = strip([(i - 0.5, y, z) for z, y in face], [(i + 0.5, y, z) for z, y in face])
        mesh += planar(piece.flipped(), "frieze", stretch=True)
    return mesh


def ceiling(y):
    """The ceiling over one bay of the gallery, centred on it."""
    mesh = Mesh()
    h = BAY / 2
    mesh.quad([(-h, y, -h), (h, y, -h), (h, y, h), (-h, y, h)])
    return planar(mesh, "plaster")


def beam(y):
    """A beam across the gallery on two brackets."""
    mesh = planar(shapes.bevel_box(0.26, 0.30, BAY - 2 * THICK, 0.02).moved(0, y - 0.15, 0),
                  "beam")
    for z in (-BAY / 2 + 0.2, BAY / 2 - THICK - 0.2):
        mesh += planar(shapes.box(0.2, 0.18, 0.4).moved(0, y - 0.39, z), "limestone")
    return mesh


def wall_panel(top, cell):
    """One bay of plain wall with a skirting, facing +z."""
    mesh = planar(shapes.rectangle(BAY, top).moved(0, top / 2, 0), cell, stretch=True)
    return mesh + planar(shapes.box(BAY, 0.3, 0.08).moved(0, 0.15, 0.02), "limestone")


def back_wall(top, spring, cell):
    """A wall panel with a pilaster and a round-headed door."""
    mesh = wall_panel(top, cell)
    pilaster = shapes.box(0.44, spring, 0.16).moved(-BAY / 2, spring / 2, 0.06)
    mesh += planar(pilaster, "limestone")
    for y, extra in ((0.2, 0.12), (spring, 0.16)):
        mesh += planar(shapes.box(0.44 + extra, 0.2, 0.16 + extra)
                       .moved(-BAY / 2, y, 0.06), "limestone")
    return mesh + doorway(0.6, 0.78, 1.7)


def doorway(inside, outside, spring):
    """A round-headed door in its stone frame."""
    def outline(radius, z):
        head = shapes.arc((0, spring), radius, 0, 180, 10)
        return [(x, y, z) for x, y in [(radius, 0)] + head + [(-radius, 0)]]

    leaf = Mesh()
    points = outline(inside, 0.05)
    for i in range(1, len(points) - 1):
        leaf.triangle([points[0], points[i], points[i + 1]])
    mesh = planar(leaf, "door")
    lines = (outline(outside, 0.0), outline(outside, 0.14),
             outline(inside, 0.14), outline(inside, 0.05))
    for first, second in zip(lines, lines[1:]):
        mesh += planar(strip(first, second), "limestone")
    return mesh


def gallery_floor(y):
    """The tiled floor of one bay of the gallery, centred on it."""
    mesh = Mesh()
    h = BAY / 2
    mesh.quad([(-h, y, h), (h, y, h), (h, y, -h), (-h, y, -h)])
    return planar(mesh, "terracotta")


def tile(size):
    """A floor tile with sloping edges."""
    outer, inner = size / 2, size / 2 - 0.015
    low = [(-outer, -0.012, outer), (outer, -0.012, outer),
           (outer, -0.012, -outer), (-outer, -0.012, -outer)]
    high = [(-inner, 0.0, inner), (inner, 0.0, inner), (inner, 0.0, -inner), (-inner, 0.0, -inner)]
    up = (0.0, 1.0, 0.0)
    mesh = Mesh()
    mesh.quad(high, (up,) * 4)
    slopes = [unit((p[0], outer, p[2])) for p in low]
    for i in range(4):
        j = (i + 1) % 4
        mesh.quad([low[i], low[j], high[j], high[i]], (slopes[i], slopes[j], up, up))
    return mesh


def balustrade():
    """The railing of one bay of the upper storey."""
    profile = [(0.035, 0.12), (0.055, 0.16), (0.035, 0.21), (0.075, 0.36),
               (0.03, 0.64), (0.045, 0.78)]
    post = around_axis(shapes.lathe(profile, 8, 60), "limestone")
    mesh = Mesh()
    for i in range(6):
        mesh += post.moved((i - 2.5) * 0.38, 0, 0)
    length = BAY - 0.5
    mesh += planar(shapes.box(length, 0.12, 0.2).moved(0, 0.06, 0), "limestone")
    return mesh + planar(shapes.bevel_box(length, 0.12, 0.24, 0.025).moved(0, 0.84, 0), "limestone")


def roof_line(y):
    """Profile (z, y) of the roof from the gutter to the outer wall."""
    return [(THICK + 0.30, y), (THICK + 0.30, y + 0.08), (-BAY - 0.4, y + 1.3)]


def roof(y):
    """The roof over one bay."""
    h = BAY / 2
    (z0, y0), (z1, y1), (z2, y2) = roof_line(y)
    mesh = Mesh()
    mesh.quad([(-h, y1, z1), (h, y1, z1), (h, y2, z2), (-h, y2, z2)])
    mesh.quad([(-h, y0, z0), (h, y0, z0), (h, y1, z1), (-h, y1, z1)])
    mesh.quad([(-h, y0, -THICK), (h, y0, -THICK), (h, y0, z0), (-h, y0, z0)])
    return planar(mesh, "roof")


def hip(y, side):
    """Half of the roof over a corner, on the left (-1) or right (1) end of a side."""
    _, (_, y1), (z2, y2) = roof_line(y)
    mesh = Mesh()
    corner = [(0, y1, THICK + 0.30), (0, y2, z2), (side * -z2, y2, z2)]
    mesh.triangle(corner if side < 0 else corner[::-1])
    return mesh


def fountain():
    """A basin with a bowl on a turned stem in the middle of the courtyard."""
    wall = [(1.75, 0.0), (1.75, 0.12), (1.60, 0.16), (1.60, 0.50), (1.70, 0.56), (1.70, 0.64),
            (1.45, 0.64), (1.45, 0.30)]
    mesh = around_axis(shapes.lathe(wall, 32, 30), "limestone")
    mesh += around_axis(shapes.disc(1.45, 32).moved(0, 0.5, 0), "water")
    stem = [(0.34, 0.45), (0.34, 0.62), (0.22, 0.70), (0.14, 0.85), (0.20, 1.05), (0.12, 1.30),
            (0.16, 1.45), (0.45, 1.55), (0.72, 1.74), (0.76, 1.80), (0.70, 1.80), (0.40, 1.68)]
    mesh += around_axis(shapes.lathe(stem, 24, 60), "limestone")
    mesh += around_axis(shapes.disc(0.66, 24).moved(0, 1.77, 0), "water")
    finial = [(0.10, 1.6), (0.07, 1.95), (0.13, 2.05), (0.15, 2.15), (0.10, 2.27), (0.0, 2.40)]
    return mesh + around_axis(shapes.lathe(finial, 16, 70), "limestone")
