"""TetGen's Delaunay triangulation (Debian's tetgen), by its command and its files, as any user has it.

KIND is cells: the tetrahedra, as lines of ids, for triangulations.py. The command is run without switches that allow
other points or choose a tolerance. What it says of points in a plane is a refusal.
"""

import os
import subprocess
import tempfile
from pathlib import Path

import answering

MOST_SECONDS = 2.5  # less than the fork that waits for it has


def answer_of(_, rows):
    with tempfile.TemporaryDirectory() as folder:
        points = Path(folder) / "points.node"
        points.write_text(f"{len(rows)} 3 0 0\n" + "".join(
            "{} {!r} {!r} {!r}\n".format(k, *row) for k, row in enumerate(rows)))
        # Quiet; no files of faces and of points; no second number in the name; points keep their numbers.
        ended = subprocess.run(["tetgen", "-QFNIJ", points], capture_output=True, text=True,
                               timeout=MOST_SECONDS, check=False)
        if ended.returncode < 0:
            os.kill(os.getpid(), -ended.returncode)
        cells = points.with_suffix(".ele")
        if ended.returncode != 0 or not cells.exists():
            raise RuntimeError((ended.stdout + ended.stderr).strip().split("\n")[-1] or "no cells")
        lines = [line.split() for line in cells.read_text().split("\n")[1:] if line and not line.startswith("#")]
        return "".join(" ".join(line[1:5]) + "\n" for line in lines)


if __name__ == "__main__":
    answering.main(["cells"], answer_of)
