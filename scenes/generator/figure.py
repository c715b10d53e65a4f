# SPDX-License-Identifier: Apache-2.0
"""A person of one skinned mesh, with joints, soft weights and a few gaits."""

import math

from . import shapes, vector
from .mesh import Mesh
from .vector import turn

# Joints as (name, parent, place at rest, end of the bone that it moves).
JOINTS = (
    ("hips", None, (0, 0.95, 0), (0, 1.06, 0)),
    ("spine", "hips", (0, 1.06, 0), (0, 1.22, 0)),
    ("chest", "spine", (0, 1.22, 0), (0, 1.44, 0)),
    ("neck", "chest", (0, 1.46, 0), (0, 1.55, 0)),
    ("head", "neck", (0, 1.55, 0), (0, 1.76, 0)),
    ("left arm", "chest", (0.185, 1.40, 0), (0.275, 1.13, -0.015)),
    ("left forearm", "left arm", (0.275, 1.13, -0.015), (0.335, 0.89, 0.02)),
    ("left hand", "left forearm", (0.335, 0.89, 0.02), (0.355, 0.77, 0.03)),
    ("right arm", "chest", (-0.185, 1.40, 0), (-0.275, 1.13, -0.015)),
    ("right forearm", "right arm", (-0.275, 1.13, -0.015), (-0.335, 0.89, 0.02)),
    ("right hand", "right forearm", (-0.335, 0.89, 0.02), (-0.355, 0.77, 0.03)),
    ("left thigh", "hips", (0.10, 0.92, 0), (0.105, 0.50, 0.015)),
    ("left shin", "left thigh", (0.105, 0.50, 0.015), (0.11, 0.09, -0.02)),
    ("left foot", "left shin", (0.11, 0.09, -0.02), (0.115, 0.03, 0.16)),
    ("right thigh", "hips", (-0.10, 0.92, 0), (-0.105, 0.50, 0.015)),
    ("right shin", "right thigh", (-0.105, 0.50, 0.015), (-0.11, 0.09, -0.02)),
    ("right foot", "right shin", (-0.11, 0.09, -0.02), (-0.115, 0.03, 0.16)),
)
NAMES = [joint[0] for joint in JOINTS]
TRUNK = ("hips", "spine", "chest")


def mirrored(mesh):
    """The same on the other side."""
    return mesh.scaled(-1, 1, 1)


def tapered(points, radii, steps, sides=20):
    """A tube through points, rounded off at both ends, with rings close enough to bend."""
    path, sizes = [], []
    for i in range(steps + 1):
        t = i / steps * (len(points) - 1)
        k = min(int(t), len(points) - 2)
        path.append(tuple(points[k][c] + (points[k + 1][c] - points[k][c]) * (t - k) for c in range(3)))
        sizes.append(radii[k] + (radii[k + 1] - radii[k]) * (t - k))
    begin = vector.unit(vector.sub(path[0], path[1]))
    end = vector.unit(vector.sub(path[-1], path[-2]))
    caps = [(math.sin(a), math.cos(a)) for a in (math.pi / 2 * i / 4 for i in range(1, 5))]
    head = [(vector.add(path[0], vector.mul(begin, sizes[0] * s)), max(sizes[0] * c, 1e-4)) for s, c in caps]
    tail = [(vector.add(path[-1], vector.mul(end, sizes[-1] * s)), max(sizes[-1] * c, 1e-4)) for s, c in caps]
    rings = head[::-1] + list(zip(path, sizes)) + tail
    return shapes.sweep([ring[0] for ring in rings], [ring[1] for ring in rings], sides).smooth()


def trunk(profile):
    """A body of revolution, flattened from front to back."""
    fine = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        fine += [(r0 + (r1 - r0) * i / 4, y0 + (y1 - y0) * i / 4) for i in range(4)]
    return shapes.lathe(fine + [profile[-1]], 28, 180).scaled(1, 1, 0.66)


def parts():
    """(material, geometry, joints that may move it) of all parts."""
    leg = tapered([(0.10, 0.90, 0), (0.105, 0.50, 0.015), (0.11, 0.12, -0.015)], [0.092, 0.066, 0.05], 22)
    shoe = shapes.rounded_box(0.095, 0.08, 0.27, 0.035, 3).moved(0.115, 0.045, 0.045)
    sleeve = tapered([(0.175, 1.395, 0), (0.275, 1.13, -0.015), (0.318, 0.96, 0.008)], [0.062, 0.05, 0.042], 16)
    hand = tapered([(0.330, 0.91, 0.017), (0.352, 0.80, 0.028)], [0.029, 0.036], 5, 14)
    left_leg, left_arm = ("hips", "left thigh", "left shin"), ("chest", "left arm", "left forearm")
    out = [("trousers", trunk([(0.0, 0.80), (0.13, 0.83), (0.165, 0.92), (0.152, 1.02), (0.0, 1.04)]), TRUNK),
           ("shirt", trunk([(0.0, 0.96), (0.160, 0.97), (0.146, 1.10), (0.176, 1.28), (0.178, 1.38),
                            (0.11, 1.455), (0.0, 1.47)]), TRUNK),
           ("skin", tapered([(0, 1.42, 0), (0, 1.56, 0.01)], [0.056, 0.052], 6), ("chest", "neck", "head")),
           ("skin", shapes.sphere(0.112, 32, 20).scaled(0.86, 1.12, 0.98).moved(0, 1.655, 0.015), ("head",)),
           ("skin", shapes.sphere(0.018, 12, 8).scaled(0.9, 1.3, 1.2).moved(0, 1.645, 0.125), ("head",)),
           ("hair", shapes.sphere(0.118, 32, 20).scaled(0.89, 1.05, 0.98).moved(0, 1.692, -0.012), ("head",))]
    for x in (-0.038, 0.038):
        out.append(("dark", shapes.sphere(0.0135, 12, 8).moved(x, 1.668, 0.115), ("head",)))
    for side, flip in (("left", lambda m: m), ("right", mirrored)):
        rename = [tuple(n.replace("left", side) for n in names) for names in
                  (left_leg, left_arm, ("left forearm", "left hand"), ("left foot",))]
        out += [("trousers", flip(leg), rename[0]), ("shirt", flip(sleeve), rename[1]),
                ("skin", flip(hand), rename[2]), ("dark", flip(shoe), rename[3])]
    return out


def distance_to_bone(p, joint):
    """From a point to the bone that the joint moves."""
    a, b = JOINTS[joint][2:]
    along = vector.sub(b, a)
    t = max(0.0, min(1.0, vector.dot(vector.sub(p, a), along) / vector.dot(along, along)))
    off = vector.sub(p, vector.add(a, vector.mul(along, t)))
    return math.sqrt(vector.dot(off, off))


def influences(p, names):
    """Up to four (joint, weight) of a vertex that these joints may move: near bones count most."""
    joints = [NAMES.index(name) for name in names]
    weights = [(j, 1 / max(distance_to_bone(p, j), 0.01) ** 6) for j in joints]
    total = sum(w for _, w in weights)
    kept = [(j, w / total) for j, w in sorted(weights, key=lambda jw: -jw[1])[:4] if w > 0.01 * total]
    total = sum(w for _, w in kept)
    return [(j, w / total) for j, w in kept]


def person_mesh(doc, paint):
    """One mesh with a primitive a material; returns its index."""
    by_material = {}
    for material, geometry, names in parts():
        geometry = Mesh(geometry.corners)
        by_material.setdefault(material, []).append((geometry, names))
    primitives = []
    for material, pieces in by_material.items():
        primitives.append((paint[material], [(g, lambda p, n=n: influences(p, n)) for g, n in pieces]))
    return doc.skinned_mesh("person", primitives)


def skeleton(doc, name, parent):
    """Nodes of all joints below `parent`; returns (nodes by name, skin)."""
    nodes = {}
    for joint, above, at, _ in JOINTS:
        origin = next(j[2] for j in JOINTS if j[0] == above) if above else (0, 0, 0)
        nodes[joint] = doc.node("%s %s" % (name, joint), parent=nodes[above] if above else parent,
                                at=vector.sub(at, origin))
    skin = doc.skin(name, [nodes[joint] for joint in NAMES], [joint[2] for joint in JOINTS])
    return nodes, skin


def wave(times, rate, phase, middle, reach):
    """A sine over times, in degrees; rate: turns a second."""
    return [middle + reach * math.sin(2 * math.pi * (rate * t + phase)) for t in times]


def swing(channels, node, times, degrees, axis=(1, 0, 0)):
    """A joint that turns about an axis."""
    channels.append((node, "rotation", "LINEAR", times, [turn(axis, d) for d in degrees]))


def knee(times, rate, phase, bend):
    """How far a knee is bent while walking: most as the leg comes forward."""
    return [6 + bend * max(0.0, math.sin(2 * math.pi * (rate * t + phase))) ** 1.5 for t in times]


def walk(channels, nodes, loop, rate):
    """Strides at `rate` a second for `loop` seconds."""
    times = [loop * i / (16 * int(rate * loop)) for i in range(16 * int(rate * loop) + 1)]
    for side, phase in (("left", 0.0), ("right", 0.5)):
        swing(channels, nodes[side + " thigh"], times, wave(times, rate, phase, -4, 26))
        swing(channels, nodes[side + " shin"], times, knee(times, rate, phase + 0.3, 50))
        swing(channels, nodes[side + " foot"], times, wave(times, rate, phase + 0.1, -2, 12))
        swing(channels, nodes[side + " arm"], times, wave(times, rate, phase + 0.5, 2, 24))
        swing(channels, nodes[side + " forearm"], times, wave(times, rate, phase + 0.5, -26, 14))
    swing(channels, nodes["spine"], times, wave(times, rate, 0.0, 0, 5), (0, 1, 0))
    swing(channels, nodes["chest"], times, wave(times, rate, 0.5, 0, 9), (0, 1, 0))
    hips = [(0, 0.93 + 0.018 * math.sin(2 * math.pi * (2 * rate * t + 0.15)), 0) for t in times]
    channels.append((nodes["hips"], "translation", "LINEAR", times, hips))


def greet(channels, nodes, loop):
    """Stands and waves the right hand."""
    times = [loop * i / 48 for i in range(49)]
    channels.append((nodes["right arm"], "rotation", "LINEAR", times,
                     [turn((0, 0, 1), -128 + 5 * math.sin(4 * math.pi * t / loop)) for t in times]))
    channels.append((nodes["right forearm"], "rotation", "LINEAR", times,
                     [turn((0, 0, 1), -24 + 26 * math.sin(12 * math.pi * t / loop)) for t in times]))
    swing(channels, nodes["left arm"], times, wave(times, 1 / loop, 0, 3, 4))
    swing(channels, nodes["head"], times, wave(times, 1 / loop, 0.2, 0, 14), (0, 1, 0))
    swing(channels, nodes["spine"], times, wave(times, 2 / loop, 0.1, 0, 3), (0, 0, 1))
