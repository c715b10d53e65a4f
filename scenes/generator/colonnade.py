# SPDX-License-Identifier: Apache-2.0
"""COLONNADE: a courtyard in two storeys of arches, one mesh of one primitive.

A bay is built once with the courtyard towards +z, then repeated around it.
"""

from . import colonnade_parts as parts
from . import colonnade_paint as paint
from .gltf import Document
from .mesh import Mesh

BAY = parts.BAY
# Turn about y, number of bays and distance of the columns from the centre.
SIDES = ((0, 6, 6.0), (90, 4, 9.0), (180, 6, 6.0), (270, 4, 9.0))
STOREY = 5.0


def around(piece, depth=0.0, corners=False):
    """The piece once in each bay (and, if asked, past the left end) of each side."""
    mesh = Mesh()
    for angle, count, distance in SIDES:
        for i in range(-1 if corners else 0, count):
            x = (i - count / 2 + 0.5) * BAY
            mesh += piece.moved(x, 0, -distance - depth).turned("y", angle)
    return mesh


def storey(shaft_height, wall):
    """Columns, arches, ceiling, beams and back wall of one storey, from y = 0."""
    top = shaft_height + parts.RADIUS + 0.35
    mesh = around(parts.column(shaft_height).moved(-BAY / 2, 0, 0))
    mesh += around(parts.arch(shaft_height, top))
    mesh += around(parts.corner_block(shaft_height, top).moved(-BAY / 2, 0, 0), 0.0)
    mesh += around(parts.cornice(top, STOREY - 0.02))
    mesh += around(parts.ceiling(top), BAY / 2, corners=True)
    mesh += around(parts.beam(top).moved(-BAY / 2, 0, 0), BAY / 2)
    mesh += around(parts.back_wall(top, shaft_height, wall), BAY)
    return mesh + corner_walls(top, wall)


def corner_walls(top, wall):
    """The two walls behind each corner of the gallery."""
    panel = parts.wall_panel(top, wall)
    mesh = Mesh()
    for angle, count, distance in SIDES:
        end = (count / 2 + 0.5) * BAY
        for x in (-end, end):
            mesh += panel.moved(x, 0, -distance - BAY).turned("y", angle)
    return mesh


def courtyard():
    """The tiled floor and the fountain in its middle."""
    mesh = Mesh()
    columns, rows, size = 18, 12, 1.0
    for i in range(columns):
        for j in range(rows):
            edge = min(i, j, columns - 1 - i, rows - 1 - j)
            cell = "tile red" if edge == 1 or (i + j) % 2 == 0 and edge > 2 else "tile light"
            tile = paint.planar(parts.tile(size), cell)
            mesh += tile.moved((i - columns / 2 + 0.5) * size, 0,
                               (j - rows / 2 + 0.5) * size)
    return mesh + parts.fountain()


def courtyard_mesh():
    """The whole scene as one mesh."""
    mesh = courtyard()
    mesh += around(parts.gallery_floor(0.0), BAY / 2, corners=True)
    mesh += storey(3.0, "plaster")
    upper = storey(2.6, "fresco")
    upper += around(parts.gallery_floor(0.0), BAY / 2, corners=True)
    upper += around(parts.balustrade())
    mesh += upper.moved(0, STOREY, 0)
    return mesh + around(parts.roof(2 * STOREY), 0.0) + corner_roofs()


def corner_roofs():
    """The hips of the roof."""
    mesh = Mesh()
    for angle, count, distance in SIDES:
        end = count / 2 * BAY
        for x, side in ((-end, -1), (end, 1)):
            piece = paint.planar(parts.hip(2 * STOREY, side), "roof")
            mesh += piece.moved(x, 0, -distance).turned("y", angle)
    return mesh


def build():
    """The finished document."""
    doc = Document()
    atlas = doc.texture("atlas", paint.atlas())
    stone = doc.material("stone", (1, 1, 1), 0.65, texture=atlas)
    doc.node("colonnade", doc.mesh("colonnade", courtyard_mesh(), stone, with_uv=True))
    doc.light("lantern", "point", 170.0, (1.0, 0.80, 0.56), at=(-3.3, 4.0, 2.3))
    doc.light("moon", "directional", 1.1, (0.55, 0.70, 1.0), direction=(0.62, -0.75, -0.5))
    doc.camera("camera", (-7.7, 2.0, 5.0), (1.2, 3.0, -2.6), 62)
    return doc
