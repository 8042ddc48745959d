#!/usr/bin/env python3
"""slow_start.py

A program that takes 0.2 s to start, and then answers case after case, as between `generate` and `verify`, exactly.
`fuzz --through` starts it once; fuzz/README.md says how many cases that makes in a minute.
"""
import sys
import time

from stationary_points_from_spec import read_points, stationary_points


def claim_lines(rows):
    """A line for each critical point: its index, no numbers, and its contact set."""
    unit = max(x.denominator for row in rows for x in row)  # a power of 2, so that all becomes whole
    names = {}
    for row, p in enumerate(rows):
        names.setdefault(tuple(int(x * unit) for x in p), row)
    ids = list(names.values())
    for (face, hull), contact, _, _ in stationary_points(list(names)):
        if face == hull:
            yield f"{hull},,,,," + ",".join(str(ids[k]) for k in contact)


def main():
    time.sleep(0.2)
    for line in sys.stdin:
        words = line.split()
        if words[:1] != ["case"]:
            continue
        rows = "".join(sys.stdin.readline() for _ in range(int(words[2])))
        print("\n".join([f"answer {words[1]}", *(claim_lines(read_points(rows)) if rows else []), "end"]), flush=True)


if __name__ == "__main__":
    main()
