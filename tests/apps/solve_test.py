"""`lissom solve`: results, exit codes, resuming, interrupts, and old results that survive."""
import json
import math
import signal
import time

import tool


class Solve(tool.ToolTest):
    def test_result_tells_everything(self):
        self.write("beam.lissom", tool.cantilever())
        out, _ = self.run_tool("solve", "beam.lissom")
        self.assertIn("loaded: settled", out)
        result = self.result("out/beam-loaded.json")
        self.assertEqual(result["verdict"]["name"], "stable")
        self.assertLess(result["residual"]["value"], result["residual"]["tolerance"])
        self.assertEqual(len(result["state"]["unknowns"]), result["unknowns"])
        self.assertAlmostEqual(sum(result["energy"]["terms"].values()), result["energy"]["total"], delta=1e-12)
        self.assertGreater(result["modes"]["stiffness"][0], 0)
        self.assertTrue(result["records"])

    def test_json_is_the_only_output(self):
        self.write("beam.lissom", tool.cantilever())
        out, err = self.run_tool("solve", "beam.lissom", "--json")
        summary = json.loads(out)
        self.assertEqual(summary["poses"][0]["pose"], "loaded")
        self.assertEqual(summary["poses"][0]["verdict"]["exit_code"], 0)
        self.assertEqual(err, "")

    def test_progress_goes_to_standard_error(self):
        self.write("beam.lissom", tool.cantilever())
        out, err = self.run_tool("solve", "beam.lissom", "--json", "--progress")
        json.loads(out)
        self.assertIn("unbalanced force", err)

    def test_same_bytes_for_any_number_of_threads(self):
        self.write("beam.lissom", tool.cantilever(edges=3000, force=-0.004))
        texts = []
        for threads in ("1", "2", "8"):
            self.run_tool("solve", "beam.lissom", "--threads", threads, "-o", "t" + threads, "--vtu", "--picture", "svg")
            texts.append([(self.folder / ("t" + threads) / ("beam-loaded" + e)).read_bytes() for e in (".json", ".vtu", ".svg")])
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], texts[2])

    def test_pictures_and_paraview_files(self):
        self.write("beam.lissom", tool.cantilever())
        out, _ = self.run_tool("solve", "beam.lissom", "--vtu", "--picture", "png", "--field", "curvature", "-o", "here")
        self.assertTrue((self.folder / "here/beam-loaded.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn(b"UnstructuredGrid", (self.folder / "here/beam-loaded.vtu").read_bytes())
        self.assertIn("wrote", out)


class FormFinding(tool.ToolTest):
    """A film between two rings at 20 mm: the catenoid, 7.52181 mm high where its radius is 45 mm."""

    def film(self, rounds):
        rim = {"membrane": "film", "rim": "outer"}, {"membrane": "film", "rim": "inner"}
        return {
            "lissom": 1,
            "membranes": [{"name": "film", "material": "elastane-cotton knit", "pre_stretch": 1.4,
                           "disc": {"radius": 60, "inner_radius": 30, "rings": 8, "sectors": 32}}],
            "poses": [{"name": "form", "form_finding": {"rounds": rounds},
                       "supports": [{"at": rim[0], "hold": "pin"}, {"at": rim[1], "hold": "pin", "move": [0, 0, 20]}]}],
            "expect": [{"quantity": "surface_height", "at": {"point": [45, 0, 0]}, "axis": "z", "unit": "mm",
                        "value": 7.52181, "tolerance": "1 %"}]}

    def test_is_solved_and_measured(self):
        self.write("film.lissom", self.film(200))
        out, _ = self.run_tool("solve", "film.lissom", "--picture", "svg")
        self.assertIn("form found in", out)
        self.run_tool("verify", "film.lissom")

    def test_says_when_it_is_not_done(self):
        self.write("film.lissom", self.film(3))
        out, _ = self.run_tool("solve", "film.lissom", code=12)
        self.assertIn("the form still moves by", out)
        out, _ = self.run_tool("verify", "film.lissom", code=1)
        self.assertIn("has no form", out)

    def test_has_no_other_load_factor(self):
        self.write("film.lissom", self.film(200))
        _, err = self.run_tool("solve", "film.lissom", "--load-factor", "0.5", code=3)
        self.assertIn("load factor 1", err)


class Resume(tool.ToolTest):
    def test_goes_on_to_the_same_bytes(self):
        self.write("beam.lissom", tool.cantilever(force=-0.006))
        self.run_tool("solve", "beam.lissom", "--max-iterations", "3", "-o", "early", code=12)
        early = "early/beam-loaded.json"
        self.assertEqual(self.result(early)["verdict"]["name"], "iteration_limit")
        for folder in ("a", "b"):
            self.run_tool("solve", "beam.lissom", "--resume", early, "-o", folder)
        a, b = ((self.folder / f / "beam-loaded.json").read_bytes() for f in ("a", "b"))
        self.assertEqual(a, b)
        self.run_tool("solve", "beam.lissom", "-o", "whole")
        resumed, whole = self.result("a/beam-loaded.json"), self.result("whole/beam-loaded.json")
        for x, y in zip(resumed["state"]["unknowns"][:60], whole["state"]["unknowns"][:60]):
            self.assertAlmostEqual(x, y, delta=1e-7)

    def test_a_finished_result_is_read_back_exactly(self):
        self.write("beam.lissom", tool.cantilever())
        self.run_tool("solve", "beam.lissom", "-o", "a")
        self.run_tool("solve", "beam.lissom", "--resume", "a/beam-loaded.json", "-o", "b")
        a, b = self.result("a/beam-loaded.json"), self.result("b/beam-loaded.json")
        self.assertEqual(b["iterations"], 0)
        self.assertEqual(a["state"], b["state"])

    def test_refuses_the_result_of_another_structure(self):
        self.write("beam.lissom", tool.cantilever())
        self.write("finer.lissom", tool.cantilever(edges=25))
        self.run_tool("solve", "beam.lissom")
        _, err = self.run_tool("solve", "finer.lissom", "--resume", "out/beam-loaded.json", code=3)
        self.assertIn("another structure", err)
        self.assertFalse((self.folder / "out/finer-loaded.json").exists())

    def test_refuses_what_is_no_result(self):
        self.write("beam.lissom", tool.cantilever())
        self.run_tool("solve", "beam.lissom")
        whole = (self.folder / "out/beam-loaded.json").read_text(encoding="utf-8")
        state = json.loads(whole)
        state["state"]["tangents"][0] = None
        for name, text in {"cut.json": whole[: len(whole) // 2], "other.json": "{}", "null.json": json.dumps(state)}.items():
            self.write(name, text)
            _, err = self.run_tool("solve", "beam.lissom", "--resume", name, code=3)
            self.assertIn(name, err)
        self.run_tool("solve", "beam.lissom", "--resume", "missing.json", code=4)


class Interrupts(tool.ToolTest):
    def slow(self):
        """Some seconds of work: a long soft rod under a large force."""
        return self.write("slow.lissom", tool.cantilever(edges=30000, force=-0.02))

    def test_ctrl_c_keeps_the_best_shape_and_resumes(self):
        process = self.start("solve", self.slow(), "--progress")
        process.stderr.readline()  # it works
        process.stderr.readline()
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=300)
        self.assertEqual(process.returncode, 15, out)
        result = self.result("out/slow-loaded.json")
        self.assertEqual(result["verdict"]["name"], "cancelled")
        self.assertTrue(all(math.isfinite(x) for x in result["state"]["unknowns"]))
        self.run_tool("solve", "slow.lissom", "--resume", "out/slow-loaded.json", "--max-iterations", "1", code=12)

    def test_a_killed_run_leaves_the_old_result(self):
        self.write("slow.lissom", tool.cantilever())
        self.run_tool("solve", "slow.lissom")
        path = self.folder / "out/slow-loaded.json"
        old = path.read_bytes()
        self.slow()
        for delay in (0.0, 0.3, 0.9):
            process = self.start("solve", "slow.lissom", "--progress", "--max-iterations", "2")
            process.stderr.readline()
            time.sleep(delay)
            process.kill()
            process.communicate()
            bytes_now = path.read_bytes()
            json.loads(bytes_now)
            if bytes_now != old:
                self.assertEqual(len(json.loads(bytes_now)["state"]["lengths"]), 30000)
                break


class WrongUse(tool.ToolTest):
    def test_commands_and_numbers(self):
        self.write("beam.lissom", tool.cantilever())
        _, err = self.run_tool("slove", "beam.lissom", code=2)
        self.assertEqual(err, 'lissom: there is no command "slove" (did you mean "solve"?)\n')
        _, err = self.run_tool("solve", "beam.lissom", "--nonsense", code=2)
        self.assertTrue(err.startswith("lissom: ") and err.count("\n") == 1 and "--nonsense" in err, err)
        for wrong in ("nan", "1e300", "-inf"):
            _, err = self.run_tool("solve", "beam.lissom", "--load-factor", wrong, code=3)
            self.assertIn("--load-factor", err)
            _, err = self.run_tool("path", "beam.lissom", "--to", wrong, code=3)
            self.assertIn("--to", err)

    def test_the_folder_is_tried_before_the_work(self):
        self.write("slow.lissom", tool.cantilever(edges=30000, force=-0.02))
        self.write("file", "")
        for command in ("solve", "path", "modes"):
            _, err = self.run_tool(command, "slow.lissom", "-o", "file", code=4)
            self.assertIn("file", err)

    def test_documents(self):
        wrong = tool.cantilever()
        wrong["rods"][0]["section"] = {"radius": "1 MPa"}
        self.write("wrong.lissom", wrong)
        out, err = self.run_tool("solve", "wrong.lissom", code=3)
        self.assertEqual(out, "")
        self.assertEqual(err.count("\n"), 1)
        self.assertIn("lissom: wrong.lissom: /rods/0/section/radius: expected a length", err)
        self.write("text.lissom", "not a document")
        self.run_tool("solve", "text.lissom", code=3)
        self.write("still.lissom", tool.cantilever(poses=[]))
        _, err = self.run_tool("solve", "still.lissom", code=3)
        self.assertIn("no pose", err)

    def test_names(self):
        self.write("beam.lissom", tool.cantilever())
        _, err = self.run_tool("solve", "beam.lissom", "--pose", "loded", code=3)
        self.assertIn('did you mean "loaded"', err)
        self.run_tool("solve", "scene:no-such-scene", code=3)

    def test_files(self):
        _, err = self.run_tool("solve", "missing.lissom", code=4)
        self.assertIn("missing.lissom: there is no such file", err)
        self.write("beam.lissom", tool.cantilever())
        self.write("taken", "a file where a folder is wanted")
        self.run_tool("solve", "beam.lissom", "-o", "taken", code=4)
        self.assertEqual((self.folder / "taken").read_text(encoding="utf-8"), "a file where a folder is wanted")

    def test_arguments(self):
        self.write("beam.lissom", tool.cantilever())
        for arguments in ([], ["solve"], ["sing"], ["solve", "beam.lissom", "--method", "guess"],
                          ["solve", "beam.lissom", "--threads", "0"], ["verify"], ["draw"]):
            _, err = self.run_tool(*arguments, code=2)
            self.assertTrue(err, arguments)
        self.run_tool("solve", "beam.lissom", "--tolerance", "2", code=3)

    def test_help(self):
        out, _ = self.run_tool("--help")
        self.assertIn("Exit codes", out)
        commands = ["solve", "path", "modes", "dynamics", "draw", "verify", "convert", "schema", "scenes"]
        for command in commands:
            self.assertIn(command, out)
            text, _ = self.run_tool(command, "--help")
            self.assertIn("Example:\n  lissom " + command, text)
        version, _ = self.run_tool("--version")
        self.assertRegex(version, r"^lissom \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    tool.main()
