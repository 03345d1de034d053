"""The other commands: verify, path, draw, convert, schema, scenes."""
import csv
import json
import math
import signal
import xml.etree.ElementTree as ElementTree

import tool

TIP = {"quantity": "displacement", "at": "tip", "axis": "-z", "unit": "mm"}
RADIUS, LENGTH = 1e-3, 0.2  # m


class FitFabric(tool.ToolTest):
    # Exact pulls of a fabric with Y1 40 N/m, Y2 15 N/m, Poisson ratio 0.25.
    PULLS = [{"angle": 0, "stretch": 1.25, "force_per_width": "14.0625 N/m", "across": 0.87770174},
             {"angle": 90, "stretch": 1.25, "force_per_width": "5.2734375 N/m", "across": 0.95597339}]

    def document(self, pulls):
        self.write("jersey.lissom", {"lissom": 1, "fabric_tests": {"jersey": pulls}})

    def test_finds_the_moduli(self):
        self.document(self.PULLS)
        out, _ = self.run_tool("fit-fabric", "jersey.lissom")
        self.assertIn("Y1 40 N/m along the warp, Y2 15 N/m along the weft, Poisson ratio 0.25", out)
        out, _ = self.run_tool("fit-fabric", "jersey.lissom", "--json")
        fabric = json.loads(out)["fabrics"][0]
        self.assertAlmostEqual(fabric["stiffness_1"], 40, delta=1e-3)
        self.assertAlmostEqual(fabric["shear"], 9.79796, delta=1e-3)
        self.assertEqual(fabric["measured"], 4)

    def test_prints_a_fabric_that_a_document_takes(self):
        self.document(self.PULLS)
        out, _ = self.run_tool("fit-fabric", "jersey.lissom")
        fabric = json.loads("{" + out.splitlines()[-1] + "}")
        self.write("sail.lissom", {
            "lissom": 1, "membrane_materials": fabric,
            "membranes": [{"name": "sail", "grid": {"size": [10, 10], "cells": [2, 2]}, "material": "jersey"}],
            "expect": [{"quantity": "bending_stiffness", "membrane": "sail", "value": 0, "tolerance": "1 N mm"}]})
        self.run_tool("verify", "sail.lissom")

    def test_says_what_is_missing(self):
        self.document([{k: v for k, v in pull.items() if k != "across"} for pull in self.PULLS])
        _, err = self.run_tool("fit-fabric", "jersey.lissom", code=3)
        self.assertIn("Poisson ratio", err)
        self.document(self.PULLS)
        _, err = self.run_tool("fit-fabric", "jersey.lissom", "--test", "jersy", code=3)
        self.assertIn('did you mean "jersey"?', err)


class Verify(tool.ToolTest):
    def check(self, *entries, code, **document):
        self.write("claims.lissom", tool.cantilever(expect=list(entries), **document))
        out, _ = self.run_tool("verify", "claims.lissom", code=code)
        return out.splitlines()

    def test_passes_and_fails(self):
        self.write("beam.lissom", tool.cantilever())
        self.run_tool("solve", "beam.lissom", "--tolerance", "1e-9")
        result = json.loads((self.folder / "out/beam-loaded.json").read_text(encoding="utf-8"))
        tip = -1000 * result["state"]["unknowns"][3 * 20 + 2]
        lines = self.check({**TIP, "label": "right", "value": tip, "tolerance": "0.001 %"},
                           {**TIP, "label": "wrong", "value": 1.01 * tip, "tolerance": "0.5 %"},
                           {**TIP, "label": "absolute", "value": tip + 1, "tolerance": 1.001}, code=1)
        self.assertTrue(lines[0].startswith("PASS  claims: right: got "), lines[0])
        self.assertTrue(lines[1].startswith("FAIL  claims: wrong: got "), lines[1])
        self.assertIn("deviation -0.99 %, tolerance 0.5 %", lines[1])
        self.assertTrue(lines[2].startswith("PASS  claims: absolute"), lines[2])
        self.assertEqual(lines[-1], "2 passed, 1 failed")

    def test_what_cannot_be_measured_fails_with_the_reason(self):
        wrong = {
            "there is no quantity": {"quantity": "displacment", "at": "tip"},
            'does not read "axis"': {"quantity": "mass", "axis": "x"},
            'needs "axis"': {"quantity": "position", "at": "tip"},
            'needs "fraction"': {"quantity": "curvature", "rod": "beam"},
            "there is no frame": {"quantity": "rotation", "at": {"rod": "beam", "at": 0.5}, "axis": "x"},
            "one node": {"quantity": "slope", "at": "all"},
            'has no "path"': {"quantity": "critical_load_factor"},
            "resolutions": {"quantity": "displacement", "at": "tip", "combine": "order", "edges": [10, 20]},
        }
        for reason, entry in wrong.items():
            lines = self.check({**entry, "value": 1, "tolerance": 1e6}, code=1)
            self.assertTrue(lines[0].startswith("FAIL"), lines[0])
            self.assertIn(reason, lines[0])

    def test_a_document_that_expects_nothing_fails(self):
        lines = self.check(code=1)
        self.assertIn("expects nothing", lines[0])
        self.assertEqual(lines[-1], "0 passed, 1 failed")

    def test_several_files_and_wrong_ones(self):
        self.write("a.lissom", tool.cantilever(expect=[{"quantity": "rest_length", "value": "200 mm", "tolerance": "0.1 %"}]))
        self.write("b.lissom", "{")
        out, _ = self.run_tool("verify", "a.lissom", "b.lissom", "missing.lissom", code=1)
        self.assertEqual(out.splitlines()[-1], "1 passed, 2 failed")
        self.run_tool("verify", "a.lissom", "a.lissom", "--threads", "2")

    def test_statics_of_a_cantilever(self):
        """Reactions balance the load; the small-load rate is P L^3 / 3 B; half the work of a small load is the energy."""
        expect = [
            {"quantity": "reaction_force", "at": "all", "axis": "z", "value": "1.2 mN", "tolerance": "0.0001 %"},
            {"quantity": "reaction_moment_rate", "at": {"rod": "beam", "at": "start"}, "axis": "y",
             "value": "-0.24 N mm", "tolerance": "0.0001 %"},
            {"quantity": "displacement_rate", "at": "tip", "axis": "-z", "divide_by": 0.0012 * LENGTH**3 / 3,
             "value": 1 / (25e6 * math.pi * RADIUS**4 / 4), "tolerance": "0.1 %"},
            {"quantity": "slope", "at": {"rod": "beam", "at": "start"}, "value": 0, "tolerance": "2 deg"},
            {"quantity": "length", "rod": "beam", "value": "200 mm", "tolerance": "0.01 %"},
            {"quantity": "energy", "combine": "difference", "poses": ["loaded", "loaded"], "value": 0, "tolerance": 1e-15},
        ]
        material = {"soft": {"youngs_modulus": "25 MPa", "poisson_ratio": 0.4}}
        document = tool.cantilever(edges=40, materials=material, expect=expect)
        document["rods"][0]["material"] = "soft"
        self.write("claims.lissom", document)
        out, _ = self.run_tool("verify", "claims.lissom")
        self.assertEqual(out.splitlines()[-1], "6 passed, 0 failed")

    def test_lists_quantities(self):
        out, _ = self.run_tool("verify", "--quantities")
        for name in ("displacement", "critical_load", "principal_stiffness"):
            self.assertIn(name, out)


class Path(tool.ToolTest):
    def test_finds_the_buckling_load(self):
        self.write("column.lissom", tool.column())
        out, _ = self.run_tool("path", "column.lissom", "--json", "--vtu", "--watch", "tip", "--axis", "x")
        followed = json.loads(out)["poses"][0]
        critical = followed["critical"][0]
        self.assertEqual(critical["kind"], "bifurcation")
        self.assertAlmostEqual(critical["load_factor"], 0.12112, delta=0.0002)
        self.assertEqual((critical["negative_modes_before"], critical["negative_modes_after"]), (0, 2))  # a round rod
        self.assertEqual(followed["end"]["name"], "reached")
        with open(self.folder / "out/column-loaded-path.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(followed["points"]))
        self.assertEqual(float(rows[-1]["load_factor"]), 0.25)
        self.assertEqual(float(rows[-1]["displacement_m"]), followed["points"][-1]["displacement_m"])
        series = ElementTree.parse(self.folder / "out/column-loaded-path.pvd").findall(".//DataSet")
        self.assertEqual(len(series), len(rows))
        for entry in series:
            self.assertTrue((self.folder / "out" / entry.get("file")).exists())

    def test_stops_where_told(self):
        self.write("column.lissom", tool.column())
        out, _ = self.run_tool("path", "column.lissom", "--stop-at-critical", "--picture", "png")
        self.assertIn("bifurcation at load factor 0.121", out)
        self.assertTrue((self.folder / "out/column-loaded-path.png").exists())

    def test_wrong_use(self):
        self.write("column.lissom", tool.column())
        _, err = self.run_tool("path", "column.lissom", "--to", "0", code=3)
        self.assertIn("same load factor", err)
        _, err = self.run_tool("path", "column.lissom", "--watch", "tipp", code=3)
        self.assertIn('did you mean "tip"', err)


class Modes(tool.ToolTest):
    def test_frequencies_of_a_cantilever(self):
        """f = 1.8751^2 / (2 pi L^2) sqrt(B / rho A), every bending mode twice; the softest motion goes with the force."""
        document = tool.cantilever(edges=40, materials={"soft": {"youngs_modulus": "25 MPa", "poisson_ratio": 0.4,
                                                                 "density": "1200 kg/m^3"}})
        document["rods"][0]["material"] = "soft"
        del document["poses"][0]["forces"]
        self.write("beam.lissom", document)
        out, _ = self.run_tool("modes", "beam.lissom", "--count", "4", "--json", "--vtu")
        modes = json.loads(out)["poses"][0]
        expected = 1.875104**2 / (2 * math.pi * LENGTH**2) * math.sqrt(25e6 * RADIUS**2 / 4 / 1200)
        for vibration in modes["vibrations"][:2]:
            self.assertAlmostEqual(vibration["frequency_Hz"], expected, delta=0.005 * expected)
            self.assertGreater(vibration["bending"], 0.99)
        self.assertEqual(len(modes["softest"]), 4)
        self.assertGreater(modes["softest"][0]["stiffness_N_per_m"], 0)
        for name in ("beam-loaded-modes.svg", "beam-loaded-modes.json", "beam-loaded-soft-3.vtu", "beam-loaded-vibration-0.vtu"):
            self.assertTrue((self.folder / "out" / name).exists(), name)

    def test_weightless_structures_have_no_vibrations(self):
        self.write("column.lissom", tool.column())
        out, _ = self.run_tool("modes", "column.lissom", "--count", "2", "--at-saddle", "stay", code=11)
        self.assertIn("no vibrations: the materials have no density", out)


class Dynamics(tool.ToolTest):
    def released(self, **more):
        """The cantilever let go from its loaded shape, for a little more than one period."""
        document = tool.cantilever(edges=16, force=-0.0002)
        document["poses"].append({"name": "free", "supports": document["poses"][0]["supports"]})
        document["motions"] = [{"name": "swing", "start_pose": "loaded", "pose": "free", "duration": 0.6, "step": 0.004,
                                "record_every": 0.02, **more}]
        return self.write("beam.lissom", document)

    def test_a_released_rod_swings_without_losing_energy(self):
        out, _ = self.run_tool("dynamics", self.released(), "--json", "--vtu", "--watch", "beam", "--watch-axis", "y")
        played = json.loads(out)["motions"][0]
        self.assertEqual(played["verdict"]["name"], "finished")
        self.assertLess(played["balance_error"], 0.01)
        with open(self.folder / "out/beam-swing.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 31)
        self.assertEqual(float(rows[-1]["time_s"]), 0.6)
        elastic = [float(row["elastic_energy_J"]) for row in rows]
        self.assertGreater(elastic[0], 0)
        self.assertLess(min(elastic), 0.2 * elastic[0])
        turn = [float(row["angular_momentum_of_beam"]) for row in rows]
        self.assertTrue(min(turn) < 0 < max(turn))
        series = ElementTree.parse(self.folder / "out/beam-swing.pvd").findall(".//DataSet")
        self.assertEqual(len(series), 31)
        for name in ("beam-swing.json", "beam-swing-energy.svg", "beam-swing-momentum.svg", "beam-swing-turn.svg", "beam-swing-strip.svg"):
            self.assertTrue((self.folder / "out" / name).exists(), name)

    def test_ctrl_c_keeps_what_was_played(self):
        process = self.start("dynamics", self.released(duration=500, step=0.0005, adaptive=False), "--progress")
        for _ in range(3):
            process.stderr.readline()
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 15, out + err)
        with open(self.folder / "out/beam-swing.csv", encoding="utf-8") as file:
            self.assertGreater(len(list(csv.DictReader(file))), 0)

    def test_wrong_use(self):
        self.write("still.lissom", tool.cantilever())
        _, err = self.run_tool("dynamics", "still.lissom", code=3)
        self.assertIn("no motion", err)
        _, err = self.run_tool("dynamics", self.released(), "--motion", "swin", code=3)
        self.assertIn('did you mean "swing"', err)


class Files(tool.ToolTest):
    def test_draw(self):
        self.write("beam.lissom", tool.cantilever())
        self.run_tool("solve", "beam.lissom")
        self.run_tool("draw", "beam.lissom", "--pose", "loaded")
        self.run_tool("draw", "out/beam-loaded.json", "--field", "stress", "--camera", "front", "--size", "640x480", "-o", "a.png")
        for state in ("rest", "deformed", "both"):
            self.run_tool("draw", "out/beam-loaded.json", "--state", state, "-o", state + ".svg")
            ElementTree.parse(self.folder / (state + ".svg"))
        self.assertTrue((self.folder / "out/beam.svg").exists())
        self.assertTrue((self.folder / "a.png").read_bytes().startswith(b"\x89PNG"))
        self.run_tool("draw", "beam.lissom", "--size", "640", code=2)
        self.run_tool("draw", "beam.lissom", "-o", "a.gif", code=3)
        self.run_tool("draw", "beam.lissom", "--field", "colour", "-o", "a.svg", code=3)
        out, _ = self.run_tool("draw", "--fields")
        self.assertIn("curvature", out)

    def test_convert(self):
        self.write("beam.lissom", tool.cantilever())
        self.run_tool("solve", "beam.lissom")
        self.run_tool("convert", "beam.lissom", "beam.obj")
        self.run_tool("convert", "beam.obj", "back.lissom", "--material", "PLA", "--radius", "2 mm", "--edges", "1")
        back = self.result("back.lissom")
        self.assertEqual(back["rods"][0]["material"], "PLA")
        self.run_tool("convert", "back.lissom", "again.lissom")
        self.assertEqual((self.folder / "back.lissom").read_bytes(), (self.folder / "again.lissom").read_bytes())
        for name in ("shape.vtu", "shape.vtp", "shape.ply", "shape.obj"):
            self.run_tool("convert", "out/beam-loaded.json", name, "--obj", "surfaces", "--field", "stress")
            self.assertGreater((self.folder / name).stat().st_size, 1000)
        self.run_tool("convert", "beam.lissom", "beam.stl", code=3)
        self.run_tool("convert", "beam.obj", "x.lissom", "--unit", "second", code=3)

    def test_convert_plans(self):
        plan = {"points": {"a": [60, 0], "b": [0, 60], "c": [-60, 0], "d": [0, -60], "m": [5, 10]},
                "rods": [{"name": "edge", "points": ["a", "b", "c", "d"], "curve": "arc", "closed": True, "ghost": True},
                         {"name": "spine", "points": ["a", "m", "c"]}],
                "material": "PLA", "r_n": "0.3 mm", "r_b": "0.5 mm", "edge_length": "5 mm",
                "fabric": {"material": "soft knit"}}
        self.write("disc.lissom", {"lissom": 1, "plan": plan})
        for drawing in ("disc.svg", "disc.dxf"):
            self.run_tool("convert", "disc.lissom", drawing)
            out, _ = self.run_tool("convert", drawing, "back.lissom", "--fabric", "soft knit")
            self.assertIn("2 rods through 5 points, 120 x 120 mm", out)
            back = self.result("back.lissom")["plan"]
            self.assertEqual([rod["name"] for rod in back["rods"]], ["edge", "spine"])
            self.assertEqual([rod.get("ghost", False) for rod in back["rods"]], [True, False])
            self.assertEqual((back["r_n"], back["r_b"]), ("0.3 mm", "0.5 mm"))
            (self.folder / drawing).unlink()
        self.write("beam.lissom", tool.cantilever())
        _, err = self.run_tool("convert", "beam.lissom", "beam.svg", code=3)
        self.assertIn("the document has no plan to draw", err)

    def test_a_document_may_name_a_drawing(self):
        self.write("net.obj", "v 0 0 0\nv 100 0 0\nv 200 0 0\nv 100 100 0\nl 1 2 3\nl 2 4\n")
        network = {"name": "net", "file": "net.obj", "unit": "mm", "edges": 4, "material": "PLA", "section": {"radius": "1 mm"}}
        pose = {"name": "held", "supports": [{"at": {"rod": "net-0", "at": "start"}, "hold": "clamp"}], "gravity": True}
        self.write("net.lissom", {"lissom": 1, "networks": [network], "poses": [pose]})
        self.run_tool("solve", "net.lissom")
        (self.folder / "net.obj").rename(self.folder / "gone.obj")
        _, err = self.run_tool("solve", "net.lissom", code=4)
        self.assertIn('/networks/0/file: there is no file "net.obj"', err)
        self.run_tool("convert", "out/net-held.json", "whole.lissom")  # a result does not need it
        self.assertEqual(len(self.result("whole.lissom")["rods"]), 3)
        _, err = self.run_tool("solve", "gone.obj", code=3)
        self.assertIn("lissom convert", err)

    def test_convert_does_not_overwrite_what_it_reads(self):
        self.write("net.obj", "v 0 0 0\nv 100 0 0\nl 1 2\n")
        _, err = self.run_tool("convert", "net.obj", "./net.obj", code=3)
        self.assertIn("the output is the input", err)

    def test_schema_is_the_published_one(self):
        out, _ = self.run_tool("schema")
        self.assertEqual(out, (tool.ROOT / "docs/guide/lissom.schema.json").read_text(encoding="utf-8"))

    def test_scenes_can_be_listed_and_written(self):
        out, _ = self.run_tool("scenes")
        for line in out.splitlines():
            name = line.split()[0]
            self.run_tool("scenes", name, "-o", "scene.lissom")
            self.assertEqual(self.result("scene.lissom")["lissom"], 1)
        self.run_tool("scenes", "no-such-scene", code=3)


if __name__ == "__main__":
    tool.main()
