"""lissom print: files that readers of others take, checks before they are written."""
import json
import math
import re
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile

import meshio
import numpy as np
import tool

CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def star(rods=3, radius="1.5 mm", **more):
    """Rods of 30 mm that meet in the origin."""
    lines = [[[0, 0, 0], [30 * math.cos(2 * math.pi * k / rods), 30 * math.sin(2 * math.pi * k / rods), 0]] for k in range(rods)]
    return {"lissom": 1, "title": "Star", "rods": [
        {"name": f"ray-{k}", "line": line, "edges": 6, "material": "TPU 92A", "section": {"radius": radius}}
        for k, line in enumerate(lines)], **more}


def volume(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def closed(triangles):
    """Every edge is used once in each direction."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    forward = {tuple(e) for e in edges.tolist()}
    return len(forward) == len(edges) and all((b, a) in forward for a, b in forward)


def read_3mf(path):
    """(unit, [(name, points, triangles)], names of materials, transforms of the items) by zip and XML alone."""
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        names = archive.namelist()
        assert "[Content_Types].xml" in names and "_rels/.rels" in names, names
        relation = ElementTree.fromstring(archive.read("_rels/.rels"))[0]
        model = ElementTree.fromstring(archive.read(relation.get("Target").lstrip("/")))
    materials = [base.get("name") for base in model.iter(CORE + "base")]
    objects = {}
    for entry in model.iter(CORE + "object"):
        points = np.array([[float(v.get(k)) for k in "xyz"] for v in entry.iter(CORE + "vertex")])
        triangles = np.array([[int(t.get(k)) for k in ("v1", "v2", "v3")] for t in entry.iter(CORE + "triangle")])
        objects[entry.get("id")] = (materials[int(entry.get("pindex"))], points, triangles)
    items = list(model.find(CORE + "build"))
    return model.get("unit"), [objects[i.get("objectid")] for i in items], [i.get("transform") for i in items]


class Print(tool.ToolTest):
    def test_3mf_is_read_by_others(self):
        self.write("star.lissom", star())
        out, _ = self.run_tool("print", "star.lissom", "--out", "star.3mf", "--json")
        said = json.loads(out)
        unit, objects, transforms = read_3mf(self.folder / "star.3mf")
        self.assertEqual(unit, "millimeter")
        self.assertEqual(transforms, [None])
        (material, points, triangles), = objects
        self.assertEqual(material, "TPU 92A")
        self.assertTrue(closed(triangles))
        self.assertEqual(len(triangles), said["objects"][0]["triangles"])
        self.assertEqual(sorted(set(triangles.ravel())), list(range(len(points))))
        self.assertAlmostEqual(volume(points, triangles) * 1e-9 / said["objects"][0]["volume"], 1, delta=1e-5)
        self.assertTrue((points.min(axis=0) >= 0).all() and (points.min(axis=0) < 1e-4).all())
        np.testing.assert_allclose(points.max(axis=0) * 1e-3, said["size"], atol=1e-7)

    def test_stl_is_clean(self):
        self.write("star.lissom", star(rods=5))
        out, _ = self.run_tool("print", "star.lissom", "--out", "star.stl", "--json")
        said = json.loads(out)["objects"][0]
        mesh = meshio.read(self.folder / "star.stl")
        triangles = mesh.cells_dict["triangle"]
        points, number = np.unique(mesh.points.round(6), axis=0, return_inverse=True)
        triangles = number.ravel()[triangles]
        self.assertEqual(len(triangles), said["triangles"])
        self.assertTrue(closed(triangles))
        self.assertAlmostEqual(volume(points.astype(float), triangles) * 1e-9 / said["volume"], 1, delta=1e-4)
        judged = subprocess.run(["admesh", str(self.folder / "star.stl")], capture_output=True, text=True, check=True).stdout
        for wrong in ("Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
                      "Facets reversed", "Backwards edges", "Normals fixed"):
            counts = re.search(wrong + r"\s*:\s*(\d+)", judged)
            self.assertIsNotNone(counts, judged)
            self.assertEqual(counts[1], "0", judged)
        self.assertRegex(judged, r"Number of parts\s*:\s*1\b")

    def test_bytes_are_the_same_at_any_number_of_threads(self):
        self.write("star.lissom", star(rods=4))
        files = []
        for threads in ("1", "2", "3"):
            self.run_tool("print", "star.lissom", "--out", f"{threads}.3mf", "--threads", threads)
            files.append((self.folder / f"{threads}.3mf").read_bytes())
        self.assertEqual(files[0], files[1])
        self.assertEqual(files[0], files[2])

    def test_materials_are_objects(self):
        document = star(rods=2)
        document["rods"][1]["material"] = "PLA"
        self.write("two.lissom", document)
        out, _ = self.run_tool("print", "two.lissom", "--out", "two.3mf", "--cost", "100", "--json")
        _, objects, _ = read_3mf(self.folder / "two.3mf")
        self.assertEqual([o[0] for o in objects], ["TPU 92A", "PLA"])
        first = json.loads(out)["objects"][0]
        self.assertAlmostEqual(first["mass"], 1200 * first["volume"], delta=1e-9)
        self.assertAlmostEqual(first["cost"], 100 * first["mass"], delta=1e-9)
        _, err = self.run_tool("print", "two.lissom", "--out", "two.stl", code=3)
        self.assertIn("single material", err)

    def test_errors_forbid_writing(self):
        self.write("thin.lissom", star(radius="0.3 mm"))
        out, _ = self.run_tool("print", "thin.lissom", "--out", "thin.3mf", code=1)
        self.assertIn("thin rod, ray-0 at (", out)
        self.assertIn("3 errors; --force writes all the same", out)
        self.assertFalse((self.folder / "thin.3mf").exists())
        self.run_tool("print", "thin.lissom", "--out", "thin.3mf", "--force")
        self.assertTrue((self.folder / "thin.3mf").exists())
        self.run_tool("print", "thin.lissom", "--out", "thinner.3mf", "--min-diameter", "0.5 mm")
        out, _ = self.run_tool("print", "thin.lissom", "--out", "small.3mf", "--bed", "40 x 60 x 10 mm", "--force")
        self.assertRegex(out, r"too large.*mm too long along x")

    def test_rods_that_touch_are_named(self):
        document = star()
        document["rods"].append({"name": "bar", "line": [[15, -8, 2], [15, 8, 2]], "edges": 4, "material": "TPU 92A",
                                 "section": {"radius": "1 mm"}})
        self.write("bar.lissom", document)
        out, _ = self.run_tool("print", "bar.lissom", "--out", "bar.3mf", "--json", code=1)
        findings = json.loads(out)["findings"]
        self.assertEqual([f["what"] for f in findings], ["rods touch"])
        self.assertIn("ray-0 and bar at (15.", findings[0]["where"])
        self.assertAlmostEqual(findings[0]["value"], -0.5e-3, delta=1e-4)

    def test_strains_of_poses(self):
        clamp = {"at": {"rod": "beam", "at": "start"}, "hold": "clamp"}
        force = {"at": {"rod": "beam", "at": "end"}, "force": [0, 0, -0.002]}
        document = tool.cantilever(edges=40, poses=[{"name": "pulled", "supports": [clamp], "forces": [force]}])
        document["rods"][0]["line"] = [[0, 0, 0], [100, 0, 0]]
        self.write("beam.lissom", document)
        out, _ = self.run_tool("print", "beam.lissom", "--out", "beam.3mf", "--json")
        strain, = json.loads(out)["strains"]
        # F L r / (E I) with E 32 MPa, r 1 mm: a bit less, as the tip comes closer.
        linear = 0.002 * 0.1 * 1e-3 / (32e6 * math.pi * 1e-12 / 4)
        self.assertAlmostEqual(strain["strain"] / linear, 1, delta=0.12)
        self.assertEqual(strain["limit"], 0.2)
        document["materials"] = {"TPU 92A": {"youngs_modulus": "32 MPa", "poisson_ratio": 0.48, "density": "1200 kg/m^3",
                                             "strain_limit": 0.005}}
        self.write("brittle.lissom", document)
        out, _ = self.run_tool("print", "brittle.lissom", "--out", "brittle.3mf")
        self.assertRegex(out, r"warning +strained too much, beam at \(")
        self.assertTrue((self.folder / "brittle.3mf").exists())
        out, _ = self.run_tool("print", "brittle.lissom", "--out", "brittle.3mf", "--no-poses")
        self.assertNotIn("strained", out)

    def test_rods_of_another_natural_shape_are_warned_of(self):
        points = [[50 * math.cos(math.pi * k / 16), 50 * math.sin(math.pi * k / 16), 0] for k in range(9)]
        self.write("arc.lissom", {"lissom": 1, "rods": [
            {"name": "arc", "spline": points, "edges": 20, "material": "TPU 92A", "section": {"radius": "1 mm"},
             "natural": "straight"}]})
        out, _ = self.run_tool("print", "arc.lissom", "--out", "arc.3mf")
        self.assertIn("sprung rods, arc at (", out)
        self.assertIn("wrote", out)

    def test_refuses_with_a_reason(self):
        self.write("star.lissom", star())
        for arguments, code, words in ((["--out", "star.obj"], 3, ".3mf, .stl"), ([], 2, "--out FILE"),
                                       (["--out", "s.3mf", "--tolerance", "0.1"], 2, "is not a length"),
                                       (["--out", "s.3mf", "--tolerance", "2 m"], 3, "is no tolerance"),
                                       (["--out", "s.3mf", "--bed", "10 mm"], 2, "is no size of a bed"),
                                       (["--out", "s.3mf", "--process", "cnc"], 2, "cnc")):
            _, err = self.run_tool("print", "star.lissom", *arguments, code=code)
            self.assertIn(words, err)
        self.write("cloth.lissom", {"lissom": 1, "membranes": [
            {"name": "sail", "grid": {"size": [10, 10], "cells": [2, 2]}, "material": "jersey"}],
            "membrane_materials": {"jersey": {"stiffness": "40 N/m"}}})
        _, err = self.run_tool("print", "cloth.lissom", "--out", "s.3mf", code=3)
        self.assertTrue(err)

    def test_lists_processes_with_sources(self):
        out, _ = self.run_tool("print", "--processes")
        self.assertEqual(out.count("sources"), 3)


if __name__ == "__main__":
    tool.main()
