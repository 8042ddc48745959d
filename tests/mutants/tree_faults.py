"""Small faults of Python programs, made from their syntax trees by the rules below, and what runs and judges them.

A fault is the name of its file, its number there, its line, and a key that says what it is. judge_py.py and proof.py
say which programs, which tests, and which faults change nothing.
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

LEAST, LEAST_SHARE, SECONDS = 100, 0.95, 180

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
        self.wanted, self.found, self.names, self.parents = wanted, [], [], []

    def visit(self, node):
        if isinstance(node, ast.JoinedStr):  # words of messages
            return node
        is_named = isinstance(node, (ast.FunctionDef, ast.ClassDef))
        self.names += [node.name] if is_named else []
        changed = None
        for other in [*other_expressions(node), *other_statements(node)]:
            if len(self.found) == self.wanted:
                changed = ast.copy_location(other, node)
            whole = [node, ast.fix_missing_locations(other), *self.parents[-1:]]
            old, new, parent = (ast.unparse(one).split("\n")[0] for one in whole)
            place = f" in {parent}" if isinstance(node, ast.Constant) else ""
            self.found.append((node.lineno, f"{'.'.join(self.names)}: {old} -> {new}{place}"))
        self.parents.append(node)
        result = self.generic_visit(node) if changed is None else changed
        self.parents.pop()
        if is_named:
            self.names.pop()
        return result


class TreeFaults:
    """The faults of some files of a folder, and the tests of these, which look for the folder in a variable."""

    def __init__(self, folder, files, tests, variable, equivalent):
        self.folder, self.files, self.tests, self.variable, self.equivalent = folder, files, tests, variable, equivalent

    def tree(self, name):
        return ast.parse((self.folder / name).read_text(encoding="utf-8"))

    def all(self):
        """The file, the number of the fault in it, its line, and what it is."""
        found = []
        for name in self.files:
            planter = Planter()
            planter.visit(self.tree(name))
            found += [(name, k, *fault) for k, fault in enumerate(planter.found)]
        return found

    def wrong(self):
        """What is wrong with what is said of the faults, one line each."""
        keys = {key for *_, key in self.all()}
        wrong = [f"no longer a fault: {key}" for key in self.equivalent if key not in keys]
        return wrong + ([] if len(keys) >= LEAST else [f"{len(keys)} faults, not {LEAST} or more"])

    def run_tests(self, name, number, *options):
        """The tests of all files with a fault, or, without a number, as they are but without their comments."""
        with tempfile.TemporaryDirectory(prefix="mutant-") as folder:
            for other in {"schemas", "vectors", *self.files}:
                Path(folder, other).symlink_to(self.folder / other)
            tree = Planter(number).visit(self.tree(name))
            Path(folder, name).unlink()
            Path(folder, name).write_text(ast.unparse(ast.fix_missing_locations(copy.deepcopy(tree))), encoding="utf-8")
            return subprocess.run([sys.executable, self.tests, "--quiet", *options], cwd=folder, timeout=SECONDS,
                                  env={**os.environ, self.variable: folder}, stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True)

    def is_noticed(self, fault):
        try:
            return self.run_tests(*fault[:2], "--failfast").returncode != 0
        except subprocess.TimeoutExpired:
            return True


def main(doc, suite, least_share=LEAST_SHARE):
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=200, help="so many faults")
    parser.add_argument("--seed", type=int, default=1, help="of the draw")
    parser.add_argument("--all", action="store_true", help="all faults")
    parser.add_argument("--jobs", type=int, default=2, help="so many at a time")
    parser.add_argument("--only", default="", help="faults with this in their file's name or description")
    parser.add_argument("--again", help="faults that are listed in a file, as a run prints them")
    parser.add_argument("--check", action="store_true", help="run nothing")
    options = parser.parse_args()
    faults = suite.all()
    if options.check:
        wrong = suite.wrong()
        print("\n".join(wrong) or f"{len(faults)} faults, of which {len(suite.equivalent)} are known to change nothing")
        return 1 if wrong else 0
    chosen = [fault for fault in faults
              if fault[-1] not in suite.equivalent and options.only in f"{fault[0]} {fault[-1]}"]
    if options.again:
        listed = [line.partition(": ")[2] for line in Path(options.again).read_text(encoding="utf-8").split("\n")]
        chosen = [fault for fault in chosen if fault[-1] in listed]
    elif not options.all and len(chosen) > options.count:
        chosen = sorted(random.Random(options.seed).sample(chosen, options.count))
    for name in {fault[0] for fault in chosen}:
        run = suite.run_tests(name, None)
        if run.returncode != 0:
            print(f"the tests fail without a fault:\n{run.stderr[-2000:]}")
            return 2
    survivors = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (name, _, line, key), noticed in zip(chosen, pool.map(suite.is_noticed, chosen)):
            if not noticed:
                survivors += 1
                print(f"{name}, line {line}: {key}", flush=True)
    share = 1 - survivors / max(1, len(chosen))
    print(f"{len(chosen)} faults of {len(faults)}, {len(chosen) - survivors} noticed ({100 * share:.1f} %)")
    return 0 if share >= least_share else 1
