#!/usr/bin/env python3
"""Fails if a file includes a header of a room that its own room may not use.

Usage: layering_test.py REPOSITORY
The rooms are the folders of src/. A public header of include/structure_from_wifi belongs to the room
of its source file. doc/architecture.md draws the same arrows.
"""

import pathlib
import re
import sys

# Each room, and the rooms that it may include. `ros` and `cli` may use every room.
ALLOWED = {
    "base": "",
    "grid": "base",
    "files": "base grid",
    "path": "base grid",
    "radio": "base path",
    "tomography": "base grid radio",
    "belief": "base grid files path radio tomography",
    "walls": "base grid radio tomography belief",
    "k_visibility": "base grid",
    "access_points": "base radio",
    "localization": "base radio",
    "checks": "base grid path radio belief access_points",
    "mapping": "base checks path radio belief walls k_visibility access_points grid",
    "output": "base grid files belief checks k_visibility mapping path",
    "exploration": "base grid checks",
    "simulation": "base grid files",
    "wireless": "base",
    "evaluation": "base grid files path radio tomography belief checks k_visibility localization exploration mapping output simulation",
    "training": "base grid path belief walls k_visibility simulation mapping",
}
# The rooms of public headers, where no source file of the same name tells.
PUBLIC_ROOMS = {"types": "base", "export": "base", "input_error": "base", "snapshot": "checks",
                "recording_findings": "base",
                "wall_segment": "base",
                "access_point_estimate": "access_points"}
INCLUDE = re.compile(r'\s*#\s*include\s*[<"]([a-z_]+)/(?:[a-z_]+/)*([a-z0-9_]+)\.h[>"]')
TOP_ROOMS = set(ALLOWED) | {"ros", "cli"}


def room_of_public(name, sources):
    return PUBLIC_ROOMS.get(name) or sources.get(name)


def violations(root):
    sources = {path.stem: path.relative_to(root / "src").parts[0]
               for path in (root / "src").rglob("*.cpp")}
    files = [(path.relative_to(root / "src").parts[0], path)
             for path in sorted((root / "src").rglob("*.[ch]*")) if path.suffix in (".h", ".cpp")]
    files += [(room_of_public(path.stem, sources), path)
              for path in sorted((root / "include").rglob("*.h"))]
    for room, path in files:
        if room not in TOP_ROOMS:
            yield "%s: is in no room" % path.relative_to(root)
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            found = INCLUDE.match(line)
            if not found:
                continue
            used, name = found.groups()
            if used == "structure_from_wifi":
                used = room_of_public(name, sources)
            if used in TOP_ROOMS and used != room and room in ALLOWED and used not in ALLOWED[room].split():
                yield "%s:%d: %s may not use %s" % (path.relative_to(root), number, room, used)


def main():
    found = list(violations(pathlib.Path(sys.argv[1])))
    print("\n".join(found))
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main())
