"""`lissom calibrate`: finds moduli from files of measurements, writes what it found, and says what is wrong with them."""
import json
import math
import pathlib
import random

import tool

AREA = math.pi * 1e-6  # m^2
MODULUS = 31.7e6       # Pa, that measurements are made with
LENGTH = 0.1           # m


def rod(measurement=None, **more):
    """A rod that weights hang on; its modulus is sought."""
    document = {
        "lissom": 1,
        "title": "Printed rod",
        "materials": {"print": {"youngs_modulus": "10 MPa", "poisson_ratio": 0.4}},
        "rods": [{"name": "beam", "line": [[0, 0, 0], [100, 0, 0]], "edges": 2, "material": "print",
                  "section": {"radius": "1 mm"}}],
        "sets": {"foot": {"rod": "beam", "at": "start"}, "tip": {"rod": "beam", "at": "end"}},
        "poses": [{"name": "hung", "supports": [{"at": "foot", "hold": "clamp"}],
                   "forces": [{"at": "tip", "force": [1, 0, 0]}]}],
        "calibration": {
            "parameters": [{"youngs_modulus": {"range": ["1 MPa", "100 GPa"]}}],
            "measurements": [measurement or {"force_length": {"file": "pull.csv", "from": "foot", "to": "tip"}}],
        },
    }
    document.update(more)
    return document


def lengths(forces, noise=0.0):
    """Lengths in mm by Hooke's law."""
    scatter = random.Random(3)
    return [1e3 * LENGTH * (1 + f / (MODULUS * AREA)) + (scatter.gauss(0, noise) if noise else 0) for f in forces]


def pairs(forces, noise=0.0):
    rows = [f"{f!r}, {x!r}" for f, x in zip(forces, lengths(forces, noise))]
    return "\n".join(["force [N], length [mm]", *rows]) + "\n"


class Calibrate(tool.ToolTest):
    def files(self):
        return sorted(p.name for p in (self.folder / "out").glob("*")) if (self.folder / "out").exists() else []

    def refused(self, document, csv, *messages, code=3, name="pull.csv"):
        """Nothing is written, and one line says what is wrong."""
        self.write("rod.lissom", document)
        if csv is not None:
            self.write(name, csv)
        _, err = self.run_tool("calibrate", "rod.lissom", code=code)
        for message in messages:
            self.assertIn(message, err)
        self.assertEqual(len(err.strip().splitlines()), 1, err)
        self.assertEqual(self.files(), [])

    def test_finds_a_modulus_from_weights(self):
        self.write("rod.lissom", rod())
        self.write("pull.csv", pairs([1, 2, 3, 4]))
        out, _ = self.run_tool("calibrate", "rod.lissom", "--json")
        summary = json.loads(out)
        self.assertEqual(summary["verdict"], "converged")
        found = summary["parameters"][0]
        self.assertEqual((found["unit"], found["state"]), ("Pa", "determined"))
        self.assertLess(abs(found["value"] / MODULUS - 1), 1e-8)
        self.assertEqual(self.files(), ["rod-calibrated.lissom", "rod-calibration-residuals.svg", "rod-calibration.html",
                                        "rod-calibration.json", "rod-calibration.svg"])
        self.assertEqual(sorted(pathlib.Path(f).name for f in summary["files"]), self.files())
        # The document that is written is the structure with the modulus that was found.
        calibrated = self.result("out/rod-calibrated.lissom")
        self.assertNotIn("calibration", calibrated)
        self.assertEqual(calibrated["materials"]["print"]["source"], "calibrated from pull.csv")
        self.run_tool("solve", "out/rod-calibrated.lissom", "-o", "again")
        tip = self.result("again/rod-calibrated-hung.json")["state"]["unknowns"][6]
        self.assertAlmostEqual(1e3 * tip, lengths([1])[0], delta=1e-6)
        page = (self.folder / "out/rod-calibration.html").read_text(encoding="utf-8")
        self.assertTrue(page.startswith("<!DOCTYPE html>"))
        self.assertNotIn("http://", page.replace("http://www.w3.org", ""))

    def test_scattered_lengths_have_the_intervals_of_regression(self):
        forces = [1, 2, 3, 4, 5, 6, 7, 8]
        self.write("rod.lissom", rod())
        self.write("pull.csv", pairs(forces, noise=0.3))
        out, _ = self.run_tool("calibrate", "rod.lissom", "--json")
        summary = json.loads(out)
        self.assertEqual(summary["degrees_of_freedom"], 7)
        # Lengths are linear in the compliance 1 / E.
        x = [1e3 * LENGTH * f / AREA for f in forces]
        y = [length - 100 for length in lengths(forces, noise=0.3)]
        slope = sum(a * b for a, b in zip(x, y)) / sum(a * a for a in x)
        deviation = math.sqrt(sum((b - slope * a) ** 2 for a, b in zip(x, y)) / 7)
        relative = deviation / math.sqrt(sum(a * a for a in x)) / slope
        found = summary["parameters"][0]
        self.assertAlmostEqual(found["value"] * slope, 1, delta=1e-8)
        self.assertAlmostEqual(found["standard_error"] / found["value"] / relative, 1, delta=1e-6)
        self.assertAlmostEqual(1e3 * summary["residual_standard_deviation"] / deviation, 1, delta=1e-6)
        self.assertAlmostEqual(summary["student_t"], 2.364624, delta=1e-6)
        half = summary["student_t"] * found["standard_error"]
        self.assertAlmostEqual(found["interval"][0] / (found["value"] - half), 1, delta=1e-12)
        rows = self.result("out/rod-calibration.json")["measurements"][0]["rows"]
        self.assertEqual([row["force"] for row in rows], forces)
        self.assertEqual(rows[2]["place"], "pull.csv:4")
        text, _ = self.run_tool("calibrate", "rod.lissom", "--picture", "png")
        self.assertIn("95 % interval", text)
        self.assertEqual((self.folder / "out/rod-calibration.png").read_bytes()[:4], b"\x89PNG")

    def test_threads_change_no_byte(self):
        self.write("rod.lissom", rod())
        self.write("pull.csv", pairs([1, 2, 3, 4, 5], noise=0.3))
        for threads in ("1", "2"):
            self.run_tool("calibrate", "rod.lissom", "-o", threads, "--threads", threads)
        one, two = ({p.name: p.read_bytes().replace(b"-o " + folder.encode(), b"") for p in (self.folder / folder).iterdir()}
                    for folder in ("1", "2"))
        self.assertEqual(len(one), 5)
        self.assertEqual(one, two)

    def test_units_are_those_of_the_header(self):
        self.write("rod.lissom", rod())
        forces = [100, 200, 300]  # gf
        stretched = [x - 100 for x in lengths([f * 9.80665e-3 for f in forces])]
        self.write("pull.csv", "Force (gf); Displacement (cm); time (s)\n" +
                   "".join(f"{f}; {x / 10!r}; 0\n" for f, x in zip(forces, stretched)))
        out, _ = self.run_tool("calibrate", "rod.lissom", "--json")
        summary = json.loads(out)
        self.assertLess(abs(summary["parameters"][0]["value"] / MODULUS - 1), 1e-8)
        self.assertEqual(summary["notes"], ['column "time" of pull.csv was not read'])

    def test_finds_a_modulus_from_a_shape(self):
        truth = rod(materials={"print": {"youngs_modulus": "31.7 MPa", "poisson_ratio": 0.4}})
        truth["rods"][0]["edges"] = 10
        truth["poses"][0]["forces"][0]["force"] = [0, 0, "-10 mN"]
        del truth["calibration"]
        self.write("truth.lissom", truth)
        self.run_tool("solve", "truth.lissom", "--tolerance", "1e-9")
        q = self.result("out/truth-hung.json")["state"]["unknowns"]
        places = ["beam:0.5", "tip"]
        rows = [f"hung, {place}, {1e3 * q[3 * n]!r}, {1e3 * q[3 * n + 2]!r}" for place, n in zip(places, (5, 10))]
        self.write("shape.csv", "\n".join(["pose, place, x [mm], z [mm]", *rows]))
        document = rod({"shapes": {"file": "shape.csv"}})
        document["rods"][0]["edges"] = 10
        document["poses"] = truth["poses"]
        self.write("rod.lissom", document)
        out, _ = self.run_tool("calibrate", "rod.lissom", "-o", "found", "--json")
        summary = json.loads(out)
        self.assertEqual(summary["measured_numbers"], 4)
        self.assertLess(abs(summary["parameters"][0]["value"] / MODULUS - 1), 1e-6)
        rows = self.result("found/rod-calibration.json")["measurements"][0]["rows"]
        self.assertEqual([(row["node"], row["axis"]) for row in rows], [(5, "x"), (5, "z"), (10, "x"), (10, "z")])
        page = (self.folder / "found/rod-calibration.html").read_text(encoding="utf-8")
        self.assertIn("Pose hung [shape.csv:2]", page)
        # By numbers of nodes it is the same.
        self.write("shape.csv", "\n".join(["node, x [m], z [m]", *(f"{n}, {q[3 * n]!r}, {q[3 * n + 2]!r}" for n in (5, 10))]))
        out, _ = self.run_tool("calibrate", "rod.lissom", "-o", "found", "--json")
        self.assertLess(abs(json.loads(out)["parameters"][0]["value"] / MODULUS - 1), 1e-6)

    def test_the_examples_of_the_guide_find_their_materials(self):
        for file in (tool.ROOT / "scenes" / "data" / "calibration").iterdir():
            self.write(file.name, file.read_text(encoding="utf-8"))
        truths = {"rod": [27.5e6], "strips": [62, 24, 0.35]}
        for name, truth in truths.items():
            out, _ = self.run_tool("calibrate", f"{name}.lissom", "--json")
            for value, found in zip(truth, json.loads(out)["parameters"], strict=True):
                self.assertEqual(found["state"], "determined")
                low, high = found["interval"]
                self.assertTrue(low < value < high, found)
                self.assertLess(high - low, 0.1 * value)
        self.assertEqual(self.result("out/rod-calibration.json")["measurements"][0]["measured"], "displacement")

    def test_says_what_is_not_determined(self):
        self.write("rod.lissom", rod())
        self.write("pull.csv", "force [N], length [mm]\n0, 100\n0, 100.01\n")
        out, _ = self.run_tool("calibrate", "rod.lissom", code=20)
        self.assertIn("not determined: the measurements do not depend on it", out)
        found = self.result("out/rod-calibration.json")["parameters"][0]
        self.assertEqual((found["state"], found["value"], found["interval"]), ("undetermined", None, None))
        self.write("pull.csv", "force [N], length [mm]\n1, 200000\n2, 400000\n")
        out, _ = self.run_tool("calibrate", "rod.lissom", code=20)
        self.assertIn("at its lower bound", out)
        self.assertEqual(self.result("out/rod-calibration.json")["parameters"][0]["value"], 1e6)

    def test_two_moduli_in_a_row_cannot_be_told_apart(self):
        document = rod({"force_length": {"file": "pull.csv", "from": "foot", "to": "tip"}})
        document["materials"]["other"] = document["materials"]["print"]
        document["rods"] = [{**document["rods"][0], "line": [[0, 0, 0], [50, 0, 0]]},
                            {**document["rods"][0], "name": "rest", "line": [[50, 0, 0], [100, 0, 0]], "material": "other"}]
        document["sets"]["tip"] = {"rod": "rest", "at": "end"}
        self.write("rod.lissom", document)
        self.write("pull.csv", pairs([1, 2, 3]))
        out, _ = self.run_tool("calibrate", "rod.lissom", code=20)
        self.assertIn('only a combination with material "print": Young\'s modulus is', out)
        summary = self.result("out/rod-calibration.json")
        self.assertEqual(summary["undetermined_combinations"], [[0, 1]])
        self.assertEqual([p["state"] for p in summary["parameters"]], ["undetermined"] * 2)

    def test_without_freedom_there_is_no_interval(self):
        self.write("rod.lissom", rod())
        self.write("pull.csv", pairs([2]))
        out, _ = self.run_tool("calibrate", "rod.lissom")
        self.assertIn("no interval", out)
        self.assertIsNone(self.result("out/rod-calibration.json")["parameters"][0]["interval"])

    def test_says_what_is_wrong_with_files(self):
        head = "force [N], length [mm]\n"
        place = "/calibration/measurements/0/force_length/file"
        self.refused(rod(), None, place, 'no file "pull.csv"', code=4)
        self.refused(rod(), "", "pull.csv: the file is empty")
        self.refused(rod(), head, "pull.csv:1: there are no rows")
        self.refused(rod(), "force, length [mm]\n1, 100\n", 'pull.csv:1:1: the column "force" has no unit')
        self.refused(rod(), "force [lb], length [mm]\n1, 100\n", "pull.csv:1:1:", 'unknown unit "lb"')
        self.refused(rod(), "force [N], length [MPa]\n1, 100\n", "pull.csv:1:12:", "got a stress")
        self.refused(rod(), "force [g], length [mm]\n1, 100\n", "pull.csv:1:1:", "write gf or kgf")
        self.refused(rod(), head + "1, 101\n2, NaN\n", 'pull.csv:3:4: "NaN" is not a finite number')
        self.refused(rod(), head + "1, 101\n2\n", "pull.csv:3: this row has 1 cells, the header 2")
        self.refused(rod(), "weight [N], length [mm]\n1, 101\n", 'pull.csv:1: there is no column "force"')
        self.refused(rod(), "force [N], length [mm], sigma [mm]\n1, 101, 0\n", "pull.csv:2:9: a standard deviation")
        self.refused(rod(), "force [N], length [mm], sigma [N]\n1, 101, 1\n", "pull.csv:1:25:", "got a force")
        other = rod({"force_length": {"file": "../pull.csv", "from": "foot", "to": "tip"}})
        self.refused(other, None, place, "leads out of the folder", code=4)

    def test_says_what_is_wrong_with_shapes(self):
        document = rod({"shapes": {"file": "pull.csv"}})
        head = "pose, place, x [mm]\n"
        self.refused(document, head + "hung, tap, 100\n", 'pull.csv:2:7: there is no set or rod "tap"')
        self.refused(document, head + "hang, tip, 100\n", 'pull.csv:2:1: there is no pose "hang"')
        self.refused(document, head + "hung, beam, 100\n", 'pull.csv:2:7: "beam" are 3 nodes')
        self.refused(document, head + "hung, tip, \n", "pull.csv:2: no coordinate of this place")
        self.refused(document, "node, x [mm]\n3, 100\n", 'pull.csv:2:1: there is no node "3"', "0 to 2")
        self.refused(document, "place, w [mm]\ntip, 100\n", 'there is no column "x"')
        self.refused(document, "x [mm]\n100\n", 'there is no column "place"')

    def test_says_what_cannot_be_fitted(self):
        document = rod()
        document["materials"]["other"] = document["materials"]["print"]
        document["rods"].append({**document["rods"][0], "name": "second", "line": [[100, 0, 0], [150, 0, 0]],
                                 "material": "other"})
        self.refused(document, pairs([1]), "1 measured number cannot determine 2 parameters")
        document = rod({"force_length": {"file": "pull.csv", "from": "left", "to": "right", "prescribed": "length"}})
        document["rods"] = []
        document["membranes"] = [{"name": "strip", "grid": {"size": [100, 30], "cells": [2, 1]}, "material": "jersey"}]
        document["membrane_materials"] = {"jersey": {"stiffness": "20 N/m", "poisson_ratio": 0.2}}
        document["sets"] = {"left": {"box": [[0, 0, 0], [0, 30, 0]]}, "right": {"box": [[100, 0, 0], [100, 30, 0]]}}
        document["poses"] = [{"name": "slack", "supports": [{"at": "left", "hold": "pin"}, {"at": "right", "hold": "pin"}]}]
        document["calibration"]["parameters"] = [{"fabric": {"stiffness": ["0.1 N/m", "1 kN/m"]}}]
        self.refused(document, "length [mm], force [N]\n120, 1\n100, 0\n", "pull.csv:3: ", "check the numbers of this row")
        document = rod()
        del document["calibration"]
        self.refused(document, None, "does not say what is unknown")


if __name__ == "__main__":
    assert pathlib.Path(tool.TOOL).exists(), tool.TOOL
    tool.main()
