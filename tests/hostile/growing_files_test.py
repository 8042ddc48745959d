"""Small files that ask for much: gzip and zlib data that grow, points whose Delaunay cells grow with their square.

Each is refused with one line that names --unlimited, within little memory, and taken with that option.

Usage: growing_files_test.py FLOWCERT
"""

import base64
import gzip
import os
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import zlib

FLOWCERT = os.path.abspath(sys.argv[1])
MEMORY = 600 << 20  # of addresses: programs, libraries, and little more
found = []


def run(words, folder, limit=MEMORY):
    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    return subprocess.run([FLOWCERT, *words], cwd=folder, capture_output=True, text=True, preexec_fn=limited)


def expect(is_so, what, finished):
    if not is_so:
        found.append(f"{what}: status {finished.returncode}, {finished.stderr[-300:]!r}")


def expect_refused(words, folder, part="--unlimited"):
    finished = run(words, folder)
    is_so = finished.returncode == 2 and finished.stderr.count("\n") == 1 and part in finished.stderr
    expect(is_so and not finished.stdout, " ".join(words), finished)


def expect_read(words, folder):
    """Another refusal, of what was read, is as good."""
    finished = run(words, folder)
    expect("--unlimited" not in finished.stderr and "out of memory" not in finished.stderr, " ".join(words), finished)
    expect(finished.returncode in (0, 1, 2), " ".join(words), finished)


def vtp(points):
    """A claim of VTK's: this many points, all zero, of index 0, in zlib data."""

    def array(kind, name, components, size):
        blocks = zlib.compress(bytes(size), 9)
        header = base64.b64encode(struct.pack("<4I", 1, size, 0, len(blocks))).decode()
        data = header + base64.b64encode(blocks).decode()
        head = f'type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary"'
        return f"<DataArray {head}>{data}</DataArray>"

    return (
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" compressor="vtkZLibDataCompressor"><PolyData>'
        f'<Piece NumberOfPoints="{points}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">'
        f'<PointData>{array("Int8", "CriticalType", 1, points)}</PointData>'
        f'<Points>{array("Float64", "Points", 3, 24 * points)}</Points></Piece></PolyData></VTKFile>'
    )


def skew_lines(n):
    rows = [(x + 0.05 * (x % 7), 0, 0) for x in range(n)] + [(n / 2, y - n / 2 + 0.05 * (y % 5), n / 2) for y in range(n)]
    return "".join("{} {} {}\n".format(*row) for row in rows)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "cube.xyz").write_text("0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        (folder / "points.gz").write_bytes(gzip.compress(b"0 0 0\n" * 300_000, 9))
        (folder / "claim.gz").write_bytes(gzip.compress(b"0,,,,,0\n" * 150_000, 9))
        (folder / "twice.gz").write_bytes(gzip.compress(b"0 0 0\n" * 100_000, 9) * 8)
        (folder / "pairs.gz").write_bytes(gzip.compress(b"0 0 inf\n" * 150_000, 9))
        (folder / "claim.vtp").write_text(vtp(60_000))
        (folder / "honest.gz").write_bytes(gzip.compress(b"0 0 0\n1 0 0\n0 1 0\n" * 3000, 9))
        (folder / "skew.xyz").write_text(skew_lines(1500))
        for words in (
            ["compute", "points.gz"],
            ["compute", "twice.gz"],
            ["locate", "points.gz", "--positions", "cube.xyz"],
            ["check", "cube.xyz", "claim.gz"],
            ["check", "points.gz", "claim.gz"],
            ["check", "cube.xyz", "pairs.gz"],
            ["check", "cube.xyz", "claim.vtp"],
        ):
            expect_refused(words, folder)
            expect_read([*words, "--unlimited"], folder)
        # A short file may grow to a megabyte.
        finished = run(["compute", "honest.gz"], folder)
        expect(finished.returncode == 0, "compute honest.gz", finished)
        for command in (["compute"], ["compute", "--manifolds", "all", "-o", "out.jsonl"], ["persistence"], ["stats"]):
            expect_refused([command[0], "skew.xyz", *command[1:]], folder)
        expect(not (folder / "out.jsonl").exists(), "an output", finished)
        finished = run(["compute", "skew.xyz", "--unlimited"], folder, 4 << 30)
        expect(finished.returncode == 0 and "grow with the square" in finished.stderr, "skew lines", finished)
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
