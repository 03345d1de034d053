#!/usr/bin/env python3
"""Measurements for the documents of scenes/data/calibration: what the tool shows for known materials, with scatter.

    tools/make_calibration_data.py [TOOL]      TOOL: the command line tool, by default build/release/lissom

Writes the CSV files beside the documents; the same bytes every time.
"""

import json
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "scenes" / "data" / "calibration"


def shown(tool, name, materials, tables):
    """What a document shows with these materials, for tables of (file, header, rows): a list per table, SI."""
    document = json.loads((FOLDER / f"{name}.lissom").read_text(encoding="utf-8"))
    for kind, table in materials.items():
        for material, numbers in table.items():
            document[kind][material].update(numbers)
    document["calibration"]["iterations"] = 1
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / f"{name}.lissom").write_text(json.dumps(document), encoding="utf-8")
        for file, header, rows in tables:
            (folder / file).write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
        subprocess.run([tool, "calibrate", f"{name}.lissom", "--json"], cwd=folder, check=False, capture_output=True)
        result = json.loads((folder / "out" / f"{name}-calibration.json").read_text(encoding="utf-8"))
    return [[row["fitted_at_start"] for row in table["rows"]] for table in result["measurements"]]


def write(file, note, header, rows):
    (FOLDER / file).write_text("\n".join([f"# {note}", header, *rows]) + "\n", encoding="utf-8")


def make_rod(tool, scatter):
    weights = [0, 1, 2, 3, 4, 5, 7, 10]  # gf
    header = "force [gf], displacement [mm]"
    [sag] = shown(tool, "rod", {"materials": {"printed TPU": {"youngs_modulus": "27.5 MPa"}}},
                  [("rod.csv", header, [f"{w}, {w}" for w in weights])])
    write("rod.csv", "how far the tip hangs below the clamp, with weights on it", header,
          [f"{w}, {1e3 * s + scatter.gauss(0, 0.3):.1f}" for w, s in zip(weights, sag)])


def make_strips(tool, scatter):
    pulls = [84, 88, 92, 96, 100, 104, 108, 112]  # mm
    header = "length [mm], force [mN]"
    dummy = [f"{length}, {length}" for length in pulls]
    places = ["waist below, 0", "waist above, 40"]
    jersey = {"jersey": {"stiffness": ["62 N/m", "24 N/m"], "poisson_ratio": 0.35}}
    warp, weft, waist = shown(tool, "strips", {"membrane_materials": jersey},
                              [("warp.csv", header, dummy), ("weft.csv", header, dummy),
                               ("waist.csv", "place, y [mm]", places)])
    for name, forces in (("warp", warp), ("weft", weft)):
        write(f"{name}.csv", f"strip along the {name}, 40 mm wide, 80 mm between the grips", header,
              [f"{length}, {1e3 * f + scatter.gauss(0, 10):.0f}" for length, f in zip(pulls, forces)])
    write("waist.csv", "edges of the strip along the warp in the middle, pulled to 100 mm", "place, y [mm]",
          [f"{p.split(',')[0]}, {1e3 * y + scatter.gauss(0, 0.1):.2f}" for p, y in zip(places, waist)])


def main():
    tool = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "lissom")
    if shutil.which(tool) is None:
        print(f"make_calibration_data: there is no {tool}; build it with `make build`", file=sys.stderr)
        return 2
    scatter = random.Random(4)
    make_rod(tool, scatter)
    make_strips(tool, scatter)
    return 0


if __name__ == "__main__":
    sys.exit(main())
