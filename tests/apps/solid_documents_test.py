"""Documents with solids: solved, drawn, warned about, and refused as designs."""
import itertools

import tool

PATHS = list(itertools.permutations(range(3)))


def block(cells=(4, 2, 2), side=10):
    """Cubes of six tetrahedra each, side in mm."""
    number, points, tetrahedra = {}, [], []

    def point(at):
        if at not in number:
            number[at] = len(points)
            points.append([side * x for x in at])
        return number[at]

    for cube in itertools.product(*(range(n) for n in cells)):
        for path in PATHS:
            at, corners = list(cube), [point(cube)]
            for axis in path:
                at[axis] += 1
                corners.append(point(tuple(at)))
            odd = sum(path[i] > path[j] for i in range(3) for j in range(i, 3)) % 2
            tetrahedra.append([corners[0], corners[2], corners[1], corners[3]] if odd else corners)
    return {"name": "block", "material": "rubber", "points": points, "tetrahedra": tetrahedra}


def hanging(**more):
    document = {
        "lissom": 1,
        "materials": {"rubber": {"youngs_modulus": "0.1 MPa", "poisson_ratio": 0.4, "density": "1000 kg/m^3"}},
        "solids": [block()],
        "poses": [{"name": "hanging", "gravity": True,
                   "supports": [{"at": {"box": [[-1, -1, -1], [1, 100, 100]]}, "hold": "pin"}]}],
    }
    document.update(more)
    return document


class Solids(tool.ToolTest):
    def test_solved_and_drawn(self):
        document = hanging()
        document["solids"][0]["stiffness"] = [0.5 if t % 2 else 1 for t in range(96)]
        self.write("block.lissom", document)
        out, _ = self.run_tool("solve", "block.lissom", "--vtu", "--picture", "svg", "--field", "displacement")
        self.assertIn("hanging: settled", out)
        result = self.result("out/block-hanging.json")
        self.assertEqual(result["verdict"]["name"], "stable")
        self.assertGreater(result["energy"]["terms"]["solid_stretch"], 0)
        self.assertLess(result["energy"]["terms"]["gravity"], 0)
        self.assertAlmostEqual(sum(result["energy"]["terms"].values()), result["energy"]["total"], delta=1e-12)
        self.assertTrue(result["modes"]["stiffness"][0] > 0)
        picture = (self.folder / "out/block-hanging.svg").read_text(encoding="utf-8")
        # The outer sides have 2 x 40 triangles, half of which can be seen at most.
        self.assertGreater(picture.count("<path") + picture.count("<polygon"), 5)
        self.run_tool("draw", "out/block-hanging.json", "-o", "again.svg")
        self.run_tool("solve", "block.lissom", "--resume", "out/block-hanging.json", "-o", "resumed")

    def test_energy_is_a_quantity(self):
        self.write("block.lissom", hanging())
        self.run_tool("solve", "block.lissom")
        energy = self.result("out/block-hanging.json")["energy"]["terms"]["solid_stretch"]
        claim = {"quantity": "energy", "unit": "J", "value": energy, "tolerance": "1e-6 %"}
        self.write("claim.lissom", hanging(expect=[claim]))
        self.run_tool("verify", "claim.lissom")
        self.write("wrong.lissom", hanging(expect=[dict(claim, value=1.01 * energy)]))
        self.run_tool("verify", "wrong.lissom", code=(1, 2, 3, 4))

    def test_same_bytes_for_any_number_of_threads(self):
        self.write("block.lissom", hanging())
        texts = []
        for threads in ("1", "2", "8"):
            self.run_tool("solve", "block.lissom", "--threads", threads, "-o", "t" + threads)
            texts.append((self.folder / ("t" + threads) / "block-hanging.json").read_bytes())
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(texts[0], texts[2])

    def test_inverted_tetrahedra_are_warned_about(self):
        document = hanging()
        corner = {"at": {"point": [40, 20, 20]}, "hold": "pin", "move": [-35, -15, -15]}
        document["poses"][0]["supports"].append(corner)
        self.write("block.lissom", document)
        self.run_tool("solve", "block.lissom")
        warnings = self.result("out/block-hanging.json")["warnings"]
        self.assertEqual([w["what"] for w in warnings], ["inverted tetrahedra"])
        self.assertIn('solid "block"', warnings[0]["where"])

    def test_designs_of_solids_are_refused(self):
        rod = {"name": "rod", "line": [[40, 20, 20], [80, 20, 20]], "edges": 4, "material": "rubber", "section": {"radius": "2 mm"}}
        design = {"parameters": [{"radii": {"range": ["1 mm", "4 mm"]}}], "goals": [{"mass": {"reach": "1 g"}}]}
        self.write("block.lissom", hanging(rods=[rod], design=design))
        out, err = self.run_tool("optimize", "block.lissom", code=(1, 2, 3))
        self.assertIn("solids", out + err)


if __name__ == "__main__":
    tool.main()
