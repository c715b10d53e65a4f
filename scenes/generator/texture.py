# SPDX-License-Identifier: Apache-2.0
"""Small RGB pictures written as PNG."""

import struct
import zlib


def png(width, height, pixel):
    """PNG bytes of an RGB picture; pixel(x, y) gives three sRGB values 0..255.

    The data is stored, not compressed: the bytes then do not depend on which
    zlib the generator runs with.
    """
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            rows += bytes(max(0, min(255, int(value))) for value in pixel(x, y))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", stored(bytes(rows))) + chunk(b"IEND", b""))


def chunk(kind, data):
    """A PNG chunk with its length and checksum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def stored(data):
    """A zlib stream of stored blocks."""
    out = bytearray(b"\x78\x01")
    for start in range(0, len(data), 65535):
        block = data[start:start + 65535]
        last = start + 65535 >= len(data)
        out += struct.pack("<BHH", last, len(block), len(block) ^ 0xFFFF) + block
    return bytes(out) + struct.pack(">I", zlib.adler32(data))
