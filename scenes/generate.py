#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Write the project's own scenes, scenes/*.glb, or check that they are current."""

import argparse
import importlib
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
SCENES = ("cornell", "office", "colonnade", "glass", "moving", "walking",
          "morphing", "materials")


def main():
    """Run the command line; returns the exit status."""
    sys.dont_write_bytecode = True
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true",
                        help="write nothing; exit 1 when a file would change")
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help="scenes to write (all of: %s)" % ", ".join(SCENES))
    options = parser.parse_args()
    unknown = [name for name in options.names if name not in SCENES]
    if unknown:
        parser.error("no such scene: " + ", ".join(unknown))
    stale = 0
    for name in options.names or SCENES:
        data = importlib.import_module("generator." + name).build().glb()
        stale += not handle(FOLDER / (name + ".glb"), data, options.check)
    return 1 if stale else 0


def handle(path, data, check):
    """Write data to path, or compare with it; returns whether all is well."""
    if not check:
        path.write_bytes(data)
        print("%s: %d bytes" % (path.name, len(data)))
        return True
    if path.exists() and path.read_bytes() == data:
        return True
    print("%s: not what the generator writes" % path.name, file=sys.stderr)
    return False


if __name__ == "__main__":
    sys.exit(main())
