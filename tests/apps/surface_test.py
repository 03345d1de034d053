"""lissom surface: a surface that somebody brings."""
import json
import math

import meshio  # reads what we write; written by others

import tool

# A cube of 20 (no unit) with quadrilaterals, closed and turned outward.
CUBE = "".join(f"v {x} {y} {z}\n" for x in (0, 20) for y in (0, 20) for z in (0, 20)) + \
    "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n"


class Surface(tool.ToolTest):
    def test_measures_and_mends(self):
        self.write("cube.obj", CUBE + "f 1 2 4 3\nv 9 9 9\n")
        out, _ = self.run_tool("surface", "cube.obj", "--unit", "mm")
        self.assertIn("OBJ with 9 vertices and 14 triangles, 8 and 12 after mending", out)
        self.assertIn("size 20 x 20 x 20 mm, area 24 cm^2, genus 0\nclosed, volume 8 cm^3", out)
        self.assertIn("mended: 1 vertices that no triangle uses: left out (vertex 8 at (9, 9, 9) mm)", out)
        self.assertIn("mended: 2 triangles that lie on another one with the same corners: left out (triangle 12", out)
        self.assertFalse((self.folder / "out").exists())

    def test_json_is_in_si_units(self):
        self.write("cube.obj", CUBE)
        out, _ = self.run_tool("surface", "cube.obj", "--size", "0.2 m", "--json")
        facts = json.loads(out)
        self.assertAlmostEqual(facts["volume"], 8e-3, places=12)
        self.assertAlmostEqual(facts["area"], 0.24, places=12)
        self.assertEqual(facts["high"], [0.2, 0.2, 0.2])
        self.assertEqual((facts["closed"], facts["boundary_loops"], facts["genus"]), (True, 0, 0))
        self.assertEqual([note["what"] for note in facts["notes"]], ["polygons with more than 3 corners"])

    def test_written_surfaces_come_back(self):
        self.write("open.obj", CUBE.replace("f 2 6 8 4\n", ""))
        for name in ("a.ply", "a.obj"):
            out, _ = self.run_tool("surface", "open.obj", "--size", "100 mm", "--out", name)
            self.assertIn("open, 1 boundary, the longest 400 mm", out)
            self.assertIn(f"wrote {name}\n", out)
            facts = json.loads(self.run_tool("surface", name, "--unit", "mm", "--json")[0])
            self.assertEqual((facts["triangles"], facts["boundary_loops"]), (10, 1))
            self.assertAlmostEqual(facts["area"], 0.05, places=12)
            self.assertEqual(facts["notes"], [])
        mesh = meshio.read(self.folder / "a.ply")
        self.assertEqual(len(mesh.cells_dict["triangle"]), 10)
        self.assertTrue(math.isclose(mesh.points.max(), 100))

    def test_asks_for_the_unit(self):
        self.write("cube.obj", CUBE)
        _, err = self.run_tool("surface", "cube.obj", code=3)
        self.assertIn("20 mm in mm, 200 mm in cm, 20 m in m, 508 mm in in", err)
        self.assertIn("--size", err)
        _, err = self.run_tool("surface", "cube.obj", "--unit", "m", code=3)
        self.assertIn("20 m across", err)
        self.assertIn("--unit mm or --unit cm or --unit in", err)
        self.run_tool("surface", "cube.obj", "--size", "20 m")
        for wrong in (("--unit", "kg"), ("--size", "230"), ("--unit", "mm", "--size", "1 m")):
            self.run_tool("surface", "cube.obj", *wrong, code=3)

    def test_refuses_with_the_place(self):
        self.write("cube.obj", CUBE + "f 1 2 300\n")
        _, err = self.run_tool("surface", "cube.obj", "--unit", "mm", code=3)
        self.assertIn("cube.obj:15: there is no vertex 300", err)
        self.write("two.obj", CUBE + "v 90 0 0\nv 99 0 0\nv 90 9 0\nf 9 10 11\n")
        _, err = self.run_tool("surface", "two.obj", "--unit", "mm", code=3)
        self.assertIn("2 separate pieces", err)
        self.assertIn("--keep-largest", err)
        out, _ = self.run_tool("surface", "two.obj", "--unit", "mm", "--keep-largest")
        self.assertIn("closed", out)
        self.run_tool("surface", "none.obj", "--unit", "mm", code=4)
        _, err = self.run_tool("surface", "cube.obj", "--unit", "mm", "--out", "cube.obj", code=3)
        self.assertIn("the output is the input", err)
        _, err = self.run_tool("surface", "cube.obj", "--unit", "mm", "--out", "cube.stl", code=3)
        self.assertIn(".ply, .obj", err)


if __name__ == "__main__":
    tool.main()
