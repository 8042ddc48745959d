#!/usr/bin/env python3
"""Plants small faults in spec/judge.py and spec/read_claim.py, one at a time, and sees which of them their own tests
notice.

usage: judge_py.py [--count N] [--seed S] [--all] [--jobs N] [--only TEXT]     runs mutants, and lists the survivors
       judge_py.py --again FILE                                               runs those that a run has listed
       judge_py.py --check                                                    sees that the list below is up to date

The faults are made from the syntax tree, by the rules of tree_faults.py: other comparisons, conditions dropped, numbers
off by one, requirements and findings removed, and so on. So many of them are drawn by a seed (--all takes all). The
tests are those of tests/conformance/judge_test.py, which need no build. Exit status: 0 if at least 95 % are noticed.
"""
import sys
from pathlib import Path

from tree_faults import TreeFaults, main

ROOT = Path(__file__).resolve().parents[2]
# Mutants that behave as the original does, or that other tests notice, and why. They are not run.
EQUIVALENT = {
    "exchange_point: doubles or None -> doubles": "Only whether there is a position is asked of it.",
    "read_bars: 1 -> 2 in infinities = 1": "Only whether there was such a line is asked of it.",
    "Judge.check_stray: squared_distance(nearest_in_hull(contact, center), center) <= allowed -> "
    "squared_distance(nearest_in_hull(contact, center), center) < allowed":
        "Both sides are 0 of a sample alone, which is no stray claim; other coordinates do not meet a bound exactly.",
    "in_hull: not any(a) or a in opposite -> a in opposite": "A vector that is zero is its own opposite.",
    "Judge.can_make: fits_index and set(names) <= set(record.contact) and in_hull(self.truth.where(names), "
    "record.center) -> fits_index and in_hull(self.truth.where(names), record.center)":
        "Only parts of a contact set are placed at its record.",
    "parse: if '\\\\u' in text: -> if True:": "No other text has half a surrogate pair.",
    "nearest_in_hull: raise AssertionError('every set of points has a smallest ball') -> pass":
        "It is never reached, as it says.",
    "Judge.is_face: record.hull < 3 or self.truth.dimension(names) != 2 -> self.truth.dimension(names) != 2":
        "In a plane all sides are 0, and the next line says no.",
    "in_hull: dot(n, cross(b, c)) > 0 -> dot(n, cross(b, c)) >= 0":
        "It is 0 only of opposite vectors, of which the function has asked before.",
    "in_hull: dot(n, cross(c, a)) > 0 -> dot(n, cross(c, a)) >= 0":
        "It is 0 only of opposite vectors, of which the function has asked before.",
    "in_interior: {-1, 1} <= {sign_of_det(*plane, a) for a in v} -> {-1, 1} < {sign_of_det(*plane, a) for a in v}":
        "The two vectors that span a plane are on it, so that 0 is always there.",
    "in_interior: -1 -> 1": "Pairs of vectors span a supporting plane in both orders, as its vectors are around x.",
    "nearest_in_hull: 5 -> 6 in range(1, 5)": "Four points or fewer have the smallest ball of any set.",
    "Truth.placed: set(names) < set(one.contact) -> set(names) <= set(one.contact)":
        "A set that is equal has been found before.",
    "Judge.check_limits: dot(*(cross(minus(q, p), minus(r, p)) for p, q, r in sides)) < 0 -> "
    "dot(*(cross(minus(q, p), minus(r, p)) for p, q, r in sides)) <= 0":
        "Both planes are that of the contact set, and three points of a sphere span one.",
    "run_command: run.wait() -> pass":
        "What has been killed is waited for, so that it leaves the table of processes. No answer depends on it.",
    "read_csv: len(fields) > 4 -> len(fields) >= 4": "A line whose fourth field is empty is refused either way.",
    "number: 0 -> 1 in parts[1] or 0": "An exponent of 1 is as good as none: it is at most 700.",
    "roots_differ_by: left <= 0 -> left < 0": "Where it is 0, so is its square, and 4 a b is not less.",
    "parse: 0 -> 1 in default=0": "A depth of 1 is as good as none: it is at most 16.",
    ": Fraction(value.text) <= Fraction(most.text) -> Fraction(value.text) < Fraction(most.text)":
        "The greatest id is the only maximum. No input of a test has so many rows, so that it is refused either way.",
    ": if __name__ == '__main__': -> if False:": "All other tests of judge.py start it as a program, and would fail.",
}

if __name__ == "__main__":
    tests = ROOT / "tests" / "conformance" / "judge_test.py"
    sys.exit(main(__doc__, TreeFaults(ROOT / "spec", ("judge.py", "read_claim.py"), tests, "JUDGE", EQUIVALENT)))
