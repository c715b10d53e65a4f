# SPDX-License-Identifier: Apache-2.0
"""Basic closed and open shapes; every one faces outwards."""

import math

from . import vector
from .mesh import Mesh

# The six faces of a cube as (u axis, v axis, normal) with u x v = normal.
CUBE_FACES = (
    ((0, 0, -1), (0, 1, 0), (1, 0, 0)), ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)), ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)), ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
)
UNIT_UV = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))


def frame(u, v, w, a, b, c):
    """The point a*u + b*v + c*w."""
    return tuple(u[i] * a + v[i] * b + w[i] * c for i in range(3))


def grid(rows, normals, uvs=None):
    """Surface through rows of points; faces along (next point) x (next row)."""
    mesh = Mesh()
    for i in range(len(rows) - 1):
        for j in range(len(rows[i]) - 1):
            at = ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))
            mesh.quad([rows[r][c] for r, c in at],
                      [normals[r][c] for r, c in at],
                      uvs and [uvs[r][c] for r, c in at])
    return mesh


def box(x, y, z):
    """A box of full size (x, y, z) about the origin."""
    mesh = Mesh()
    for u, v, w in CUBE_FACES:
        corners = [frame(u, v, w, a, b, 1)
                   for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        mesh.quad([(p[0] * x / 2, p[1] * y / 2, p[2] * z / 2) for p in corners],
                  (w,) * 4, UNIT_UV)
    return mesh


def bevel_box(x, y, z, bevel):
    """A box whose edges are cut off and shaded as if round (44 triangles)."""
    inner = (x / 2 - bevel, y / 2 - bevel, z / 2 - bevel)

    def corner(signs, axis):
        normal = tuple(float(signs[i]) if i == axis else 0.0 for i in range(3))
        at = tuple(signs[i] * inner[i] + normal[i] * bevel for i in range(3))
        return at, normal

    def polygon(parts):
        middle = [sum(part[0][i] for part in parts) for i in range(3)]
        a, b, c = (part[0] for part in parts[:3])
        if vector.dot(vector.cross(vector.sub(b, a), vector.sub(c, a)), middle) < 0:
            parts = parts[::-1]
        add = mesh.quad if len(parts) == 4 else mesh.triangle
        add([part[0] for part in parts], [part[1] for part in parts])

    mesh = Mesh()
    signs = (-1, 1)
    for axis in range(3):
        j, k = (axis + 1) % 3, (axis + 2) % 3

        def at(a, b, c):
            out = [0, 0, 0]
            out[axis], out[j], out[k] = a, b, c
            return out

        for a in signs:
            polygon([corner(at(a, b, c), axis)
                     for b, c in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
            for b in signs:
                polygon([corner(at(-1, a, b), j), corner(at(1, a, b), j),
                         corner(at(1, a, b), k), corner(at(-1, a, b), k)])
    for a in signs:
        for b in signs:
            for c in signs:
                polygon([corner((a, b, c), axis) for axis in range(3)])
    return mesh


def rounded_box(x, y, z, radius, steps=2):
    """A box with round edges and corners, steps facets from face to 45 degrees."""
    ramp = [(s, math.tan(math.pi / 4 * (i / steps - (s < 0))))
            for s in (-1, 1) for i in range(steps + 1)]
    half = (x / 2 - radius, y / 2 - radius, z / 2 - radius)
    mesh = Mesh()
    for u, v, w in CUBE_FACES:
        normals = [[vector.unit(frame(u, v, w, a, b, 1)) for _, a in ramp]
                   for _, b in ramp]
        rows = [[tuple(frame(u, v, w, su, sv, 1)[i] * half[i]
                       + normals[r][c][i] * radius for i in range(3))
                 for c, (su, _) in enumerate(ramp)]
                for r, (sv, _) in enumerate(ramp)]
        mesh += grid(rows, normals)
    return mesh


def profile_normals(profile, crease):
    """Per segment of a (radius, height) profile, the normals at its two ends."""
    faces = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        length = math.hypot(r1 - r0, y1 - y0)
        faces.append(((y1 - y0) / length, (r0 - r1) / length))

    def joint(face, neighbour):
        if face[0] * neighbour[0] + face[1] * neighbour[1] < math.cos(math.radians(crease)):
            return face
        x, y = face[0] + neighbour[0], face[1] + neighbour[1]
        return (x / math.hypot(x, y), y / math.hypot(x, y))

    def beyond(face, radius):
        # Across the axis the surface goes on as its own mirror image.
        return (-face[0], face[1]) if radius == 0 else face

    around = [beyond(faces[0], profile[0][0]), *faces, beyond(faces[-1], profile[-1][0])]
    return [(joint(face, around[i]), joint(face, around[i + 2]))
            for i, face in enumerate(faces)]


def lathe(profile, sides, crease=40):
    """Turn a (radius, height) profile about y; going up, it faces outwards."""
    ring = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides))
            for i in range(sides)]
    ring.append(ring[0])
    mesh = Mesh()
    ends = profile_normals(profile, crease)
    for (low, high), (n_low, n_high) in zip(zip(profile, profile[1:]), ends):
        rows = [[(r * c, y, -r * s) for c, s in ring] for r, y in (low, high)]
        normals = [[(n * c, up, -n * s) for c, s in ring] for n, up in (n_low, n_high)]
        mesh += grid(rows, normals)
    return mesh


def cylinder(radius, height, sides):
    """A closed cylinder standing on y = 0."""
    return lathe([(0, 0), (radius, 0), (radius, height), (0, height)], sides)


def sphere(radius, sides, rings):
    """A sphere of latitude and longitude."""
    profile = [(radius * math.sin(math.pi * i / rings) if 0 < i < rings else 0.0,
                -radius * math.cos(math.pi * i / rings)) for i in range(rings + 1)]
    return lathe(profile, sides, 180)


def disc(radius, sides):
    """A disc at y = 0 that faces up."""
    return lathe([(radius, 0), (0, 0)], sides)


def sweep(points, radius, sides, closed=False, flat=False):
    """A tube along points; radius is a number or one number per point."""
    count = len(points)
    radii = radius if isinstance(radius, (list, tuple)) else [radius] * count
    tangents = path_tangents(points, closed)
    side = vector.unit(vector.cross(tangents[0], (0.3, 0.9, 0.2)))
    rows, normals = [], []
    for point, tangent, r in zip(points, tangents, radii):
        side = vector.unit(vector.sub(side, vector.mul(tangent, vector.dot(side, tangent))))
        up = vector.cross(tangent, side)
        ring = [frame(side, up, tangent, math.cos(a), math.sin(a), 0)
                for a in (2 * math.pi * i / sides for i in range(sides))]
        ring.append(ring[0])
        normals.append(ring)
        rows.append([vector.add(point, vector.mul(n, r)) for n in ring])
    if closed:
        shift = best_shift(rows[-1], rows[0])
        rows.append(rows[0][shift:-1] + rows[0][:shift + 1])
        normals.append(normals[0][shift:-1] + normals[0][:shift + 1])
    mesh = grid(rows, normals)
    return flattened(mesh) if flat else mesh


def path_tangents(points, closed):
    """Unit direction of a path at each of its points."""
    count = len(points)
    tangents = []
    for i in range(count):
        before = points[(i - 1) % count] if closed else points[max(i - 1, 0)]
        after = points[(i + 1) % count] if closed else points[min(i + 1, count - 1)]
        tangents.append(vector.unit(vector.sub(after, before)))
    return tangents


def best_shift(row, other):
    """Where in the ring other the point nearest to row's first one lies."""
    def distance(i):
        d = vector.sub(other[i], row[0])
        return vector.dot(d, d)
    return min(range(len(other) - 1), key=distance)


def flattened(mesh):
    """The mesh with one normal to each triangle."""
    out = Mesh()
    for i in range(0, len(mesh.corners), 3):
        three = mesh.corners[i:i + 3]
        out.triangle([c[0] for c in three], None, [c[2] for c in three])
    return out


def prism(outline, depth):
    """A convex outline of (x, y), counter-clockwise, extruded from z = 0 to depth."""
    mesh = Mesh()
    count = len(outline)
    for i in range(count):
        (x0, y0), (x1, y1) = outline[i], outline[(i + 1) % count]
        mesh.quad([(x0, y0, 0), (x1, y1, 0), (x1, y1, depth), (x0, y0, depth)])
    for i in range(1, count - 1):
        a, b, c = outline[0], outline[i], outline[i + 1]
        mesh.triangle([(*a, depth), (*b, depth), (*c, depth)])
        mesh.triangle([(*a, 0), (*c, 0), (*b, 0)])
    return mesh


def rectangle(width, height):
    """A rectangle in the xy plane about the origin that faces +z."""
    x, y = width / 2, height / 2
    mesh = Mesh()
    mesh.quad([(-x, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0)], None,
              ((0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)))
    return mesh


def arc(centre, radius, start, end, steps):
    """Points (x, y) on a circle from start to end degrees."""
    angles = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a))
            for a in angles]
