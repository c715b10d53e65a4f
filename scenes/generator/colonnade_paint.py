# SPDX-License-Identifier: Apache-2.0
"""The courtyard's texture atlas, and ways to lay a piece into one of its cells."""

import math
import random

from .mesh import Mesh
from .texture import png

CELL = 64
COLUMNS, ROWS = 4, 3
INSET = 2.5
CELLS = ("limestone", "ashlar", "tile light", "tile red",
         "terracotta", "door", "plaster", "beam",
         "water", "roof", "frieze", "fresco")
BASE = {"limestone": (226, 214, 190), "ashlar": (214, 196, 166),
        "tile light": (206, 200, 186), "tile red": (158, 76, 58),
        "terracotta": (176, 104, 74), "door": (112, 72, 42),
        "plaster": (208, 160, 96), "beam": (96, 64, 42),
        "water": (60, 128, 150), "roof": (170, 86, 58),
        "frieze": (224, 210, 180), "fresco": (150, 168, 160)}


def noise(name, seed_step):
    """A smooth repeating field of values -1..1 over a cell."""
    source = random.Random(name + str(seed_step))
    count = CELL // seed_step
    lattice = [[source.uniform(-1, 1) for _ in range(count)] for _ in range(count)]

    def at(x, y):
        fx, fy = x / seed_step, y / seed_step
        i, j = int(fx), int(fy)
        u, v = fx - i, fy - j
        u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
        rows = [lattice[(j + d) % count][i % count] * (1 - u)
                + lattice[(j + d) % count][(i + 1) % count] * u for d in (0, 1)]
        return rows[0] * (1 - v) + rows[1] * v
    return at


def joint(name, x, y):
    """How dark the pattern of a cell is at a pixel: 1 plain, below 1 darker."""
    if name == "ashlar":
        shifted = (x + 16 * (y // 16 % 2)) % 32
        return 0.72 if y % 16 == 0 or shifted == 0 else 1.0 + 0.05 * ((y // 16 * 5 + x // 32) % 3 - 1)
    if name.startswith("tile"):
        return 0.7 if min(x, y, 63 - x, 63 - y) < 3 else 1.0
    if name == "terracotta":
        return 0.6 if x % 16 == 0 or y % 16 == 0 else 1.0 + 0.14 * ((x // 16 + y // 16) % 2)
    if name in ("door", "beam"):
        return 0.55 if x % 16 == 0 else 1.0
    if name in ("plaster", "fresco"):
        return 0.55 if y > 44 and y < 48 else 0.62 if y >= 48 else 1.0
    if name == "roof":
        return 0.75 + 0.3 * abs(math.sin(math.pi * x / 8)) - (0.2 if y % 16 < 2 else 0)
    if name == "frieze":
        return frieze(x % 32, y)
    return 1.0


def frieze(x, y):
    """A painted band of diamonds between two lines."""
    if 8 <= y < 11 or 53 <= y < 56:
        return 0.45
    reach = abs(x - 15.5) + abs(y - 31.5) * 0.75
    return 0.42 if reach < 6 or 10 < reach < 13 else 1.0


def atlas():
    """PNG bytes of all cells."""
    coarse = {name: noise(name, 16) for name in CELLS}
    fine = {name: noise(name, 4) for name in CELLS}

    def pixel(px, py):
        name = CELLS[py // CELL * COLUMNS + px // CELL]
        x, y = px % CELL, py % CELL
        factor = joint(name, x, y) * (1 + 0.07 * coarse[name](x, y) + 0.05 * fine[name](x, y))
        return [round(value * factor) for value in BASE[name]]
    return png(COLUMNS * CELL, ROWS * CELL, pixel)


def in_cell(name, u, v):
    """Atlas coordinates of (u, v), both 0..1 with v down, inside a cell."""
    index = CELLS.index(name)
    span = CELL - 2 * INSET
    x = index % COLUMNS * CELL + INSET + u * span
    y = index // COLUMNS * CELL + INSET + v * span
    return (x / (COLUMNS * CELL), y / (ROWS * CELL))


def bounds(mesh):
    """Lowest corner and size of the mesh's bounding box."""
    low = [min(p[i] for p, _, _ in mesh.corners) for i in range(3)]
    high = [max(p[i] for p, _, _ in mesh.corners) for i in range(3)]
    return low, [max(h - l, 1e-6) for l, h in zip(low, high)]


def planar(mesh, name, stretch=False):
    """Lay the mesh into a cell, seen along the main axis of each normal.

    It keeps its proportions unless stretch asks to fill the cell.
    """
    low, size = bounds(mesh)

    def uv(p, n, _):
        axis = max(range(3), key=lambda i: (abs(round(n[i], 3)), i))
        across, up = ((2, 1), (0, 2), (0, 1))[axis]
        longest = max(size[across], size[up])
        u = (p[across] - low[across]) / (size[across] if stretch else longest)
        v = (p[up] - low[up]) / (size[up] if stretch else longest)
        return in_cell(name, u, 1 - v)
    return mesh.with_uv(uv)


def around_axis(mesh, name):
    """Lay a turned piece into a cell, there and back around its y axis."""
    low, size = bounds(mesh)

    def uv(p, _, __):
        u = abs(math.atan2(p[2], p[0])) / math.pi if abs(p[0]) + abs(p[2]) > 1e-9 else 0.5
        return in_cell(name, u, 1 - (p[1] - low[1]) / size[1])
    return Mesh(mesh.corners).with_uv(uv)
