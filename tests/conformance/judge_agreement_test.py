#!/usr/bin/env python3
"""judge_agreement_test.py FLOWCERT SPEC ROUNDS

Both judges, spec/judge.py and `flowcert conformance --levels 4`, judge claims about every fourth vector, and about all
in a whole run: right ones, and so many rounds of mutated ones. They have to agree on every outcome and every finding,
and on the statement of the profile.
"""
import json
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from hashlib import sha256
from pathlib import Path

import mutated_claims
import thinned_vectors

FLOWCERT, SPEC, ROUNDS = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
KEYS = ("level", "reason", "permitted", "clause", "line", "contact")


def points_text(points):
    return "".join(" ".join(row) + "\n" for row in points) or "# no points\n"


def computed(points, folder, *options):
    source, target = folder / "points.xyz", folder / "claim.jsonl"
    source.write_text(points_text(points))
    subprocess.run([FLOWCERT, "compute", source, "-o", target, *options], check=True, capture_output=True)
    return target.read_text()


def claim_in_round(k, points, right, folder, rng):
    """Round 0 has the right claims."""
    if k == 0 or not points:
        return right
    shape = rng.random()
    if shape < 0.2 and all(abs(float.fromhex(x)) < 1e100 for row in points for x in row):
        moved = mutated_claims.perturbed_points([[float.fromhex(x) for x in row] for row in points], rng)
        text = computed([[x.hex() for x in row] for row in moved], folder, "--manifolds", "s2", "--centers", "none")
        if rng.random() < 0.5:
            text = computed([[x.hex() for x in row] for row in moved], folder, "--manifolds", "u2", "--centers", "none")
        head, records = mutated_claims.claim_of(text)
        for key in ("input_sha256", "merged_duplicates", "classes"):
            head.pop(key)
        if rng.random() < 0.7:
            head.pop("regular_stationary")
        return mutated_claims.text_of(head, records)
    if shape < 0.3:
        return mutated_claims.as_csv(right, rng)
    if shape < 0.45:
        return mutated_claims.as_bars(right, rng)
    return mutated_claims.mutated(right, len(points), rng)


def write_claims(cases, folder):
    """One file for each round and case, under the digest of the points. Returns how many there are."""
    work = folder / "work"
    work.mkdir()
    written = 0
    for case in cases:
        if case["result"] == "invalid":
            continue
        text = points_text(case["points"])
        right = computed(case["points"], work, "--manifolds", "all", "--volumes", "double")
        for k in range(ROUNDS + 1):
            target = folder / str(k) / sha256(text.encode()).hexdigest()
            target.parent.mkdir(exist_ok=True)
            target.write_text(claim_in_round(k, case["points"], right, work, random.Random(f"{case['id']} {k}")))
            written += 1
    return written


def findings_of(outcome):
    return sorted(([one[key] for key in KEYS] for one in outcome["findings"]), key=json.dumps)


def differences(case, ours, theirs):
    """What the two judges say differently of one case."""
    if ours["outcome"] != theirs["outcome"]:
        return [f"{ours['outcome']} {ours['message']!r}, but {theirs['outcome']} {theirs['message']!r}"]
    if theirs["findings_left_out"] or findings_of(ours) == findings_of(theirs):
        return []
    a, b = findings_of(ours), findings_of(theirs)
    only = [[one for one in a if one not in b], [one for one in b if one not in a]]
    return [f"only in judge.py: {only[0]}; only in conformance: {only[1]}"]


def run_both(command, vectors):
    both = []
    for program in ([sys.executable, SPEC / "judge.py"], [FLOWCERT, "conformance"]):
        words = [*program, "--vectors", vectors, "--levels", "4", "--hex", "--json", "--against", command]
        run = subprocess.run(words, capture_output=True)
        assert run.returncode in (0, 1), run.stderr.decode()
        both.append(json.loads(run.stdout))
    return both


def main():
    folder = Path(tempfile.mkdtemp(prefix="agreement-"))
    try:
        vectors = folder / "vectors"
        vectors.mkdir()
        thinned_vectors.write_thinned(SPEC / "vectors", vectors)
        cases = [case for path in sorted(vectors.glob("*.json")) if path.name != "flags.json"
                 for case in json.loads(path.read_text())["cases"]]
        written = write_claims(cases, folder)
        outcomes, reasons, wrong, own = Counter(), Counter(), 0, 0.0
        for k in range(ROUNDS + 1):
            command = f"cat {folder}/{k}/$(sha256sum < {{in}} | cut -c1-64)"
            ours, theirs = run_both(command, vectors)
            own += ours["own_seconds"]
            for one, other in zip(ours["cases"], theirs["cases"], strict=True):
                assert one["id"] == other["id"]
                outcomes[one["outcome"]] += 1
                reasons.update({(f["level"], f["reason"], f["permitted"]) for f in one["findings"]})
                for text in differences(one["id"], one, other):
                    wrong += 1
                    print(f"round {k}: {one['id']}: {text}"[:2000])
            if ours["statement"] != theirs["profile"]["statement"]:
                wrong += 1
                print(f"round {k}: {ours['statement']!r}, but {theirs['profile']['statement']!r}")
            for level in "1234":
                if sum(int(level) in one["judged"] for one in ours["cases"]) != theirs["judged"][level]:
                    wrong += 1
                    print(f"round {k}: other numbers of claims judged on level {level}")
        print(f"{written} claims, {wrong} differences, {own:.1f} s of judge.py's own time")
        print(dict(outcomes))
        for (level, reason, permitted), count in sorted(reasons.items()):
            print(f"  level {level}  {reason:24} {'permitted' if permitted else 'wrong':10} {count:5}")
        return 1 if wrong else 0
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(main())
