"""The documents of scenes/data/fabric: that they are what their drawing program writes, and that the small ones come to
rest in the shapes that the figures of the thesis describe."""
import subprocess
import sys

import tool

SCENES = tool.ROOT / "scenes" / "data" / "fabric"


class Fabric(tool.ToolTest):
    def released(self, name):
        """Solves a scene; its result, which has to be a stable shape."""
        self.run_tool("solve", str(SCENES / (name + ".lissom")), "-o", str(self.folder))
        result = self.result(name + "-released.json")
        self.assertEqual(result["verdict"]["name"], "stable", name)
        return result

    def totals(self, name):
        return self.released(name)["totals"]


class Drawing(Fabric):
    def test_documents_are_as_drawn(self):
        done = subprocess.run([sys.executable, str(tool.ROOT / "tools" / "draw_fabric_scenes.py"), "--check"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


class Frames(Fabric):
    def test_settings_of_figure_6_3(self):
        base, more = self.totals("frame-base"), self.totals("frame-more-stretch")
        soft, thick = self.totals("frame-soft-in-plane"), self.totals("frame-thick")
        self.assertGreater(base["height"], 0.03)
        self.assertGreater(base["smallest_stretch"], 1)
        self.assertGreater(more["height"], 1.5 * base["height"])
        self.assertGreater(more["smallest_stretch"], 1)
        self.assertLess(soft["smallest_stretch"], 1)
        self.assertGreater(soft["slack_area"], 0)
        self.assertLess(thick["height"], 1e-5)
        self.assertGreater(thick["smallest_stretch"], 1.2)


if __name__ == "__main__":
    tool.main()
