#!/usr/bin/env python3
"""Plants small faults in spec/judge.py and spec/read_claim.py, one at a time, and sees which of them their own tests
notice.

usage: judge_py.py [--count N] [--seed S] [--all] [--jobs N] [--only TEXT]     runs mutants, and lists the survivors
       judge_py.py --again FILE                                               runs those that a run has listed
       judge_py.py --check                                                    sees that the list below is up to date

The faults are made from the syntax tree, by the rules below: other comparisons, conditions dropped, numbers off by one,
requirements and findings removed, and so on. So many of them are drawn by a seed (--all takes all). The tests are those
of tests/conformance/judge_test.py, which need no build. Exit status: 0 if at least 95 % are noticed.
"""
import argparse
import ast
import concurrent.futures
import copy
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SPEC, TESTS = ROOT / "spec", ROOT / "tests" / "conformance" / "judge_test.py"
FILES = ("judge.py", "read_claim.py")
LEAST, LEAST_SHARE, SECONDS = 100, 0.95, 180
# Mutants that behave as the original does, or that other tests notice, and why. They are not run.
EQUIVALENT = {
    "exchange_point: doubles or None -> doubles": "Only whether there is a position is asked of it.",
    "read_bars: 1 -> 2": "Only whether there was such a line is asked of it.",
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
    "nearest_in_hull: 5 -> 6": "Four points or fewer have the smallest ball of any set.",
    "Truth.placed: set(names) < set(one.contact) -> set(names) <= set(one.contact)":
        "A set that is equal has been found before.",
    "Judge.check_limits: dot(*(cross(minus(q, p), minus(r, p)) for p, q, r in sides)) < 0 -> "
    "dot(*(cross(minus(q, p), minus(r, p)) for p, q, r in sides)) <= 0":
        "Both planes are that of the contact set, and three points of a sphere span one.",
    "run_command: run.wait() -> pass":
        "What has been killed is waited for, so that it leaves the table of processes. No answer depends on it.",
    "read_csv: len(fields) > 4 -> len(fields) >= 4": "A line whose fourth field is empty is refused either way.",
    "number: 0 -> 1": "An exponent of 1 is as good as none: it is at most 700.",
    "roots_differ_by: left <= 0 -> left < 0": "Where it is 0, so is its square, and 4 a b is not less.",
    "parse: 0 -> 1": "A depth of 1 is as good as none: it is at most 16.",
    ": Fraction(value.text) <= Fraction(most.text) -> Fraction(value.text) < Fraction(most.text)":
        "The greatest id is the only maximum. No input of a test has so many rows, so that it is refused either way.",
    ": if __name__ == '__main__': -> if False:": "All other tests of judge.py start it as a program, and would fail.",
}

OTHER_COMPARISONS = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
                     ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is}
OTHER_OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Add, ast.Div: ast.Mult, ast.Pow: ast.Mult}
OTHER_FUNCTIONS = {"all": "any", "any": "all", "min": "max", "max": "min"}


def other_expressions(node):
    """What an expression may become."""
    if isinstance(node, ast.Compare):
        for k, operator in enumerate(node.ops):
            yield ast.Compare(node.left, [*node.ops[:k], OTHER_COMPARISONS[type(operator)](), *node.ops[k + 1:]],
                              node.comparators)
    if isinstance(node, ast.BoolOp):
        for k in range(len(node.values)):
            rest = node.values[:k] + node.values[k + 1:]
            yield rest[0] if len(rest) == 1 else ast.BoolOp(node.op, rest)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
        yield node.operand
    if isinstance(node, ast.BinOp) and type(node.op) in OTHER_OPERATORS:
        yield ast.BinOp(node.left, OTHER_OPERATORS[type(node.op)](), node.right)
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
        yield ast.Constant(node.value + 1)
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        yield ast.Constant(not node.value)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in OTHER_FUNCTIONS:
        yield ast.Call(ast.Name(OTHER_FUNCTIONS[node.func.id], ast.Load()), node.args, node.keywords)
    if isinstance(node, ast.IfExp):
        yield node.body
        yield node.orelse


def other_statements(node):
    """What a statement may become. Requirements and findings are removed; branches are always or never taken."""
    is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    if isinstance(node, (ast.Expr, ast.AugAssign, ast.Raise)) and not is_docstring:
        yield ast.Pass()
    if isinstance(node, ast.If):
        yield ast.If(ast.Constant(True), node.body, node.orelse)
        yield ast.If(ast.Constant(False), node.body, node.orelse)


class Planter(ast.NodeTransformer):
    """Numbers all faults of a tree, and plants the one of a number."""

    def __init__(self, wanted=None):
        self.wanted, self.found, self.names = wanted, [], []

    def visit(self, node):
        if isinstance(node, ast.JoinedStr):  # words of messages
            return node
        is_named = isinstance(node, (ast.FunctionDef, ast.ClassDef))
        self.names += [node.name] if is_named else []
        changed = None
        for other in [*other_expressions(node), *other_statements(node)]:
            if len(self.found) == self.wanted:
                changed = ast.copy_location(other, node)
            old, new = (ast.unparse(one).split("\n")[0] for one in (node, ast.fix_missing_locations(other)))
            self.found.append((node.lineno, f"{'.'.join(self.names)}: {old} -> {new}"))
        result = self.generic_visit(node) if changed is None else changed
        if is_named:
            self.names.pop()
        return result


def source_of(name):
    return (SPEC / name).read_text(encoding="utf-8")


def all_faults():
    """Of both files: the file, the number of the fault in it, its line, and what it is."""
    found = []
    for name in FILES:
        planter = Planter()
        planter.visit(ast.parse(source_of(name)))
        found += [(name, k, *fault) for k, fault in enumerate(planter.found)]
    return found


def run_tests(name, number, *options):
    """The tests of both files with a fault, or, without a number, as they are but without their comments."""
    with tempfile.TemporaryDirectory(prefix="judge-mutant-") as folder:
        for other in ("schemas", "vectors", *FILES):
            Path(folder, other).symlink_to(SPEC / other)
        tree = Planter(number).visit(ast.parse(source_of(name)))
        Path(folder, name).unlink()
        Path(folder, name).write_text(ast.unparse(ast.fix_missing_locations(copy.deepcopy(tree))), encoding="utf-8")
        return subprocess.run([sys.executable, TESTS, "--quiet", *options], env={**os.environ, "JUDGE": folder},
                              cwd=folder, timeout=SECONDS, stdin=subprocess.DEVNULL, capture_output=True, text=True)


def is_noticed(fault):
    try:
        return run_tests(*fault[:2], "--failfast").returncode != 0
    except subprocess.TimeoutExpired:
        return True


def check(faults):
    keys = {key for *_, key in faults}
    wrong = [f"no longer a fault: {key}" for key in EQUIVALENT if key not in keys]
    wrong += [] if len(faults) >= LEAST else [f"{len(faults)} faults, not {LEAST} or more"]
    print("\n".join(wrong) or f"{len(faults)} faults, of which {len(EQUIVALENT)} are known to change nothing")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200, help="so many faults")
    parser.add_argument("--seed", type=int, default=1, help="of the draw")
    parser.add_argument("--all", action="store_true", help="all faults")
    parser.add_argument("--jobs", type=int, default=2, help="so many at a time")
    parser.add_argument("--only", default="", help="faults with this in their description")
    parser.add_argument("--again", help="faults that are listed in a file, as a run prints them")
    parser.add_argument("--check", action="store_true", help="run nothing")
    options = parser.parse_args()
    faults = all_faults()
    if options.check:
        return check(faults)
    chosen = [fault for fault in faults if fault[-1] not in EQUIVALENT and options.only in fault[-1]]
    if options.again:
        listed = [line.partition(": ")[2] for line in Path(options.again).read_text(encoding="utf-8").split("\n")]
        chosen = [fault for fault in chosen if fault[-1] in listed]
    elif not options.all and len(chosen) > options.count:
        chosen = sorted(random.Random(options.seed).sample(chosen, options.count))
    for name in FILES:
        run = run_tests(name, None)
        if run.returncode != 0:
            print(f"the tests fail without a fault:\n{run.stderr[-2000:]}")
            return 2
    survivors = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (name, _, line, key), noticed in zip(chosen, pool.map(is_noticed, chosen)):
            if not noticed:
                survivors += 1
                print(f"{name}, line {line}: {key}", flush=True)
    share = 1 - survivors / max(1, len(chosen))
    print(f"{len(chosen)} faults of {len(faults)}, {len(chosen) - survivors} noticed ({100 * share:.1f} %)")
    return 0 if share >= LEAST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
