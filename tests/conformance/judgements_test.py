#!/usr/bin/env python3
"""judgements_test.py FLOWCERT SPEC

Both judges, `flowcert check` and judge.py, have to give the verdicts and findings of spec/judgements.json.
Every clause of claims.md about the levels 1 to 4 has three judgements at least.
"""
import json
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

FLOWCERT, SPEC = sys.argv[1], Path(sys.argv[2])
KEYS = ("level", "reason", "permitted", "clause")
CLAUSES = [f"FC-CLAIM-{k:02}" for k in (1, 2, 3, 4, 5, 6, 7, 9, 12, 19, 20, 21)]


def sorted_findings(findings):
    return sorted([one[key] for key in KEYS] for one in findings)


def by_check(points, claim, levels):
    run = subprocess.run([FLOWCERT, "check", points, claim, "--levels", str(levels), "--json"], capture_output=True)
    if run.returncode == 2:
        return "unreadable", []
    report = json.loads(run.stdout)
    return report["verdict"], sorted_findings(report["findings"])


def by_judge(case, claim, levels):
    order = [sys.executable, SPEC / "judge.py", "--case", case, "--claim", claim, "--levels", str(levels), "--json"]
    outcome = json.loads(subprocess.run(order, capture_output=True).stdout)["cases"][0]
    return outcome["outcome"], sorted_findings(outcome["findings"])


def main():
    cases = {case["id"]: case for path in (SPEC / "vectors").glob("*.json")
             for case in json.loads(path.read_text()).get("cases", [])}
    judgements = json.loads((SPEC / "judgements.json").read_text())["judgements"]
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="judgements-") as folder:
        points, claim = Path(folder, "points.xyz"), Path(folder, "claim")
        for one in judgements:
            points.write_text("".join(" ".join(row) + "\n" for row in cases[one["case"]]["points"]))
            claim.write_text("\n".join(one["claim"]) + "\n")
            levels = one.get("levels", 4)
            owed = one["verdict"], sorted_findings(one["findings"])
            for name, given in (("check", by_check(points, claim, levels)),
                                ("judge.py", by_judge(one["case"], claim, levels))):
                if given != owed:
                    wrong += 1
                    print(f"{one['id']}: {name} says {given}, not {owed}")
    counts = Counter(one["clause"] for one in judgements)
    for clause in CLAUSES:
        if counts[clause] < 3:
            wrong += 1
            print(f"{clause}: {counts[clause]} judgements, not 3 or more")
    if len({one["id"] for one in judgements}) < len(judgements):
        wrong += 1
        print("an id twice")
    print(f"{len(judgements)} judgements, {wrong} complaints")
    return 1 if wrong or not judgements else 0


if __name__ == "__main__":
    sys.exit(main())
