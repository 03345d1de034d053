"""The documents of scenes/data/fabric: that they are what their drawing program writes, and that the small ones come to
rest in the shapes that the figures of the thesis describe."""
import subprocess
import sys

import tool

SCENES = tool.ROOT / "scenes" / "data" / "fabric"
FLAT = 1e-5  # m


class Fabric(tool.ToolTest):
    def totals(self, name):
        """Solves a scene, which has to end in a stable shape, and returns what is known of that."""
        self.run_tool("solve", str(SCENES / (name + ".lissom")), "-o", str(self.folder))
        result = self.result(name + "-released.json")
        self.assertEqual(result["verdict"]["name"], "stable", name)
        return result["totals"]

    def sides(self, totals):
        """Length, width and height of the box around a shape, m."""
        return [high - low for low, high in zip(totals["low"], totals["high"])]


class Drawing(Fabric):
    def test_documents_are_as_drawn(self):
        done = subprocess.run([sys.executable, str(tool.ROOT / "tools" / "draw_fabric_scenes.py"), "--check"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


class Families(Fabric):
    def test_frames(self):
        base, more = self.totals("frame-base"), self.totals("frame-more-stretch")
        soft, thick = self.totals("frame-soft-in-plane"), self.totals("frame-thick")
        length, width, height = self.sides(base)
        self.assertAlmostEqual(length, width, delta=1e-4)  # a saddle: both diagonals bend alike
        self.assertGreater(height, 0.03)
        self.assertGreater(base["smallest_stretch"], 1)
        self.assertGreater(more["height"], 1.5 * base["height"])
        self.assertGreater(more["smallest_stretch"], 1)
        self.assertLess(soft["smallest_stretch"], 1)
        self.assertGreater(soft["slack_area"], 0.1 * soft["area"])
        self.assertLess(thick["height"], FLAT)
        self.assertGreater(thick["smallest_stretch"], 1.2)

    def test_discs(self):
        empty, split, crossed, ringed = (
            self.totals("disc-" + name) for name in ("empty", "split", "crossed", "ringed"))
        self.assertGreater(empty["height"], 0.055)  # a deep saddle that turns about its axis at nearly no cost
        self.assertGreater(split["height"], 0.06)  # kinks at the cut
        self.assertLess(split["smallest_stretch"], 1)
        for disc in (crossed, ringed):
            self.assertGreater(disc["height"], 0.015)
            self.assertLess(disc["height"], 0.03)
            self.assertGreater(disc["smallest_stretch"], 1.2)

    def test_rectangles(self):
        empty, squares, strips = (self.totals("rectangle-" + name) for name in ("empty", "squares", "strips"))
        self.assertLess(empty["area"], 0.9 * strips["area"])  # compressed sideways
        self.assertLess(squares["height"], 0.6 * strips["height"])
        self.assertGreater(strips["height"], 0.04)
        self.assertGreater(self.sides(strips)[1], 0.095)
        self.assertGreater(strips["smallest_stretch"], 1.1)

    def test_removed_rods(self):
        whole, one, rim = (self.totals("wheel-" + name) for name in ("whole", "one-removed", "rim-removed"))
        self.assertGreater(one["height"], whole["height"])
        self.assertGreater(rim["height"], 1.3 * one["height"])

    def test_kinks(self):
        self.assertLess(self.totals("kink-whole")["height"], FLAT)
        split = self.totals("kink-split")
        self.assertGreater(split["height"], 0.05)
        self.assertLess(self.sides(split)[0], 0.12)


class Designs(Fabric):
    def test_full_designs(self):
        for name, height in (("butterfly", 0.02), ("mask", 0.02), ("car", 0.025)):
            totals = self.totals(name)
            self.assertGreater(totals["height"], height, name)
            self.assertGreater(totals["smallest_stretch"], 1.02, name)


if __name__ == "__main__":
    tool.main()
