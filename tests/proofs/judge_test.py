#!/usr/bin/env python3
"""The proved judge of spec/proofs/ on right and on wrong records.

usage: judge_test.py BUILD ORACLE [--small] [--scan FLOWCERT POINTS]

All critical and regular points of all conformance vectors are proved. Of records that are changed a little, none is
proved that the oracle rejects, whether with the weights that are found for it or with those of the right record, and
each is proved that it accepts: 1,000 are rejected. Of a scan's list, 2,000 records are proved in under 60 seconds of
processor time. The judge is built in BUILD/proofs/, which needs Coq and OCaml. --small: a few of each, in seconds.
"""
import argparse
import copy
import json
import random
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

import check_claims
import weights
from proved_program import built
from read_claim import exchange_point, parse, read_claim

VECTORS = check_claims.ROOT / "spec" / "vectors"
KEYS = ("index", "kind", "contact", "center", "squared_distance")


def cases():
    """The distinct inputs of all vectors: rows in words, and the records that are right."""
    found = {}
    for path in sorted(VECTORS.glob("*.json")):
        for case in json.loads(path.read_text()).get("cases", []):
            if "stationary" in case.get("expected", {}):
                records = [{key: one[key] for key in KEYS} for one in case["expected"]["stationary"]]
                found.setdefault(json.dumps(case["points"]), (case["id"], case["points"], records))
    return list(found.values())


def rows_of(points):
    return [tuple(Fraction(float.fromhex(x)) for x in row) for row in points]


def claimed(record, line=0):
    return exchange_point(parse(json.dumps(record)), line)


# ---- Changes. Each takes a record, all records, the rows, and a generator of random numbers.


def contact_replaced(record, records, rows, rng):
    record["contact"][rng.randrange(len(record["contact"]))] = rng.randrange(len(rows))


def contact_larger(record, records, rows, rng):
    record["contact"] = sorted({*record["contact"], rng.randrange(len(rows))})


def contact_smaller(record, records, rows, rng):
    if len(record["contact"]) > 1:
        record["contact"].pop(rng.randrange(len(record["contact"])))


def contact_of_other(record, records, rows, rng):
    record["contact"] = list(rng.choice(records)["contact"])


def contact_repeated(record, records, rows, rng):
    """A row of a class instead of its name."""
    place = rng.randrange(len(record["contact"]))
    record["contact"][place] = rng.choice([k for k, row in enumerate(rows) if row == rows[record["contact"][place]]])


def other_sphere(record, records, rows, rng):
    """The smallest sphere of a few samples, with all that follows from it."""
    names = [one["contact"][0] for one in records if one["index"] == 0]
    contact = sorted(rng.sample(names, min(len(names), rng.choice([2, 3, 4]))))
    center = weights.center_of([rows[k] for k in contact])
    square = sum((x - y) ** 2 for x, y in zip(center, rows[contact[0]]))
    record.update(index=len(contact) - 1, kind="critical", contact=contact, center=list(map(str, center)),
                  squared_distance=str(square))


def kind_changed(record, records, rows, rng):
    record["index"] = rng.choice([0, 1, 2, 3, [1, 2], [1, 3], [2, 3]])
    record["kind"] = "regular" if isinstance(record["index"], list) else "critical"


def as_critical(record, records, rows, rng):
    """A regular point as a critical one, of the dimension of its face or of its hull."""
    if isinstance(record["index"], list):
        record["index"], record["kind"] = rng.choice(record["index"]), "critical"


def center_moved(record, records, rows, rng):
    axis, step = rng.randrange(3), Fraction(rng.choice([1, -1]), 2 ** rng.choice([1, 20, 52, 1100]))
    record["center"][axis] = str(Fraction(record["center"][axis]) + step)


def center_turned(record, records, rows, rng):
    record["center"] = record["center"][1:] + record["center"][:1]


def square_changed(record, records, rows, rng):
    step = Fraction(rng.choice([1, -1]), 2 ** rng.choice([1, 30, 52, 100]))
    record["squared_distance"] = str(abs(Fraction(record["squared_distance"]) * (1 + step) or step))


def place_of_other(record, records, rows, rng):
    other = rng.choice(records)
    for key in ("center", "squared_distance"):
        record[key] = copy.deepcopy(other[key])


CHANGES = [contact_replaced, contact_larger, contact_smaller, contact_of_other, contact_repeated, other_sphere,
           kind_changed, as_critical, center_moved, center_turned, square_changed, place_of_other]


def changed_records(records, rows, number, rng):
    """Pairs of a right record and a changed one."""
    pairs = []
    regular = [one for one in records if isinstance(one["index"], list)]
    for _ in range(number):
        right = rng.choice(regular if regular and rng.random() < 0.5 else records)
        wrong = copy.deepcopy(right)
        rng.choice(CHANGES)(wrong, records, rows, rng)
        if wrong != right:
            pairs.append((right, wrong))
    return pairs


# ---- The oracle


def rejected_by_oracle(oracle, points, records, folder):
    """For each record, whether the oracle rejects it."""
    source, target = folder / "points.xyz", folder / "records.jsonl"
    source.write_text("".join(" ".join(row) + "\n" for row in points))
    head = {"format": "flowcert-stationary-points", "format_version": 1, "points": len(points),
            "merged_duplicates": len(points) - len(set(rows_of(points))), "critical": [len(records), 0, 0, 0],
            "regular_stationary": {}}
    target.write_text("".join(json.dumps(one) + "\n" for one in [head, *records]))
    done = subprocess.run([oracle, "certify", source, target, "--sample", str(len(records))], capture_output=True,
                          text=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr)
    lines = {int(line) for line in re.findall(rf"^{re.escape(str(target))}:(\d+): ", done.stdout + done.stderr,
                                              flags=re.MULTILINE)}
    if bool(lines) != (done.returncode == 1):
        raise RuntimeError("the oracle names no line")
    return [k + 2 in lines for k in range(len(records))]


# ---- The parts of the test. Each returns what is wrong.


def vectors_proved(judge, all_cases):
    faults, counts = [], Counter()
    for name, points, records in all_cases:
        verdicts = check_claims.judged(judge, rows_of(points), [claimed(one) for one in records])
        for record, said in zip(records, verdicts):
            counts[record["kind"]] += 1
            if said != "proved":
                faults.append(f"{name}: {record}: {said}")
    print(f"{len(all_cases)} inputs: {counts['critical']:,} critical, {counts['regular']:,} regular points", flush=True)
    return faults


def changes_refused(judge, oracle, all_cases, number, rng):
    faults, counts = [], Counter()
    with tempfile.TemporaryDirectory() as folder:
        while counts[True] < number:
            name, points, records = rng.choice([case for case in all_cases if case[2]])
            rows = rows_of(points)
            pairs = changed_records(records, rows, 10, rng)
            if not pairs:
                continue
            wrong = [claimed(changed) for _, changed in pairs]
            rejected = rejected_by_oracle(oracle, points, [changed for _, changed in pairs], Path(folder))
            found = [check_claims.record_line(one, check_claims.found_for(one, rows)) for one in wrong]
            kept = [check_claims.record_line(one, check_claims.found_for(claimed(right), rows))
                    for (right, _), one in zip(pairs, wrong)]
            said = check_claims.verdicts(judge, rows, found + kept)
            for k, is_rejected in enumerate(rejected):
                counts[is_rejected] += 1
                counts[said[k]] += is_rejected
                if ("proved" in (said[k], said[k + len(pairs)])) == is_rejected:
                    faults.append(f"{name}: {pairs[k][1]}: rejected {is_rejected}, said {said[k]}")
    print(f"{counts[True]:,} changed records that the oracle rejects, {counts[False]:,} that it accepts", flush=True)
    print({said: count for said, count in counts.items() if isinstance(said, str)}, flush=True)
    return faults


def scan_proved(judge, program, scan, number):
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "list.jsonl"
        subprocess.run([program, "compute", scan, "-o", target], check=True, capture_output=True)
        start, wall = processor_seconds(), time.monotonic()
        rows = check_claims.rows_of(Path(scan).read_text())
        points = read_claim(check_claims.sampled(target.read_bytes(), number, 1), len(rows)).points
        said = Counter(check_claims.judged(judge, rows, points))
    seconds = processor_seconds() - start
    print(f"{len(points):,} records of {len(rows):,} points: {seconds:.1f} s of processor time, "
          f"{time.monotonic() - wall:.1f} s, {1000 * seconds / len(points):.2f} ms a record", flush=True)
    return [f"{scan}: {said}"] * (said != {"proved": len(points)}) + [f"{scan}: too slow"] * (seconds >= 60)


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("oracle")
    parser.add_argument("--small", action="store_true")
    parser.add_argument("--scan", nargs=2, metavar=("FLOWCERT", "POINTS"))
    options = parser.parse_args()
    judge, rng = built("judge", options.build), random.Random(7)
    all_cases = cases()
    faults = vectors_proved(judge, all_cases[::40] if options.small else all_cases)
    faults += changes_refused(judge, options.oracle, all_cases, 50 if options.small else 1000, rng)
    if options.scan:
        faults += scan_proved(judge, *options.scan, 50 if options.small else 2000)
    for fault in faults[:20]:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
