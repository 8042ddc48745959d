"""Claims of megabytes that are made to be slow: reading and judging each takes little processor time.

What takes the square of their size would take minutes; the limit of processor time is there to end that.

Usage: large_claims_test.py FLOWCERT
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

FLOWCERT = os.path.abspath(sys.argv[1])
SECONDS = 40 if float(os.environ.get("FLOWCERT_PROPERTY_SCALE", "1")) > 1 else 25
RECORDS = 300_000
HEADER = {"format": "flowcert-stationary-points", "format_version": 1}


def lines(record, count=RECORDS):
    return [json.dumps(record(k)) for k in range(count)]


def one(**fields):
    return [json.dumps(fields)]


def claims():
    many = range(RECORDS // 4)
    triangle = {"index": 2, "contact": [0, 1, 2]}
    yield "one key each", lines(lambda k: {"index": 0, "contact": [0], f"k{k}": 1})
    yield "long keys", lines(lambda k: {"index": 0, "contact": [0], "k" * 300_000 + str(k): 1}, 20)
    yield "one point again and again", lines(lambda k: {"index": 1, "contact": [0, 1]})
    yield "one place again and again", lines(lambda k: {"index": 1, "center": [0.5, 0, 0], "squared_distance": 0.25})
    yield "near places", lines(lambda k: {"index": 1, "center": [0.5 + 1e-12 * k, 0.1, 0]}, RECORDS // 2)
    yield "a long contact set", one(index=1, contact=[0] * RECORDS)
    yield "a long number", one(index=1, contact=[0, 1], center=["7" * 1_000_000, "0", "0"], squared_distance="1/4")
    yield "a long list", one(**triangle, **{"lambda": {"directions": [{"limit": [0, 1, 2]}] * RECORDS, "arcs": []}})
    yield "a long walk", one(**triangle, stable={"boundary": [[0, 1] for _ in many], "segments": RECORDS})
    yield "many connections", one(**triangle, connections=[{"to": [0, 1], "orbits": k, "families": 1} for k in many])
    yield "many shares", one(index=3, contact=[0, 1, 2, 3], shares=[{"sample": 0, "volume": "1/9"} for _ in many])
    yield "empty records", ["{}"] * RECORDS
    yield "open arrays", ['{"index":' + "[" * 1_000_000]
    yield "long pairs", None


def judged(text, folder):
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))

    (folder / "claim").write_text(text)
    words = [FLOWCERT, "check", "points.xyz", "claim"]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, preexec_fn=limited)


def main():
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "points.xyz").write_text("0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        for what, records in claims():
            text = "1 0.5 0.7\n" * RECORDS + "0 0 inf\n" if records is None else "\n".join(
                [json.dumps(HEADER), *records, ""])
            finished = judged(text, folder)
            lines_of_error = finished.stderr.count("\n")
            if finished.returncode not in (1, 2) or lines_of_error != (finished.returncode == 2):
                found.append(f"{what}: status {finished.returncode}, {finished.stderr[-200:]!r}")
            if max(map(len, finished.stdout.splitlines()), default=0) > 10_000:
                found.append(f"{what}: a line of more than 10,000 characters is printed")
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
