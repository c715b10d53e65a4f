# SPDX-License-Identifier: Apache-2.0
"""Small things on and around the desks; they stand on y = 0 and face +z."""

import math
import random

from . import shapes, vector
from .mesh import Mesh
from .office_furniture import SHELVES, STOCK


def monitor_shell():
    """Housing and foot of a monitor."""
    mesh = shapes.rounded_box(0.58, 0.35, 0.03, 0.012).moved(0, 0.33, 0)
    mesh += shapes.rounded_box(0.26, 0.2, 0.03, 0.012, 1).moved(0, 0.33, -0.024)
    neck = [(0, 0.01, -0.05), (0, 0.12, -0.065), (0, 0.24, -0.06), (0, 0.32, -0.03)]
    mesh += shapes.sweep(neck, 0.02, 12)
    return mesh + shapes.rounded_box(0.26, 0.014, 0.19, 0.006).moved(0, 0.007, -0.03)


def screen(width=0.55, height=0.32):
    """The lit area of a monitor."""
    return shapes.rectangle(width, height).moved(0, 0.33, 0.0155)


def screen_windows():
    """Two pale windows on the screen."""
    mesh = shapes.rectangle(0.27, 0.24).moved(-0.11, 0.335, 0.016)
    mesh += shapes.rectangle(0.18, 0.13).moved(0.155, 0.39, 0.016)
    return mesh + shapes.rectangle(0.55, 0.014).moved(0, 0.178, 0.016)


def screen_text():
    """Lines of text and a bar chart in the windows."""
    source = random.Random("text")
    mesh = Mesh()
    for line in range(13):
        x = -0.235
        while x < -0.02:
            word = source.uniform(0.012, 0.045)
            mesh += shapes.rectangle(word, 0.006).moved(x + word / 2, 0.44 - 0.0165 * line, 0.0165)
            x += word + 0.008
            if source.random() < 0.08:
                break
    for i in range(7):
        height = source.uniform(0.02, 0.1)
        mesh += shapes.rectangle(0.014, height).moved(
            0.09 + 0.022 * i, 0.335 + height / 2, 0.0165)
    return mesh


def keyboard_body():
    """The board under the keys."""
    return shapes.rounded_box(0.45, 0.018, 0.15, 0.008, 1).moved(0, 0.009, 0)


def keyboard_keys():
    """Six rows of keys with a space bar."""
    rows = ([1] * 16, [1] * 14 + [2], [1.5] + [1] * 13 + [1.5], [1.75] + [1] * 12 + [2.25],
            [2.25] + [1] * 11 + [2.75], [1.25, 1.25, 1.25, 6.25, 1.25, 1.25, 1.25, 2.25])
    pitch = 0.0268
    mesh = Mesh()
    for row, widths in enumerate(rows):
        x = -8 * pitch
        for units in widths:
            width = units * pitch
            key = shapes.bevel_box(width - 0.003, 0.012, 0.0195, 0.003)
            mesh += key.moved(x + width / 2, 0.0215, -0.056 + 0.0224 * row)
            x += width
    return mesh


def mouse():
    """A computer mouse."""
    dome = [(0.0, 0.0), (0.97, 0.0)] + shapes.arc((0, 0), 1.0, 4, 90, 9)[:-1] + [(0.0, 1.0)]
    body = shapes.lathe(dome, 24, 60).scaled(0.031, 0.034, 0.055)
    wheel = shapes.cylinder(0.008, 0.007, 16).turned("z", 90).moved(0.0035, 0.030, -0.025)
    return body + wheel


def mug():
    """A mug with its handle, inside and outside."""
    wall = [(0, 0), (0.034, 0), (0.039, 0.004), (0.041, 0.02), (0.041, 0.09), (0.0395, 0.093),
            (0.038, 0.09), (0.037, 0.012), (0.033, 0.007), (0, 0.006)]
    ear = [(0.039, 0.072, 0)] + [(0.046 + 0.027 * math.cos(math.radians(a)),
                                  0.047 + 0.027 * math.sin(math.radians(a)), 0)
                                 for a in range(75, -76, -15)] + [(0.039, 0.022, 0)]
    return shapes.lathe(wall, 32) + shapes.sweep(ear, 0.0055, 8)


def coffee():
    """What is in the mug."""
    return shapes.disc(0.0375, 24).moved(0, 0.075, 0)


def carafe():
    """A thick-walled water carafe, closed inside and outside."""
    outer = [(0, 0), (0.045, 0), (0.052, 0.004), (0.062, 0.03), (0.064, 0.07), (0.056, 0.12),
             (0.038, 0.165), (0.026, 0.20), (0.025, 0.23), (0.034, 0.265)]
    inner = [(0.030, 0.266), (0.0215, 0.23), (0.0225, 0.20), (0.034, 0.163), (0.052, 0.118),
             (0.060, 0.07), (0.058, 0.032), (0.049, 0.009), (0, 0.008)]
    return shapes.lathe(outer + inner, 40, 60)


def tumbler():
    """A thin drinking glass."""
    return shapes.lathe([(0, 0.004), (0.027, 0.004), (0.030, 0.008), (0.036, 0.10)], 32)


def pencil_pot():
    """An open pot."""
    return shapes.lathe([(0, 0), (0.04, 0), (0.042, 0.003), (0.042, 0.098), (0.040, 0.10),
                         (0.038, 0.098), (0.038, 0.006), (0, 0.005)], 24)


def pencils():
    """Sharpened pencils that lean in the pot."""
    source = random.Random("pencils")
    pencil = shapes.lathe([(0, 0), (0.0038, 0), (0.0038, 0.15), (0.001, 0.168), (0, 0.17)], 6, 10)
    mesh = Mesh()
    for i in range(7):
        mesh += pencil.turned("x", source.uniform(4, 13)).moved(0, 0.01, 0).turned("y", 51 * i)
    return mesh


def book(thick, tall, deep):
    """The cover of an upright book whose rounded spine faces +z."""
    mesh = shapes.rounded_box(thick, tall, 0.012, min(0.006, thick / 2 - 0.001), 1)
    mesh = mesh.moved(0, tall / 2, deep / 2)
    for side in (-1, 1):
        board = shapes.box(0.003, tall, deep).moved(side * (thick / 2 - 0.0015), tall / 2, 0)
        mesh += board
    return mesh


def books():
    """(covers by colour number 0..4, pages) of all books in the bookcase."""
    source = random.Random("books")
    covers, pages = [Mesh() for _ in range(5)], Mesh()
    for shelf, y in enumerate(SHELVES[:-1]):
        x = -STOCK / 2 + 0.03
        end = STOCK / 2 - source.uniform(0.15, 0.5)
        while x < end:
            thick, tall, deep = (source.uniform(*r) for r in
                                 ((0.02, 0.055), (0.20, 0.31), (0.15, 0.21)))
            lean = 9 if source.random() < 0.06 else 0
            at = (x + thick / 2 + 0.2 * math.sin(math.radians(lean)) * 0.5, y + 0.0135, 0.0)
            cover = book(thick, tall, deep).turned("z", -lean)
            block = shapes.box(thick - 0.007, tall - 0.008, deep).moved(0, tall / 2, -0.002)
            covers[source.randrange(5)] += cover.moved(*at)
            pages += block.turned("z", -lean).moved(*at)
            x += thick + 0.002 + (0.05 if lean else 0)
    return covers, pages


def binders(colour):
    """A row of ring binders; colour 0 gives the bodies, 1 the labels."""
    mesh = Mesh()
    for i in range(4):
        body = shapes.bevel_box(0.07, 0.31, 0.26, 0.004).moved(0.075 * i, 0.155, 0)
        label = shapes.rectangle(0.05, 0.12).moved(0.075 * i, 0.2, 0.1305)
        mesh += label if colour else body
    return mesh


def plant_pot(radius=0.17):
    """A tapered pot with a rim."""
    return shapes.lathe([(0, 0), (radius * 0.7, 0), (radius * 0.92, 0.24), (radius, 0.24),
                         (radius, 0.29), (radius * 0.9, 0.29), (radius * 0.85, 0.25)], 32)


def soil(radius=0.17):
    """The soil in the pot."""
    return shapes.disc(radius * 0.88, 32).moved(0, 0.26, 0)


def leaf(length, width, droop):
    """One arching leaf along +x with a folded middle (a single, double-sided layer)."""
    steps = 8
    rows = []
    for i in range(steps + 1):
        s = i / steps
        x, y = length * s * (1 - 0.18 * s), length * (0.75 * s - droop * s * s)
        w = width * math.sin(math.pi * min(1.0, 0.04 + s * 0.955)) ** 0.8
        rows.append([(x, y + 0.25 * w, w), (x, y, 0), (x, y + 0.25 * w, -w)])
    flat = [[(0.0, 1.0, 0.0)] * 3] * (steps + 1)
    return shapes.grid(rows[::-1], flat).smooth()


def leaves(count=34, spread=1.0, seed="leaves"):
    """A bush of leaves that springs from the pot, their stems included."""
    source = random.Random(seed)
    mesh = Mesh()
    for i in range(count):
        rise = i / count
        length = spread * source.uniform(0.34, 0.52) * (1.15 - 0.45 * rise)
        droop = 1.0 - 0.75 * rise + source.uniform(-0.1, 0.1)
        blade = leaf(length, 0.055 * spread, droop).turned("z", 20 * rise)
        turn = 137.5 * i + source.uniform(-12, 12)
        high = 0.28 + 0.55 * rise * spread
        stem = [(0, 0.24, 0), (0.02, 0.12 + high * 0.5, 0), (0.05, high, 0)]
        mesh += (blade.moved(0.05, high, 0) + shapes.sweep(stem, 0.006, 5)).turned("y", turn)
    return mesh


def waste_bin():
    """An open bin, inside and outside."""
    return shapes.lathe([(0, 0), (0.11, 0), (0.14, 0.29), (0.147, 0.295), (0.147, 0.305),
                         (0.137, 0.305), (0.107, 0.008), (0, 0.006)], 32)


def paper_ball(seed):
    """A crumpled sheet."""
    source = random.Random(seed)
    moved = {}
    mesh = Mesh()
    corners = shapes.sphere(0.045, 10, 7).corners
    for i in range(0, len(corners), 3):
        points = []
        for p, _, _ in corners[i:i + 3]:
            key = tuple(round(x, 6) + 0.0 for x in p)
            moved.setdefault(key, vector.mul(p, source.uniform(0.72, 1.1)))
            points.append(moved[key])
        mesh.triangle(points)
    return mesh.moved(0, 0.04, 0)


def paper_stack():
    """Sheets that do not lie quite straight."""
    source = random.Random("paper")
    mesh = Mesh()
    for i in range(9):
        sheet = shapes.box(0.21, 0.0025, 0.297).turned("y", source.uniform(-5, 5))
        mesh += sheet.moved(source.uniform(-0.006, 0.006), 0.0015 + 0.003 * i, 0)
    return mesh


def telephone():
    """Body and receiver."""
    def slope(p):
        return (p[0], p[1] * (1 - 1.6 * p[2]), p[2])
    body = shapes.rounded_box(0.18, 0.06, 0.20, 0.012).moved(0, 0.03, 0)
    mesh = Mesh((slope(p), n, t) for p, n, t in body.corners).smooth()
    grip = [(-0.055, 0.055, 0.085), (-0.055, 0.09, 0.06), (-0.055, 0.105, 0.0),
            (-0.055, 0.105, -0.05), (-0.055, 0.085, -0.085)]
    mesh += shapes.sweep(grip, [0.022, 0.02, 0.014, 0.02, 0.022], 12)
    for z in (0.085, -0.085):
        mesh += shapes.sphere(0.027, 16, 8).moved(-0.055, 0.075, z)
    return mesh


def telephone_keys():
    """Twelve keys on the telephone's slope."""
    mesh = Mesh()
    for i in range(12):
        key = shapes.bevel_box(0.017, 0.012, 0.013, 0.003).turned("x", 5)
        z = -0.03 + 0.024 * (i // 3)
        mesh += key.moved(0.015 + 0.024 * (i % 3), 0.061 * (1 - 1.6 * z), z)
    return mesh


def computer():
    """A tower with feet, slots and a button."""
    mesh = shapes.rounded_box(0.18, 0.40, 0.42, 0.012).moved(0, 0.22, 0)
    for x in (-0.06, 0.06):
        for z in (-0.16, 0.16):
            mesh += shapes.cylinder(0.015, 0.022, 12).moved(x, 0, z)
    for i in range(9):
        mesh += shapes.bevel_box(0.13, 0.006, 0.008, 0.002).moved(0, 0.08 + 0.014 * i, 0.21)
    return mesh + shapes.cylinder(0.012, 0.006, 16).turned("x", 90).moved(0, 0.38, 0.209)


def cable(points, radius=0.004):
    """A cable along a smoothed path."""
    for _ in range(2):
        finer = [points[0]]
        for a, b in zip(points, points[1:]):
            finer += [vector.add(vector.mul(a, 0.75), vector.mul(b, 0.25)),
                      vector.add(vector.mul(a, 0.25), vector.mul(b, 0.75))]
        points = finer + [points[-1]]
    return shapes.sweep(points, radius, 6)


def power_strip():
    """A multiple socket."""
    mesh = shapes.rounded_box(0.34, 0.045, 0.06, 0.01, 1).moved(0, 0.0225, 0)
    for i in range(5):
        mesh += shapes.lathe([(0.022, 0.045), (0.022, 0.048), (0.018, 0.048), (0.017, 0.046)],
                             16).moved(-0.12 + 0.06 * i, 0, 0)
    return mesh


def rug(radius=1.15):
    """A round rug; three rings are made by calling it with smaller radii."""
    return shapes.lathe([(radius, 0), (radius - 0.01, 0.012), (0, 0.014)], 64, 60)


def umbrella():
    """A furled umbrella."""
    folded = shapes.lathe([(0.006, 0.03), (0.022, 0.2), (0.034, 0.55), (0.02, 0.6), (0.008, 0.62)],
                          16, 60)
    stick = [(0, 0, 0), (0, 0.74, 0), (0.01, 0.79, 0), (0.035, 0.81, 0), (0.06, 0.79, 0),
             (0.065, 0.75, 0)]
    return folded + shapes.sweep(stick, 0.007, 8)
