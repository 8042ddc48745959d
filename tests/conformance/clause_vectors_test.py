#!/usr/bin/env python3
"""clause_vectors_test.py [SPEC]        every clause has three vectors or judgements, or a reason why not
clause_vectors_test.py --self-test     asks of wrong tables, and sees them complained about

The reasons are the table "Clauses without vectors" of formats/vectors.md. A clause that has three needs none. Each flag
has three vectors, too. The numbers of vectors of points, and of their distinct inputs, in that page are right.
"""
import json
import re
import sys
from collections import Counter
from pathlib import Path

ENOUGH = 3
CLAUSE = re.compile(r"^\*\*(FC-[A-Z]+-\d\d)\*\* \(", re.MULTILINE)
RANGE = re.compile(r"(FC-[A-Z]+)-(\d\d)(?: to (\d\d))?")


def excepted(page):
    """The clauses that the table names, each as often as it does, and rows that give no reason."""
    table = page.split("## Clauses without vectors")[1]
    rows = [line.split("|")[1:-1] for line in table.split("\n") if line.startswith("| FC-")]
    names = [f"{word}-{k:02}" for row in rows for word, first, last in RANGE.findall(row[0])
             for k in range(int(first), int(last or first) + 1)]
    return names, [row[0].strip() for row in rows if len(row) != 2 or len(row[1].split()) < 3]


def complaints_about(clauses, counts, flags, page):
    names, without_reason = excepted(page)
    found = [f"{row}: no reason" for row in without_reason]
    found += [f"{name}: named {n} times in the table" for name, n in Counter(names).items() if n > 1]
    found += [f"{name}: no clause, but in the table" for name in names if name not in clauses]
    for clause in clauses:
        if counts[clause] < ENOUGH and clause not in names:
            found.append(f"{clause}: {counts[clause]} vectors and judgements, and no reason")
        if counts[clause] >= ENOUGH and clause in names:
            found.append(f"{clause}: {counts[clause]} vectors and judgements, and still a reason")
    return found + [f"flag {flag}: {n} vectors" for flag, n in flags.items() if n < ENOUGH]


def sentences_on_inputs(cases):
    """How many distinct inputs there are, as the page says it."""
    lists = [(json.dumps(case["points"]), case["result"] != "invalid") for case in cases if "points" in case]
    texts = {case["text"] for case in cases if "points" not in case}
    of_all, of_valid = len({rows for rows, _ in lists}), len({rows for rows, is_valid in lists if is_valid})
    valid = sum(case["result"] != "invalid" for case in cases)
    return [f"The {len(cases):,} vectors of points have {of_all + len(texts):,} distinct inputs: {of_all:,} lists of "
            f"points, and {len(texts)} texts of files.",
            f"The {valid:,} vectors that are not invalid have {of_valid:,} of these lists."]


def check(spec):
    pages = sorted(spec.glob("*.md")) + sorted(spec.glob("formats/*.md"))
    clauses = [name for page in pages for name in CLAUSE.findall(page.read_text())]
    files = [json.loads(path.read_text()) for path in sorted(spec.glob("vectors/*.json"))]
    cases = [case for file in files for case in file.get("cases", [])]
    files += [json.loads(path.read_text()) for path in sorted(spec.glob("vectors/balls/*.json"))]
    all_cases = [case for file in files for case in file.get("cases", [])]
    counts = Counter(name for case in all_cases for name in case["clauses"])
    counts.update(one["clause"] for one in json.loads((spec / "judgements.json").read_text())["judgements"])
    used = Counter(name for case in all_cases for name in case["flags"])
    flags = {one["flag"]: used[one["flag"]] for file in files for one in file.get("flags", [])}
    page = (spec / "formats/vectors.md").read_text()
    found = complaints_about(clauses, counts, flags, page)
    found += [f"{name}: named by vectors or judgements, but no clause" for name in counts if name not in clauses]
    found += [f"formats/vectors.md does not say: {one}" for one in sentences_on_inputs(cases) if one not in page]
    print("\n".join(found))
    few = sum(counts[name] < ENOUGH for name in clauses)
    print(f"{len(clauses)} clauses, {few} of them with a reason; {len(all_cases)} vectors, {len(flags)} flags")
    return 1 if found or len(cases) in (0, len(all_cases)) or not flags else 0


def self_test():
    page = "## Clauses without vectors\n\n| clauses | why |\n|---|---|\n| FC-IN-01 to 02, FC-VOL-01 | It is so. |\n"
    clauses, counts, flags = ["FC-IN-01", "FC-IN-02", "FC-VOL-01", "FC-VOL-02"], Counter({"FC-VOL-02": 3}), {"flag": 3}
    failures = [] if not complaints_about(clauses, counts, flags, page) else ["the table is right"]
    wrong = {
        "a clause with too few": (counts - Counter({"FC-VOL-02": 1}), flags, page),
        "a reason that nobody needs": (counts + Counter({"FC-IN-02": 3}), flags, page),
        "a flag with too few": (counts, {"flag": 2}, page),
        "no reason": (counts, flags, page.replace("It is so.", "")),
        "a clause that there is not": (counts, flags, page.replace("to 02", "to 03")),
        "a clause twice": (counts, flags, page.replace("FC-VOL-01", "FC-VOL-01, FC-IN-01")),
    }
    points = [["0", "0", "0"], ["1", "0", "0"]]
    cases = [{"points": points, "result": "determined"}, {"points": points[::-1], "result": "invalid"},
             {"points": points, "result": "acceptable"}, {"text": "1", "result": "invalid"}]
    if sentences_on_inputs(cases) != ["The 4 vectors of points have 3 distinct inputs: 2 lists of points, and 1 texts of "
                                      "files.",
                                      "The 2 vectors that are not invalid have 1 of these lists."]:
        failures.append("the inputs are counted otherwise")
    failures += [f"not noticed: {what}" for what, (n, of, table) in wrong.items()
                 if not complaints_about(clauses, n, of, table)]
    print("\n".join(failures) or "all noticed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else
             check(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2] / "spec")))
