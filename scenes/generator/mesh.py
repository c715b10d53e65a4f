# SPDX-License-Identifier: Apache-2.0
"""A triangle list that shapes are collected in."""

from . import vector


class Mesh:
    """Corners (position, normal, uv), three to a triangle, counter-clockwise.

    Equal corners are merged only when the mesh is written, so shapes need
    not keep track of indices.
    """

    def __init__(self, corners=()):
        self.corners = list(corners)

    def __add__(self, other):
        return Mesh(self.corners + other.corners)

    def __iadd__(self, other):
        self.corners += other.corners
        return self

    def triangle_count(self):
        """Number of triangles."""
        return len(self.corners) // 3

    def triangle(self, points, normals=None, uvs=None):
        """Add a triangle; without normals it is flat, and nothing if empty."""
        a, b, c = points
        face = vector.cross(vector.sub(b, a), vector.sub(c, a))
        if vector.dot(face, face) < 1e-18:
            return
        normals = normals or (vector.unit(face),) * 3
        uvs = uvs or ((0.0, 0.0),) * 3
        self.corners += zip(points, normals, uvs)

    def quad(self, points, normals=None, uvs=None):
        """Add a quadrilateral as two triangles."""
        if normals is None:
            a, b, c, d = points
            face = vector.unit(vector.cross(vector.sub(c, a), vector.sub(d, b)))
            normals = (face,) * 4
        uvs = uvs or ((0.0, 0.0),) * 4
        for i, j, k in ((0, 1, 2), (0, 2, 3)):
            self.triangle((points[i], points[j], points[k]),
                          (normals[i], normals[j], normals[k]),
                          (uvs[i], uvs[j], uvs[k]))

    def moved(self, x, y, z):
        """A copy shifted by (x, y, z)."""
        return Mesh((vector.add(p, (x, y, z)), n, t) for p, n, t in self.corners)

    def turned(self, axis, degrees):
        """A copy turned about "x", "y" or "z" through the origin."""
        q = vector.turn(tuple(float(axis == name) for name in "xyz"), degrees)
        return self.turned_by(q)

    def turned_by(self, q):
        """A copy turned by a unit quaternion."""
        return Mesh((vector.rotate(q, p), vector.rotate(q, n), t)
                    for p, n, t in self.corners)

    def scaled(self, x, y, z):
        """A copy scaled along the axes; the winding stays counter-clockwise."""
        corners = [((p[0] * x, p[1] * y, p[2] * z),
                    vector.unit((n[0] / x, n[1] / y, n[2] / z)), t)
                   for p, n, t in self.corners]
        if x * y * z < 0:
            corners[1::3], corners[2::3] = corners[2::3], corners[1::3]
        return Mesh(corners)

    def flipped(self):
        """A copy that faces the other way."""
        corners = [(p, vector.mul(n, -1), t) for p, n, t in self.corners]
        corners[1::3], corners[2::3] = corners[2::3], corners[1::3]
        return Mesh(corners)

    def with_uv(self, function):
        """A copy whose uv is function(position, normal, uv)."""
        return Mesh((p, n, function(p, n, t)) for p, n, t in self.corners)

    def smooth(self):
        """A copy with the face normals averaged wherever positions meet."""
        sums = {}
        keys = [tuple(round(x, 6) for x in p) for p, _, _ in self.corners]
        for i in range(0, len(self.corners), 3):
            a, b, c = (corner[0] for corner in self.corners[i:i + 3])
            face = vector.cross(vector.sub(b, a), vector.sub(c, a))
            for key in keys[i:i + 3]:
                sums[key] = vector.add(sums.get(key, (0.0, 0.0, 0.0)), face)
        return Mesh((p, vector.unit(sums[key]), t)
                    for key, (p, _, t) in zip(keys, self.corners))

    def welded(self):
        """(corners without repetition, indices), rounded to be reproducible."""
        index, order, indices = {}, [], []
        for p, n, t in self.corners:
            key = (tuple(round(x, 5) + 0.0 for x in p),
                   tuple(round(x, 4) + 0.0 for x in n),
                   tuple(round(x, 5) + 0.0 for x in t))
            if key not in index:
                index[key] = len(order)
                order.append(key)
            indices.append(index[key])
        return order, without_empty(order, indices)


def without_empty(corners, indices):
    """Indices less the triangles that rounding has made empty."""
    kept = []
    for i in range(0, len(indices), 3):
        three = indices[i:i + 3]
        if len({corners[j][0] for j in three}) == 3:
            kept += three
    return kept
