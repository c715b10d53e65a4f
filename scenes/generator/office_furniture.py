# SPDX-License-Identifier: Apache-2.0
"""Desks, chairs, shelves and lamps; they stand on y = 0 and are used from +z."""

import math

from . import shapes
from .mesh import Mesh

DESK = (1.5, 0.74, 0.75)  # width, height, depth
SHELVES = (0.08, 0.46, 0.84, 1.22, 1.60, 1.96)
STOCK = 1.2  # width of a bookcase


def deformed(mesh, function):
    """The mesh with its points moved by a function and smooth normals again."""
    return Mesh((function(p), n, t) for p, n, t in mesh.corners).smooth()


def desk_top():
    """The board of a desk."""
    return shapes.rounded_box(DESK[0], 0.034, DESK[2], 0.014).moved(0, DESK[1] - 0.017, 0)


def desk_frame():
    """Steel legs and rails."""
    x, z, height = DESK[0] / 2 - 0.06, DESK[2] / 2 - 0.06, DESK[1] - 0.034
    mesh = Mesh()
    for sx in (-x, x):
        for sz in (-z, z):
            mesh += shapes.bevel_box(0.05, height, 0.05, 0.008).moved(sx, height / 2, sz)
            mesh += shapes.cylinder(0.03, 0.012, 16).moved(sx, 0, sz)
        mesh += shapes.bevel_box(0.04, 0.05, 2 * z, 0.006).moved(sx, height - 0.03, 0)
    return mesh + shapes.bevel_box(2 * x, 0.05, 0.04, 0.006).moved(0, height - 0.03, -z)


def drawer_body():
    """The box of a drawer unit that stands under a desk."""
    return shapes.bevel_box(0.40, 0.56, 0.54, 0.006).moved(0.45, 0.34, -0.02)


def drawer_fronts():
    """Three drawer fronts."""
    mesh = Mesh()
    for y, height in ((0.53, 0.16), (0.36, 0.16), (0.165, 0.21)):
        mesh += shapes.rounded_box(0.39, height - 0.012, 0.022, 0.007, 1).moved(0.45, y, 0.262)
    return mesh


def drawer_handles():
    """Bow handles on the drawers."""
    bow = [(-0.06, 0, 0)] + [(x, 0, 0.028) for x in (-0.055, -0.03, 0.03, 0.055)] + [(0.06, 0, 0)]
    handle = shapes.sweep(bow, 0.005, 8)
    mesh = Mesh()
    for y in (0.56, 0.39, 0.21):
        mesh += handle.moved(0.45, y, 0.273)
    return mesh


def chair_seat():
    """The cushion of a swivel chair that faces -z."""
    pad = shapes.rounded_box(0.50, 0.09, 0.48, 0.042, 3)

    def dish(p):
        return (p[0], p[1] + 0.25 * p[0] ** 2 - 0.3 * max(0.0, -p[2] - 0.12) ** 2, p[2])
    return deformed(pad, dish).moved(0, 0.47, 0)


def chair_back():
    """The bent backrest."""
    pad = shapes.rounded_box(0.46, 0.58, 0.07, 0.033, 3)

    def bend(p):
        return (p[0] * (1 - 0.25 * max(0.0, p[1])), p[1],
                p[2] - 0.7 * p[0] ** 2 + 0.25 * p[1] ** 2)
    return deformed(pad, bend).turned("x", 8).moved(0, 0.88, 0.27)


def chair_arms():
    """Two armrests with their supports, and the bar that bears the back."""
    mesh = Mesh()
    for side in (-1, 1):
        path = [(side * x, y, 0.03) for x, y in
                ((0.1, 0.41), (0.26, 0.41), (0.295, 0.43), (0.305, 0.48), (0.305, 0.67))]
        mesh += shapes.sweep(path, 0.014, 8)
        mesh += shapes.rounded_box(0.07, 0.03, 0.26, 0.014).moved(side * 0.305, 0.685, 0)
    spine = [(0, 0.41, 0.0), (0, 0.41, 0.24), (0, 0.44, 0.29), (0, 0.60, 0.32), (0, 0.82, 0.31)]
    return mesh + shapes.sweep(spine, 0.02, 10)


def chair_base():
    """The five-star foot and the gas spring."""
    column = [(0.0, 0.07), (0.055, 0.07), (0.06, 0.10), (0.045, 0.15), (0.03, 0.17), (0.03, 0.27),
              (0.02, 0.28), (0.02, 0.40), (0.09, 0.41), (0.09, 0.43), (0, 0.43)]
    mesh = shapes.lathe(column, 20)
    leg = [(0.03, 0.115, 0), (0.12, 0.105, 0), (0.24, 0.085, 0), (0.31, 0.075, 0), (0.325, 0.073, 0)]
    for i in range(5):
        star = shapes.sweep(leg, [0.03, 0.027, 0.022, 0.018, 0.001], 8)
        mesh += star.turned("y", 72 * i)
    return mesh


def castor():
    """A twin-wheeled castor, its pin at the origin's x and z."""
    wheel = shapes.lathe([(0, -0.009), (0.022, -0.009), (0.027, -0.006), (0.027, 0.006),
                          (0.022, 0.009), (0, 0.009)], 16, 50).turned("z", 90)
    mesh = wheel.moved(-0.014, 0.027, 0.012) + wheel.moved(0.014, 0.027, 0.012)
    mesh += shapes.rounded_box(0.014, 0.03, 0.045, 0.006, 1).moved(0, 0.042, 0.008)
    return mesh + shapes.cylinder(0.007, 0.05, 8).moved(0, 0.03, 0)


def bookcase():
    """Sides, boards and back of a bookcase."""
    depth, height = 0.30, 2.0
    mesh = shapes.box(STOCK, height, 0.01).moved(0, height / 2, -depth / 2 + 0.005)
    for x in (-STOCK / 2, STOCK / 2):
        mesh += shapes.bevel_box(0.03, height, depth, 0.004).moved(x, height / 2, 0)
    for y in SHELVES:
        mesh += shapes.bevel_box(STOCK - 0.03, 0.025, depth, 0.004).moved(0, y, 0)
    return mesh


def round_table():
    """Top of a meeting table."""
    return shapes.lathe([(0, 0.70), (0.52, 0.70), (0.548, 0.708), (0.555, 0.72), (0.548, 0.732),
                         (0.53, 0.735), (0, 0.735)], 48, 35)


def round_table_foot():
    """Trumpet foot of a meeting table."""
    return shapes.lathe([(0, 0), (0.30, 0), (0.30, 0.012), (0.20, 0.03), (0.08, 0.07), (0.04, 0.15),
                         (0.035, 0.55), (0.06, 0.66), (0.16, 0.70)], 32, 60)


def stool_seat():
    """A round cushion."""
    return shapes.lathe([(0, 0.40), (0.17, 0.40), (0.19, 0.415), (0.195, 0.44), (0.185, 0.465),
                         (0.15, 0.48), (0, 0.485)], 32, 60)


def stool_legs():
    """Four splayed legs and a foot ring."""
    mesh = Mesh()
    for i in range(4):
        leg = shapes.sweep([(0.22, 0, 0), (0.13, 0.41, 0)], [0.012, 0.018], 10)
        mesh += leg.turned("y", 45 + 90 * i)
    ring = [(0.19 * math.cos(a), 0.15, 0.19 * math.sin(a))
            for a in (2 * math.pi * i / 32 for i in range(32))]
    return mesh + shapes.sweep(ring, 0.008, 6, closed=True)


def floor_lamp_stand():
    """Foot and pole of an uplighter."""
    return shapes.lathe([(0, 0), (0.15, 0), (0.15, 0.015), (0.13, 0.03), (0.02, 0.045),
                         (0.014, 0.06), (0.014, 1.66), (0.03, 1.68)], 24)


def floor_lamp_bowl():
    """The bowl of an uplighter, inside and outside."""
    return shapes.lathe([(0.03, 1.67), (0.10, 1.69), (0.16, 1.75), (0.19, 1.83), (0.185, 1.83),
                         (0.15, 1.755), (0.09, 1.70), (0, 1.695)], 32, 60)


def pendant_rod():
    """Rose and cord of a pendant that hangs from y = 0."""
    rose = shapes.lathe([(0.012, -0.05), (0.055, -0.03), (0.06, 0)], 20)
    cord = shapes.sweep([(0, -0.04, 0), (0, -0.42, 0)], 0.004, 6)
    cap = shapes.lathe([(0.05, -0.44), (0.045, -0.41), (0.01, -0.39)], 20)
    return rose + cord + cap


def pendant_globe():
    """The milky globe of a pendant."""
    return shapes.sphere(0.14, 32, 16).moved(0, -0.57, 0)


def desk_lamp_stand():
    """Foot, two arms and joints of a desk lamp that leans towards +z."""
    mesh = shapes.lathe([(0, 0), (0.085, 0), (0.085, 0.012), (0.075, 0.02), (0.015, 0.025),
                         (0, 0.03)], 28, 30)
    joints = [(0, 0.03, 0), (0, 0.33, -0.10), (0, 0.47, 0.13)]
    for side in (-0.012, 0.012):
        for start, end in zip(joints, joints[1:]):
            mesh += shapes.sweep([(side, start[1], start[2]), (side, end[1], end[2])], 0.005, 8)
    for joint in joints:
        mesh += shapes.sphere(0.018, 16, 8).moved(*joint)
    return mesh


def desk_lamp_shade():
    """The shade with its inside, at the end of the arms."""
    return shapes.lathe([(0.085, -0.10), (0.045, -0.02), (0.028, 0.0), (0.025, 0.04), (0.0, 0.045)],
                        28, 35).moved(0, 0.46, 0.15) + shapes.lathe(
        [(0.0, 0.0), (0.025, 0.0), (0.043, -0.02), (0.083, -0.10), (0.085, -0.10)],
        28, 35).moved(0, 0.46, 0.15)


def desk_lamp_bulb():
    """The bulb below the shade's neck."""
    return shapes.sphere(0.026, 16, 10).moved(0, 0.42, 0.15)


def coat_stand():
    """A turned pole on four feet with hooks."""
    mesh = shapes.lathe([(0.03, 0.08), (0.035, 0.2), (0.02, 0.3), (0.02, 1.6), (0.03, 1.66),
                         (0.015, 1.72), (0.03, 1.76), (0.0, 1.79)], 16, 60)
    for i in range(4):
        foot = [(0.0, 0.2, 0), (0.1, 0.17, 0), (0.2, 0.08, 0), (0.26, 0.015, 0)]
        hook = [(0.0, 1.5, 0), (0.07, 1.5, 0), (0.13, 1.56, 0), (0.14, 1.63, 0), (0.13, 1.66, 0)]
        mesh += shapes.sweep(foot, [0.022, 0.02, 0.017, 0.012], 8).turned("y", 90 * i)
        mesh += shapes.sweep(hook, [0.012, 0.011, 0.01, 0.009, 0.012], 8).turned("y", 45 + 90 * i)
    return mesh
