"""Damages of the table of mutants, each of which its check must notice; and how the runner counts."""
import contextlib
import io
import pathlib
import tempfile
import types
import unittest

import run
import table

TEXT = "if (a < b) return a;\nif (a < c) return a;\nreturn b;\n"
GOOD = {"id": "less-or-equal", "file": "src/geometry/least.cpp", "old": "a < b", "new": "a <= b",
        "wrong": "Of two equal numbers the other is returned."}


def faults(*entries, least=1, least_of_judging=0):
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "src/geometry").mkdir(parents=True)
        (root / GOOD["file"]).write_text(TEXT, encoding="utf-8")
        return table.faults_of(list(entries), root, least, least_of_judging)


def outcome_of(entries, killed):
    """What the runner says of mutants of which the named ones are known to be killed."""
    results = types.SimpleNamespace(known={name: {"killed": True} for name in killed})
    text = io.StringIO()
    with contextlib.redirect_stdout(text):
        well = run.report(entries, results)
    return well, text.getvalue()


class Table(unittest.TestCase):
    def test_what_applies_is_right(self):
        self.assertEqual(faults(GOOD), [])
        self.assertEqual(faults({**GOOD, "equivalent": "It is never asked of equal numbers."}), [])
        self.assertEqual(table.mutated(GOOD, TEXT), TEXT.replace("a < b", "a <= b"))

    def test_damages_are_noticed(self):
        damages = [{"old": "a < d"}, {"old": "return a;"}, {"new": "a < b"}, {"file": "src/geometry/most.cpp"},
                   {"file": "tests/least.cpp"}, {"id": "Less or equal"}, {"wrong": "something"}, {"reason": "None."},
                   {"equivalent": ""}, {"equivalent": "It is.", "accepted": "It is."}]
        for damage in damages:
            self.assertEqual(len(faults({**GOOD, **damage})), 1, damage)
        for field in table.FIELDS:
            self.assertEqual(len(faults({k: v for k, v in GOOD.items() if k != field})), 1, field)
        self.assertEqual(len(faults(GOOD, GOOD)), 1)
        self.assertEqual(len(faults(GOOD, least=2)), 1)
        self.assertEqual(len(faults(GOOD, least_of_judging=1)), 1)

    def test_folders(self):
        for name, folder in (("src/geometry/a.cpp", "geometry"), ("src/certify/claims/a.cpp", "certify"),
                             ("fuzz/judge/a.cpp", "judge"), ("oracle/a.cpp", "oracle"),
                             ("oracle/fast/a.cpp", "oracle")):
            self.assertEqual(table.folder_of({"file": name}), folder)


class Report(unittest.TestCase):
    def entries(self, count):
        return [{**GOOD, "id": f"m{k}"} for k in range(count)]

    def test_survivors_without_a_reason_fail(self):
        entries = self.entries(40)
        names = [entry["id"] for entry in entries]
        self.assertTrue(outcome_of(entries, names)[0])
        well, text = outcome_of(entries, names[1:])
        self.assertFalse(well)
        self.assertIn("m0: SURVIVED", text)
        self.assertIn("97.5 % of 40", text)

    def test_reasons(self):
        entries = self.entries(40)
        names = [entry["id"] for entry in entries]
        entries[0]["accepted"] = "Nobody minds."
        self.assertEqual(outcome_of(entries, names[1:])[0], True)
        self.assertIn("97.5 % of 40", outcome_of(entries, names[1:])[1])
        entries[0] = {**GOOD, "id": "m0", "equivalent": "There are no equal numbers."}
        self.assertIn("100.0 % of 39", outcome_of(entries, names[1:])[1])

    def test_too_many_reasons_fail(self):
        entries = self.entries(40)
        for entry in entries[:3]:
            entry["accepted"] = "Nobody minds."
        well, text = outcome_of(entries, [entry["id"] for entry in entries[3:]])
        self.assertFalse(well)
        self.assertIn("92.5 % of 40", text)


class Order(unittest.TestCase):
    def test_every_test_is_run_once_and_the_likely_ones_first(self):
        named = set().union(*run.LIKELY.values(), *run.BLIND.values(), *run.REACHED_BY.values())
        limits = {name: 5 for name in named} | {"slow_test": 9, "fast_test": 1}
        for name in ("src/geometry/predicates.cpp", "src/morse/stable_manifolds.cpp", "src/cli/main.cpp"):
            order = run.order_for({"file": name}, limits)
            blind = run.BLIND.get(name.split("/")[1], set())
            self.assertEqual(sorted(order), sorted(limits.keys() - blind))
            self.assertLess(order.index("fast_test"), order.index("slow_test"))
        self.assertEqual(run.order_for({"file": "src/geometry/rational.cpp"}, limits)[0], "rational_test")

    def test_what_judges_is_tried_on_the_tests_that_reach_it(self):
        reaching = run.REACHED_BY["oracle"]
        order = run.order_for({"file": "oracle/orbit.cpp"}, {name: 5 for name in reaching} | {"fast_test": 1})
        self.assertEqual(sorted(order), sorted(reaching))
        self.assertEqual(order[0], "oracle_orbit_test")
        for prefix, names in run.LIKELY.items():
            folder = table.folder_of({"file": prefix + "/"})
            self.assertEqual([name for name in names if name not in run.REACHED_BY.get(folder, names)], [], prefix)

    def test_none_is_lost_by_spreading(self):
        entries = list(range(146))
        self.assertEqual(sorted(run.spread(entries)), entries)


if __name__ == "__main__":
    unittest.main()
