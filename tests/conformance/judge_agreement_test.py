#!/usr/bin/env python3
"""judge_agreement_test.py FLOWCERT SPEC ROUNDS

Both judges, spec/judge.py and `flowcert conformance --highest-level 4`, judge claims about every fourth vector, and
about all in a whole run: right ones, and so many rounds of mutated ones, of which every third has a greater tolerance. They have
to agree on every outcome and every finding, and on the statement of the profile.
So they have to on mutated orbits, which may go on beyond regular stationary points.
"""
import copy
import itertools
import json
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction
from hashlib import sha256
from pathlib import Path

import mutated_claims
import thinned_vectors

FLOWCERT, SPEC, ROUNDS = sys.argv[1], Path(sys.argv[2]), int(sys.argv[3])
KEYS = ("level", "reason", "permitted", "clause", "line", "contact")


def tolerance_of(k):
    return "1e-3" if k % 3 == 2 else "1e-9"


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
        return mutated_claims.respelled(mutated_claims.as_csv(right, rng), rng)
    if shape < 0.45:
        return mutated_claims.as_bars(right, rng)
    text = mutated_claims.mutated(right, len(points), rng)
    return mutated_claims.respelled(text, rng) if rng.random() < 0.3 else text


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
            claim = claim_in_round(k, case["points"], right, work, random.Random(f"{case['id']} {k}"))
            target.write_text(claim, encoding="utf-8", newline="")
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


def run_both(command, vectors, *options):
    both = []
    for program in ([sys.executable, SPEC / "judge.py"], [FLOWCERT, "conformance"]):
        words = [*program, "--vectors", vectors, "--highest-level", "4", "--hex", "--json", "--against", command,
                 *options]
        run = subprocess.run(words, capture_output=True)
        assert run.returncode in (0, 1), run.stderr.decode()
        both.append(json.loads(run.stdout))
    return both


# ---- Orbits


def as_json(segments, limit):
    """An orbit as spec/judge.py has it, as JSON."""
    def words(position):
        return None if position is None else [str(x) for x in position]

    keys = ("start_contact", "crossed_contact", "end_contact")
    told = [{"type": kind, "driver": words(driver), "end": words(end), **dict(zip(keys, contacts))}
            for kind, driver, end, *contacts in segments]
    if limit is None:
        return {"segments": told, "limit": {"kind": "infinity"}}
    kind, index, position, contact, squared = limit
    index = [int(one.text) for one in index] if isinstance(index, list) else int(index.text)
    return {"segments": told, "limit": {"kind": kind, "index": index, "position": words(position), "contact": contact,
                                        "squared_distance": str(squared)}}


def gone_on(judge, case, orbit, rng):
    """The orbit, which goes on where it ends at a regular stationary point, in a direction that may be possible."""
    segments, limit = judge.read_orbit(json.dumps(orbit).encode())
    flow = judge.Flow(judge.Truth(case))
    ways = [way for way in itertools.product((-2, -1, 0, 1, 2), repeat=3) if any(way)]
    while limit is not None and limit[0] == "regular" and rng.random() < 0.9:
        y = limit[2]
        firsts = [flow.segment(y, y, tuple(map(Fraction, way))) for way in rng.sample(ways, 12)]
        possible = [one for one in firsts if judge.in_hull(flow.truth.where(one[4]), y)]
        first = rng.choice(possible if possible and rng.random() < 0.9 else firsts)
        more, limit = flow.orbit(first[2]) if first[2] else ([], None)
        segments = [*segments, first, *more]
    return {**copy.deepcopy(orbit), **as_json(segments, limit)}


def write_orbits(cases, folder):
    """An answer for each orbit that is asked for, under the digest of the points and the start."""
    sys.path.insert(0, str(SPEC))
    import judge
    written = 0
    for case in [one for one in cases if one["result"] != "invalid"]:
        for orbit in case["expected"].get("orbits", []):
            start = ",".join(orbit["start"])
            rng = random.Random(f"{case['id']} {start}")
            claimed = gone_on(judge, case, orbit, rng)
            if rng.random() < 0.5:
                claimed = mutated_claims.damaged_orbit(claimed, rng)
            digest = sha256((points_text(case["points"]) + start + "\n").encode()).hexdigest()
            (folder / digest).write_text(json.dumps(claimed))
            written += 1
    return written


def orbit_differences(case, ours, theirs):
    ours = {one["start"]: one["outcome"] == "perturbed" for one in ours["orbits"] if one["outcome"] != "conforms"}
    theirs = {one["start"]: one["permitted"] for one in theirs["orbit_findings"]}
    return [f"orbits that differ, and whether that is permitted: {ours}, but {theirs}"] if ours != theirs else []


def compare_orbits(cases, folder, vectors):
    """How many orbits there are, and how many cases the judges differ about."""
    (folder / "orbits").mkdir()
    written = write_orbits(cases, folder / "orbits")
    digest = "$( (cat {in}; echo {start}) | sha256sum | cut -c1-64)"
    right = f"cat {folder}/0/$(sha256sum < {{in}} | cut -c1-64)"
    both = run_both(right, vectors, "--orbits-against", f"cat {folder}/orbits/{digest}")
    wrong, outcomes = 0, Counter(one["outcome"] for case in both[0]["cases"] for one in case["orbits"])
    for one, other in zip(both[0]["cases"], both[1]["cases"], strict=True):
        for text in differences(one["id"], one, other) + orbit_differences(one["id"], one, other):
            wrong += 1
            print(f"orbits: {one['id']}: {text}"[:2000])
    print(f"{written} orbits: {dict(outcomes)}")
    return wrong


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
            ours, theirs = run_both(command, vectors, "--tolerance", tolerance_of(k))
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
        wrong += compare_orbits(cases, folder, vectors)
        print(f"{written} claims, {wrong} differences, {own:.1f} s of judge.py's own time")
        print(dict(outcomes))
        for (level, reason, permitted), count in sorted(reasons.items()):
            print(f"  level {level}  {reason:24} {'permitted' if permitted else 'wrong':10} {count:5}")
        return 1 if wrong else 0
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    sys.exit(main())
