"""`lissom branches`: the shapes of a design, their files, and going on from one of them."""
import json

import tool

SCENES = tool.ROOT / "scenes" / "data" / "fabric"


class Branches(tool.ToolTest):
    def search(self, name, *more):
        output, _ = self.run_tool("branches", str(SCENES / (name + ".lissom")), "-o", str(self.folder), "--json", *more)
        return json.loads(output)["poses"][0]

    def test_frame_has_one_shape_and_its_mirror_image(self):
        found = self.search("frame-base", "--most", "20")
        self.assertEqual(found["drawn_shape_negative_modes"], 2)
        self.assertEqual(len(found["shapes"]), 1)
        shape = found["shapes"][0]
        self.assertTrue(shape["barrier_free"])
        self.assertTrue(shape["mirror_image_is_stable_too"])
        self.assertAlmostEqual(shape["height_m"], 0.0407, delta=2e-4)
        saved = self.folder / "frame-base-released-shape-1.json"
        self.assertTrue(saved.exists())
        self.assertTrue((self.folder / "frame-base-released-branches.png").exists())
        self.run_tool("solve", str(SCENES / "frame-base.lissom"), "--resume", str(saved), "-o", str(self.folder))
        again = self.result("frame-base-released.json")
        self.assertEqual(again["verdict"]["name"], "stable")
        self.assertAlmostEqual(again["energy"]["total"], shape["energy_J"], delta=1e-9 * shape["energy_J"])

    def test_thick_frame_stays_flat(self):
        found = self.search("frame-thick", "--most", "6")
        self.assertEqual(found["drawn_shape_negative_modes"], 0)
        self.assertLess(found["shapes"][0]["height_m"], 1e-6)

    def test_limit_that_ends_the_search_is_said(self):
        self.assertFalse(self.search("frame-base", "--most", "3")["exhausted"])


if __name__ == "__main__":
    tool.main()
