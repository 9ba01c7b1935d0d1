"""Reads the include graph and fails on a loop, on an arrow to the right, and on a library outside its room.

    params, math -> image -> scene -> { mapping | intersect } -> shading -> { raster -> radiosity | ray } -> workbench
    -> measure -> ui;  shading -> gl -> ui

Usage: include_order.py ROOT        checks ROOT/src and ROOT/ui
       include_order.py --self-test  checks that each kind of fault is found
"""
import pathlib
import re
import sys
import tempfile

# Each room with the rooms it may include, itself aside.
LEFT = {"params": [], "math": ["params"]}
LEFT["image"] = LEFT["math"] + ["math"]
LEFT["scene"] = LEFT["image"] + ["image"]
LEFT["mapping"] = LEFT["scene"] + ["scene"]
LEFT["intersect"] = LEFT["scene"] + ["scene"]
LEFT["shading"] = LEFT["scene"] + ["scene", "mapping", "intersect"]
LEFT["raster"] = LEFT["shading"] + ["shading"]
LEFT["radiosity"] = LEFT["raster"] + ["raster"]
LEFT["ray"] = LEFT["shading"] + ["shading"]
LEFT["gl"] = LEFT["shading"] + ["shading"]
LEFT["workbench"] = LEFT["radiosity"] + ["radiosity", "ray"]
LEFT["measure"] = LEFT["workbench"] + ["workbench"]
LEFT["ui"] = LEFT["measure"] + ["measure", "gl"]

# Where a library may be included: (pattern of the include, rooms, only in .cpp files).
LIBRARIES = [
    (r"nlohmann/", {"params"}, True),
    (r"OpenMesh/", {"scene"}, True),
    (r"OpenImageIO/|OpenEXR/|Imath/", {"image"}, False),
    (r"Eigen/|unsupported/Eigen", {"mapping", "radiosity"}, True),
    (r"embree", {"intersect"}, False),
    (r"tbb/|oneapi/", {"raster", "radiosity", "ray"}, False),
    (r"epoxy/|EGL/|GL/", {"gl", "ui"}, False),
    (r"CLI/", {"workbench"}, False),
    (r"md4c", {"workbench"}, True),
    (r"GLFW/|imgui|fontconfig/|ft2build", {"ui"}, False),
    (r"gtest/|benchmark/", set(), False),
]
# A library that only one file, or one program's folder, may include.
ONE_PLACE_ONLY = {"nlohmann/": "src/params/json.cpp", "OpenImageIO/": "src/image/images_program/",
                  "md4c": "src/workbench/lesson_markdown.cpp"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.M)


def room_of(path):
    parts = path.split("/")
    return "ui" if parts[0] == "ui" else parts[1] if parts[0] == "src" and len(parts) > 2 else None


def faults(root):
    root = pathlib.Path(root)
    files = sorted(p.relative_to(root).as_posix() for top in ("src", "ui") for p in (root / top).rglob("*")
                   if p.suffix in (".h", ".cpp", ".inl"))
    graph, found = {}, []
    for name in files:
        room = room_of(name)
        if room not in LEFT:
            found.append(f"{name}: no room of that name")
            continue
        graph[name] = []
        for include in INCLUDE.findall((root / name).read_text(encoding="utf-8")):
            target = next((t for t in (f"src/{include}", include, f"{name.rsplit('/', 1)[0]}/{include}") if t in files), None)
            if target:
                graph[name].append(target)
                if room_of(target) != room and room_of(target) not in LEFT[room]:
                    found.append(f"{name}: includes {include}, which stands to its right")
            for pattern, rooms, source_only in LIBRARIES:
                if re.match(pattern, include):
                    if room not in rooms:
                        found.append(f"{name}: includes <{include}>, a library of {sorted(rooms) or 'tests'} only")
                    elif source_only and not name.endswith(".cpp"):
                        found.append(f"{name}: includes <{include}> in a header")
            for prefix, only in ONE_PLACE_ONLY.items():
                if include.startswith(prefix) and not name.startswith(only):
                    found.append(f"{name}: includes <{include}>, which only {only} may")
    return found + loops(graph)


def loops(graph):
    state, found = {}, []

    def visit(name, trail):
        if state.get(name) == "done":
            return
        if name in trail:
            found.append("loop: " + " -> ".join(trail[trail.index(name):] + [name]))
            return
        for target in graph.get(name, []):
            visit(target, trail + [name])
        state[name] = "done"

    for name in graph:
        visit(name, [])
    return found


def self_test():
    cases = {
        "arrow to the right": ({"src/math/a.h": '#include "raster/b.h"\n', "src/raster/b.h": ""}, "right"),
        "a sibling": ({"src/gl/a.cpp": '#include "raster/b.h"\n', "src/raster/b.h": ""}, "right"),
        "a loop": ({"src/math/a.h": '#include "math/b.h"\n', "src/math/b.h": '#include "math/a.h"\n'}, "loop"),
        "a library elsewhere": ({"src/scene/a.cpp": "#include <GLFW/glfw3.h>\n"}, "library"),
        "a library in a header": ({"src/scene/a.h": "#include <OpenMesh/Core/Mesh.hh>\n"}, "header"),
        "JSON in a second file": ({"src/params/slots.cpp": "#include <nlohmann/json.hpp>\n"}, "only"),
        "OpenImageIO outside its program": ({"src/image/a.cpp": "#include <OpenImageIO/imageio.h>\n"}, "only"),
        "nothing": ({"src/raster/a.cpp": '#include "shading/b.h"\n', "src/shading/b.h": "#include <vector>\n"}, None),
    }
    for title, (files, expected) in cases.items():
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            got = faults(folder)
            if (expected is None) != (not got) or (expected and not any(expected in f for f in got)):
                print(f"{title}: expected {expected!r}, got {got}")
                return 1
    print("each kind of fault is found")
    return 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(self_test())
    found = faults(sys.argv[1])
    print("\n".join(found) or "the include order holds")
    sys.exit(bool(found))
