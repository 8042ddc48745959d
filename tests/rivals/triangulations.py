"""The triangulations of GUDHI, CGAL, SciPy and TetGen: spec/proof.py proves or refutes each, from a list of its cells.

    triangulations.py FLOWCERT FOLDER [--jobs 2] [--seed 1] [--only NAME] [--record FILE]
    triangulations.py --self-test

The inputs are the conformance vectors, 50 drawn ones of each family, and larger ones that are made here. Of Flowcert
only the points are asked: the programs print rows of points, line by line, and proof.py reads just these lines.
Each refutation is confirmed by fractions, straight from the definition: a cell that is flat, a point inside of a
sphere, cells on the same side of a facet, a point beyond the hull, or a point that is no vertex. Exit status 1 if one
is not, or if a triangulation by CGAL is refuted: either would say that proof.py is wrong.
Standard output is Markdown, and FOLDER/smallest/ has the smallest input for each condition that fails.
"""

import argparse
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction
from itertools import product
from pathlib import Path

import rivals
from rivals import HERE, PYTHON, Program

sys.path.insert(0, str(HERE.parents[1] / "spec"))
import proof

OF_EACH_FAMILY = 50
CLASSES = ("proved", "refuted", "unreadable", "refused", "crashed")


def programs(cgal):
    gudhi, scipy = str(HERE / "gudhi_alpha.py"), str(HERE / "scipy_delaunay.py")
    return [*(Program(f"gudhi {kind}", [PYTHON, gudhi, f"{kind}-cells"]) for kind in ("fast", "safe", "exact")),
            *(Program(f"cgal {kind}", [cgal, f"cells-{kind}"]) for kind in ("epick", "epeck")),
            Program("scipy", [PYTHON, scipy, "plain-cells"]),
            Program("scipy joggled", [PYTHON, scipy, "joggled-cells"]),
            Program("tetgen", [PYTHON, str(HERE / "tetgen_delaunay.py"), "cells"])]


# ---- Inputs ----

def cases_in(text):
    """The rows of each case, by id."""
    cases, lines = {}, iter(text.splitlines())
    for line in lines:
        if line.startswith("case "):
            _, name, count = line.split()
            cases[name] = [tuple(map(float, next(lines).split())) for _ in range(int(count))]
    return cases


def generated(flowcert, *options):
    return cases_in(subprocess.run([flowcert, "generate", *options], capture_output=True, text=True, check=True).stdout)


def drawn_cases(flowcert, seed):
    """The cases of each family. Families that `generate` does not know are for other tests."""
    listed = subprocess.run([flowcert, "fuzz", "--families", "list"], capture_output=True, text=True, check=True).stdout
    families = {}
    for family in re.findall(r"^  (\S+)", listed, re.MULTILINE):
        try:
            families[family] = generated(flowcert, "--level", "2", "--seed", str(seed), "--cases", str(OF_EACH_FAMILY),
                                         "--family", family)
        except subprocess.CalledProcessError:
            print(f"no drawn cases of {family}", file=sys.stderr)
    return families


def larger_inputs():
    """Inputs of some hundred points each, by name. All but the last one are degenerate, or nearly."""
    draw = random.Random(45)
    lattice = list(product(range(6), repeat=3))
    turned = [(2 * x - y + 2 * z, 2 * x + 2 * y - z, -x + 2 * y + 2 * z) for x, y, z in lattice]
    grid = list(product(range(14), repeat=2))
    sphere = [p for p in product(range(-11, 12), repeat=3) if sum(x * x for x in p) == 101]
    unit = [tuple(x / sum(y * y for y in p) ** 0.5 for x in p)
            for p in ([draw.gauss(0, 1) for _ in range(3)] for _ in range(200))]
    return {"lattice 6x6x6": lattice,
            "the same, turned, three times as large": turned,
            "the same, turned, rounded": [tuple(x / 3 for x in p) for p in turned],
            "168 integer points of a sphere": sphere,
            "200 points of a sphere, rounded": unit,
            "grid 14x14, up to 2^-50 off a plane": [(x, y, draw.randrange(-4, 5) * 2.0**-52) for x, y in grid],
            "grid 14x14, up to 2^-20 off a plane": [(x, y, draw.randrange(-4, 5) * 2.0**-22) for x, y in grid],
            "scan of a sphere in steps of 1/8": sorted({tuple(round(8 * x) / 8 for x in p) for p in unit}),
            "200 points of a cube": [tuple(draw.random() for _ in range(3)) for _ in range(200)]}


# ---- Asking and judging ----

def ask(program, cases):
    """The outcome and the text of each case, by id; the text of an answer is its lines of cells."""
    text = "".join(f"case {name} {len(rows)}\n" + "".join("{!r} {!r} {!r}\n".format(*row) for row in rows)
                   for name, rows in cases.items())
    said = subprocess.run(program.command, input=text, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}, timeout=rivals.VECTOR_LIMIT,
                          check=True).stdout
    answers, lines = {}, iter(said.splitlines(keepends=True))
    for line in lines:
        outcome, name, *reason = line.split()
        if outcome == "answer":
            answers[name] = outcome, "".join(iter(lambda: next(lines), "end\n"))
        else:
            kind = rivals.kind_of_reason(" ".join(reason))
            answers[name] = "crashed" if kind.startswith("crashed") else "refused", kind
    if set(answers) != set(cases):
        raise RuntimeError(f"{program.name}: not one answer for each case")
    return answers


def judged(rows, lines, folder):
    """(proved, "proved"), (refuted, condition) or (unreadable, the reason), as `proof.py SCAN --cells FILE` says."""
    scan, cells = Path(folder) / "points.f64", Path(folder) / "cells.txt"
    scan.write_bytes(b"".join(struct.pack("<3d", *row) for row in rows))
    cells.write_text(lines)
    try:
        proof.prove(argparse.Namespace(scan=str(scan), cells=str(cells), from_cells=None, list=None))
        return "proved", "proved"
    except proof.Rejected as error:
        return "refuted", re.match(r"cells rejected: (T\d) ", str(error))[1]
    except proof.Undecodable as error:
        return "unreadable", str(error).split(": ", 1)[1]


def cells_in(lines):
    return [tuple(map(int, line.split())) for line in lines.splitlines()]


class Verdict:
    def __init__(self, rows, answer, folder):
        self.rows, self.lines = rows, answer[1]
        self.outcome, self.reason = judged(rows, answer[1], folder) if answer[0] == "answer" else answer
        self.why = reason_by_fractions(rows, cells_in(self.lines), self.reason) if self.outcome == "refuted" else None


def verdicts_on(program, cases):
    """The verdict on each case, by id."""
    with tempfile.TemporaryDirectory() as folder:
        return {name: Verdict(cases[name], answer, folder) for name, answer in ask(program, cases).items()}


# ---- By exact arithmetic ----

def place(points, cell, p):
    """The barycentric coordinates of a point of the cell's affine hull: negative beyond the facet of a corner."""
    corners = [[Fraction(x) for x in points[i]] for i in cell]
    *edges, toward = [[a - b for a, b in zip(end, corners[0])] for end in [*corners[1:], map(Fraction, points[p])]]
    weights = rivals.solved([[rivals.dot(u, v) for v in edges] for u in edges], [rivals.dot(u, toward) for u in edges])
    return [1 - sum(weights), *weights]


def share(value):
    """The value as a fraction where that is short, as a power of two where it is less than any double."""
    if len(str(value)) < 10:
        return str(value)
    if float(value) == 0:
        return f"about 2^{value.numerator.bit_length() - value.denominator.bit_length()}"
    return f"{float(value):.3g}"


def flaws(points, cells):
    """What is wrong with cells, as (condition, sentence), in passes; T6 is of a hull that is not convex or not closed.
    It shares no code with proof.py. There is none where balls are empty, facets are in pairs or on the hull, and no
    point is left out."""
    first = {tuple(row): i for i, row in reversed(list(enumerate(points)))}
    name = [first[tuple(row)] for row in points]
    distinct = sorted(set(name))
    cells = [tuple(name[i] for i in cell) for cell in cells]
    dimension = len(rivals.independent_part(points, distinct)) - 1
    if any(len(cell) != dimension + 1 for cell in cells) or not cells and dimension > 0:
        yield "T0", f"the points have dimension {dimension}"
        return
    flat = [cell for cell in cells if rivals.sphere_facts([points[p] for p in cell], range(dimension + 1)) is None]
    yield from (("T1", f"the cell {in_words(cell)} is flat") for cell in flat)
    if cells:
        yield from (("T8", f"{p} is no vertex of a cell") for p in sorted(set(distinct).difference(*cells)))
    cells, facets = [cell for cell in cells if cell not in flat], {}
    for cell in cells:
        for i, apex in enumerate(cell):
            facets.setdefault(tuple(sorted(cell[:i] + cell[i + 1:])), []).append((apex, cell))
    for facet, sides in facets.items():
        (apex, cell), (other, second) = sides[0], sides[-1]
        if len(sides) > 2:
            yield "T2", f"{len(sides)} cells have the facet {in_words(facet)}"
        elif len(sides) == 2 and place(points, cell, other)[cell.index(apex)] >= 0:
            yield "T2", f"{in_words(cell)} and {in_words(second)} are on the same side of their common facet"
    for cell in cells:
        facts = rivals.sphere_facts(points, cell)
        if facts["inside"]:
            depth, p = max((1 - rivals.squared(points[p], facts["center"]) / facts["square"], -p) for p in distinct)
            yield "T3", f"{-p} is inside of the sphere of {in_words(cell)}, by {share(depth)} of the squared radius"
    for facet, [(apex, cell), *others] in facets.items():
        beyond = [p for p in distinct if not others and place(points, cell, p)[cell.index(apex)] < 0]
        if beyond:
            yield "T6", f"only {in_words(cell)} has the facet {in_words(facet)}, and {beyond[0]} is beyond it"


def in_words(ids):
    return " ".join(map(str, ids))


def reason_by_fractions(points, cells, condition):
    """A flaw of this condition, or else any; None if there is none. All of the hull's conditions are T6 here."""
    sought = "T6" if condition in ("T4", "T5", "T7") else condition
    any_flaw = None
    for kind, text in flaws(points, cells):
        if kind == sought:
            return text
        any_flaw = any_flaw or text
    return any_flaw


# ---- The report ----

def short(name):
    return name.replace("gudhi ", "g-").replace("cgal ", "").replace("scipy joggled", "joggled")


def print_by_program(what, verdicts):
    conditions = sorted({v.reason for of in verdicts.values() for v in of.values() if v.outcome == "refuted"})
    rows = []
    for name, of in verdicts.items():
        outcomes, reasons = Counter(v.outcome for v in of.values()), Counter(v.reason for v in of.values())
        rows.append([name, len(of), outcomes["proved"], outcomes["refuted"], *(reasons[c] for c in conditions),
                     *(outcomes[outcome] for outcome in CLASSES[2:])])
    rivals.print_table([what, "n", *CLASSES[:2], *conditions, *CLASSES[2:]], rows)


def print_by_family(families, verdicts):
    rows = []
    for family, cases in families.items():
        row = [family, len(cases)]
        for of in verdicts.values():
            count = Counter(of[name].outcome for name in cases)
            row.append(f"{count['proved']}/{count['refuted'] + count['unreadable'] + count['crashed']}")
        rows.append(row)
    rivals.print_table(["family", "n", *map(short, verdicts)], rows)


def print_smallest(name, verdicts, folder):
    kinds = {}
    for where, verdict in verdicts.items():
        if verdict.outcome not in ("proved", "refused"):
            kinds.setdefault((verdict.outcome, verdict.reason if verdict.outcome != "unreadable" else ""), []).append(
                (len(verdict.rows), where, verdict))
    if not kinds:
        return
    print(f"{name}:\n")
    folder.mkdir(parents=True, exist_ok=True)
    for (outcome, reason), found in sorted(kinds.items()):
        count, where, verdict = min(found, key=lambda one: (one[0], len(str(one[2].rows)), one[1]))
        label = f"{outcome} {reason}".replace("crashed crashed", "crashed").strip()
        print(f"- {label}: {rivals.count_text(len(found), 'input')}; the smallest is {where}, "
              f"{rivals.count_text(count, 'point')}.")
        if outcome == "refuted":
            print(f"  {verdict.why}.")
        stem = "".join(c if c.isalnum() else "-" for c in f"{name}-cells-{label}")
        text = "".join(" ".join(map(repr, row)) + "\n" for row in verdict.rows)
        (folder / f"{stem}.xyz").write_text(text)
        (folder / f"{stem}.txt").write_text(verdict.lines)
    print()


def report(options):
    folder = Path(options.folder).resolve()
    asked = [p for p in programs(rivals.compiled(folder)) if options.only in (None, p.name)]
    if not asked:
        return 0
    flowcert = str(Path(options.flowcert).resolve())
    families = drawn_cases(flowcert, options.seed)
    vectors = {name.split(":")[1]: rows for name, rows in generated(flowcert, "--vectors").items()}
    drawn = {name: rows for cases in families.values() for name, rows in cases.items()}
    larger = {f"larger-{k}": rows for k, rows in enumerate(larger_inputs().values())}

    def in_groups(program):
        return [verdicts_on(program, cases) for cases in (vectors, drawn, larger)]

    results = dict(zip([p.name for p in asked], rivals.in_turn(options.jobs, in_groups, asked, "triangulations")))
    print("### Triangulations\n")
    for k, what in enumerate(("vectors", "drawn")):
        print_by_program(what, {name: groups[k] for name, groups in results.items()})
    print_by_family(families, {name: groups[1] for name, groups in results.items()})
    rivals.print_table(["larger inputs", "n", *map(short, results)], [
        [what, len(larger[name]), *(groups[2][name].reason if groups[2][name].outcome == "refuted"
                                    else groups[2][name].outcome for groups in results.values())]
        for name, what in zip(larger, larger_inputs())])
    everything = {name: {where: v for group in groups for where, v in group.items()}
                  for name, groups in results.items()}
    rivals.add_to_record(options.record, "triangulations", {
        name: {where: v.outcome for where, v in of.items()} for name, of in everything.items()})
    for name, of in everything.items():
        print_smallest(name, of, folder / "smallest")
    doubtful = [f"{name}, {where}: {v.reason}" for name, of in everything.items() for where, v in of.items()
                if v.outcome == "refuted" and (name.startswith("cgal") or v.why is None)]
    print("".join(f"To be looked at: {one}\n" for one in doubtful), end="")
    return 1 if doubtful else 0


def self_test():
    square = [(0, 0, 0), (2, 0, 0), (0, 2, 0), (2, 2, 0)]
    above = [*square, (0, 0, 2), (0, 0, 0), (1, 1, 0.5)]
    obtuse = [(0, 0, 0), (4, 0, 0), (2, 1, 0), (2, -1, 0)]
    line = [(0, 0, 0), (1, 1, 1), (2, 2, 2)]
    with tempfile.TemporaryDirectory() as folder:
        def says(points, *cells):
            lines = "".join(" ".join(map(str, cell)) + "\n" for cell in cells)
            return judged(points, lines, folder)[1], sorted({kind for kind, _ in flaws(points, cells)})
        assert says(square, (0, 1, 2), (1, 2, 3)) == says(square, (3, 0, 1), (0, 2, 3)) == ("proved", [])
        assert says(square, (0, 1, 2), (0, 1, 3)) == ("T2", ["T2"] + ["T6"])
        assert says(square, (0, 1, 2)) == ("T8", ["T6", "T8"])
        assert says(square, (0, 1)) == ("T0", ["T0"]) and says(square) == ("T0", ["T0"])
        assert says(obtuse, (0, 1, 2), (0, 1, 3)) == ("T3", ["T3"])
        assert says(obtuse, (0, 2, 3), (1, 2, 3)) == ("proved", [])
        assert says([*square, (1, 3, 0)], (0, 1, 2), (1, 2, 3), (2, 3, 4)) == ("proved", [])
        assert says([*square, (1, 3, 0), (-2, 2, 0)], (0, 1, 2), (1, 2, 3), (2, 3, 4), (0, 2, 5)) == ("T6", ["T6"])
        assert says(above[:6], (5, 1, 2, 4), (1, 2, 3, 4)) == ("proved", [])
        assert says(above, (0, 1, 2, 4), (1, 2, 3, 4))[1] == ["T3", "T8"]
        assert says(above[:5], (0, 1, 2, 3)) == ("T1", ["T1", "T8"])
        assert says(line, (0, 1), (1, 2)) == ("proved", []) and says(line, (0, 2)) == ("T8", ["T3", "T8"])
        assert says([(1, 1, 1)] * 2) == says([]) == ("proved", [])
        assert judged(square, "0 1 4\n", folder)[0] == "unreadable"
    assert all(len(set(rows)) == len(rows) > 100 for rows in larger_inputs().values())
    assert share(Fraction(2, 5)) == "2/5" and share(Fraction(1, 2**2000)) == "about 2^-2000"
    assert cases_in("# a\ncase a 1\n1 2 3\ncase b 0\n") == {"a": [(1, 2, 3)], "b": []}


def main():
    options = rivals.options_of(__doc__)
    if options.self_test:
        self_test()
        return 0
    return report(options)


if __name__ == "__main__":
    sys.exit(main())
