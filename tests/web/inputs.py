"""The inputs of which pages are tested: degenerate ones that fit on a line, the Stanford bunny, and molecules."""
import itertools
import math
import pathlib

BUNNY = "/usr/share/glmark2/models/bunny.obj"


def rows(points):
    return "".join(" ".join(map(str, point)) + "\n" for point in points)


def octahedra():
    """The corners of octahedra in a lattice of 2 by 2 by 2: ties and regular stationary points."""
    steps = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    centers = itertools.product((0, 2), repeat=3)
    return sorted({tuple(a + b for a, b in zip(c, step)) for c in centers for step in steps})


PYRAMID = "0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 3\n1.2 0.3 1.1\n"


def shifted(text, offset, spacing):
    return rows([offset + spacing * float(x) for x in line.split()] for line in text.splitlines())


# A hollow ball and a triangle near its wall: both orbits of the triangle's saddle end at the maximum within.
BALL_WITH_TRIANGLE = (
    "3 0 10; -3 3 9; 0 -6 8; 4 5 8; -7 -2 7; 7 -4 6; -2 8 5; -4 -8 5; 9 3 4; -9 4 3; 4 -9 2; 3 10 2; "
    "-9 -5 1; 10 -2 0; -6 8 0; -1 -10 -1; 7 7 -2; -9 1 -2; 7 -6 -3; -1 9 -4; -5 -7 -5; 8 1 -5; -6 4 -6; "
    "2 -7 -7; 3 6 -8; -5 -2 -8; 4 -2 -9; -1 2 -10; 8 0 1; 8 0 -1; 6 0 0"
)

FILES = pathlib.Path(__file__).resolve().parents[1] / "inputs"
BARREL = FILES / "barrel.pdb"
CAGE, CAGE_OPTIONS = FILES / "cage.xyz", ["--radii", "bondi", "--depth", "0.5", "--probe", "2"]


def pdb_line(number, name, element, position):
    residue = number // 8 + 1
    place = "".join(f"{x:8.3f}" for x in position)
    return f"ATOM  {number + 1:5d}  {name:<3s} SER B{residue:4d}    {place}  1.00  0.00          {element:>2s}\n"


def cup():
    """Atoms on a sphere, as near as bonds, with an opening toward +x: a pocket with one wide mouth."""
    count, radius, turn = 200, 6, math.pi * (3 - math.sqrt(5))
    kinds = [("N", "N"), ("CA", "C"), ("C", "C"), ("O", "O"), ("CB", "C"), ("SG", "S")]
    lines = []
    for k in range(count):
        z = 1 - (2 * k + 1) / count
        across = math.sqrt(1 - z * z)
        position = (across * math.cos(turn * k), across * math.sin(turn * k), z)
        if position[0] < 0.8:
            name, element = kinds[len(lines) % len(kinds)]
            lines.append(pdb_line(len(lines), name, element, [radius * x for x in position]))
    return "".join(lines)


TEXTS = {
    "cube": rows(itertools.product((0, 1), repeat=3)),
    "octahedra": rows(octahedra()),
    "square": "0 0 0\n2 0 0\n2 2 0\n0 2 0\n",
    "pyramid": PYRAMID,
    "far": shifted("0 0 0\n8 0 0\n8 8 0\n0 8 0\n4 4 12\n5 1 4\n3 7 5\n", 1e15, 0.125),
    "huge": shifted(PYRAMID, 0, 1e300),
    "half-octahedron": "1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n",
    "kind-2-3": "5 0 0\n-3 4 0\n-3 -4 0\n0 0 5\n",
    "repeated": "1 1 1\n0 0 0\n1 1 1\n4 0 0\n0 4 0\n0 0 4\n",
    "huge-cube": shifted(rows(itertools.product((0, 1), repeat=3)), 0, 1e307),
    "both-sides": BALL_WITH_TRIANGLE.replace("; ", "\n") + "\n",
    "line": "0 0 0\n1 0 0\n3 0 0\n",
    "tiny": "1e-300 0 0\n-1e-300 0 0\n0 1.5e-300 0\n0 1e-301 2e-300\n0 0 -7e-301\n",
    "one": "1 2 3\n",
    "none": "# no point\n",
}
# For the picture of a degenerate input: the eight corners of a cube, and points right above three of its sides.
PICTURE = TEXTS["cube"] + "0.5 0.5 1.5\n1.5 0.5 0.5\n0.5 -0.5 0.5\n"
SMALL = sorted(TEXTS)
ALL = [*SMALL, "bunny"]


def text(name):
    """The text of an input, or None for the bunny, which is a file."""
    return TEXTS.get(name)
