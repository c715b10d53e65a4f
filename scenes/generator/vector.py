# SPDX-License-Identifier: Apache-2.0
"""Vectors as tuples of three floats, and unit quaternions as (x, y, z, w)."""

import math


def add(a, b):
    """Sum of two vectors."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    """Difference of two vectors."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, factor):
    """Vector times a number."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def unit(a):
    """The vector scaled to length one."""
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length)


def turn(axis, degrees):
    """Quaternion of a turn about an axis (any length, right-handed)."""
    half = math.radians(degrees) / 2
    return (*mul(unit(axis), math.sin(half)), math.cos(half))


def chain(q, r):
    """Quaternion that turns by r first, then by q."""
    v = add(add(mul(r[:3], q[3]), mul(q[:3], r[3])), cross(q[:3], r[:3]))
    return (*v, q[3] * r[3] - dot(q[:3], r[:3]))


def rotate(q, v):
    """The vector turned by a unit quaternion."""
    t = mul(cross(q[:3], v), 2)
    return add(add(v, mul(t, q[3])), cross(q[:3], t))


def facing(direction):
    """Quaternion that turns -z (where cameras and spots look) to a direction."""
    d = unit(direction)
    yaw = math.degrees(math.atan2(-d[0], -d[2]))
    pitch = math.degrees(math.asin(max(-1.0, min(1.0, d[1]))))
    return chain(turn((0, 1, 0), yaw), turn((1, 0, 0), pitch))
