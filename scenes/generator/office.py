# SPDX-License-Identifier: Apache-2.0
"""OFFICE: three desks with their chairs and clutter, in the evening."""

import math

from . import office_furniture as furniture
from . import office_room as room
from . import office_things as things
from .gltf import Document
from .texture import png
from .vector import turn

BACK, LEFT, RIGHT = -room.DEPTH / 2, -room.WIDTH / 2, room.WIDTH / 2
BOOK_COLOURS = ((0.55, 0.10, 0.09), (0.10, 0.24, 0.42), (0.85, 0.62, 0.18),
                (0.14, 0.36, 0.24), (0.78, 0.74, 0.66))
# name: (colour, roughness, metallic, emissive)
PAINTS = {
    "oak 0": ((0.50, 0.32, 0.18), 0.22, 0, None), "oak 1": ((0.44, 0.27, 0.14), 0.25, 0, None),
    "oak 2": ((0.56, 0.37, 0.22), 0.2, 0, None), "wall": ((0.80, 0.78, 0.72), 0.95, 0, None),
    "back wall": ((0.42, 0.56, 0.58), 0.95, 0, None), "ceiling": ((0.88, 0.88, 0.86), 0.95, 0, None),
    "white": ((0.85, 0.85, 0.83), 0.4, 0, None), "birch": ((0.74, 0.58, 0.38), 0.12, 0, None),
    "walnut": ((0.26, 0.15, 0.09), 0.3, 0, None), "steel": ((0.62, 0.63, 0.65), 0.3, 1, None),
    "chrome": ((0.85, 0.86, 0.88), 0.08, 1, None), "brass": ((0.90, 0.70, 0.34), 0.2, 1, None),
    "black": ((0.04, 0.04, 0.045), 0.35, 0, None), "grey": ((0.25, 0.26, 0.28), 0.5, 0, None),
    "keys": ((0.70, 0.71, 0.72), 0.55, 0, None), "blue cloth": ((0.10, 0.20, 0.42), 0.9, 0, None),
    "orange": ((0.88, 0.36, 0.08), 0.6, 0, None), "red": ((0.72, 0.08, 0.07), 0.3, 0, None),
    "teal": ((0.05, 0.42, 0.42), 0.3, 0, None), "clay": ((0.66, 0.30, 0.18), 0.8, 0, None),
    "soil": ((0.09, 0.06, 0.04), 1.0, 0, None), "coffee": ((0.10, 0.05, 0.02), 0.1, 0, None),
    "paper": ((0.88, 0.87, 0.82), 0.9, 0, None), "green": ((0.06, 0.30, 0.14), 0.4, 0, None),
    "rug": ((0.62, 0.22, 0.16), 1.0, 0, None), "rug light": ((0.85, 0.74, 0.56), 1.0, 0, None),
    "screen": ((0.02, 0.02, 0.03), 0.3, 0, (0.06, 0.16, 0.32)),
    "windows": ((0.1, 0.1, 0.1), 0.3, 0, (0.62, 0.68, 0.74)),
    "text": ((0.02, 0.02, 0.02), 0.3, 0, (0.04, 0.09, 0.20)),
    "glow": ((0.9, 0.9, 0.9), 0.3, 0, (1.0, 0.90, 0.72)),
    "dusk": ((0, 0, 0), 1.0, 0, (0.10, 0.13, 0.28)), "tower": ((0, 0, 0), 1.0, 0, (0.022, 0.028, 0.06)),
    "lit": ((0, 0, 0), 1.0, 0, (0.95, 0.72, 0.36)),
}


class Office:
    """The document together with its materials and the meshes stored so far."""

    def __init__(self):
        self.doc = Document()
        self.paints = {name: self.doc.material(name, colour, rough, float(metal), emissive=glow)
                       for name, (colour, rough, metal, glow) in PAINTS.items()}
        self.paints["leaf"] = self.doc.material("leaf", (0.10, 0.36, 0.10), 0.45,
                                                double_sided=True)
        self.paints["pane"] = self.doc.material("pane", (0.95, 0.97, 0.98), 0.0, ior=1.5,
                                                transmission=1.0, double_sided=True)
        self.paints["glass"] = self.doc.material("glass", (1, 1, 1), 0.0, transmission=1.0, ior=1.5,
                                                 thickness=0.004)
        for number, colour in enumerate(BOOK_COLOURS):
            self.paints["cover %d" % number] = self.doc.material("cover %d" % number, colour, 0.55)
        self.meshes = {}

    def store(self, name, geometry, paint, with_uv=False):
        """Write a mesh under a name for later use."""
        self.meshes[name] = self.doc.mesh(name, geometry, self.paints[paint], with_uv)

    def place(self, name, at, degrees=0.0, parent=None):
        """A node of a stored mesh (or a bare one), turned about y."""
        spin = turn((0, 1, 0), degrees) if degrees else None
        return self.doc.node(name, self.meshes.get(name), at=at, turn=spin, parent=parent)

    def group(self, name, parts, at, degrees=0.0, parent=None):
        """A node that holds several stored meshes at its origin."""
        node = self.place(name, at, degrees, parent)
        for part in parts:
            self.place(part, None, parent=node)
        return node


def shell(office):
    """Floor, walls, windows and what lies outside."""
    for shade in range(3):
        office.store("planks %d" % shade, room.planks(shade), "oak %d" % shade)
        office.place("planks %d" % shade, None)
    for name, geometry, paint in (
            ("back wall", room.back_wall(), "back wall"), ("walls", room.other_walls(), "wall"),
            ("ceiling", room.ceiling(), "ceiling"), ("skirting", room.skirting(), "white"),
            ("towers", room.city(), "tower"), ("tower windows", room.city_lights(), "lit"),
            ("dusk", room.shapes.rectangle(60, 24).moved(0, 2, -20), "dusk")):
        office.store(name, geometry, paint)
        office.place(name, None)
    middle = (room.WINDOW_LOW + room.WINDOW_HIGH) / 2
    office.store("window frame", room.window_frame(), "white")
    office.store("window pane", room.shapes.rectangle(1.5, 1.3), "pane")
    office.store("sill", room.window_sill(), "white")
    office.store("blind", room.blind(), "paper")
    for x in room.WINDOWS:
        office.place("window frame", (x, middle, BACK - 0.13))
        office.place("window pane", (x, middle, BACK - 0.13))
        office.place("sill", (x, room.WINDOW_LOW - 0.015, BACK - 0.02))
        office.place("blind", (x, room.WINDOW_HIGH, BACK - 0.05))


def on_the_walls(office):
    """Door, clock and pictures."""
    door = ("door leaf", "door frame", "door handle")
    for part, geometry, paint in zip(door, (room.door_leaf(), room.door_frame(),
                                            room.door_handle()), ("walnut", "white", "brass")):
        office.store(part, geometry, paint)
    office.group("door", door, (LEFT + 0.01, 0, 1.7), 90)
    clock = ("clock rim", "clock face", "clock marks")
    for part, geometry, paint in zip(clock, (room.clock_rim(), room.clock_face(),
                                             room.clock_marks()), ("chrome", "paper", "black")):
        office.store(part, geometry, paint)
    office.group("clock", clock, (-0.35, 1.95, BACK))
    for name, width, height, size, pixel, at, degrees in (
            ("landscape", 0.78, 0.52, (64, 32), room.landscape, (RIGHT, 1.55, -1.0), -90),
            ("abstract", 0.48, 0.60, (32, 32), room.abstract, (LEFT, 1.55, 0.72), 90),
            ("small abstract", 0.32, 0.40, (32, 32), room.abstract, (-0.35, 1.42, BACK), 0)):
        texture = office.doc.texture(name, png(*size, pixel))
        office.paints[name] = office.doc.material(name, (0.9, 0.9, 0.9), 0.8, texture=texture)
        office.store(name, room.shapes.rectangle(width, height).moved(0, 0, 0.008), name, True)
        office.store(name + " frame", room.picture_frame(width, height), "black")
        picture = office.place(name + " frame", at, degrees)
        office.place(name, None, parent=picture)


DESK_PARTS = (("desk top", furniture.desk_top, "birch"), ("desk frame", furniture.desk_frame, "steel"),
              ("drawer body", furniture.drawer_body, "white"),
              ("drawer fronts", furniture.drawer_fronts, "teal"),
              ("drawer handles", furniture.drawer_handles, "chrome"))
CHAIR_PARTS = (("chair seat", furniture.chair_seat, "blue cloth"),
               ("chair back", furniture.chair_back, "blue cloth"),
               ("chair arms", furniture.chair_arms, "black"),
               ("chair base", furniture.chair_base, "chrome"))
MONITOR_PARTS = (("monitor shell", things.monitor_shell, "black"), ("screen", things.screen, "screen"),
                 ("screen windows", things.screen_windows, "windows"),
                 ("screen text", things.screen_text, "text"))
KEYBOARD_PARTS = (("keyboard body", things.keyboard_body, "grey"),
                  ("keyboard keys", things.keyboard_keys, "keys"))
LAMP_PARTS = (("desk lamp stand", furniture.desk_lamp_stand, "brass"),
              ("desk lamp shade", furniture.desk_lamp_shade, "green"),
              ("desk lamp bulb", furniture.desk_lamp_bulb, "glow"))
PHONE_PARTS = (("telephone", things.telephone, "red"), ("telephone keys", things.telephone_keys, "paper"))
SINGLES = (("castor", furniture.castor, "black"), ("mouse", things.mouse, "grey"),
           ("mug", things.mug, "red"), ("coffee", things.coffee, "coffee"),
           ("pencil pot", things.pencil_pot, "steel"), ("pencils", things.pencils, "orange"),
           ("paper stack", things.paper_stack, "paper"), ("computer", things.computer, "black"),
           ("power strip", things.power_strip, "white"), ("waste bin", things.waste_bin, "steel"),
           ("bookcase", furniture.bookcase, "walnut"), ("table top", furniture.round_table, "birch"),
           ("table foot", furniture.round_table_foot, "chrome"),
           ("stool seat", furniture.stool_seat, "orange"), ("stool legs", furniture.stool_legs, "walnut"),
           ("carafe", things.carafe, "glass"), ("tumbler", things.tumbler, "pane"),
           ("plant pot", things.plant_pot, "clay"), ("soil", things.soil, "soil"),
           ("leaves", things.leaves, "leaf"), ("coat stand", furniture.coat_stand, "walnut"),
           ("umbrella", things.umbrella, "teal"), ("pendant rod", furniture.pendant_rod, "brass"),
           ("pendant globe", furniture.pendant_globe, "glow"),
           ("uplighter stand", furniture.floor_lamp_stand, "brass"),
           ("uplighter bowl", furniture.floor_lamp_bowl, "white"))


def store_all(office):
    """Write the meshes of everything that is placed later."""
    for group in (DESK_PARTS, CHAIR_PARTS, MONITOR_PARTS, KEYBOARD_PARTS, LAMP_PARTS,
                  PHONE_PARTS, SINGLES):
        for name, function, paint in group:
            office.store(name, function(), paint)
    covers, pages = things.books()
    for number, cover in enumerate(covers):
        office.store("books %d" % number, cover, "cover %d" % number)
    office.store("pages", pages, "paper")
    office.store("binders", things.binders(0), "teal")
    office.store("binder labels", things.binders(1), "paper")
    office.store("rug", things.rug(), "rug")
    office.store("rug ring", things.rug(0.95).moved(0, 0.003, 0), "rug light")
    office.store("rug middle", things.rug(0.82).moved(0, 0.006, 0), "rug")
    for number in range(3):
        office.store("paper ball %d" % number, things.paper_ball(number), "paper")
    for name, points in (("screen cable", [(0, 0.98, -0.25), (0, 0.76, -0.36), (0.1, 0.6, -0.42),
                                           (-0.3, 0.35, -0.38), (-0.5, 0.3, -0.3)]),
                         ("mains cable", [(-0.5, 0.3, -0.3), (-0.45, 0.08, -0.36), (-0.2, 0.01, -0.3),
                                          (0, 0.005, -0.1), (0.1, 0.03, -0.25)]),
                         ("keyboard cable", [(-0.05, 0.752, 0.06), (-0.04, 0.745, -0.1),
                                             (-0.12, 0.745, -0.2), (-0.1, 0.76, -0.36),
                                             (-0.1, 0.6, -0.42)])):
        office.store(name, things.cable(points), "black")


def names(parts):
    """The names in a table of parts."""
    return [part[0] for part in parts]


def desk(office, name, at, degrees, lamp_x, extras=()):
    """A desk with computer, lamp and extras (name, x, z, degrees) on its top."""
    top = furniture.DESK[1]
    node = office.group(name, names(DESK_PARTS), at, degrees)
    office.group("monitor", names(MONITOR_PARTS), (0.0, top, -0.16), 0, node)
    office.group("keyboard", names(KEYBOARD_PARTS), (-0.04, top, 0.14), 0, node)
    office.place("mouse", (0.30, top, 0.15), -8, node)
    office.place("computer", (-0.56, 0, -0.05), 0, node)
    office.place("power strip", (0.05, 0, -0.26), 10, node)
    for cable in ("screen cable", "mains cable", "keyboard cable"):
        office.place(cable, None, parent=node)
    lamp = office.group("desk lamp", names(LAMP_PARTS), (lamp_x, top, -0.18),
                        -25 if lamp_x > 0 else 25, node)
    office.doc.light("desk lamp light", "spot", 0.9, (1.0, 0.82, 0.55), at=(0, 0.385, 0.15),
                     direction=(0, -1, 0.12), cone=(28, 58), parent=lamp)
    for extra, x, z, angle in extras:
        part = office.place(extra, (x, top, z), angle, node)
        for inside in {"mug": ["coffee"], "pencil pot": ["pencils"],
                       "telephone": ["telephone keys"]}.get(extra, []):
            office.place(inside, None, parent=part)


def chair(office, at, degrees):
    """A swivel chair on five castors."""
    node = office.group("swivel chair", names(CHAIR_PARTS), at, degrees)
    for i in range(5):
        angle = math.radians(72 * i)
        office.place("castor", (0.315 * math.cos(angle), 0, -0.315 * math.sin(angle)),
                     40 + 95 * i, node)


def meeting_corner(office):
    """The round table with water, glasses and stools on the rug."""
    x, z = -1.05, 1.0
    office.group("rugs", ["rug", "rug ring", "rug middle"], (x, 0, z))
    table = office.group("round table", ["table top", "table foot"], (x, 0.014, z))
    office.place("carafe", (0.05, 0.737, 0.02), 0, table)
    for dx, dz in ((0.24, 0.12), (0.2, -0.16), (-0.2, 0.16)):
        office.place("tumbler", (dx, 0.735, dz), 0, table)
    mug = office.place("mug", (-0.12, 0.735, -0.22), 200, table)
    office.place("coffee", None, parent=mug)
    office.place("paper stack", (0.02, 0.735, 0.3), 75, table)
    for dx, dz in ((0.75, 0.35), (0.35, -0.78), (-0.75, -0.2)):
        office.group("stool", ["stool seat", "stool legs"], (x + dx, 0.014, z + dz))


def along_the_walls(office):
    """Bookcase, plants, bins and stands."""
    parts = ["books %d" % i for i in range(5)] + ["pages"]
    case = office.place("bookcase", (LEFT + 0.16, 0, -0.55), 90)
    for part in parts:
        office.place(part, None, parent=case)
    office.group("binder row", ["binders", "binder labels"], (-0.5, 1.97, 0), 0, case)
    for at, degrees in (((-3.05, 0, BACK + 0.5), 0), ((2.95, 0, BACK + 0.45), 120)):
        office.group("plant", ["plant pot", "soil", "leaves"], at, degrees)
    office.place("waste bin", (-0.5, 0, -1.95))
    for number, at in enumerate(((-0.48, 0.22, -1.95), (-0.55, 0.25, -1.98), (-0.22, 0, -1.7))):
        office.place("paper ball %d" % number, at)
    office.place("coat stand", (-3.15, 0, -1.5))
    office.place("umbrella", (LEFT + 0.09, 0, 1.02), 40)
    office.group("uplighter", ["uplighter stand", "uplighter bowl"], (2.15, 0, BACK + 0.45))
    office.doc.light("uplighter light", "point", 3.0, (1.0, 0.88, 0.70), at=(2.15, 1.95, BACK + 0.45))


def pendants(office):
    """Two globes under the ceiling, each with a light just below it."""
    for x, z in ((-1.25, 0.2), (1.25, -0.2)):
        node = office.group("pendant", ["pendant rod", "pendant globe"], (x, room.HEIGHT, z))
        office.doc.light("pendant light", "point", 11.0, (1.0, 0.90, 0.74),
                         at=(0, -0.95, 0), parent=node)


def build():
    """The finished document."""
    office = Office()
    office.doc.camera("camera", (3.15, 1.72, 2.45), (-0.75, 0.80, -0.95), 50)
    shell(office)
    on_the_walls(office)
    store_all(office)
    z = BACK + 0.46
    desk(office, "left desk", (-1.7, 0, z), 0, -0.55,
         (("mug", 0.42, 0.05, 40), ("pencil pot", 0.55, -0.2, 0), ("paper stack", -0.5, 0.15, 8)))
    desk(office, "right desk", (1.0, 0, z), 0, 0.56,
         (("telephone", -0.52, 0.02, 20), ("mug", 0.5, 0.18, -30), ("pencil pot", -0.4, -0.25, 0)))
    desk(office, "side desk", (RIGHT - 0.46, 0, -0.75), -90, 0.56,
         (("mug", -0.45, 0.12, 160), ("paper stack", -0.5, -0.1, 80), ("telephone", 0.55, 0.1, -10)))
    chair(office, (-1.6, 0, z + 0.78), 20)
    chair(office, (0.75, 0, z + 0.85), -38)
    chair(office, (RIGHT - 1.35, 0, -0.6), -65)
    meeting_corner(office)
    along_the_walls(office)
    pendants(office)
    return office.doc
