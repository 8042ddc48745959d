"""Time and memory of whole programs against the number of points, drawn of the table in tests/bench/README.md.

Guarantees: every row of that table with a number of points and a time is a mark, and nothing else is; a program that
ran out of memory has none. The SVG is the same to the byte for the same table and the same matplotlib.
"""
import collections
import re

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "flowcert", "svg.fonttype": "none", "font.size": 9})
from matplotlib import pyplot  # noqa: E402

HEAD = "| input | program | seconds | times ours | peak memory [MB] | pairs |"
ROW = re.compile(r"\| ([\d,]+) uniform \| ([^|]+) \| ([\d.]+) \| [\d.]+ \| ([\d,]+) \|")


def rows_of(text):
    """{program: [(points, seconds, megabytes)]}, of the first table with that head."""
    found = collections.defaultdict(list)
    for line in text[text.index(HEAD):].split("\n\n", 1)[0].splitlines():
        if row := ROW.match(line):
            points, program, seconds, memory = (part.replace(",", "") for part in row.groups())
            found[program].append((int(points), float(seconds), int(memory)))
    if "flowcert" not in found:
        raise ValueError("tests/bench/README.md has no table of whole programs")
    return dict(found)


def draw(text, path):
    figure, axes = pyplot.subplots(1, 2, figsize=(8, 3.8), layout="constrained")
    for axis, column, name in ((axes[0], 1, "seconds"), (axes[1], 2, "peak memory [MB]")):
        for program, rows in rows_of(text).items():
            is_ours = program == "flowcert"
            axis.plot([row[0] for row in rows], [row[column] for row in rows], label=program, marker="o",
                      markersize=4, linewidth=2.5 if is_ours else 1, linestyle="--" if "3d" in program else "-",
                      color="black" if is_ours else None)
        axis.set(xscale="log", yscale="log", xlabel="uniform points", title=name)
        axis.grid(alpha=0.3)
    axes[0].legend(frameon=False, fontsize=8)
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
