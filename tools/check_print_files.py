#!/usr/bin/env python3
"""Checks files for printers with manifold-3d and PrusaSlicer; tools/check_print_files.sh installs both and calls this.

    check_print_files.py --tools FOLDER [--layers FOLDER] FILE...

FOLDER of --tools: where npm has installed manifold-3d. With --layers a layer in the middle of each file is drawn as SVG.
"""

import argparse
import json
import pathlib
import re
import struct
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
import zipfile

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
JUDGE = """
import fs from 'fs';
import Module from 'manifold-3d';
const wasm = await Module();
wasm.setup();
const mesh = JSON.parse(fs.readFileSync(process.argv[2]));
try {
  const solid = new wasm.Manifold(new wasm.Mesh({numProp: 3, vertProperties: new Float32Array(mesh.points.flat()),
    triVerts: new Uint32Array(mesh.triangles.flat())}));
  console.log(JSON.stringify({status: solid.status(), volume: solid.volume(), genus: solid.genus()}));
} catch (error) {
  console.log(JSON.stringify({status: String(error.message ?? error), volume: 0}));
}
"""
# A printer with room for all; lines of 0.4 mm in layers of 0.15 mm, without supports, skirt or filling.
SETTINGS = {"bed-shape": "0x0,600x0,600x600,0x600", "max-print-height": "600", "layer-height": "0.15",
            "first-layer-height": "0.15", "nozzle-diameter": "0.4", "perimeters": "3", "fill-density": "100%",
            "fill-pattern": "rectilinear", "skirts": "0", "brim-width": "0", "center": "300,300"}


def objects_of(path):
    """[(points in mm, triangles)]; corners of STL files with the same coordinates are one point."""
    if path.suffix.lower() == ".3mf":
        with zipfile.ZipFile(path) as archive:
            model = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
        return [([[float(v.get(k)) for k in "xyz"] for v in entry.iter(CORE + "vertex")],
                 [[int(t.get(k)) for k in ("v1", "v2", "v3")] for t in entry.iter(CORE + "triangle")])
                for entry in model.iter(CORE + "object")]
    data, numbers, triangles = path.read_bytes(), {}, []
    for i in range(struct.unpack_from("<I", data, 80)[0]):
        corners = struct.unpack_from("<9f", data, 84 + 50 * i + 12)
        triangles.append([numbers.setdefault(corners[k:k + 3], len(numbers)) for k in (0, 3, 6)])
    return [([list(p) for p in numbers], triangles)]


def volume_of(points, triangles):
    total = 0
    for a, b, c in ((points[i], points[j], points[k]) for i, j, k in triangles):
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def judge_manifold(tools, points, triangles):
    """Complaints; none when manifold-3d takes the mesh with the same volume."""
    (tools / "judge.mjs").write_text(JUDGE, encoding="utf-8")
    (tools / "mesh.json").write_text(json.dumps({"points": points, "triangles": triangles}), encoding="utf-8")
    code, text = run("node", str(tools / "judge.mjs"), str(tools / "mesh.json"))
    if code != 0:
        return [f"manifold-3d fails: {text.strip()}"]
    said, volume = json.loads(text), volume_of(points, triangles)
    print(f"  manifold-3d: {said['status']}, {said['volume']:.3f} mm³ of {volume:.3f}, genus {said.get('genus')}")
    if said["status"] not in ("NoError", 0):
        return [f"manifold-3d says {said['status']}"]
    return [] if abs(said["volume"] / volume - 1) < 1e-4 else [f"manifold-3d finds {said['volume']} mm³ of {volume}"]


def judge_slicer(path, tools, volume):
    """Complaints, and the G-code."""
    _, text = run("prusa-slicer", "--info", str(path))
    complaints = [] if re.search(r"manifold = yes", text) else [f"PrusaSlicer calls it not manifold: {text.strip()}"]
    found = [float(v) for v in re.findall(r"volume = ([\d.]+)", text)]
    print(f"  PrusaSlicer: manifold {'no' if complaints else 'yes'}, {sum(found):.3f} mm³")
    if abs(sum(found) / volume - 1) > 1e-3:
        complaints.append(f"PrusaSlicer finds {sum(found)} mm³ of {volume}")
    gcode = tools / "sliced.gcode"
    gcode.unlink(missing_ok=True)
    options = [part for name, value in SETTINGS.items() for part in (f"--{name}", value)]
    code, text = run("prusa-slicer", "--export-gcode", *options, "--output", str(gcode), str(path))
    loud = [line for line in text.splitlines() if re.search(r"error|warning|repair|empty layer|fail", line, re.I)]
    if code != 0 or loud or not gcode.exists():
        complaints.append(f"slicing ends with code {code}: {' / '.join(loud) or text.strip()}")
    return complaints, gcode


def middle_layer(gcode):
    """[(type, [(x, y), ...])] of the lines of a layer in the middle."""
    layers, kind, place, line = [], "", (0.0, 0.0), []
    for text in gcode.read_text(encoding="utf-8").splitlines():
        if text.startswith(";LAYER_CHANGE"):
            layers.append([])
        elif text.startswith(";TYPE:"):
            kind = text[6:]
        elif text.startswith("G1 ") and layers:
            words = {word[0]: float(word[1:]) for word in text.split(";")[0].split()[1:] if len(word) > 1}
            to = (words.get("X", place[0]), words.get("Y", place[1]))
            if words.get("E", 0) > 0 and to != place:
                if not line:
                    line = [place]
                    layers[-1].append((kind, line))
                line.append(to)
            else:
                line = []
            place = to
    return layers[len(layers) // 2]


def draw(lines, path):
    colours = {"External perimeter": "#b45309", "Perimeter": "#d9a441"}
    x, y = ([p[i] for _, line in lines for p in line] for i in (0, 1))
    low, size = (min(x) - 1, min(y) - 1), (max(x) - min(x) + 2, max(y) - min(y) + 2)
    body = "".join(
        f'<polyline stroke="{colours.get(kind, "#6b8fb3")}" points="'
        + " ".join(f"{px - low[0]:.2f},{size[1] - py + low[1]:.2f}" for px, py in line) + '"/>\n' for kind, line in lines)
    path.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]:.1f}mm" height="{size[1]:.1f}mm" '
        f'viewBox="0 0 {size[0]:.2f} {size[1]:.2f}"><g fill="none" stroke-width="0.36" stroke-linejoin="round" '
        f'stroke-linecap="round">\n{body}</g></svg>\n', encoding="utf-8")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tools", type=pathlib.Path, required=True)
    parser.add_argument("--layers", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    failed = 0
    for path in arguments.files:
        objects = objects_of(path)
        print(f"{path}: {len(objects)} objects, {sum(len(t) for _, t in objects)} triangles")
        complaints = [c for points, triangles in objects for c in judge_manifold(arguments.tools, points, triangles)]
        more, gcode = judge_slicer(path, arguments.tools, sum(volume_of(*o) for o in objects))
        complaints += more
        if arguments.layers and gcode.exists():
            arguments.layers.mkdir(parents=True, exist_ok=True)
            picture = arguments.layers / (path.stem + "-layer.svg")
            draw(middle_layer(gcode), picture)
            print(f"  drew {picture}")
        for complaint in complaints:
            print(f"  FAIL {complaint}")
        failed += bool(complaints)
    print(f"{len(arguments.files) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
