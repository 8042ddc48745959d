"""The balls tangent to four atoms, by Debian's `voronota calculate-vertices`, against the peaks of `flowcert pores`.

    tangent_balls.py FLOWCERT FOLDER [--seed 1] [--only NAME] [--record FILE]
    tangent_balls.py --self-test

voronota lists the vertices of the Voronoi diagram of balls: quadruples with the ball that is tangent to them. A
critical point of index 3 (FC-BALL-03) is one of these, and its contacts have the quadruple. `pores --depth 0 --json`
tells all critical points of index 3, as peaks of chambers. Asked is, for each set of balls: which of ours are vertices
of voronota within TOLERANCE, and which of its vertices inside of their own tetrahedra are not ours.
What differs is looked at straight from the definition. Exit status 1 if that does not explain it.
FLOWCERT_BENCH_DATA may name a folder with a protein, protein_1mvm.xyz. Standard output is Markdown.
"""

import json
import math
import os
import random
import shutil
import subprocess
import sys
from collections import Counter, defaultdict
from fractions import Fraction
from itertools import product
from pathlib import Path

import rivals

TOLERANCE = 1e-6  # of a coordinate or a radius, and of a weight
ROOT = rivals.HERE.parents[1]
BONDI = {"H": "1.20", "C": "1.70", "N": "1.55", "O": "1.52"}


# ---- Inputs: lists of balls, each four texts ----

def symmetric_sets():
    golden = (1 + 5 ** 0.5) / 2
    signs = list(product((1, -1), repeat=3))
    turns = [(0, 1, 2), (1, 2, 0), (2, 0, 1)]

    def turned(*points):
        return sorted({tuple(s * p[t] for s, t in zip(sign, turn)) for p in points for turn in turns for sign in signs})
    icosahedron = turned((0, 1, golden))
    return {"tetrahedron": [(2, 2, 2), (2, -2, -2), (-2, 2, -2), (-2, -2, 2)],
            "octahedron": turned((0, 0, 2)), "cube": turned((2, 2, 2)), "cuboctahedron": turned((0, 2, 2)),
            "icosahedron": icosahedron, "dodecahedron": turned((1, 1, 1), (0, 1 / golden, golden)),
            "icosahedron in another": icosahedron + [tuple(3 * x for x in point) for point in icosahedron]}


def grid(size, step=1):
    return [tuple(step * x for x in point) for point in product(range(size), repeat=3)]


def with_radii(points, *radii):
    return [tuple(repr(x) if isinstance(x, float) else str(x) for x in point) + (radii[k % len(radii)],)
            for k, point in enumerate(points)]


def inputs(seed):
    """By name, the sets of balls."""
    lines = (ROOT / "tests/inputs/cage.xyz").read_text().splitlines()[2:]
    sets = {"cage": [[(x, y, z, BONDI[element]) for element, x, y, z in (line.split()[:4] for line in lines if line)]]}
    sets["symmetric"] = [with_radii(points, "0.5") for points in symmetric_sets().values()]
    sets["symmetric, two radii"] = [with_radii(points, "0.5", "0.25") for points in symmetric_sets().values()]
    sets["grids"] = [with_radii(grid(size), *radii) for size in (2, 3, 5) for radii in (["0.25"], ["0.25", "0.125"])]
    sets["body-centred grids"] = [with_radii(grid(4, 2) + [tuple(x + 1 for x in point) for point in grid(3, 2)], radius)
                                  for radius in ("0.5", "0.25")]
    draw = random.Random(seed)

    def drawn(count, coordinate, radius):
        return [(coordinate(), coordinate(), coordinate(), radius()) for _ in range(count)]
    lattice = lambda: str(draw.randrange(-3, 4))
    few = lambda: draw.choice(("0.5", "1", "1.5"))
    sets["lattice, 6 to 14 balls"] = [drawn(draw.randrange(6, 15), lattice, few) for _ in range(200)]
    uniform = lambda: f"{draw.uniform(-10, 10):.4f}"
    sets["random, 100 balls"] = [drawn(100, uniform, lambda: f"{draw.uniform(0.2, 2):.3f}") for _ in range(30)]
    sets["random, 2,000 balls"] = [drawn(2000, uniform, lambda: f"{draw.uniform(0.1, 0.5):.3f}")]
    sets["far, 100 balls"] = [drawn(100, lambda: f"{1e4 + draw.uniform(-10, 10):.4f}", few) for _ in range(10)]
    protein = Path(os.environ.get("FLOWCERT_BENCH_DATA", "/nowhere")) / "protein_1mvm.xyz"
    if protein.exists():
        rows = [line.split()[:3] for line in protein.read_text().splitlines() if line.strip()]
        sets["protein, 4 radii in turn"] = [with_radii([tuple(row) for row in rows], "1.70", "1.55", "1.52", "1.20")]
    return sets


# ---- What both say ----

def peaks(flowcert, path):
    """By contact set, position and value of our critical points of index 3."""
    report = rivals.json_of([flowcert, "pores", path, "--radii", "column:4", "--depth", "0", "--json"])
    return {tuple(point["contact"]): ([c["double"] for c in point["center"]], chamber["peak"]["value"]["double"])
            for chamber in report["chambers"] for point in chamber["peak"]["points"]}


class Ended(Exception):
    pass


def vertices(path):
    """By quadruple, position and radius of the tangent balls."""
    with open(path) as balls:
        ended = subprocess.run(["voronota", "calculate-vertices"], stdin=balls, capture_output=True, text=True,
                               timeout=rivals.VECTOR_LIMIT, check=False)
    if ended.returncode != 0:
        raise Ended(f"status {ended.returncode}: {(ended.stderr.strip().splitlines() or ['nothing'])[-1]}")
    found = defaultdict(list)
    for words in map(str.split, ended.stdout.splitlines()):
        found[tuple(sorted(map(int, words[:4])))].append(tuple(map(float, words[4:])))
    return found


# ---- By fractions and by doubles ----

def exact(ball):
    return [Fraction(word) for word in ball]


def overlap(balls, ids, place):
    """By how much a ball enters the one around a place that touches those of these ids, and how many touch it."""
    room = [math.dist(place, ball[:3]) - ball[3] for ball in balls]
    touched = max(room[i] for i in ids)
    return touched - min(room), sum(abs(r - touched) <= TOLERANCE for r in room)


def weights(corners, place):
    """The barycentric coordinates of a place in a tetrahedron, exact for these doubles; nothing if it is flat."""
    corners = [exact(corner[:3]) for corner in corners]
    edges = [[a - b for a, b in zip(corner, corners[0])] for corner in corners[1:]]
    towards = [Fraction(x) - a for x, a in zip(place, corners[0])]
    solution = rivals.solved([list(row) for row in zip(*edges)], towards)
    return None if solution is None else [1 - sum(solution), *solution]


def distance(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


# Places are near only if their cells are neighbours.
def cell_of(place):
    return tuple(math.floor(x / 0.01) for x in place[:3])


def nearby(by_cell, place):
    return [one for cell in product(*((c - 1, c, c + 1) for c in cell_of(place))) for one in by_cell.get(cell, ())]


def comparison(balls, ours, theirs):
    """Counts of what agrees, and what does not, in words."""
    count, doubts = Counter(ours=len(ours), theirs=sum(map(len, theirs.values()))), []
    numbers = [[float(word) for word in ball] for ball in balls]
    of_place, used = defaultdict(list), set()
    for q, found in theirs.items():
        for ball in found:
            of_place[cell_of(ball)].append((q, ball))
    ours_at = defaultdict(list)
    for place, value in ours.values():
        ours_at[cell_of([*place, value])].append([*place, value])
    for contact, (place, value) in ours.items():
        here = [*place, value]
        near = [(distance(here, ball), q, ball) for q, ball in nearby(of_place, here)]
        near = [(off, q, ball) for off, q, ball in near if off <= TOLERANCE]
        same = [(off, q, ball) for off, q, ball in near if set(q) <= set(contact)]
        used |= {(q, ball) for _, q, ball in same}
        count["same" if same else "other four" if near else "missed"] += 1
        count["worst"] = max(count["worst"], min((off for off, *_ in same), default=0))
        if near:
            continue
        text = f"{' '.join(map(str, contact))} at {place}, value {value!r}, is not there"
        entered, touched = overlap(numbers, contact, place)
        if entered > TOLERANCE or touched < len(contact):
            doubts.append(f"{text}; it is no vertex by {entered:.3g}")
        count.setdefault("first", text)
    count["used"] = len(used)
    for q, found in theirs.items():
        for ball in found:
            *place, radius = ball
            if (q, ball) in used or radius < TOLERANCE:
                continue
            inside = weights([balls[i] for i in q], place)
            if inside is None or min(inside) < TOLERANCE:
                continue
            if any(distance(one, ball) <= TOLERANCE for one in nearby(ours_at, ball)):
                count["other four of theirs"] += 1
                continue
            count["inside, not ours"] += 1
            entered, _ = overlap(numbers, q, place)
            text = f"{' '.join(map(str, q))} at {place}, radius {radius!r}"
            if entered <= TOLERANCE:
                doubts.append(f"theirs is not ours: {text}")
            count.setdefault("first", f"{text}, is no vertex by {entered:.3g}")
    return count, doubts


def report(options):
    folder = Path(options.folder).resolve()
    if options.only not in (None, "voronota"):
        return 0
    print("### Balls tangent to four\n")
    if shutil.which("voronota") is None:
        print("voronota is not there: this system has no such package.\n")
        return 0
    flowcert = str(Path(options.flowcert).resolve())
    rows, outcomes, remarks, all_doubts = [], {}, [], []
    (folder / "balls").mkdir(parents=True, exist_ok=True)
    for name, sets in inputs(options.seed).items():
        total, ended = Counter(), 0
        for number, balls in enumerate(sets):
            path = folder / "balls" / f"{name.replace(' ', '-').replace(',', '')}-{number}.xyz"
            path.write_text("".join(" ".join(ball) + "\n" for ball in balls))
            ours = peaks(flowcert, path)
            try:
                count, doubts = comparison(balls, ours, vertices(path))
            except (Ended, subprocess.TimeoutExpired) as error:
                ended += 1
                outcomes[path.stem] = "crashed"
                remarks.append(f"{path.stem}: voronota ended, {error}")
                continue
            outcomes[path.stem] = "wrong" if count["missed"] + count["inside, not ours"] else "right"
            if "first" in count:
                remarks.append(f"{path.stem}: {count.pop('first')}")
            worst = max(total["worst"], count["worst"])
            total += count
            total["worst"] = worst
            all_doubts += [f"{path.stem}: {doubt}" for doubt in doubts]
        rows.append([name, len(sets), total["ours"], total["same"], total["other four"],
                     total["missed"], f"{float(total['worst']):.1e}", total["theirs"], total["used"],
                     total["inside, not ours"], ended])
    rivals.print_table(["balls", "n", "our peaks", "same", "other four", "missed", "worst", "vertices", "ours",
                        "inside, not ours", "ended"], rows)
    rivals.add_to_record(options.record, "tangent balls", {"voronota": outcomes})
    print("".join(f"- {remark}\n" for remark in remarks[:12]))
    print("".join(f"To be looked at: {doubt}\n" for doubt in all_doubts), end="")
    return 1 if all_doubts else 0


def self_test():
    balls = with_radii([*symmetric_sets()["tetrahedron"], (9, 9, 9)], "1")
    value = 2 * 3 ** 0.5 - 1
    ours, theirs = {(0, 1, 2, 3): ([0, 0, 0], value)}, {(0, 1, 2, 3): [(0, 0, 0, value)]}
    count, doubts = comparison(balls, ours, theirs)
    assert (count["same"], count["used"], count["missed"], doubts) == (1, 1, 0, [])
    count, doubts = comparison(balls, ours, {(0, 1, 2, 4): [(0, 0, 1e-9, value)]})
    assert (count["same"], count["other four"], count["missed"], doubts) == (0, 1, 0, [])
    count, doubts = comparison(balls, ours, {})
    assert (count["missed"], doubts) == (1, [])
    count, doubts = comparison(balls, {}, theirs)
    assert count["inside, not ours"] == 1 and doubts
    count, doubts = comparison(balls, {(0, 1, 2, 3): ([0, 0, 1], value)}, theirs)
    assert (count["missed"], count["inside, not ours"], len(doubts)) == (1, 1, 2)
    assert weights(balls, (0, 0, 0)) == [Fraction(1, 4)] * 4 and weights([balls[0]] * 4, (0, 0, 0)) is None
    assert [len(points) for points in symmetric_sets().values()] == [4, 6, 8, 12, 12, 20, 24]
    assert all(len({ball[3] for ball in balls}) <= 3 for balls in inputs(1)["lattice, 6 to 14 balls"])


def main():
    options = rivals.options_of(__doc__)
    if options.self_test:
        self_test()
        return 0
    return report(options)


if __name__ == "__main__":
    sys.exit(main())
