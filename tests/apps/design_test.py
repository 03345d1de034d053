"""lissom design and lissom examples: from a surface and its poses to a print file."""
import json
import math
import signal
import time
import zipfile

import tool

ENDS = (0, 12, 13)  # converged, out of iterations, no step lowers the objective: whatever a few iterations come to


def sheet_obj(cells=10, size=100.0, dome=12.0, moved=None):
    """A square sheet with a dome, in mm, as OBJ."""
    lines = []
    for i in range(cells + 1):
        for j in range(cells + 1):
            x, y = size * i / cells, size * j / cells
            z = dome * math.sin(math.pi * x / size) * math.sin(math.pi * y / size)
            if moved:
                x, y, z = moved(x, y, z)
            lines.append(f"v {x} {y} {z}")
    at = lambda i, j: i * (cells + 1) + j + 1
    for i in range(cells):
        for j in range(cells):
            lines.append(f"f {at(i, j)} {at(i + 1, j)} {at(i + 1, j + 1)} {at(i, j + 1)}")
    return "\n".join(lines) + "\n"


def cube_obj():
    """A closed cube of 60 mm."""
    corners = [(x, y, z) for z in (0, 60) for y in (0, 60) for x in (0, 60)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    return "".join(f"v {x} {y} {z}\n" for x, y, z in corners) + "".join("f %d %d %d %d\n" % f for f in faces)


def box(low, high):
    return {"box": [[1000 if v is None and s > 0 else -1000 if v is None else v for v in side]
                    for side, s in ((low, -1), (high, 1))]}


EDGE = box((None, None, None), (15, None, None))  # two columns of vertices: a clamp
FAR = box((90, None, None), (None, None, None))


def project(**more):
    """A sheet held at one edge and pulled up at the other, then bent by hand."""
    made = {
        "lissom_project": 1,
        "title": "Flap",
        "surface": {"file": "sheet.obj", "unit": "mm"},
        "topology": {"cells": {"count": 12}},
        "rods": {"edges": 4},
        "deformers": {"felt": {"kind": "shell", "youngs_modulus": "20 MPa", "thickness": "2 mm",
                               "regions": [{"low": [50, -1000, -1000], "high": [1000, 1000, 1000], "stiffness": 0.2,
                                            "blend": "20 mm"}]}},
        "poses": [{"pose": {"name": "up", "supports": [{"at": EDGE, "hold": "pin"}],
                            "forces": [{"at": FAR, "force": [0, 0, 0.6], "shared": True}]}, "deformer": "felt"}],
        "design": {"iterations": [3, 0, 0, 3]},
    }
    made.update(more)
    return made


class Design(tool.ToolTest):
    def setUp(self):
        super().setUp()
        self.write("sheet.obj", sheet_obj())

    def refused(self, changed, *said, code=3):
        self.write("bad.lissom", changed)
        _, error = self.run_tool("design", "bad.lissom", "-o", "bad", code=code)
        for text in said:
            self.assertIn(text, error)
        self.assertEqual([p for p in self.folder.glob("bad/*design*")], [])

    def test_from_a_surface_to_a_print_file(self):
        self.write("flap.lissom", project())
        out, _ = self.run_tool("design", "flap.lissom", "-o", "out", "--json", code=ENDS)
        done = json.loads(out)
        self.assertLess(done["rms_after"], 0.6 * done["rms_before"])
        self.assertGreater(done["poses"][0]["farthest"], 0.02)
        self.assertEqual(done["nodes"], done["joints"] + 3 * done["rods"])
        self.assertEqual(done["edges"], 4 * done["rods"])
        self.assertEqual(done["joints"] - done["rods"] + 12, 1)  # of a disc
        self.assertEqual(done["print"]["errors"], 0)
        self.assertLess(done["rms_radii_only"], done["rms_before"])
        self.assertLess(done["rms_after"], done["rms_radii_only"])
        self.assertEqual(done["poses"][0]["rms_radii_only"], done["rms_radii_only"])
        self.assertGreater(done["seconds"], 0)
        self.assertEqual(self.result("out/flap-rods.lissom")["design"]["wishes"]["clearance"], "0.6 mm")
        with zipfile.ZipFile(self.folder / "out/flap.3mf") as archive:
            self.assertIsNone(archive.testzip())
        page = (self.folder / "out/flap-design.html").read_text()
        for heading in ("Poses, by the distance", "By radii alone", "What is printed", "What speaks against printing it"):
            self.assertIn(heading, page)
        # What is between the steps is a document like any other.
        self.run_tool("solve", "out/flap-rods.lissom", "-o", "again")
        self.run_tool("solve", "out/flap-designed.lissom", "-o", "again")

    def test_a_pose_that_is_held_back_is_only_judged(self):
        posed = sheet_obj(moved=lambda x, y, z: (x, y, z + 0.002 * x * x))
        self.write("posed.obj", posed)
        poses = project()["poses"] + [
            {"pose": {"name": "test", "supports": [{"at": EDGE, "hold": "pin"}, {"at": FAR, "hold": "pin"}]},
             "mesh": "posed.obj", "held_back": True}]
        self.write("flap.lissom", project(poses=poses))
        out, _ = self.run_tool("design", "flap.lissom", "-o", "out", "--json", code=ENDS)
        done = json.loads(out)
        self.assertEqual([p["held_back"] for p in done["poses"]], [False, True])
        self.assertEqual(done["rms_after"], done["poses"][0]["rms_after"])
        self.assertGreater(done["poses"][1]["rms_after"], 0)
        goals = self.result("out/flap-rods.lissom")["design"]["goals"]
        self.assertEqual([goal["pose"] for goal in goals], ["up"])

    def test_a_table_holds_the_rods(self):
        self.write("sheet.obj", sheet_obj(dome=0))
        everything = box((None, None, None), (None, None, None))
        poses = [{"pose": {"name": "pulled", "supports": [{"at": EDGE, "hold": "pin"}, {"at": FAR, "hold": "pin"},
                                                          {"at": everything, "hold": ["z"]}]},
                  "warp": [[[x, y, 0], [1.2 * x, y, 0]] for x in (0, 50, 100) for y in (0, 100)]}]
        self.write("flap.lissom", project(poses=poses, deformers={}))
        self.run_tool("design", "flap.lissom", "-o", "out", code=ENDS)
        pose = self.result("out/flap-rods.lissom")["poses"][0]
        self.assertEqual([support["hold"] for support in pose["supports"]], [["z"]])
        self.assertGreater(len(pose["soft_pins"]), 4)

    def test_warps_patterns_and_drawings(self):
        bent = [[[x, y, 0], [x, y, 0.003 * x * x]] for x in (0, 50, 100) for y in (0, 100)]
        poses = [{"pose": {"name": "bent", "supports": [{"at": EDGE, "hold": "pin"}, {"at": FAR, "hold": "pin"}]},
                  "warp": bent}]
        self.write("lines.obj", "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 50 50 0\n"
                   "l 1 2\nl 2 3\nl 3 4\nl 4 1\nl 1 5 3\nl 2 5 4\n")
        for topology, rods in (({"pattern": {"shape": "quads", "width": "24 mm"}}, 40),
                               ({"lines": {"file": "lines.obj"}}, 8), ({"dual": {"triangles": 20}}, None)):
            self.write("flap.lissom", project(topology=topology, poses=poses, deformers={}))
            out, _ = self.run_tool("design", "flap.lissom", "-o", "out", "--json", code=(1, *ENDS))
            done = json.loads(out)
            self.assertLess(done["rms_after"], done["rms_before"])
            if rods:
                self.assertEqual(done["rods"], rods)

    def test_bodies_pose_closed_surfaces(self):
        self.write("cube.obj", cube_obj())
        low, high = box((None,) * 3, (None, None, 1)), box((None, None, 59), (None,) * 3)
        body = {"body": {"kind": "solid", "youngs_modulus": "1 MPa", "cell": "15 mm"}}
        poses = [{"pose": {"name": "sheared", "supports": [{"at": low, "hold": "pin"}],
                           "forces": [{"at": high, "force": [60, 0, 0], "shared": True}]}, "deformer": "body"}]
        changed = project(surface={"file": "cube.obj", "unit": "mm"}, deformers=body, poses=poses,
                          topology={"cells": {"count": 24}})
        self.write("cube.lissom", changed)
        out, _ = self.run_tool("design", "cube.lissom", "-o", "out", "--json", code=(1, *ENDS))
        done = json.loads(out)
        self.assertEqual(done["joints"] - done["rods"] + 24, 2)  # of a sphere
        self.assertLess(done["rms_after"], done["rms_before"])

    def test_a_killed_run_goes_on_to_the_same_bytes(self):
        self.write("flap.lissom", project(design={"iterations": [12, 6, 0, 12]}))
        self.run_tool("design", "flap.lissom", "-o", "whole", code=ENDS)
        run = self.start("design", "flap.lissom", "-o", "killed")
        checkpoint = self.folder / "killed/flap-design.checkpoint.json"
        until = time.monotonic() + 60
        while not checkpoint.exists() and run.poll() is None and time.monotonic() < until:
            time.sleep(0.005)
        run.send_signal(signal.SIGKILL)
        run.communicate()
        made = (self.folder / "killed/flap-rods.lissom").stat().st_mtime_ns
        self.run_tool("design", "flap.lissom", "-o", "killed", "--resume", code=ENDS)
        self.assertEqual((self.folder / "killed/flap-rods.lissom").stat().st_mtime_ns, made)
        for name in ("flap-designed.lissom", "flap.3mf"):
            self.assertEqual((self.folder / "whole" / name).read_bytes(), (self.folder / "killed" / name).read_bytes())

    def test_resuming_notices_that_the_surface_has_changed(self):
        self.write("flap.lissom", project(design={"iterations": [1, 0, 0, 0]}))
        self.run_tool("design", "flap.lissom", "-o", "out", code=ENDS)
        before = (self.folder / "out/flap-rods.lissom").read_bytes()
        self.write("sheet.obj", sheet_obj(dome=20.0))
        _, error = self.run_tool("design", "flap.lissom", "-o", "out", "--resume", code=3)
        self.assertIn("made from another document", error)
        self.run_tool("design", "flap.lissom", "-o", "out", code=ENDS)
        self.assertNotEqual((self.folder / "out/flap-rods.lissom").read_bytes(), before)

    def test_a_structure_with_a_brief_is_designed_and_printed(self):
        self.run_tool("examples", "sheet", "-o", "examples")
        document = self.result("examples/sheet.lissom")
        document["design"]["stages"] = []
        document["design"]["settings"] = {"iterations": 1}
        document["design"]["parameters"] = document["design"]["parameters"][:1]
        self.write("sheet.lissom", document)
        out, _ = self.run_tool("design", "sheet.lissom", "-o", "out", "--json", code=(1, *ENDS))
        done = json.loads(out)
        self.assertEqual((done["rods"], done["joints"], done["nodes"], done["edges"]), (71, 54, 693, 710))
        self.assertEqual(len(done["poses"]), 4)

    def test_bad_projects_are_refused_at_the_place(self):
        good = project()
        self.refused(project(surface={"file": "missing.obj", "unit": "mm"}), "missing.obj", code=4)
        self.refused(project(surface={"file": "sheet.obj"}), "--unit")
        self.refused(project(surface={"file": "../sheet.obj", "unit": "mm"}), "../sheet.obj", code=(3, 4))
        pose = good["poses"][0]
        self.refused(project(poses=[{**pose, "deformer": "silk"}]), "/poses/0/deformer", "silk")
        self.refused(project(poses=[{**pose, "mesh": "sheet.obj"}]), "/poses/0", "several ways")
        self.refused(project(poses=[{**pose, "held_back": True}]), "held back")
        free = {**pose, "pose": {"name": "free"}}
        self.refused(project(poses=[free]), "/poses/0/pose/supports")
        nowhere = {"at": box((200, 0, 0), (300, 1, 1)), "hold": "pin"}
        self.refused(project(poses=[{**pose, "pose": {"name": "up", "supports": [nowhere]}}]), "/poses/0")
        corner = {"at": box((None, None, None), (1, 1, None)), "hold": "pin"}
        thin = {**pose, "pose": {**pose["pose"], "supports": [pose["pose"]["supports"][0], corner]}}
        self.write("thin.lissom", project(poses=[thin]))
        solid = {"felt": {"kind": "solid"}}
        self.refused(project(deformers=solid), "/deformers/felt")
        self.refused(project(rods={"material": "steeel"}), "/rods/material")
        self.refused(project(rods={"r_n": "9 mm"}), "/rods/r_n")
        self.refused(project(design={"radii": ["1 mm", "10 mm"]}), "/design/radii", "eighth")
        self.refused(project(design={"method": "magic"}), "/design/method")
        self.refused(project(print={"process": "sls", "bed": [0, 1, 1]}), "/print/bed")
        self.refused(project(topology={"cells": {"count": 2}}), "/topology/cells/count")
        self.refused(project(topology={}), "/topology")
        self.refused(project(topology={"pattern": {"shape": "quads", "width": "300 mm"}}), "/topology/pattern")
        self.refused(project(lines=1), "lines")
        self.write("short.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        posed = {"pose": pose["pose"], "mesh": "short.obj"}
        self.refused(project(poses=[posed]), "/poses/0/mesh", "121")

    def test_examples_are_listed_and_written(self):
        out, _ = self.run_tool("examples")
        for name in ("sheet", "hat", "dinosaur", "smiley"):
            self.assertIn(name, out)
            self.run_tool("examples", name, "-o", "all")
            self.assertTrue((self.folder / "all" / f"{name}.lissom").exists())
        for name in ("hat", "dinosaur", "face"):
            self.run_tool("surface", f"all/{name}.ply", "--unit", "mm")
        _, error = self.run_tool("examples", "horse", code=3)
        self.assertIn("horse", error)


if __name__ == "__main__":
    tool.main()
