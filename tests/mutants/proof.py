#!/usr/bin/env python3
"""Plants small faults in both checkers of certificates, flowcert-proof and spec/proof.py, one at a time, and sees which
of them the witnesses notice.

usage: proof.py [--count N] [--seed S] [--all] [--jobs N] [--only TEXT]     runs mutants, and lists the survivors
       proof.py --again FILE                                                runs those that a run has listed
       proof.py --check                                                     sees that the lists below are up to date

The faults of flowcert-proof are those of proof.json: each condition deleted, each sign and strictness, bounds of
numbers, and what is compared. It is compiled with checks of its arithmetic and indices, and answers the inputs of
tests/conformance/proof_witnesses_test.py. The faults of proof.py are made from its syntax tree, by the rules of
tree_faults.py, and tried by tests/conformance/proof_py_test.py. Exit status: 0 if all are noticed.
"""
import functools
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tree_faults import TreeFaults, main

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, TESTS = ROOT / "oracle" / "proof", ROOT / "tests" / "conformance"
TABLE = json.loads(Path(__file__).with_name("proof.json").read_text(encoding="utf-8"))
COMPILE = ["g++", "-std=c++20", "-O0", "-ffp-contract=off", "-fsanitize=shift,signed-integer-overflow",
           "-fno-sanitize-recover=all", "-D_GLIBCXX_ASSERTIONS"]
LEAST = 100
# Mutants that behave as the original does, and why. They are not run.
EQUIVALENT = {
    'if (facets.size() != 2) reject("T4 " + name(facet) + " has a ridge that is not of two facets of the hull"); -> '
    'nothing':
        "T4 follows from T2, T5 and T7 (FC-CERT-02).",
    "facets.size() != 2 -> facets.size() > 2": "T4 follows from T2, T5 and T7 (FC-CERT-02).",
    "facets.size() != 2 -> facets.size() < 2": "T4 follows from T2, T5 and T7 (FC-CERT-02).",
    'if (is_odd == (facet % 2 != other % 2)) reject("T4 " + name(facet) + " has a facet not oriented as the next"); -> '
    'nothing':
        "T4 follows from T2, T5 and T7 (FC-CERT-02).",
    'if (ridges.empty()) reject("T4 no facet is unpaired"); -> nothing':
        "Cells of positive volume, all of whose facets are paired, are not there: T1 and T2 say so.",
    'if (axis_ == 3) reject("T1 cell 0 has no volume"); -> nothing': "Its volume is 0, and T1 is asked of all cells.",
    "while (axis_ < 3 -> while (axis_ < 2": "What remains is the third axis; T1 is asked of all cells.",
    'if (side <= 0) reject("T5 -> if (side < 0) reject("T5':
        "By T6, a hull facet whose plane has the middle of cell 0 has this middle itself, or one beside it has. So two "
        "cells cover one side of it. A ray to this side leaves both, and one to the other side meets it: T7 fails.",
    "mate == kHull || mate < facet -> mate == kHull": "T3 is asked of a pair twice, with the same answer.",
    "mate == kHull || mate < facet -> mate == kHull || mate > facet": "T3 is asked of a pair the other way round.",
    "> 0x1p-47 -> >= 0x1p-47": "The error is less than the bound, so that a value which is equal to it has its sign.",
    "std::fabs(value) > -> value >": "Negative values are computed in integers, too.",
    "x.value < 0 ? -1 -> x.value <= 0 ? -1": "The sign of 0 is never certain.",
    "filtered.has_certain_sign() -> false": "All is computed in integers.",
    "grid_bits_ <= bits -> grid_bits_ < bits": "A bit fewer than 128 bits hold.",
    "int bits = 18 -> int bits = 19": "6 bits + 13 is 127 then, which 128 bits hold with a sign.",
    "std::ilogb(x) + 1 -> std::ilogb(x)":
        "The filter's bound is relative, and 128 bits hold one bit more, by Hadamard's bound for radii.",
    "std::ilogb(x) + 1 -> std::ilogb(x) + 2": "The scale is half as large, and a bit fewer is computed in 128.",
    "rows[a] < rows[b] -> rows[a] > rows[b]": "Equal rows stand together in either order.",
    "if (v[1] == kNone) return {{}, N{1}}; -> if (v[1] == kNone) return {{}, N{2}};":
        "The numerator is 0, whatever the denominator is.",
    "if (first == facet) open_.push_back(facet); -> open_.push_back(facet);":
        "A facet that has got its cell is passed over when its turn comes.",
    "x += 0.0 -> x": "A zero is compared as a number everywhere, and has no sign on the grid.",
    'if (rows.size() >= kNone) cannot_decide(path + ": too many rows"); -> nothing':
        "No test has 2^32 rows, which are 96 GB.",
    "(k > 0 && blanks == 0) ||  -> nothing": "A decimal ends where none of its characters follows.",
    "(v[0] > v[1]) != ((v[0] > v[2]) -> (v[0] > v[1]) == ((v[0] > v[2])":
        "The parity is compared with another one alone, and both are reversed.",
    " || count_ >= kOpen / 4 -> nothing": "No test has 2^30 cells, which are a GB and more.",
    "is_cospherical[first] == 0 || sphere -> sphere": "A cell alone has the sphere of its own vertices then.",
    "std::find(v.begin(), v.end(), x) == v.end() &&  -> nothing": "A triangle's vertices are coplanar with it.",
    "if (t_.dimension == 3) ids.erase -> ids.erase": "In dimension 2 all points are coplanar.",
    "spoke.link) > 0 -> spoke.link) >= 0":
        "With link vertices on the sphere and none inside, both values are the same.",
    "t_.opposite(facet)) > 0 -> t_.opposite(facet)) >= 0":
        "With link vertices on the sphere and none inside, both values are the same.",
    "if (about.has_certain_sign()) return sign_of(about); -> nothing": "All is computed in integers.",
    "polynomial, 6) -> polynomial, 7)": "128 bits hold what one bit more gives, by Hadamard's bound.",
    "a.quotient < b.quotient -> a.quotient > b.quotient": "What is not sorted then is sorted by exact values.",
    "std::isfinite(quotient) ? quotient : 0 -> quotient":
        "What is sorted badly because of NaN is sorted by exact values.",
    "points_.grid_bits() <= 6 -> points_.grid_bits() < 6": "BigInteger is as right as 128 bits.",
    "points_.grid_bits() <= 6 -> points_.grid_bits() <= 0": "BigInteger is as right as 128 bits.",
    "Points.__init__: below.bit_length() - 1 -> below.bit_length() + 1": "The grid is finer by two bits.",
    "Points.__init__: 0 -> 1 in default=0": "There are no coordinates then.",
    "face_of: turn + i + sum((a > b for a, b in combinations(rest, 2))) -> turn + i - sum((a > b for a, b in "
    "combinations(rest, 2)))": "Only the parity counts.",
    "face_of: turn + i -> turn - i": "Only the parity counts.",
    "face_of: a > b -> a >= b": "Only a facet with a vertex twice has another parity; its cell and the next have both.",
    "Triangulation.enter: 0 -> 1 in face_of(cell, 0, i)": "All orientations are compared with each other alone.",
    "Triangulation.enter: 2 -> 3 in :2": "Nobody reads the third one.",
    "Triangulation.check_dimension: 1 -> 2 in (self.points.distinct, self.dimension, None, 1)": "Only its sign counts.",
    "Triangulation.check_dimension: 1 -> 2 in 1 if normal[self.axis] > 0 else -1": "Only its sign counts.",
    "Triangulation.check_dimension: 1 -> 2 in -1": "Only its sign counts.",
    "Triangulation.check_dimension: 0 -> 1 in cells[0][0]": "Any vertex of the cell is in its affine hull.",
    "Triangulation.check_dimension: normal[self.axis] > 0 -> normal[self.axis] >= 0": "It is not 0 along this axis.",
    "Triangulation.check_cells: mate and mate[0] > c -> mate": "T3 is asked of a pair twice, with the same answer.",
    "Triangulation.check_cells: mate[0] > c -> mate[0] >= c": "No cell with a volume is its own neighbour.",
    "Triangulation.check_hull: side < 0 -> side <= 0": "A side is 1 or -1.",
    "Triangulation.check_hull: 0 -> 1 in side < 0": "A side is 1 or -1.",
    "Triangulation.check_hull: len(sides) != 2 or sides[0][0] == sides[1][0] -> len(sides) != 2":
        "T4 follows from T2, T5 and T7 (FC-CERT-02).",
    "Triangulation.check_hull: 1 -> 2 in (1,)": "Only the direction of the ray counts.",
    "read_cells: volume > 0 -> volume >= 0": "A cell without volume is rejected before.",
    "encode: 0 -> 1 in face_of(cell, 0, i)": "Its orientation is not asked for.",
    "encode.apex_behind: apex > opposite -> apex >= opposite": "They are different.",
    "StationaryPoints.find_clusters: self.dimension == 3 and len(cluster) > 1 -> self.dimension == 3":
        "A cell alone has the circles of its facets, which is what is taken without.",
    "StationaryPoints.find_clusters: len(cluster) > 1 -> len(cluster) >= 1":
        "A cell alone has the circles of its facets, which is what is taken without.",
    "StationaryPoints.find_simplices: 2 -> 3 in self.dimension + 2": "No cell has so many vertices.",
    "StationaryPoints.find_simplices: 0 -> 1 in default=0": "Neither is negative.",
    "test_rounding(); -> nothing": "The processor rounds as the bound needs it.",
}


def key_of(old, new):
    return f"{old} -> {new or 'nothing'}"


class ProofFaults(TreeFaults):
    """The faults of proof.py and those of the table, whose number is the place in their file's list."""

    def all(self):
        texts = {name: (PROGRAM / name).read_text(encoding="utf-8") for name in TABLE}
        return [(name, k, texts[name][:texts[name].find(old)].count("\n") + 1, key_of(old, new))
                for name, faults in TABLE.items() for k, (old, new) in enumerate(faults)] + super().all()

    def wrong(self):
        wrong = super().wrong()
        for name, faults in TABLE.items():
            text = (PROGRAM / name).read_text(encoding="utf-8")
            wrong += [f"{name}: not once, but {times} times: {old}" for old, _ in faults
                      if (times := text.count(old)) != 1]
        wrong += [f"{name}: twice: {fault}" for name, faults in TABLE.items() for fault in faults
                  if faults.count(fault) > 1]
        count = sum(map(len, TABLE.values()))
        return wrong + ([] if count >= LEAST else [f"{count} faults of flowcert-proof, not {LEAST} or more"])

    @functools.cached_property
    def inputs(self):
        """The inputs of flowcert-proof, with their answers; the function that judges one; headers, compiled once."""
        folder = self.scratch = tempfile.TemporaryDirectory(prefix="proof-inputs-")
        sys.path.insert(0, str(TESTS))
        import proof_witnesses_test as witnesses
        witnesses.WitnessTest.kept = Path(folder.name)
        tests = unittest.defaultTestLoader.loadTestsFromTestCase(witnesses.WitnessTest)
        if not unittest.TextTestRunner(verbosity=0).run(tests).wasSuccessful():
            raise SystemExit("the witnesses fail without a fault")
        header = Path(folder.name, "headers.h")
        lines = {line for path in PROGRAM.iterdir() for line in path.read_text(encoding="utf-8").split("\n")}
        header.write_text("".join(f"{line}\n" for line in sorted(lines) if line.startswith("#include <")), "utf-8")
        subprocess.run([*COMPILE, "-x", "c++-header", header], check=True)
        return witnesses, header

    def run_tests(self, name, number, *options):
        if name not in TABLE:
            return super().run_tests(name, number, *options)
        return self.unchanged if number is None else self.answers(name, *TABLE[name][number])

    @functools.cached_property
    def unchanged(self):
        return self.answers("main.cpp", "", "")

    def answers(self, name, old, new):
        """How the program with a fault ends, which is compiled here, and the first input with a wrong answer."""
        witnesses, header = self.inputs
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            for path in PROGRAM.iterdir():
                text = path.read_text(encoding="utf-8")
                Path(folder, path.name).write_text(text.replace(old, new) if path.name == name else text, "utf-8")
            program = Path(folder, "flowcert-proof")
            built = subprocess.run([*COMPILE, "-include", header, "main.cpp", "-lgmpxx", "-lgmp", "-o", program],
                                   cwd=folder, capture_output=True, text=True)
            if built.returncode != 0:  # which is an error of the table
                print(f"{name}: {key_of(old, new)} does not compile:\n{built.stderr[:800]}", flush=True)
                return subprocess.CompletedProcess([], 0)
            fault = next((fault for case in witnesses.CASES if (fault := witnesses.fault_of(program, case))), "")
            return subprocess.CompletedProcess([program], 1 if fault else 0, "", fault)


if __name__ == "__main__":
    suite = ProofFaults(ROOT / "spec", ("proof.py",), TESTS / "proof_py_test.py", "PROOF", EQUIVALENT)
    sys.exit(main(__doc__, suite, least_share=1))
