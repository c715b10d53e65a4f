# SPDX-License-Identifier: Apache-2.0
"""A glTF 2.0 document under construction, written as one .glb file."""

import array
import json
import math
import struct
import sys

from . import vector
from .mesh import Mesh

FLOAT, UBYTE, USHORT, UINT = 5126, 5121, 5123, 5125
ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
TYPE_CODES = {FLOAT: "f", UBYTE: "B", USHORT: "H", UINT: "I"}
TYPE_NAMES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


def packed_weights(row):
    """Four weights of 16 bits that sum to 65535."""
    whole = [int(w * 65535 + 0.5) for _, w in row]
    whole[0] += 65535 - sum(whole)
    return tuple(whole + [0] * (4 - len(row)))


class Document:
    """Collects materials, meshes, nodes, cameras, lights and animations."""

    def __init__(self):
        self.binary = bytearray()
        self.lights = []
        self.extensions = set()
        self.roots = []
        self.lists = {name: [] for name in (
            "nodes", "meshes", "skins", "materials", "cameras", "animations", "textures",
            "images", "samplers", "accessors", "bufferViews")}

    def _append(self, name, item):
        self.lists[name].append(item)
        return len(self.lists[name]) - 1

    def _view(self, data, target=None):
        self.binary += b"\0" * (-len(self.binary) % 4)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        if target:
            view["target"] = target
        self.binary += data
        return self._append("bufferViews", view)

    def _accessor(self, rows, component, target=None, normalised=False, bounds=False):
        values = array.array(TYPE_CODES[component], (x for row in rows for x in row))
        width = len(rows[0])
        item = {"componentType": component, "count": len(rows), "type": TYPE_NAMES[width]}
        if normalised:
            item["normalized"] = True
        if bounds:
            item["min"] = [min(values[i::width]) for i in range(width)]
            item["max"] = [max(values[i::width]) for i in range(width)]
        if sys.byteorder == "big":
            values.byteswap()
        item["bufferView"] = self._view(values.tobytes(), target)
        return self._append("accessors", item)

    def texture(self, name, png):
        """Embed a PNG; returns the texture's index."""
        image = self._append("images", {
            "name": name, "mimeType": "image/png", "bufferView": self._view(png)})
        if not self.lists["samplers"]:
            self._append("samplers", {"magFilter": 9729, "minFilter": 9987})
        return self._append("textures", {"sampler": 0, "source": image})

    def material(self, name, colour=(1, 1, 1), roughness=0.8, metallic=0.0, *,
                 emissive=None, texture=None, double_sided=False,
                 transmission=0.0, ior=None, thickness=None, extensions=None):
        """Add a material; glass with a thickness is solid and bends light."""
        surface = {"baseColorFactor": [*colour, 1.0],
                   "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            surface["baseColorTexture"] = {"index": texture}
        item = {"name": name, "pbrMetallicRoughness": surface}
        if emissive:
            item["emissiveFactor"] = list(emissive)
        if double_sided:
            item["doubleSided"] = True
        given, extensions = extensions or {}, {}
        if transmission:
            extensions["KHR_materials_transmission"] = {"transmissionFactor": transmission}
        if ior:
            extensions["KHR_materials_ior"] = {"ior": ior}
        if thickness:
            extensions["KHR_materials_volume"] = {"thicknessFactor": thickness}
        extensions.update(given)
        if extensions:
            item["extensions"] = extensions
            self.extensions.update(extensions)
        return self._append("materials", item)

    def mesh(self, name, geometry, material, with_uv=False, tangent=None):
        """Write a Mesh with one primitive; returns its index. tangent: of a position."""
        corners, indices = geometry.welded()
        wide = len(corners) > 65535
        normals = [vector.unit(normal) for _, normal, _ in corners]
        attributes = {
            "POSITION": self._accessor([c[0] for c in corners], FLOAT, ARRAY_BUFFER,
                                       bounds=True),
            "NORMAL": self._accessor(normals, FLOAT, ARRAY_BUFFER)}
        if tangent:
            attributes["TANGENT"] = self._accessor(
                [(*tangent(c[0]), 1.0) for c in corners], FLOAT, ARRAY_BUFFER)
        if with_uv:
            attributes["TEXCOORD_0"] = self._uv_accessor([c[2] for c in corners])
        return self._append("meshes", {"name": name, "primitives": [{
            "attributes": attributes, "material": material,
            "indices": self._accessor([(i,) for i in indices], UINT if wide else USHORT,
                                      ELEMENT_ARRAY_BUFFER)}]})

    def skinned_mesh(self, name, primitives):
        """Write (material, pieces) a primitive; a piece is a Mesh and what gives a vertex's (joint, weight) list."""
        written = []
        for material, pieces in primitives:
            corners, indices, rows = [], [], []
            for geometry, influences in pieces:
                own, own_indices = geometry.welded()
                indices += [len(corners) + i for i in own_indices]
                corners += own
                rows += [influences(corner[0]) for corner in own]
            joints = [tuple([j for j, _ in row] + [0] * (4 - len(row))) for row in rows]
            written.append({"attributes": {
                "POSITION": self._accessor([c[0] for c in corners], FLOAT, ARRAY_BUFFER, bounds=True),
                "NORMAL": self._accessor([vector.unit(c[1]) for c in corners], FLOAT, ARRAY_BUFFER),
                "JOINTS_0": self._accessor(joints, UBYTE, ARRAY_BUFFER),
                "WEIGHTS_0": self._accessor([packed_weights(row) for row in rows], USHORT, ARRAY_BUFFER,
                                            normalised=True)},
                "material": material,
                "indices": self._accessor([(i,) for i in indices], USHORT, ELEMENT_ARRAY_BUFFER)})
        return self._append("meshes", {"name": name, "primitives": written})

    def skin(self, name, joints, places):
        """A skin of nodes that stand unturned at these places at rest; returns its index."""
        rows = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -p[0], -p[1], -p[2], 1) for p in places]
        return self._append("skins", {"name": name, "joints": joints,
                                      "inverseBindMatrices": self._accessor(rows, FLOAT)})

    def morphing_mesh(self, name, geometry, material, targets, weights):
        """Write a Mesh whose corners each target moves: a (position, normal) to add for each corner."""
        marked = [Mesh([(p, n, (0.0, 0.0))]) for p, n, _ in geometry.corners]
        places = [mesh.welded()[0][0] for mesh in marked]
        corners, indices = geometry.welded()
        first = {}
        for i, place in enumerate(places):
            first.setdefault((place[0], place[1]), i)
        order = [first[(c[0], c[1])] for c in corners]
        item = {"attributes": {
            "POSITION": self._accessor([c[0] for c in corners], FLOAT, ARRAY_BUFFER, bounds=True),
            "NORMAL": self._accessor([vector.unit(c[1]) for c in corners], FLOAT, ARRAY_BUFFER)},
            "material": material, "targets": [],
            "indices": self._accessor([(i,) for i in indices], USHORT, ELEMENT_ARRAY_BUFFER)}
        for target in targets:
            item["targets"].append({
                "POSITION": self._accessor([target[i][0] for i in order], FLOAT, ARRAY_BUFFER, bounds=True),
                "NORMAL": self._accessor([target[i][1] for i in order], FLOAT, ARRAY_BUFFER)})
        return self._append("meshes", {"name": name, "primitives": [item], "weights": list(weights)})

    def _uv_accessor(self, uvs):
        if all(0 <= x <= 1 for uv in uvs for x in uv):
            packed = [tuple(int(x * 65535 + 0.5) for x in uv) for uv in uvs]
            return self._accessor(packed, USHORT, ARRAY_BUFFER, normalised=True)
        return self._accessor(uvs, FLOAT, ARRAY_BUFFER)

    def node(self, name, mesh=None, *, parent=None, at=None, turn=None, scale=None, **extra):
        """Add a node under parent (or the scene); returns its index."""
        item = {"name": name}
        if mesh is not None:
            item["mesh"] = mesh
        for key, value in (("translation", at), ("rotation", turn), ("scale", scale)):
            if value is not None:
                item[key] = [round(float(x), 6) for x in value]
        item.update(extra)
        index = self._append("nodes", item)
        if parent is None:
            self.roots.append(index)
        else:
            self.lists["nodes"][parent].setdefault("children", []).append(index)
        return index

    def camera(self, name, eye, target, yfov_degrees, *, aspect=16 / 9, near=0.05,
               far=200.0, parent=None):
        """Add a perspective camera that looks from eye to target."""
        camera = self._append("cameras", {"name": name, "type": "perspective", "perspective": {
            "yfov": round(math.radians(yfov_degrees), 6), "aspectRatio": round(aspect, 6),
            "znear": near, "zfar": far}})
        return self.node(name, parent=parent, at=eye, camera=camera,
                         turn=vector.facing(vector.sub(target, eye)))

    def light(self, name, kind, intensity, colour=(1, 1, 1), *, at=None, direction=None,
              cone=None, parent=None):
        """Add a "point", "spot" or "directional" light; cone is (inner, outer) degrees."""
        item = {"name": name, "type": kind, "intensity": intensity, "color": list(colour)}
        if cone:
            item["spot"] = {"innerConeAngle": round(math.radians(cone[0]), 6),
                            "outerConeAngle": round(math.radians(cone[1]), 6)}
        self.lights.append(item)
        self.extensions.add("KHR_lights_punctual")
        reference = {"KHR_lights_punctual": {"light": len(self.lights) - 1}}
        return self.node(name, parent=parent, at=at, extensions=reference,
                         turn=vector.facing(direction) if direction else None)

    def animation(self, name, channels):
        """Add an animation of channels (node, path, interpolation, times, rows)."""
        item = {"name": name, "channels": [], "samplers": []}
        for node, path, interpolation, times, rows in channels:
            item["samplers"].append({
                "input": self._accessor([(t,) for t in times], FLOAT, bounds=True),
                "output": self._accessor(rows, FLOAT), "interpolation": interpolation})
            item["channels"].append({"sampler": len(item["samplers"]) - 1,
                                     "target": {"node": node, "path": path}})
        return self._append("animations", item)

    def glb(self):
        """The whole document as the bytes of a .glb file."""
        self.binary += b"\0" * (-len(self.binary) % 4)
        root = {"asset": {"version": "2.0", "generator": "crsh scenes/generate.py",
                          "copyright": "The crsh authors, Apache-2.0"},
                "scene": 0, "scenes": [{"nodes": self.roots}]}
        root.update((key, items) for key, items in self.lists.items() if items)
        root["buffers"] = [{"byteLength": len(self.binary)}]
        if self.extensions:
            root["extensionsUsed"] = sorted(self.extensions)
        if self.lights:
            root["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        text = json.dumps(root, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        size = 12 + 8 + len(text) + 8 + len(self.binary)
        return (struct.pack("<4sII", b"glTF", 2, size)
                + struct.pack("<I4s", len(text), b"JSON") + text
                + struct.pack("<I4s", len(self.binary), b"BIN\0") + bytes(self.binary))
