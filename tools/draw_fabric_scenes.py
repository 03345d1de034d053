#!/usr/bin/env python3
"""Draws the documents of scenes/data/fabric: small plans after the figures of the thesis and three full designs.

    tools/draw_fabric_scenes.py            writes all of them
    tools/draw_fabric_scenes.py --check    fails when a document differs from what would be written

Lengths are in millimetres. Full designs are drawn as halves: a point off the axis x = 0 is written once and becomes
NAME-l and NAME-r; a rod is drawn on both sides, or across the axis.
"""
import json
import math
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parents[1] / "scenes" / "data" / "fabric"
THESIS = "Computational Design of Flexible Structures, "
SOFT = {"r_n": 0.2, "r_b": 0.4}    # with the soft knit (0.3 N/m)
PRINTED = {"r_n": 0.65, "r_b": 1.3}  # with the elastane-cotton knit (47.2 N/m)
UP = {"seed": {"amplitude": 0.3}}  # the middle goes up, not down
DOWN = {"seed": {"amplitude": -0.3}}


class Drawing:
    """Points and rods of a plan."""

    def __init__(self):
        self.points, self.rods = {}, []

    def point(self, name, x, y, **more):
        at = [round(x, 6) + 0.0, round(y, 6) + 0.0]
        self.points[name] = {"at": at, **more} if more else at
        return name

    def rod(self, name, points, curve=None, closed=False, ghost=False):
        entry = {"name": name, "points": points.split() if isinstance(points, str) else list(points)}
        if curve:
            entry["curve"] = curve
        if closed:
            entry["closed"] = True
        if ghost:
            entry["ghost"] = True
        self.rods.append(entry)

    def document(self, title, source, edge_length, radii, fabric, pose=None):
        plan = {"points": self.points, "rods": self.rods, "material": "PLA", **radii, "edge_length": edge_length,
                "fabric": fabric}
        return {"lissom": 1, "title": title, "source": THESIS + source, "plan": plan,
                "poses": [{"name": "released", **(pose or {})}]}


class Half(Drawing):
    """A drawing that is the same on both sides of x = 0."""

    def __init__(self, axis, side):
        super().__init__()
        self.sides = set(side)
        for name, (x, y, *more) in side.items():
            for mark, sign in (("l", -1), ("r", 1)):
                self.point(f"{name}-{mark}", sign * x, y, **(more[0] if more else {}))
        for name, (y, *more) in axis.items():
            self.point(name, 0, y, **(more[0] if more else {}))

    def named(self, points, mark):
        return [f"{p}-{mark}" if p in self.sides else p for p in points.split()]

    def both(self, name, points, **how):
        """One rod on each side."""
        for mark in "lr":
            self.rod(f"{name}-{mark}", self.named(points, mark), **how)

    def across(self, name, points, **how):
        """One rod over both sides, given from the axis outwards; closed: from axis to axis."""
        left, right = self.named(points, "l"), self.named(points, "r")
        if how.get("closed"):
            inner = [p for p in reversed(left) if p not in right]
            return self.rod(name, right + inner, **how)
        return self.rod(name, left[::-1] + [p for p in right if p not in left], **how)


def knit(stretch, edge=None, **more):
    if edge:
        more = {"edge_length": edge, **more}
    return {"material": "elastane-cotton knit", "pre_stretch": stretch, **more}


def circle(drawing, name, radius, count, start=0.0, splits=(), **how):
    """Points NAME-0, NAME-1, ... on a circle about the origin, and the rod through them."""
    names = []
    for i in range(count):
        angle = math.radians(start + 360 * i / count)
        more = {"split": True} if i in splits else {}
        names.append(drawing.point(f"{name}-{i}", radius * math.cos(angle), radius * math.sin(angle), **more))
    drawing.rod(name, names, "arc", closed=True, **how)
    return names


# Figure 6.3


def frame(title, stretch, radii):
    d = Drawing()
    for name, x, y in (("a", 0, 0), ("b", 120, 0), ("c", 120, 120), ("d", 0, 120)):
        d.point(name, x, y)
    for side in ("a b", "b c", "c d", "d a"):
        d.rod(side.replace(" ", ""), side, "straight")
    drawn = d.document(title, "figure 6.3", 5, radii, {"material": "soft knit", "pre_stretch": stretch})
    return {"lissom": 1, "torsion": "polar", **drawn}  # the torsion constant of the thesis


def frames():
    yield "frame-base", frame("Square frame", 1.3, SOFT)
    yield "frame-more-stretch", frame("Square frame, more stretch", 1.6, SOFT)
    yield "frame-soft-in-plane", frame("Square frame, softer in its plane", 1.3, {"r_n": 0.2, "r_b": 0.2})
    yield "frame-thick", frame("Square frame, thicker out of its plane", 1.3, {"r_n": 0.4, "r_b": 0.4})


# Figure 6.4


def disc(title, interior):
    d = Drawing()
    interior(d)
    return d.document(title, "figure 6.4", 5, PRINTED, knit(1.4))


def crossed(d):
    rim = circle(d, "rim", 75, 4)
    d.point("centre", 0, 0)
    d.rod("along", [rim[0], "centre", rim[2]], "straight")
    d.rod("across", [rim[1], "centre", rim[3]], "straight")


def ringed(d):
    rim = circle(d, "rim", 75, 4)
    ring = circle(d, "ring", 35, 4)
    for i in range(4):
        d.rod(f"spoke-{i}", [ring[i], rim[i]], "straight")


def discs():
    yield "disc-empty", disc("Disc", lambda d: circle(d, "rim", 75, 4))
    yield "disc-split", disc("Disc with a cut rim", lambda d: circle(d, "rim", 75, 4, splits=(0,)))
    yield "disc-crossed", disc("Disc with two crossing rods", crossed)
    yield "disc-ringed", disc("Disc with a ring", ringed)


# Figure 6.5


def rectangle(title, lines_along, lines_across, radii):
    """Sides of 200 and 100 mm; lines parallel to the long and the short side."""
    d = Drawing()
    length, width = 200, 100
    xs = [length * i / (lines_across + 1) for i in range(lines_across + 2)]
    ys = [width * i / (lines_along + 1) for i in range(lines_along + 2)]
    for i, x in enumerate(xs):
        for j, y in enumerate(ys):
            if i in (0, len(xs) - 1) or j in (0, len(ys) - 1) or (lines_along and lines_across):
                d.point(f"p{i}{j}", x, y)
    last_x, last_y = len(xs) - 1, len(ys) - 1
    for j in range(last_y + 1):
        d.rod(f"along-{j}", [f"p{i}{j}" for i in range(last_x + 1) if f"p{i}{j}" in d.points], "straight")
    for i in range(last_x + 1):
        d.rod(f"across-{i}", [f"p{i}{j}" for j in range(last_y + 1) if f"p{i}{j}" in d.points], "straight")
    return d.document(title, "figure 6.5", 5, radii, knit(1.4))


def rectangles():
    yield "rectangle-empty", rectangle("Rectangle", 0, 0, {"r_n": 0.65, "r_b": 1.5})
    yield "rectangle-squares", rectangle("Rectangle of squares", 1, 3, {"r_n": 0.45, "r_b": 0.9})
    yield "rectangle-strips", rectangle("Rectangle of strips", 0, 7, {"r_n": 0.5, "r_b": 1.3})


# Figures 6.6 and 6.7


def wheel(title, ghosts):
    """A disc with eight spokes whose rim is made of eight rods; `ghosts` of them are not printed."""
    d = Drawing()
    count = 8
    d.point("centre", 0, 0)
    for i in range(2 * count):
        angle = math.pi * i / count
        d.point(f"rim-{i}", 75 * math.cos(angle), 75 * math.sin(angle))
    for i in range(count):
        names = [f"rim-{2 * i}", f"rim-{2 * i + 1}", f"rim-{(2 * i + 2) % (2 * count)}"]
        d.rod(f"rim-{i}", names, "arc", ghost=i in ghosts)
    for i in range(count):
        d.rod(f"spoke-{i}", ["centre", f"rim-{2 * i}"], "straight")
    return d.document(title, "figure 6.6", 5, {"r_n": 0.45, "r_b": 0.9}, knit(1.4))


def kink(title, split):
    """A strip with three long rods across it; `split`: their middles are cut."""
    d = Drawing()
    how = {"split": True} if split else {}
    for j, y in enumerate((0, 40, 80)):
        for i, x in enumerate((0, 50, 100, 150, 200)):
            d.point(f"p{i}{j}", x, y, **(how if i == 2 else {}))
    for j in range(3):
        d.rod(f"along-{j}", [f"p{i}{j}" for i in range(5)], "straight")
    for i in (0, 1, 3, 4):
        d.rod(f"across-{i}", [f"p{i}{j}" for j in range(3)], "straight")
    return d.document(title, "figure 6.7", 5, {"r_n": 0.5, "r_b": 1.3}, knit(1.2))


def removals_and_kinks():
    yield "wheel-whole", wheel("Wheel", ())
    yield "wheel-one-removed", wheel("Wheel without one rod of its rim", (0,))
    yield "wheel-rim-removed", wheel("Wheel without rim", range(8))
    yield "kink-whole", kink("Strip", False)
    yield "kink-split", kink("Strip with rods cut in the middle", True)


# Figures 6.10 to 6.12


def butterfly():
    body = {"r_n": 0.42, "r_b": 1.3}
    d = Half({"head": (41, body), "tail": (-60, body)}, {
        "b1": (5, 26, body), "b2": (6, 10, body), "b3": (5, -6, body), "b4": (4, -34, body),
        "f1": (40, 57), "f2": (82, 84), "f3": (122, 93), "f4": (117, 56), "f5": (101, 23), "n": (85, 1),
        "h1": (94, -26), "h2": (84, -58), "h3": (52, -86), "h4": (22, -72),
        "c": (48, 35), "k1": (92, 71), "k2": (89, 47), "k3": (80, 24), "mm": (55, 2.5),
        "d": (32, -22), "p1": (70, -22), "p2": (63, -47), "p3": (42, -62),
        "a": (19, 84)})
    d.both("body", "head b1 b2 b3 b4 tail")
    d.both("antenna", "head a", curve="straight")
    d.both("antenna-under", "b1 a", curve="straight")
    d.both("fore-edge", "b1 f1 f2 f3")
    d.both("fore-margin", "f3 f4 f5 n")
    d.both("hind-margin", "n h1 h2 h3 h4 b4")
    d.both("fore-trailing", "b3 mm n")
    d.both("vein-1", "b2 c k1 f3")
    d.both("vein-2", "c k2 f4")
    d.both("vein-3", "c k3 f5")
    d.both("vein-4", "b3 d p1 h1")
    d.both("vein-5", "d p2 h2")
    d.both("vein-6", "b4 d")
    d.both("vein-7", "d p3 h3")
    d.both("fore-band", "f2 k1 k2 k3 mm")
    d.both("hind-band", "mm p1 p2 p3 h4")
    d.both("fore-cell", "f1 c mm")
    return "butterfly", d.document("Butterfly", "figure 6.10, drawn anew", 1.26, {"r_n": 0.42, "r_b": 0.9},
                                  knit(1.45, 14, min_angle=5.5), DOWN)


def mask():
    d = Half({"crown": (104,), "fore": (68,), "glabella": (36,), "bridge": (14,), "nose": (-12,), "nose-base": (-25,),
              "philtrum": (-33,), "lip-u": (-40,), "mouth": (-47,), "lip-l": (-57,), "crease": (-72,),
              "chin": (-102,)}, {
        "o1": (36, 98), "o2": (63, 78), "o3": (77, 42), "o4": (79, 4), "o5": (71, -36),
        "o6": (52, -72), "o7": (25, -97),
        "e1": (16, 13), "e2": (27, 24), "e3": (42, 25), "e4": (56, 17), "e5": (45, 10), "e6": (30, 9),
        "br1": (16, 38), "br2": (38, 46), "br3": (60, 36),
        "n1": (9, 6), "n2": (17, -15), "n3": (9, -26),
        "m1": (31, -48), "m2": (9, -38), "m3": (15, -57),
        "c1": (38, -4), "c2": (61, 0), "c3": (34, -28), "c4": (56, -36), "c5": (32, -67), "j": (30, -83),
        "fh1": (31, 71), "fh2": (55, 60)})
    d.across("face", "crown o1 o2 o3 o4 o5 o6 o7 chin", closed=True)
    d.both("eye", "e1 e2 e3 e4 e5 e6", closed=True)
    d.across("brow", "glabella br1 br2 br3 o3")
    d.across("forehead", "fore fh1 fh2 o3")
    d.rod("ridge", "crown fore glabella bridge nose nose-base philtrum lip-u")
    d.rod("chin-line", "lip-l crease chin")
    d.both("nose-side", "br1 n1 n2")
    d.across("nose-under", "nose-base n3 n2")
    d.across("upper-lip", "lip-u m2 m1")
    d.across("parting", "mouth m1")
    d.across("lower-lip", "lip-l m3 m1")
    d.both("cheekbone", "n2 c1 c2 o4")
    d.both("fold", "n2 c3 m1 c5")
    d.across("chin-crease", "crease c5 o6")
    d.both("cheek", "e4 c2 c4 c5")
    d.both("jaw", "c5 j o7")
    d.both("temple", "o1 fh1 br2")
    d.both("lid", "br2 e3")
    fabric = knit([1.45, 1.2], 8, min_angle=8.2, holes=[[-36, 17], [36, 17]])
    return "mask", d.document("Mask", "figure 6.12, drawn anew", 1.06, {"r_n": 0.4, "r_b": 0.9}, fabric, UP)


def car():
    d = Half({"bumper": (153,), "nose": (140,), "screen": (64,), "roof": (18,), "hoop": (-22,), "rear-roof": (-62,),
              "rear-screen": (-101,), "boot": (-140,), "tail": (-152,)}, {
        "s1": (38, 148), "s2": (67, 134), "s3": (80, 116), "a1": (62, 94), "s4": (84, 72),
        "s5": (88, 26), "s6": (88, -22), "s7": (85, -68), "a2": (62, -90), "s8": (82, -112), "s9": (70, -136),
        "s10": (40, -149),
        "l1": (50, 124), "w1": (50, 94), "w2": (52, 58), "w3": (57, 22), "w4": (59, -22),
        "w5": (57, -60), "w6": (51, -96), "l2": (50, -124), "r1": (37, 14), "r2": (40, -22), "r3": (36, -58),
        "c1": (26, 63),
        "c2": (29, 100), "c3": (26, 138), "t1": (26, -100), "t2": (27, -138), "h1": (50, 138), "h2": (52, -139),
        "g1": (17, 17), "g2": (19, -22),
        "g3": (17, -61), "d1": (72, 62), "d2": (75, -22), "d3": (73, -58)})
    d.across("front", "bumper s1 s2")
    d.both("wing", "s2 s3")
    d.both("front-arch", "s3 a1 s4", curve="arc")
    d.both("sill", "s4 s5 s6 s7")
    d.both("rear-arch", "s7 a2 s8", curve="arc")
    d.both("quarter", "s8 s9")
    d.across("rear", "tail s10 s9")
    d.both("belt", "l1 w1 w2 w3 w4 w5 w6 l2")
    d.both("front-pillar", "w2 r1")
    d.both("roof-edge", "r1 r2 r3")
    d.both("rear-pillar", "r3 w6")
    d.across("screen-base", "screen c1 w2")
    d.across("roof-front", "roof g1 r1")
    d.across("roof-hoop", "hoop g2 r2 w4 d2 s6")
    d.across("roof-rear", "rear-roof g3 r3")
    d.across("rear-screen-base", "rear-screen t1 w6")
    d.both("roof-rib", "g1 g2 g3")
    d.both("bonnet", "c1 c2 c3")
    d.across("bonnet-front", "nose c3 l1")
    d.rod("badge", "nose bumper")
    d.both("grille", "c3 s1")
    d.both("headlight", "c3 h1 s2")
    d.both("headlight-side", "l1 s2")
    d.both("boot-edge", "t1 t2")
    d.across("boot-rear", "boot t2 l2")
    d.rod("rear-badge", "boot tail")
    d.both("exhaust", "t2 s10")
    d.both("tail-light", "t2 h2 s9")
    d.both("tail-light-side", "l2 s9")
    d.both("crease", "d1 d2 d3")
    d.both("front-door", "w2 d1 s4")
    d.both("rear-door", "w5 d3 s7")
    fabric = knit([1.55, 1.15], 8, min_angle=9.7)
    return "car", d.document("Car concept", "figure 6.11, drawn anew", 1.082, {"r_n": 0.5, "r_b": 1.2}, fabric, UP)


def documents():
    for family in (frames(), discs(), rectangles(), removals_and_kinks()):
        yield from family
    for design in (butterfly, mask, car):
        yield design()


def text(document):
    """JSON with one point and one rod per line."""
    whole = json.dumps(document, indent=2)
    plan = document["plan"]
    for key, entries in (("points", plan["points"]), ("rods", plan["rods"])):
        named = isinstance(entries, dict)
        lines = [(json.dumps(k) + ": " if named else "") + json.dumps(v) for k, v in
                 (entries.items() if named else enumerate(entries))]
        flat = ("{" if named else "[") + "\n      " + ",\n      ".join(lines) + "\n    " + ("}" if named else "]")
        old = json.dumps(entries, indent=2).replace("\n", "\n    ")
        assert old in whole
        whole = whole.replace(old, flat, 1)
    fabric = json.dumps(plan["fabric"], indent=2).replace("\n", "\n    ")
    return whole.replace(fabric, json.dumps(plan["fabric"])) + "\n"


def main():
    check = "--check" in sys.argv[1:]
    FOLDER.mkdir(parents=True, exist_ok=True)
    differ = []
    for name, document in documents():
        path, content = FOLDER / (name + ".lissom"), text(document)
        if check:
            if not path.exists() or path.read_text(encoding="utf-8") != content:
                differ.append(path.name)
        else:
            path.write_text(content, encoding="utf-8")
    if differ:
        sys.exit("tools/draw_fabric_scenes.py: run it without --check, these differ: " + ", ".join(differ))


if __name__ == "__main__":
    main()
