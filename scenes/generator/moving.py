# SPDX-License-Identifier: Apache-2.0
"""MOVING: a small fairground whose rigid parts move in a loop of four seconds."""

import math

from . import shapes
from .gltf import Document
from .mesh import Mesh
from .vector import turn

LOOP = 4.0


def paints(doc):
    """The materials by name."""
    table = (("grass", (0.22, 0.42, 0.14), 0.95, 0), ("gravel", (0.62, 0.56, 0.46), 0.9, 0),
             ("white", (0.88, 0.86, 0.80), 0.7, 0), ("red", (0.78, 0.10, 0.08), 0.45, 0),
             ("blue", (0.08, 0.25, 0.65), 0.45, 0), ("yellow", (0.95, 0.70, 0.10), 0.5, 0),
             ("wood", (0.45, 0.28, 0.15), 0.7, 0), ("dark", (0.08, 0.08, 0.09), 0.5, 0),
             ("brass", (0.92, 0.72, 0.35), 0.2, 1), ("green", (0.10, 0.40, 0.22), 0.45, 0))
    return {name: doc.material(name, colour, roughness, float(metal))
            for name, colour, roughness, metal in table}


def spin(axis, turns, steps=None):
    """Times and rotations of whole turns about an axis within the loop."""
    steps = steps or 4 * abs(turns)
    times = [LOOP * i / steps for i in range(steps + 1)]
    return times, [turn(axis, 360 * turns * i / steps) for i in range(steps + 1)]


def bob(low, high, phase, x=0.0, z=0.0):
    """Times and cubic spline rows of a smooth rise and fall, twice in the loop."""
    times = [LOOP * i / 8 for i in range(9)]
    rate = math.pi * 2 * 2 / LOOP
    rows = []
    for t in times:
        angle = rate * t + phase
        middle, reach = (low + high) / 2, (high - low) / 2
        slope = (0.0, reach * rate * math.cos(angle), 0.0)
        rows += [slope, (x, middle + reach * math.sin(angle), z), slope]
    return times, rows


def windmill(doc, paint, channels, name, at, scale=None, meshes=None):
    """A mill with turning sails; returns its meshes, to be used again."""
    if meshes is None:
        body = shapes.lathe([(1.05, 0), (0.72, 2.6), (0.78, 2.62), (0.78, 2.74), (0.7, 2.74)], 12, 20)
        cap = shapes.lathe([(0.8, 0), (0.74, 0.3), (0.45, 0.62), (0.0, 0.78)], 24, 60)
        door = shapes.bevel_box(0.5, 0.95, 0.12, 0.03).moved(0, 0.48, 0.93)
        meshes = {"body": doc.mesh("mill body", body, paint["white"]),
                  "cap": doc.mesh("mill cap", cap, paint["red"]),
                  "door": doc.mesh("mill door", door, paint["wood"]),
                  "sails": doc.mesh("mill sails", sails(), paint["wood"]),
                  "cloth": doc.mesh("mill cloth", cloth(), paint["yellow"])}
    mill = doc.node(name, meshes["body"], at=at, scale=scale)
    doc.node(name + " cap", meshes["cap"], parent=mill, at=(0, 2.74, 0))
    doc.node(name + " door", meshes["door"], parent=mill)
    rotor = doc.node(name + " rotor", meshes["sails"], parent=mill, at=(0, 2.95, 0.95))
    doc.node(name + " cloth", meshes["cloth"], parent=rotor)
    channels.append((rotor, "rotation", "LINEAR", *spin((0, 0, 1), 1)))
    return meshes


def sails(length=1.85):
    """The hub, axle and four lattices of a mill."""
    mesh = shapes.cylinder(0.13, 0.5, 16).turned("x", 90).moved(0, 0, -0.38)
    arm = shapes.box(0.07, length, 0.07).moved(0, length / 2, 0)
    for i in range(7):
        arm += shapes.box(0.46, 0.03, 0.03).moved(0.2, 0.45 + 0.22 * i, 0)
    arm += shapes.box(0.03, 1.36, 0.03).moved(0.42, 1.11, 0)
    for i in range(4):
        mesh += arm.turned("z", 90 * i)
    return mesh


def cloth():
    """The canvas of the four sails."""
    mesh = Mesh()
    for i in range(4):
        mesh += shapes.box(0.34, 1.3, 0.012).moved(0.22, 1.11, -0.02).turned("z", 90 * i)
    return mesh


def horse():
    """A simple wooden horse that looks along +x."""
    mesh = shapes.rounded_box(0.62, 0.26, 0.24, 0.10)
    for x in (-0.23, 0.23):
        for z in (-0.07, 0.07):
            mesh += shapes.lathe([(0.03, -0.42), (0.045, -0.38), (0.04, -0.1)], 8).moved(x, 0, z)
    neck = shapes.rounded_box(0.17, 0.42, 0.15, 0.06)
    mesh += neck.turned("z", -35).moved(0.36, 0.22, 0)
    mesh += shapes.rounded_box(0.30, 0.15, 0.13, 0.05).turned("z", -25).moved(0.55, 0.36, 0)
    tail = [(-0.30, 0.05, 0), (-0.40, 0.08, 0), (-0.46, -0.06, 0), (-0.47, -0.25, 0)]
    return mesh + shapes.sweep(tail, [0.03, 0.045, 0.04, 0.01], 8)


def carousel(doc, paint, channels):
    """A turning platform with six horses that rise and fall; returns its node."""
    deck = shapes.lathe([(1.75, 0), (1.85, 0.05), (1.85, 0.18), (1.75, 0.22), (0, 0.22)], 48, 20)
    roof = shapes.lathe([(1.95, 0), (2.0, 0.22), (1.2, 0.55), (0.25, 1.0), (0.0, 1.2)], 12, 10)
    pillar = shapes.lathe([(0.42, 0.2), (0.30, 0.4), (0.30, 2.2), (0.42, 2.4)], 24, 50)
    knob = shapes.sphere(0.12, 24, 12)
    pole = shapes.cylinder(0.02, 2.2, 10)
    centre = doc.node("carousel", at=(-0.3, 0, 0.8))
    table = doc.node("carousel platform", doc.mesh("platform", deck, paint["wood"]), parent=centre)
    channels.append((table, "rotation", "LINEAR", *spin((0, 1, 0), 1)))
    doc.node("carousel roof", doc.mesh("roof", roof, paint["red"]), parent=table, at=(0, 2.4, 0))
    doc.node("carousel pillar", doc.mesh("pillar", pillar, paint["yellow"]), parent=table)
    doc.node("carousel knob", doc.mesh("knob", knob, paint["brass"]), parent=table, at=(0, 3.66, 0))
    pole_mesh = doc.mesh("pole", pole, paint["brass"])
    shape = horse()
    horses = [doc.mesh("horse " + name, shape, paint[name]) for name in ("white", "blue", "green")]
    for i in range(6):
        seat = doc.node("seat %d" % i, pole_mesh, parent=table, at=(0, 0.2, 0),
                        turn=turn((0, 1, 0), 60 * i))
        doc.lists["nodes"][seat]["translation"] = [
            round(1.4 * math.sin(math.radians(60 * i)), 6), 0.2,
            round(1.4 * math.cos(math.radians(60 * i)), 6)]
        ride = doc.node("horse %d" % i, horses[i % 3], parent=seat, at=(0, 0.9, 0))
        channels.append((ride, "translation", "CUBICSPLINE", *bob(0.7, 1.15, math.pi * i / 1.5)))
    return table


def train(doc, paint, channels):
    """A little engine with two wagons on a ring of rails, its wheels turning."""
    radius = 4.3
    rails = Mesh()
    for r in (radius - 0.22, radius + 0.22):
        rails += shapes.lathe([(r - 0.03, 0), (r - 0.03, 0.08), (r + 0.03, 0.08), (r + 0.03, 0)][::-1], 96)
    for i in range(60):
        rails += shapes.box(0.75, 0.05, 0.14).moved(radius, 0.02, 0).turned("y", 6 * i)
    ring = doc.node("railway", at=(-0.3, 0, 0.8))
    doc.node("rails", doc.mesh("rails", rails, paint["dark"]), parent=ring)
    runner = doc.node("train", parent=ring)
    channels.append((runner, "rotation", "LINEAR", *spin((0, 1, 0), 1, 8)))
    wheel = shapes.lathe([(0, -0.03), (0.12, -0.03), (0.14, -0.01), (0.14, 0.02), (0.12, 0.03),
                          (0, 0.03)], 16).turned("z", 90)
    for i in range(3):
        wheel += shapes.box(0.075, 0.22, 0.03).turned("x", 60 * i)
    wheel_mesh = doc.mesh("wheel", wheel, paint["brass"])
    engine, chimney = engine_shapes()
    wagon = shapes.rounded_box(0.62, 0.4, 0.95, 0.06).moved(0, 0.42, 0)
    parts = (("engine", doc.mesh("engine", engine, paint["green"])),
             ("wagon 1", doc.mesh("wagon 1", wagon, paint["blue"])),
             ("wagon 2", doc.mesh("wagon 2", wagon, paint["yellow"])))
    for i, (name, mesh) in enumerate(parts):
        angle = -15.5 * i + 40
        x, z = radius * math.cos(math.radians(angle)), -radius * math.sin(math.radians(angle))
        car = doc.node(name, mesh, parent=runner, at=(x, 0.08, z), turn=turn((0, 1, 0), angle))
        if i == 0:
            doc.node("chimney", doc.mesh("chimney", chimney, paint["brass"]), parent=car)
        for side in (-0.24, 0.24):
            for end in (-0.3, 0.3):
                axle = doc.node("%s wheel" % name, wheel_mesh, parent=car, at=(side, 0.14, end))
                channels.append((axle, "rotation", "LINEAR", *spin((-1, 0, 0), 3)))


def engine_shapes():
    """The body of the engine, which runs towards -z, and its chimney and dome."""
    body = shapes.rounded_box(0.6, 0.14, 1.05, 0.04).moved(0, 0.26, 0)
    body += shapes.cylinder(0.22, 0.62, 24).turned("x", -90).moved(0, 0.52, 0.12)
    body += shapes.rounded_box(0.56, 0.62, 0.36, 0.05).moved(0, 0.60, 0.32)
    body += shapes.bevel_box(0.7, 0.06, 0.5, 0.02).moved(0, 0.94, 0.32)
    chimney = shapes.lathe([(0.07, 0.68), (0.06, 0.95), (0.11, 1.05), (0.09, 1.05), (0.05, 0.9)], 16)
    chimney = chimney.moved(0, 0, -0.36) + shapes.sphere(0.1, 16, 8).moved(0, 0.75, -0.05)
    return body, chimney


def balloon(doc, paint, channels):
    """A balloon that drifts, with a basket below it."""
    bag = shapes.lathe([(0.14, 0), (0.35, 0.3), (0.72, 0.85), (0.80, 1.25), (0.66, 1.65),
                        (0.36, 1.9), (0.0, 1.98)], 24, 70)
    band = shapes.lathe([(0.795, 1.02), (0.815, 1.25), (0.772, 1.42)], 24, 70)
    basket = shapes.bevel_box(0.34, 0.26, 0.34, 0.03).moved(0, -0.55, 0)
    for x in (-0.13, 0.13):
        for z in (-0.13, 0.13):
            basket += shapes.sweep([(x, -0.45, z), (x * 0.95, 0.04, z * 0.95)], 0.012, 6)
    node = doc.node("balloon", doc.mesh("balloon", bag, paint["blue"]), at=(3.3, 3.3, -2.2))
    doc.node("balloon band", doc.mesh("balloon band", band, paint["yellow"]), parent=node)
    doc.node("basket", doc.mesh("basket", basket, paint["wood"]), parent=node)
    channels.append((node, "translation", "CUBICSPLINE", *bob(3.1, 3.7, 0.0, 3.3, -2.2)))


def bouncing_ball(doc, paint, channels):
    """A ball that hops and is squashed (unevenly scaled) on the ground."""
    ball = doc.node("ball", doc.mesh("ball", shapes.sphere(0.3, 32, 16).moved(0, 0.3, 0),
                                     paint["red"]), at=(1.7, 0, 3.6))
    times, rows = [], []
    for i in range(9):
        times.append(i * LOOP / 8)
        up = i % 2
        # The path leaves and meets the ground at speed; both tangents are given.
        before, after = ((0, 0, 0), (0, 0, 0)) if up else ((0, -4.2, 0), (0, 4.2, 0))
        rows += [before, (1.7, 1.05 * up, 3.6), after]
    channels.append((ball, "translation", "CUBICSPLINE", times, rows))
    squash = [(1.2, 0.65, 1.2), (0.93, 1.15, 0.93), (1.0, 1.0, 1.0), (0.93, 1.15, 0.93)]
    channels.append((ball, "scale", "LINEAR", [i * LOOP / 16 for i in range(17)],
                     [squash[i % 4] for i in range(17)]))


def lanterns(doc, paint, channels):
    """Two posts whose glowing heads jump between sizes (stepped scale)."""
    glow = doc.material("lantern glow", (0.9, 0.7, 0.4), 0.6, emissive=(1.0, 0.72, 0.35))
    post = doc.mesh("lantern post", shapes.lathe(
        [(0.16, 0), (0.16, 0.06), (0.05, 0.16), (0.04, 1.9), (0.10, 1.96)], 12, 30), paint["dark"])
    head = doc.mesh("lantern head", shapes.rounded_box(0.24, 0.34, 0.24, 0.06), glow)
    for i, at in enumerate(((-4.9, 0, 4.4), (4.6, 0, 1.0))):
        stand = doc.node("lantern post %d" % i, post, at=at)
        lamp = doc.node("lantern %d" % i, head, parent=stand, at=(0, 2.12, 0))
        sizes = [(1, 1, 1), (1.5, 0.8, 1.5), (0.7, 1.4, 0.7), (1.2, 1.2, 1.2), (1, 1, 1)]
        shift = sizes[:-1][i:] + sizes[:-1][:i]
        channels.append((lamp, "scale", "STEP", [float(k) for k in range(5)],
                         shift + shift[:1]))


def ground(doc, paint):
    """A round meadow with a gravel ring under the railway."""
    meadow = shapes.lathe([(14, -0.3), (13, -0.02), (0, -0.02)], 64, 20)
    doc.node("meadow", doc.mesh("meadow", meadow, paint["grass"]))
    gravel = shapes.lathe([(4.95, -0.02), (4.8, 0.015), (3.8, 0.015), (3.65, -0.02)], 64)
    doc.node("gravel", doc.mesh("gravel", gravel, paint["gravel"]), at=(-0.3, 0, 0.8))
    square = shapes.lathe([(2.5, -0.02), (2.45, 0.01), (0, 0.01)], 48)
    doc.node("square", doc.mesh("square", square, paint["gravel"]), at=(-0.3, 0, 0.8))


def build():
    """The finished document."""
    doc = Document()
    paint = paints(doc)
    fair, drift = [], []
    doc.camera("camera", (3.4, 3.2, 8.9), (-0.3, 1.45, 0.0), 46)
    ground(doc, paint)
    table = carousel(doc, paint, fair)
    train(doc, paint, fair)
    mill = windmill(doc, paint, fair, "mill", (-4.6, 0, -4.2))
    windmill(doc, paint, fair, "mirrored mill", (1.6, 0, -5.2), (-0.8, 0.8, 0.8), mill)
    bouncing_ball(doc, paint, fair)
    lanterns(doc, paint, fair)
    balloon(doc, paint, drift)
    doc.animation("fairground", fair)
    doc.animation("balloon", drift)
    doc.light("sun", "directional", 2.7, (1.0, 0.92, 0.80), direction=(-0.55, -0.85, -0.62))
    doc.light("sky", "directional", 0.9, (0.65, 0.80, 1.0), direction=(0.7, -0.6, -0.35))
    doc.camera("rider", (0.45, 1.75, 0.95), (-1.6, 1.25, 1.9), 62, parent=table)
    return doc
