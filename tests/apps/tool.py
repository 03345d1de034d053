"""Runs the command line tool in a folder of its own, and makes small documents for it."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = os.environ.get("LISSOM_CLI", str(ROOT / "build" / "release" / "lissom"))


def cantilever(edges=20, force=-0.0012, **more):
    """A clamped rod of TPU, 200 mm long, with a force (N) along z at its free end."""
    document = {
        "lissom": 1,
        "title": "Cantilever",
        "rods": [{"name": "beam", "line": [[0, 0, 0], [200, 0, 0]], "edges": edges, "material": "TPU 92A",
                  "section": {"radius": "1 mm"}}],
        "sets": {"tip": {"rod": "beam", "at": "end"}},
        "poses": [{"name": "loaded", "supports": [{"at": {"rod": "beam", "at": "start"}, "hold": "clamp"}],
                   "forces": [{"at": "tip", "force": [0, 0, force]}]}],
    }
    document.update(more)
    return document


def column():
    """A clamped column under a force of 10 mN times the load factor; it buckles at 2.4674 B / L^2, factor 0.12112."""
    document = cantilever(edges=40, materials={"soft": {"youngs_modulus": "25 MPa", "poisson_ratio": 0.4}})
    document["rods"][0]["material"] = "soft"
    document["poses"][0]["forces"] = [{"at": "tip", "force": [-0.01, 0, 0]}]
    document["poses"][0]["path"] = {"to": 0.25, "steps": 8}
    return document


class ToolTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def write(self, name, content):
        text = content if isinstance(content, str) else json.dumps(content)
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def start(self, *arguments):
        return subprocess.Popen([TOOL, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True)

    def run_tool(self, *arguments, code=0):
        """Runs the tool, checks its exit code (or that it is one of several), returns what it printed on standard output and standard error."""
        done = subprocess.run([TOOL, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=300, check=False)
        self.assertIn(done.returncode, code if isinstance(code, tuple) else (code,), f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done.stdout, done.stderr

    def result(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))


def main():
    """Runs the tests of the calling script; ends with the line that tools/run_tests.py counts."""
    program = unittest.main(exit=False, verbosity=2)
    outcome = program.result
    failed = len(outcome.failures) + len(outcome.errors)
    print(f"{outcome.testsRun - failed} passed, {failed} failed")
    raise SystemExit(1 if failed or outcome.testsRun == 0 else 0)
