"""Shapes of rods on fabric: what solve says about them, their pictures, and their files read back by meshio."""
import json

import meshio
import numpy
import tool

SIDE, CELLS = 120, 6  # mm


def frame(pre_stretch=1.3, r_n="0.2 mm"):
    """Fig. 6.3 of the thesis: a square of thin rods on pre-stretched knit."""
    corners = [[0, 0, 0], [SIDE, 0, 0], [SIDE, SIDE, 0], [0, SIDE, 0]]
    names = ["south", "east", "north", "west"]
    return {
        "lissom": 1,
        "title": "Frame",
        "materials": {"plastic": {"youngs_modulus": "3.31 GPa", "poisson_ratio": 0.36}},
        "rods": [{"name": names[k], "line": [corners[k], corners[(k + 1) % 4]], "edges": CELLS, "material": "plastic",
                  "section": {"r_n": r_n, "r_b": "0.4 mm"}} for k in range(4)],
        "membranes": [{"name": "sail", "grid": {"corner": [0, 0], "size": [SIDE, SIDE], "cells": [CELLS, CELLS]},
                       "material": "soft knit", "pre_stretch": pre_stretch}],
        "poses": [{"name": "released"}],
    }


class FabricFiles(tool.ToolTest):
    def solve(self, **numbers):
        self.write("frame.lissom", frame(**numbers))
        out, _ = self.run_tool("solve", "frame.lissom")
        return out, self.result("out/frame-released.json")

    def test_totals_worst_elements_and_warnings(self):
        out, result = self.solve()
        totals = result["totals"]
        self.assertAlmostEqual(totals["height"], totals["high"][2] - totals["low"][2], places=12)
        self.assertGreater(totals["height"], 0.02)
        self.assertAlmostEqual(totals["rest_area"], (SIDE / 1000 / 1.3) ** 2, places=9)
        self.assertEqual(totals["slack_area"], 0)
        worst = {w["what"]: w for w in result["worst"]}
        self.assertAlmostEqual(worst["smallest stretch"]["value"], totals["smallest_stretch"], places=12)
        self.assertEqual(worst["smallest stretch"]["membrane"], "sail")
        self.assertGreater(worst["compression"]["value"], 0)
        self.assertIn("height", out)
        self.assertEqual({w["what"] for w in result["warnings"]}, {"thin rod"})  # 0.4 mm, printers want 0.5
        self.assertIn("multiply all radii by 1.25", out)

    def test_rods_alone_have_neither(self):
        self.write("beam.lissom", tool.cantilever())
        out, _ = self.run_tool("solve", "beam.lissom", "--json")
        pose = json.loads(out)["poses"][0]
        self.assertNotIn("totals", pose)
        self.assertNotIn("warnings", pose)

    def test_files_read_back(self):
        _, result = self.solve()
        for ending in ("vtu", "obj", "ply"):
            self.run_tool("convert", "out/frame-released.json", f"sail.{ending}")
        triangles = 2 * CELLS * CELLS
        vtu = meshio.read(self.folder / "sail.vtu")
        self.assertEqual([(c.type, len(c.data)) for c in vtu.cells], [("line", 4 * CELLS), ("triangle", triangles)])
        stretch = vtu.cell_data["smallest stretch"]
        self.assertTrue(numpy.isnan(stretch[0]).all())
        self.assertAlmostEqual(stretch[1].min(), result["totals"]["smallest_stretch"], places=12)
        corners = vtu.points[vtu.cells[1].data]
        area = numpy.linalg.norm(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        self.assertAlmostEqual(area.sum(), result["totals"]["area"], places=12)
        energy = result["energy"]["terms"]["membrane_stretch"]
        rest = result["totals"]["rest_area"] / triangles
        self.assertAlmostEqual(vtu.cell_data["fabric energy (J/m^2)"][1].sum() * rest, energy, delta=1e-9 * energy)
        obj = meshio.read(self.folder / "sail.obj")
        self.assertEqual(sum(len(c.data) for c in obj.cells if c.type == "triangle"), triangles)
        self.assertEqual(len(obj.points), (CELLS + 1) ** 2)  # the rods share their points with the fabric
        ply = meshio.read(self.folder / "sail.ply")
        self.assertGreater(sum(len(c.data) for c in ply.cells if c.type == "triangle"), triangles)
        self.assertAlmostEqual(numpy.ptp(ply.points[-(CELLS + 1) ** 2:, 2]), 1000 * result["totals"]["height"], places=3)

    def test_pictures(self):
        self.solve()
        self.run_tool("draw", "out/frame-released.json", "--field", "axial strain", "--tension", "--shadow", "-o", "one.svg")
        self.assertIn("<linearGradient", (self.folder / "one.svg").read_text(encoding="utf-8"))
        self.run_tool("draw", "out/frame-released.json", "frame.lissom", "--fabric-field", "smallest stretch", "-o", "two.png")
        self.assertTrue((self.folder / "two.png").read_bytes().startswith(b"\x89PNG"))
        _, err = self.run_tool("draw", "out/frame-released.json", "--fabric-field", "stretch", "-o", "no.png", code=3)
        self.assertIn("smallest stretch", err)


if __name__ == "__main__":
    tool.main()
