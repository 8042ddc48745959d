#!/usr/bin/env python3
"""judgements_test.py FLOWCERT SPEC
judgements_test.py --self-test

`flowcert` has to give the verdicts and findings of spec/judgements.json and of the examples in claims.md.
So has judge.py for those of the levels 1 to 4.
Every clause of claims.md has three judgements at least.
"""
import json
import re
import shlex
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction
from pathlib import Path

FLOWCERT, SPEC = (sys.argv[1], Path(sys.argv[2])) if len(sys.argv) > 2 else (None, None)
KEYS = ("level", "reason", "permitted", "clause")
VERDICTS = ("conforms", "conforms where determined", "perturbed", "fails", "unreadable")
# All is right on level 1 about this claim, whatever the points are.
NO_POINT = '{"format": "flowcert-stationary-points", "format_version": 1}\n'


class Malformed(Exception):
    """An example in claims.md that is none. The message says where and why."""


def require(condition, message):
    if not condition:
        raise Malformed(message)


def example_of(block, place):
    """A judgement of its own and its points, of the lines of a block in claims.md."""
    words = block[0].split()
    require(len(words) == 2 and re.fullmatch(r"FC-CLAIM-\d\d", words[1]), f"{place}: no clause in '{block[0]}'")
    one = {"id": f"{place} ({words[1]})", "clause": words[1], "findings": []}
    points, part = [], None
    for line in block[1:]:
        word, _, rest = line.partition(" ")
        if word in ("points", "claim") and not rest:
            require(word not in one, f"{place}: '{word}' is there twice")
            one[word] = part = []
        elif word == "verdict" and "claim" in one:
            require(rest in VERDICTS and word not in one, f"{place}: '{line}'")
            one[word] = rest
            part = None
        elif part is not None:
            part.append(line)
        elif word in ("title", "case") and "points" not in one:
            require(rest and word not in one, f"{place}: '{line}'")
            one[word] = rest
        elif word == "levels" and "points" not in one:
            require(re.fullmatch("[1-5]", rest) and word not in one, f"{place}: '{line}'")
            one[word] = int(rest)
        elif word == "finding" and "verdict" in one:
            match = re.fullmatch(r"([1-5]) ([a-z-]+) (FC-[A-Z]+-\d\d(?: \([a-z]\))?)( permitted)?", rest)
            require(match, f"{place}: '{line}'")
            level, reason, clause, permitted = match.groups()
            one["findings"].append(dict(zip(KEYS, (int(level), reason, permitted is not None, clause))))
        else:
            raise Malformed(f"{place}: '{line}' is not known here")
    for word in ("title", "case", "points", "claim", "verdict"):
        require(one.get(word), f"{place}: no {word}")
    try:
        points = [[Fraction(word) for word in line.split()] for line in one["points"]]
    except (ValueError, ZeroDivisionError):
        raise Malformed(f"{place}: a point that is none") from None
    return one, points


def examples(text):
    """The lines of the blocks of a text, each with the number of its first one."""
    block = None
    for number, line in enumerate(text.splitlines(), 1):
        if block is not None:
            if line == "```":
                yield block, first
                block = None
            else:
                block.append(line)
        elif line.startswith("```judgement"):
            block, first = [line.removeprefix("```")], number
    require(block is None, "claims.md: the last example has no end")


def sorted_findings(findings):
    return sorted([one[key] for key in KEYS] for one in findings)


def by_check(points, claim, levels):
    order = [FLOWCERT, "check", points, claim, "--highest-level", str(levels), "--json"]
    run = subprocess.run(order, capture_output=True)
    if run.returncode == 2:
        return "unreadable", [], None
    report = json.loads(run.stdout)
    return report["verdict"], sorted_findings(report["findings"]), report["profile"]["statement"]


def by_conformance(case, pairs, no_point, vectors):
    copies = [f"test -f {{in}} && cp {shlex.quote(str(path))} {{out}}" for path in (no_point, pairs)]
    order = [FLOWCERT, "conformance", "--vectors", vectors, "--case", case, "--highest-level", "1", "--json"]
    run = subprocess.run([*order, "--against", copies[0], "--persistence-against", copies[1]], capture_output=True)
    outcome = json.loads(run.stdout)["cases"][0]
    return outcome["outcome"], sorted([one["reason"]] for one in outcome["persistence_findings"])


def by_judge(case, claim, levels, vectors):
    order = [sys.executable, SPEC / "judge.py", "--vectors", vectors, "--highest-level", str(levels), "--json"]
    run = subprocess.run([*order, "--case", case, "--claim", claim], capture_output=True)
    report = json.loads(run.stdout)
    outcome, statement = report["cases"][0], report["statement"]
    # Behind the statement stands the number of vectors.
    return outcome["outcome"], sorted_findings(outcome["findings"]), statement and statement.split(" (")[0]


def write_vectors(groups, ids, folder):
    """The vectors with these cases alone: they are read anew for each judgement."""
    folder.mkdir()
    for name, group in groups.items():
        cases = [case for case in group.get("cases", []) if case["id"] in ids]
        if cases or name == "flags.json":
            (folder / name).write_text(json.dumps({**group, "cases": cases} if cases else group))


def answers(one, case, folder):
    """Who was asked, what was said, and what is owed."""
    points, claim, no_point = folder / "points.xyz", folder / "claim", folder / "no_point"
    points.write_text("".join(" ".join(row) + "\n" for row in case["points"]))
    claim.write_text("\n".join(one["claim"]) + "\n")
    if one.get("answers") == "persistence":
        no_point.write_text(NO_POINT)
        owed = one["verdict"], sorted([finding["reason"]] for finding in one["findings"])
        yield "conformance", by_conformance(one["case"], claim, no_point, folder / "vectors"), owed
        return
    levels, parts = one.get("levels", 4), 3 if "statement" in one else 2
    owed = (one["verdict"], sorted_findings(one["findings"]), one.get("statement"))[:parts]
    yield "check", by_check(points, claim, levels)[:parts], owed
    if levels <= 4:
        yield "judge.py", by_judge(one["case"], claim, levels, folder / "vectors")[:parts], owed


def ball_cases():
    return json.loads((SPEC / "vectors" / "balls" / "pores.json").read_text())["cases"]


def wrong_of_pores(case, folder):
    balls, claim = folder / "balls.xyz", folder / "diameters"
    balls.write_text("".join(" ".join(row) + "\n" for row in case["balls"]))
    for one in case["expected"]["claims"]:
        claim.write_text("\n".join(one["claim"]) + "\n")
        order = [FLOWCERT, "check", balls, claim, "--radii", "column:4", "--claim-format", "pores", "--json"]
        report = json.loads(subprocess.run(order, capture_output=True).stdout)
        given = sorted({finding["reason"] for finding in report["findings"]})
        if given != one["reasons"] or (report["verdict"] == "conforms") != (not given):
            yield f"{case['id']}: check says {report['verdict']}, {given} of {one['claim']}"


def main():
    groups = {path.name: json.loads(path.read_text()) for path in (SPEC / "vectors").glob("*.json")}
    cases = {case["id"]: case for group in groups.values() for case in group.get("cases", [])}
    judgements = json.loads((SPEC / "judgements.json").read_text())["judgements"]
    text = (SPEC / "claims.md").read_text()
    clauses = re.findall(r"^\*\*(FC-CLAIM-\d\d)\*\* ", text, re.MULTILINE)
    counts = Counter(one["clause"] for one in judgements)
    # Vectors with claims of cycles or pores are judgements, too.
    with_cycles = [case for case in cases.values() if "cycles" in case.get("expected", {})]
    with_pores = [case for case in ball_cases() if "claims" in case.get("expected", {})]
    counts.update(clause for case in with_cycles + with_pores for clause in case["clauses"])
    complaints = [f"{clause}: {counts[clause]} judgements, not 3 or more" for clause in clauses if counts[clause] < 3]
    complaints += [f"{one['id']}: no clause {one['clause']}" for one in judgements if one["clause"] not in clauses]
    complaints += [f"{name} is there twice" for name, n in Counter(one["id"] for one in judgements).items() if n > 1]
    if not clauses:
        complaints.append("claims.md has no clause")
    shown = []
    try:
        for block, number in examples(text):
            one, points = example_of(block, f"claims.md:{number}")
            require(one["clause"] in clauses, f"{one['id']}: no such clause")
            require(one["case"] in cases, f"{one['id']}: no case {one['case']}")
            owed = [[Fraction(float.fromhex(word)) for word in row] for row in cases[one["case"]]["points"]]
            require(points == owed, f"{one['id']}: other points than those of {one['case']}")
            shown.append(one)
    except Malformed as error:
        complaints.append(str(error))
    with tempfile.TemporaryDirectory(prefix="judgements-") as folder:
        write_vectors(groups, {one["case"] for one in judgements + shown}, Path(folder, "vectors"))
        for one in judgements + shown:
            for name, given, owed in answers(one, cases[one["case"]], Path(folder)):
                if given != owed:
                    complaints.append(f"{one['id']}: {name} says {given}, not {owed}")
        complaints += [wrong for case in with_pores for wrong in wrong_of_pores(case, Path(folder))]
    for complaint in complaints:
        print(complaint)
    print(f"{len(judgements)} judgements, {len(shown)} examples, {len(complaints)} complaints")
    return 1 if complaints else 0


EXAMPLE = """```judgement FC-CLAIM-02
title Three corners of a square
case cospherical-clusters-0001
levels 3
points
0 0 0
0 1/2 1e0
claim
{"index": 2, "contact": [0, 1, 2]}
verdict conforms where determined
finding 2 spanning-part FC-CLAIM-02 permitted
finding 2 contact-incomplete FC-CRIT-05 (c)
```
"""
DAMAGES = (
    ("judgement FC-CLAIM-02", "judgement"), ("FC-CLAIM-02\n", "CLAIM-02\n"), ("FC-CLAIM-02\n", "FC-CRIT-02\n"),
    ("title ", "tilte "), ("title Three corners of a square\n", ""), ("title Three corners of a square", "title"),
    ("levels 3", "levels 6"), ("levels 3", "levels 3\nlevels 3"), ("points\n", "points\npoints\n"),
    ("case cospherical-clusters-0001\n", ""), ("points\n0 0 0\n0 1/2 1e0\n", ""), ("1/2", "half"), ("1/2", "1/0"),
    ("claim\n", ""), ('{"index": 2, "contact": [0, 1, 2]}\n', ""), ("verdict conforms where", "verdict is"),
    ("verdict conforms where determined\n", ""), ("finding 2 s", "finding s"), ("finding 2 s", "finding 6 s"),
    ("permitted", "allowed"), ("(c)\n", "(c) \n"), ("(c)\n", "(c)\nmore\n"), ("(c)\n```", "(c)"))


def self_test():
    [(block, number)] = examples("text\n" + EXAMPLE + "text\n")
    one, points = example_of(block, "here")
    assert number == 2 and points == [[0, 0, 0], [0, Fraction(1, 2), 1]]
    assert (one["case"], one["levels"], one["verdict"]) == ("cospherical-clusters-0001", 3, VERDICTS[1])
    assert one["claim"] == ['{"index": 2, "contact": [0, 1, 2]}']
    assert [list(finding.values()) for finding in one["findings"]] == [
        [2, "spanning-part", True, "FC-CLAIM-02"], [2, "contact-incomplete", False, "FC-CRIT-05 (c)"]]
    for old, new in DAMAGES:
        assert old in EXAMPLE, old
        try:
            for block, _ in examples(EXAMPLE.replace(old, new, 1)):
                example_of(block, "here")
        except Malformed:
            continue
        raise AssertionError(f"'{new}' instead of '{old}' is not noticed")
    print(f"reads an example, and notices {len(DAMAGES)} damages")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
