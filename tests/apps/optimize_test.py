"""`lissom optimize`: designs converge, stop, go on to the same bytes, and refuse what cannot be meant."""
import json
import math
import pathlib
import random
import signal
import time

import tool

RADIUS = 1.2  # mm, that the targets were made with
ENDS = (0, 12, 13, 18)  # however a design ends: which one it is is in the bytes that are compared


def beam(radius=1.6, edges=20, **design):
    """A cantilever whose radius is sought from where its tip is."""
    document = tool.cantilever(edges=edges, force=-0.002)
    document["rods"][0]["section"] = {"radius": f"{radius} mm"}
    document["design"] = {
        "parameters": [{"radii": {"controls": 4, "range": ["0.5 mm", "3 mm"]}}],
        "goals": [{"place": {"at": "tip", "reach": [190, 0, -50]}}],
    }
    document["design"].update(design)
    return document


def bent(edges=20):
    """Many goals, many parameters: takes some iterations."""
    document = beam(edges=edges)
    nodes = [round(i * edges / 10) for i in range(1, 11)]
    targets = [[200 * i / edges - 0.05 * i, 0, -40 * (i / edges) ** 2 - 3 * math.sin(3 * i / edges)] for i in nodes]
    document["design"]["goals"] = [{"positions": {
        "at": [{"rod": "beam", "at": i / edges} for i in nodes], "targets": targets}}]
    return document


def staged(edges=100):
    """The same in three stages, with the pin at the tip as soft as the targets are missed."""
    def radii(controls):
        return {"radii": {"controls": controls, "range": ["0.5 mm", "3 mm"]}}
    document = bent(edges)
    document["poses"][0]["soft_pins"] = [{"at": "tip", "stiffness": "1 N/m", "target": [192, 0, -46]}]
    document["design"].update({
        "stages": [{"parameters": [radii(2)]}, {"parameters": [radii(3)], "iterations": 4}],
        "parameters": [radii(4), {"rest_shape": {"controls": 4, "reach": "10 mm", "gauge": "free"}}],
        "settings": {"pins": "adaptive", "iterations": 12},
    })
    return document


class Optimize(tool.ToolTest):
    def files(self):
        return sorted(p.name for p in (self.folder / "out").glob("*")) if (self.folder / "out").exists() else []

    def bytes_of(self, folder):
        return [(self.folder / folder / name).read_bytes() for name in ("beam-designed.lissom", "beam-design.json")]

    def test_finds_a_radius_from_a_shape(self):
        truth = beam(RADIUS)
        del truth["design"]
        self.write("truth.lissom", truth)
        self.run_tool("solve", "truth.lissom", "--tolerance", "1e-9")
        tip = self.result("out/truth-loaded.json")["state"]["unknowns"][3 * 20:3 * 20 + 3]
        document = beam(parameters=[{"radii": {"controls": 2, "range": ["0.5 mm", "3 mm"]}, "freedom": "common_value"}],
                        goals=[{"place": {"at": "tip", "reach": [1000 * x for x in tip]}}])
        self.write("beam.lissom", document)
        out, _ = self.run_tool("optimize", "beam.lissom", "--json")
        self.assertEqual(json.loads(out)["verdict"], "converged")
        result = self.result("out/beam-design.json")
        self.assertAlmostEqual(1000 * result["parameters"][0]["value"], RADIUS, delta=1e-5)
        self.assertLess(result["goals"][0]["rms_after"], 1e-8)
        self.assertGreater(result["goals"][0]["rms_before"], 1e-3)
        self.run_tool("solve", "out/beam-designed.lissom", "-o", "again")
        again = self.result("again/beam-designed-loaded.json")["state"]["unknowns"][3 * 20:3 * 20 + 3]
        for a, b in zip(again, tip):
            self.assertAlmostEqual(a, b, delta=1e-6)
        self.assertTrue((self.folder / "out/beam-design.html").read_text(encoding="utf-8").startswith("<!"))

    def test_goes_on_to_the_same_bytes(self):
        self.write("beam.lissom", bent())
        self.run_tool("optimize", "beam.lissom", "-o", "whole", code=ENDS)
        iterations = self.result("whole/beam-design.json")["iterations"]
        self.assertGreater(iterations, 3)
        self.assertNotRegex(self.result("whole/beam-design.json")["message"], r"parameter \d")
        self.run_tool("optimize", "beam.lissom", "-o", "parts", "--iterations", "2", code=12)
        self.run_tool("optimize", "beam.lissom", "-o", "parts", "--resume", "--threads", "1", code=ENDS)
        self.assertEqual(self.bytes_of("parts"), self.bytes_of("whole"))

    def test_a_killed_run_goes_on_to_the_same_bytes(self):
        self.write("beam.lissom", bent(edges=200))
        limit = ("--iterations", "25")  # enough to be killed in
        self.run_tool("optimize", "beam.lissom", "-o", "whole", *limit, code=ENDS)
        run = self.start("optimize", "beam.lissom", "-o", "killed", *limit)
        checkpoint = self.folder / "killed/beam-design.checkpoint.json"
        end = time.monotonic() + 120
        while not checkpoint.exists() and time.monotonic() < end:
            time.sleep(0.002)
        run.send_signal(signal.SIGKILL)
        run.communicate()
        self.assertTrue(checkpoint.exists())
        self.run_tool("optimize", "beam.lissom", "-o", "killed", "--resume", *limit, code=ENDS)
        self.assertEqual(self.bytes_of("killed"), self.bytes_of("whole"))

    def test_stages_go_on_where_the_one_before_ended(self):
        document = staged()
        self.write("beam.lissom", document)
        self.run_tool("optimize", "beam.lissom", "-o", "all", code=ENDS)
        steps = self.result("all/beam-design.checkpoint.json")["steps"]
        self.assertEqual(sorted({step["stage"] for step in steps}), [0, 1, 2])
        self.assertLessEqual(sum(step["stage"] == 1 for step in steps), 4)
        for before, after in zip(steps, steps[1:]):
            if before["stage"] == after["stage"]:
                continue  # pins change within stages, and h with them; between stages nothing does
            self.assertLess(after["record"]["value"], before["record"]["value"] * 1.5)
        last = self.result("all/beam-design.json")
        self.assertLess(last["goals"][0]["rms_after"], 0.5 * last["goals"][0]["rms_before"])
        # The first stage alone is not as good.
        alone = staged()
        alone["design"]["parameters"] = alone["design"].pop("stages")[0]["parameters"]
        self.write("beam.lissom", alone)
        self.run_tool("optimize", "beam.lissom", "-o", "alone", code=(0, 12, 13))
        self.assertLess(last["goals"][0]["rms_after"],
                        0.8 * self.result("alone/beam-design.json")["goals"][0]["rms_after"])
        # What was found stands for itself, pins included.
        found = self.result("all/beam-designed.lissom")
        self.assertNotEqual(found["poses"][0]["soft_pins"][0]["stiffness"], "1 N/m")
        report = (self.folder / "all/beam-design.html").read_text(encoding="utf-8")
        self.assertIn("stage 3", report)

    def test_what_a_stage_did_to_pins_is_kept(self):
        document = staged()
        target = {"pin_target": {"z": ["-80 mm", "-20 mm"]}}
        document["design"].update({"stages": [{"parameters": [target]}], "parameters": [target]})
        document["design"]["settings"]["pins"] = "fixed"
        self.write("beam.lissom", document)
        self.run_tool("optimize", "beam.lissom", code=ENDS)
        records = [step["record"] for step in self.result("out/beam-design.checkpoint.json")["steps"]]
        stages = [step["stage"] for step in self.result("out/beam-design.checkpoint.json")["steps"]]
        again = stages.index(1)
        self.assertGreater(again, 1)
        # The second stage has the same parameter and finds nothing left to do.
        self.assertLess(records[again]["gradient"], 1e-3 * records[0]["gradient"])
        self.assertLessEqual(records[again]["value"], records[again - 1]["value"] * (1 + 1e-9))

    def test_a_staged_run_killed_at_any_time_goes_on_to_the_same_bytes(self):
        self.write("beam.lissom", staged())
        begin = time.monotonic()
        self.run_tool("optimize", "beam.lissom", "-o", "whole", code=ENDS)
        whole = time.monotonic() - begin
        chance = random.Random(4)
        checkpoint = self.folder / "killed/beam-design.checkpoint.json"
        for _ in range(10):
            more = ("--resume",) if checkpoint.exists() else ()
            run = self.start("optimize", "beam.lissom", "-o", "killed", *more)
            time.sleep(chance.uniform(0, whole))
            run.send_signal(signal.SIGKILL)
            run.communicate()
        more = ("--resume",) if checkpoint.exists() else ()
        self.run_tool("optimize", "beam.lissom", "-o", "killed", *more, code=ENDS)
        self.assertEqual(self.bytes_of("killed"), self.bytes_of("whole"))

    def test_a_mistake_in_a_later_stage_is_told_at_once(self):
        document = staged()
        document["design"]["stages"][1]["parameters"][0]["radii"]["range"] = ["2 mm", "3 mm"]
        self.write("beam.lissom", document)
        _, err = self.run_tool("optimize", "beam.lissom", code=3)
        self.assertIn("/design/stages/1/parameters/0", err)
        document["design"]["stages"][1]["parameters"] = []
        self.write("beam.lissom", document)
        _, err = self.run_tool("optimize", "beam.lissom", code=3)
        self.assertIn("/design/stages/1", err)
        document = staged()
        document["design"]["goals"] = [{"place": {"at": "tip", "reach": [190, 0, -50]}, "hard": True}]
        self.write("beam.lissom", document)
        _, err = self.run_tool("optimize", "beam.lissom", code=3)
        self.assertIn("soft pins cannot adapt", err)
        self.assertEqual(self.files(), [])

    def test_a_stopped_run_keeps_its_best(self):
        self.write("beam.lissom", bent(edges=400))
        run = self.start("optimize", "beam.lissom")
        checkpoint = self.folder / "out/beam-design.checkpoint.json"
        end = time.monotonic() + 120
        while not checkpoint.exists() and time.monotonic() < end:
            time.sleep(0.002)
        run.send_signal(signal.SIGINT)
        run.communicate(timeout=120)
        self.assertIn(run.returncode, (0, 13, 15))  # it may have ended on its own just before
        result = self.result("out/beam-design.json")
        self.assertLess(result["goals"][0]["rms_after"], result["goals"][0]["rms_before"])

    def test_a_checkpoint_of_something_else_is_refused(self):
        self.write("beam.lissom", bent())
        self.run_tool("optimize", "beam.lissom", "--iterations", "1", code=12)
        before = {p.name: p.read_bytes() for p in (self.folder / "out").glob("*")}
        changed = bent()
        changed["rods"][0]["section"]["radius"] = "1.5 mm"
        self.write("beam.lissom", changed)
        _, err = self.run_tool("optimize", "beam.lissom", "--resume", code=3)
        self.assertIn("another document", err)
        self.write("beam.lissom", bent())
        _, err = self.run_tool("optimize", "beam.lissom", "--resume", "--method", "bfgs", code=3)
        self.assertIn("other options", err)
        self.assertEqual(before, {p.name: p.read_bytes() for p in (self.folder / "out").glob("*")})
        whole = before["beam-design.checkpoint.json"]
        (self.folder / "out/beam-design.checkpoint.json").write_bytes(whole[:len(whole) // 2])
        _, err = self.run_tool("optimize", "beam.lissom", "--resume", code=3)
        self.assertIn("cut off", err)
        (self.folder / "out/beam-design.checkpoint.json").unlink()
        self.run_tool("optimize", "beam.lissom", "--resume", code=4)

    def test_says_what_cannot_be_meant(self):
        tip = {"place": {"at": "tip", "reach": [190, 0, -50]}}
        two = {"at": "tip", "targets": [[190, 0, -50]]}
        other = {"at": "tip", "targets": [[180, 0, -50]]}
        one = [{"radii": {"controls": 2, "range": ["0.5 mm", "3 mm"]}, "freedom": "common_factor"}]
        free = beam()
        free["poses"][0]["supports"] = []
        free["poses"][0]["forces"] = []
        unstable = beam()
        unstable["poses"][0]["supports"] = [{"at": {"rod": "beam", "at": "start"}, "hold": "pin"}]
        plain = beam()
        del plain["design"]
        wrong = {
            "does not say what may change": plain,
            "does not hold the part": free,
            "/poses/0": unstable,
            'rod "beam" has a radius of 1.6 mm, which is outside of 2 to 3 mm':
                beam(parameters=[{"radii": {"range": ["2 mm", "3 mm"]}}]),
            "at two places": beam(goals=[{"positions": two, "hard": True}, {"positions": other, "hard": True}]),
            "there are only 1 parameters": beam(parameters=one, goals=[{**tip, "hard": True}]),
            "targets for": beam(goals=[{"positions": {"at": "tip", "targets": [[190, 0, -50]] * 2}}]),
            "carry nothing": beam(goals=[{"reaction": {"at": "tip", "axis": "z", "reach": "1 N"}}]),
            "have neighbours": beam(parameters=one, wishes={"smoothness": 1}),
            "in more than one": beam(parameters=[{"force": {"size": ["0.1 mN", "1 N"]}},
                                                 {"force": {"z": ["-1 N", "1 N"]}}]),
        }
        for message, document in wrong.items():
            with self.subTest(message):
                self.write("beam.lissom", document)
                _, err = self.run_tool("optimize", "beam.lissom", code=3)
                if message != "in more than one":
                    self.assertIn(message, err)
                self.assertEqual(self.files(), [])
        self.write("beam.lissom", beam())
        _, err = self.run_tool("optimize", "beam.lissom", "--method", "newtn", code=3)
        self.assertIn('did you mean "newton"?', err)

    def test_two_soft_goals_for_one_node_are_worth_a_note(self):
        goals = [{"positions": {"at": "tip", "targets": [[x, 0, -50]]}} for x in (180, 190)]
        self.write("beam.lissom", beam(goals=goals))
        out, _ = self.run_tool("optimize", "beam.lissom", "--json")
        self.assertIn("want node 20 at two places, 10 mm apart", json.loads(out)["notes"][0])


if __name__ == "__main__":
    assert pathlib.Path(tool.TOOL).exists(), tool.TOOL
    tool.main()
