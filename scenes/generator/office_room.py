# SPDX-License-Identifier: Apache-2.0
"""The office's shell: floor, walls, windows, door and what hangs on the walls."""

import math
import random

from . import shapes
from .mesh import Mesh

WIDTH, HEIGHT, DEPTH = 7.0, 2.8, 5.5
WINDOW_WIDTH, WINDOW_LOW, WINDOW_HIGH = 1.6, 0.95, 2.35
WINDOWS = (-1.75, 1.05)  # where on the back wall (x)


def planks(shade):
    """Every third plank of the floor (shade 0, 1 or 2), with chamfered edges."""
    source = random.Random("planks")
    mesh = Mesh()
    board, count = 0.175, 40
    for row in range(count):
        x = -WIDTH / 2 + (row + 0.5) * board
        z = -DEPTH / 2 - source.uniform(0.0, 1.4)
        while z < DEPTH / 2:
            length = source.uniform(1.3, 1.9)
            low, high = max(z, -DEPTH / 2), min(z + length, DEPTH / 2)
            if source.randrange(3) == shade and high - low > 0.02:
                mesh += plank(board, high - low).moved(x, 0, (low + high) / 2)
            z += length
    return mesh


def plank(width, length):
    """One floor board, top and sloping edges."""
    def rim(x, y, z):
        return [(-x, y, z), (x, y, z), (x, y, -z), (-x, y, -z)]
    low = rim(width / 2, -0.004, length / 2)
    high = rim(width / 2 - 0.003, 0.0, length / 2 - 0.003)
    mesh = Mesh()
    mesh.quad(high)
    for i in range(4):
        j = (i + 1) % 4
        mesh.quad([low[i], low[j], high[j], high[i]])
    return mesh


def back_wall():
    """The wall with two window openings and their reveals."""
    mesh = Mesh()
    edges = [-WIDTH / 2]
    for x in WINDOWS:
        edges += [x - WINDOW_WIDTH / 2, x + WINDOW_WIDTH / 2]
    edges.append(WIDTH / 2)

    def piece(x0, x1, y0, y1):
        mesh.quad([(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)])

    for i in range(0, len(edges), 2):
        piece(edges[i], edges[i + 1], 0, HEIGHT)
    for x in WINDOWS:
        x0, x1 = x - WINDOW_WIDTH / 2, x + WINDOW_WIDTH / 2
        piece(x0, x1, 0, WINDOW_LOW)
        piece(x0, x1, WINDOW_HIGH, HEIGHT)
        rim = [(x0, WINDOW_LOW), (x1, WINDOW_LOW), (x1, WINDOW_HIGH), (x0, WINDOW_HIGH)]
        for i in range(4):
            (ax, ay), (bx, by) = rim[i], rim[(i + 1) % 4]
            mesh.quad([(ax, ay, 0), (bx, by, 0), (bx, by, -0.2), (ax, ay, -0.2)])
    return mesh.moved(0, 0, -DEPTH / 2)


def other_walls():
    """Left, right and front wall."""
    y = HEIGHT / 2
    mesh = shapes.rectangle(DEPTH, HEIGHT).turned("y", 90).moved(-WIDTH / 2, y, 0)
    mesh += shapes.rectangle(DEPTH, HEIGHT).turned("y", -90).moved(WIDTH / 2, y, 0)
    return mesh + shapes.rectangle(WIDTH, HEIGHT).turned("y", 180).moved(0, y, DEPTH / 2)


def ceiling():
    """The ceiling, facing down."""
    return shapes.rectangle(WIDTH, DEPTH).turned("x", 90).moved(0, HEIGHT, 0)


def skirting():
    """Boards along the foot of the walls, with a gap at the door."""
    mesh = Mesh()
    for z in (-DEPTH / 2, DEPTH / 2):
        mesh += shapes.bevel_box(WIDTH, 0.09, 0.03, 0.006).moved(0, 0.045, z)
    mesh += shapes.bevel_box(0.03, 0.09, DEPTH, 0.006).moved(WIDTH / 2, 0.045, 0)
    length = DEPTH / 2 + 1.13
    return mesh + shapes.bevel_box(0.03, 0.09, length, 0.006).moved(
        -WIDTH / 2, 0.045, -DEPTH / 2 + length / 2)


def window_frame():
    """Frame, mullion and transom of a window about its middle."""
    width, height, bar = WINDOW_WIDTH, WINDOW_HIGH - WINDOW_LOW, 0.06
    mesh = Mesh()
    for x in (-width / 2 + bar / 2, 0, width / 2 - bar / 2):
        mesh += shapes.bevel_box(bar, height, 0.06, 0.008).moved(x, 0, 0)
    for y in (-height / 2 + bar / 2, 0.22, height / 2 - bar / 2):
        mesh += shapes.bevel_box(width, bar * 0.9, 0.055, 0.008).moved(0, y, 0)
    handle = [(0.0, -0.1, 0.03), (0.0, -0.1, 0.06), (0.0, -0.09, 0.07), (0.0, 0.02, 0.07)]
    return mesh + shapes.sweep(handle, 0.008, 8)


def window_sill():
    """A sill that stands out from the wall."""
    return shapes.rounded_box(WINDOW_WIDTH + 0.1, 0.03, 0.28, 0.012, 1)


def blind():
    """A venetian blind, partly lowered, hanging from y = 0."""
    width = WINDOW_WIDTH - 0.1
    mesh = shapes.bevel_box(width, 0.04, 0.05, 0.005).moved(0, -0.02, 0)
    slat = Mesh()
    line = [(math.radians(a), 0.04) for a in (-36, -12, 12, 36)]
    rows = [[(x, r * math.cos(a) - 0.035, r * math.sin(a)) for x in (-width / 2, width / 2)]
            for a, r in reversed(line)]
    normals = [[(0.0, math.cos(a), math.sin(a))] * 2 for a, _ in reversed(line)]
    slat = shapes.grid(rows, normals)
    slat += slat.flipped().moved(0, -0.0008, 0)
    for i in range(12):
        mesh += slat.turned("x", 20).moved(0, -0.07 - 0.04 * i, 0)
    for x in (-width * 0.35, width * 0.35):
        mesh += shapes.sweep([(x, -0.02, 0.03), (x, -0.56, 0.03)], 0.0025, 5)
    return mesh + shapes.bevel_box(width, 0.02, 0.045, 0.004).moved(0, -0.56, 0)


def city():
    """Towers beyond the windows."""
    source = random.Random("city")
    mesh = Mesh()
    for i in range(16):
        width, height = source.uniform(1.2, 2.4), source.uniform(3.0, 8.5)
        x, z = -15 + 2 * i, -14 - source.uniform(0, 4)
        mesh += shapes.box(width, height, 1.5).moved(x, height / 2 - 4, z)
    return mesh


def city_lights():
    """Lit windows of the towers, drawn from the same numbers as the towers."""
    source = random.Random("city")
    lit = random.Random("lit")
    mesh = Mesh()
    for i in range(16):
        width, height = source.uniform(1.2, 2.4), source.uniform(3.0, 8.5)
        x, z = -15 + 2 * i, -14 - source.uniform(0, 4)
        for column in range(4):
            for row in range(int(height / 0.55)):
                if lit.random() < 0.45:
                    pane = shapes.rectangle(width * 0.14, 0.26)
                    mesh += pane.moved(x + (column - 1.5) * width * 0.23,
                                       height - 4.35 - 0.55 * row, z + 0.76)
    return mesh


def door_leaf():
    """A panelled door 0.9 wide in the xy plane, facing +z, its foot at y = 0."""
    mesh = shapes.bevel_box(0.88, 2.05, 0.04, 0.004).moved(0, 1.03, 0)
    for y, height in ((0.52, 0.72), (1.47, 0.92)):
        for x in (-0.2, 0.2):
            mesh += shapes.bevel_box(0.28, height, 0.02, 0.009).moved(x, y, 0.022)
    return mesh


def door_frame():
    """The casing of the door."""
    mesh = shapes.bevel_box(1.1, 0.1, 0.07, 0.012).moved(0, 2.11, 0)
    for x in (-0.5, 0.5):
        mesh += shapes.bevel_box(0.1, 2.06, 0.07, 0.012).moved(x, 1.03, 0)
    return mesh


def door_handle():
    """Lever and key plate."""
    mesh = shapes.bevel_box(0.04, 0.2, 0.008, 0.003).moved(0.37, 1.02, 0.03)
    lever = [(0.37, 1.06, 0.03), (0.37, 1.06, 0.07), (0.36, 1.06, 0.08), (0.26, 1.06, 0.08)]
    return mesh + shapes.sweep(lever, 0.009, 10)


def clock_rim(radius=0.17):
    """The ring of a wall clock that faces +z."""
    points = [(radius * math.cos(a), radius * math.sin(a), 0.02)
              for a in (2 * math.pi * i / 48 for i in range(48))]
    return shapes.sweep(points, 0.016, 8, closed=True)


def clock_face(radius=0.17):
    """The dial."""
    return shapes.disc(radius, 48).turned("x", 90).moved(0, 0, 0.012)


def clock_marks(radius=0.17):
    """Hour marks and hands at ten past ten."""
    mesh = Mesh()
    for hour in range(12):
        size = 0.03 if hour % 3 == 0 else 0.018
        mark = shapes.box(0.008, size, 0.003).moved(0, radius - 0.04, 0.015)
        mesh += mark.turned("z", -30 * hour)
    for degrees, length, width in ((-305, 0.085, 0.011), (-60, 0.125, 0.008)):
        hand = shapes.box(width, length, 0.003).moved(0, length / 2 - 0.015, 0.018)
        mesh += hand.turned("z", degrees)
    return mesh + shapes.cylinder(0.01, 0.008, 12).turned("x", 90).moved(0, 0, 0.016)


def picture_frame(width, height):
    """Four mitre-less bars around a picture that faces +z."""
    bar = 0.035
    mesh = Mesh()
    for side in (-1, 1):
        mesh += shapes.bevel_box(width + 2 * bar, bar, 0.03, 0.008).moved(
            0, side * (height + bar) / 2, 0.015)
        mesh += shapes.bevel_box(bar, height, 0.03, 0.008).moved(
            side * (width + bar) / 2, 0, 0.015)
    return mesh


def landscape(x, y):
    """A little picture of hills at sunset, 64 x 32."""
    if (x - 44) ** 2 / 1.8 + (y - 11) ** 2 < 22:
        return (255, 236, 170)
    if y > 22 + 3 * math.sin(x / 7):
        return (38, 66, 52)
    if y > 17 + 4 * math.sin(x / 12 + 2):
        return (80, 98, 112)
    return (240 - 3 * y, 130 + 3 * y, 90 + 4 * y)


def abstract(x, y):
    """A picture of coloured blocks, 32 x 32."""
    if x in (11, 24) or y in (8, 21):
        return (20, 20, 24)
    colours = ((222, 60, 40), (244, 240, 228), (40, 80, 160),
               (244, 240, 228), (246, 196, 40), (244, 240, 228),
               (30, 110, 110), (244, 240, 228), (222, 60, 40))
    return colours[(x > 11) + (x > 24) + 3 * ((y > 8) + (y > 21))]
