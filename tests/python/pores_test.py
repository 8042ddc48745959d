"""Pores: known values, what the program says of the same balls, exact numbers, and what is refused."""

import json
import pathlib
import pickle
from decimal import Decimal, localcontext
from fractions import Fraction

import flowcert
import hypothesis
import numpy as np
import pytest
from conftest import flowcert_says
from hypothesis import strategies

CAGE = pathlib.Path(__file__).parents[1] / "inputs" / "cage.xyz"
HYDROGENS = "ignore:.*hydrogens:UserWarning"
OCTAHEDRON = 2 * np.concatenate([np.eye(3), -np.eye(3)])
FOUR = [[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]]
WINDOW = (125000, 425000, -1182713)  # of (s + 17/10)^2 = 1543963/125000


def rows_of_cage():
    return [line.split()[:4] for line in CAGE.read_text().splitlines()[2:]]


def contacts(pores, places):
    return [pores.contacts[slice(*pores.points["contact_offsets"][i])].tolist() for i in places]


def parts(pores):
    lists = [[some.tolist() for some in (c.peaks, c.gates, c.windows, c.handles)] for c in pores.chambers]
    return [
        lists, [(c.peak, c.gate, c.exit, c.depth) for c in pores.chambers], [vars(w) for w in pores.windows],
        [v.tolist() for v in pores.vestibules], pores.cavities.tolist(), pores.points.tobytes(), pores.hidden.tolist(),
    ]  # fmt: skip


@pytest.mark.filterwarnings(HYDROGENS)
def test_the_cage_of_a_file_and_of_its_text():
    centres, radii, atoms = flowcert.read_balls(CAGE, "bondi", return_atoms=True)
    assert centres.shape == (168, 3) and radii.shape == (168,) and len(atoms) == 168
    rows = rows_of_cage()
    assert atoms["element"].tolist() == [row[0] for row in rows]
    of_element = {"C": "1.70", "N": "1.55", "H": "1.20"}
    texts, sizes = [row[1:] for row in rows], [of_element[row[0]] for row in rows]
    assert centres.tolist() == [[Fraction(x) for x in row] for row in texts]
    made = flowcert.pores(centres, radii, depth="0.5")
    assert parts(made) == parts(flowcert.pores(texts, sizes, depth=0.5, threads=1))
    [chamber] = made.chambers
    assert len(contacts(made, chamber.peaks)[0]) == 12
    windows = [made.windows[k] for k in chamber.windows]
    assert len(windows) == 4 and all(window.value == windows[0].value for window in windows)
    assert {(window.value.polynomial, window.value.root, window.rooms) for window in windows} == {(WINDOW, 1, (0, -1))}
    assert all([rows[i][0] for i in made_contacts] == ["C"] * 3
               for made_contacts in contacts(made, [window.point for window in windows]))  # fmt: skip
    assert f"{chamber.diameter:.6f} {windows[0].diameter:.6f}" == "5.397020 3.628998"
    assert chamber.diameter == made.largest_cavity_diameter
    assert chamber.limiting_diameter == windows[0].diameter == made.pore_limiting_diameter
    assert [chamber.status(s) for s in ("1.8144", "1.8145", 3)] == ["open", "closed", "too small"]


@pytest.mark.filterwarnings(HYDROGENS)
def test_the_cage_in_doubles_has_no_equal_windows():
    centres, radii = flowcert.read_balls(CAGE, "bondi")
    made = flowcert.pores(flowcert.read_points(CAGE), radii.astype(float), depth=0.5)
    values = [window.value for window in made.windows]
    assert len(set(values)) > 1 and values == sorted(values, reverse=True)
    exact = flowcert.pores(centres, radii, depth=0.5).windows[0].value
    assert all(abs(value.double - exact.double) < 1e-15 for value in values)
    assert float(values[0]) - float(values[-1]) == 2.0**-51


def test_an_octahedron():
    made = flowcert.pores(OCTAHEDRON, Fraction(1, 2))
    [chamber] = made.chambers
    assert (chamber.peak.polynomial, chamber.peak.root, chamber.peak) == ((2, -3), 0, Fraction(3, 2))
    assert chamber.gate == chamber.exit and chamber.gate.polynomial == (12, 12, -29)  # 2 sqrt(2/3) - 1/2
    assert chamber.depth == pytest.approx(2 - 2 * (2 / 3) ** 0.5)
    assert contacts(made, chamber.peaks) == [[0, 1, 2, 3, 4, 5]]
    position, value = made.exact(0)
    assert position == (0, 0, 0) and value == chamber.peak == 1.5
    assert made.points["index"].tolist() == [3] + [2] * 8 + [1] * 12
    assert made.points["rank"].tolist() == [0] + [1] * 8 + [2] * 12
    assert made.points["value"][[0, 1, 9]].tolist() == [1.5, float(chamber.gate), float(made.exact(9)[1])]
    assert made.exact(9)[1].polynomial == (4, 4, -7)  # sqrt(2) - 1/2
    assert made.points["center"][9:].round(12).tolist().count([1, 1, 0]) == 1
    assert made.cavities.tolist() == [[1, 0]] and made.vestibules == [] and len(chamber.windows) == 8
    assert [(step.polynomial, count) for step, count in made.cavity_steps()] == [((2, -3), 1), ((12, 12, -29), 0)]
    assert [made.cavities_at(s) for s in (0, "1.1329", "1.133", 1.5, 2)] == [0, 0, 1, 1, 0]
    assert repr(made) == "<flowcert.Pores of 6 balls: 1 chambers>"
    assert parts(pickle.loads(pickle.dumps(made))) == parts(made)
    nested = flowcert.pores(np.concatenate([OCTAHEDRON, [[2, 0, 0], [2, 0, 0.1]]]), [0.5] * 7 + ["0.1"])
    assert nested.hidden.tolist() == [6, 7]


@pytest.mark.parametrize(
    "radii",
    [1, 1.0, "1", "2/2", Decimal(1), Fraction(1), np.float32(1), [1, "1", 1.0, Fraction(1)], np.ones(4, dtype=int),
     np.array(["1"] * 4)],
)  # fmt: skip
def test_all_that_says_the_same_is_the_same(radii):
    expected = parts(flowcert.pores(FOUR, 1))
    for points in (FOUR, np.array(FOUR), np.array(FOUR).astype(str), [[Fraction(x) for x in row] for row in FOUR]):
        assert parts(flowcert.pores(points, radii)) == expected


@pytest.mark.parametrize(
    "points, radii, options, message",
    [
        (FOUR, [1, 1, 0, 1], {}, "radius 2: 0 is not above 0"),
        (FOUR, "-1/2", {}, "radii: -1/2 is not above 0"),
        (FOUR, "bondi", {}, "radii: bondi is not a finite number"),
        (FOUR, "1/0", {}, "radii: 1/0 is not a finite number"),
        (FOUR, True, {}, "radii: True is not a finite number"),
        (FOUR, [1, 1, 1, float("nan")], {}, "radius 3: nan is not a finite number"),
        (FOUR, [1, 1, 1], {}, "radii must be one number, or one for each of 4 points, not (3,)"),
        ([*FOUR[:3], [0, "inf", 0]], 1, {}, "point 3: inf is not a finite number"),
        ([[0, 0]], 1, {}, "points must have three coordinates: numpy.insert(points, 2, 0, axis=1) makes their z 0"),
        (FOUR, np.ma.array([1, 1, 1, 1], mask=[1, 0, 0, 0]), {}, "radii has masked values"),
        (FOUR, 1, {"depth": -1}, "depth: not 0 or more"),
        (FOUR, 1, {"threads": 0}, "threads must be from 1 to 1024"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_line(points, radii, options, message):
    with pytest.raises(ValueError) as refused:
        flowcert.pores(points, radii, **options)
    assert str(refused.value) == message


def test_what_else_is_refused():
    with pytest.raises(TypeError, match=r"^points is the name of .* flowcert.read_balls\('a.xyz', 'bondi'\) has its"):
        flowcert.pores("a.xyz", "bondi")
    made = flowcert.pores(FOUR, 1)
    for place in (-1, len(made.points), 2**80):
        with pytest.raises(ValueError, match="^there is no point "):
            made.exact(place)
    for ask in (made.cavities_at, made.chambers[0].status):
        with pytest.raises(ValueError, match="^probe: not 0 or more$"):
            ask("-0.1")
    with pytest.raises(ValueError, match="--radii:1: bondi, alvarez, .*; not 'bondo'$"):
        flowcert.read_balls(CAGE, "bondo")
    with pytest.raises(TypeError, match="colums"):
        flowcert.read_balls(CAGE, "bondi", colums="1,2,3")
    empty = flowcert.pores(np.empty((0, 3)), [])
    assert (empty.chambers, empty.windows, len(empty.points), empty.pore_limiting_diameter) == ([], [], 0, None)


def test_files_are_read_with_the_words_of_the_commands(tmp_path):
    table, crystal = tmp_path / "balls.csv", tmp_path / "crystal.xyz"
    table.write_text("0.1,0.2,0.3,1.70\n1,2,3,0x1.8p0\n")
    centres, radii = flowcert.read_balls(table, "column:4")
    assert radii.tolist() == [Fraction("1.70"), Fraction(3, 2)] and centres[0, 0] == Fraction("0.1")
    centres, radii, left_out = flowcert.read_balls(table, 0.1, columns="4,2,1", return_left_out=True)
    assert radii.tolist() == [Fraction(0.1)] * 2 and centres[0].tolist() == [Fraction(x) for x in ("1.7", "0.2", "0.1")]
    assert len(left_out) == 0
    crystal.write_text('1\nLattice="5 0 0 0 5 0 0 0 5"\nFe 0 0 0\n')
    with pytest.raises(ValueError, match="--finite"):
        flowcert.read_balls(crystal, "bondi,Fe=2.04")
    with pytest.warns(UserWarning, match="lattice is ignored"):
        assert flowcert.read_balls(crystal, "bondi,Fe=2.04", finite=True)[1].tolist() == [Fraction("2.04")]


def test_cavities_for_one_probe():
    twice = FOUR + FOUR[:1]  # repeated rows are balls of their own
    found = [flowcert.cavities(twice, "1", probe) for probe in (2.2, Fraction(12, 5), "2.6")]
    assert [[rows.tolist() for rows in linings] for linings in found] == [[], [[0, 1, 2, 3, 4]], []]
    with pytest.raises(ValueError, match="^radius 1: 0 is not above 0$"):
        flowcert.cavities(FOUR, [1, 0, 1, 1], 1)
    with pytest.raises(ValueError, match="^probe: not 0 or more$"):
        flowcert.cavities(FOUR, 1, -1)


# ---- What the program says


def number(said):
    return said and (tuple(map(int, said["polynomial"])), said["root"], said["double"])


def same(value):
    return value and (value.polynomial, value.root, value.double)


BALL = strategies.tuples(*[strategies.integers(-3, 3)] * 3, strategies.sampled_from(["0.5", "0.7", "1", "1.3"]))


@hypothesis.settings(max_examples=25)
@hypothesis.given(strategies.lists(BALL, min_size=6, max_size=14), strategies.sampled_from(["0", "0.4", "1"]))
def test_pores_are_those_of_the_program(tmp_path_factory, balls, probe):
    file = tmp_path_factory.mktemp("pores") / "balls.txt"
    file.write_text("".join(" ".join(map(str, ball)) + "\n" for ball in balls))
    said = json.loads(flowcert_says("pores", file, "--radii", "column:4", "--depth", "0", "--probe", probe, "--json"))
    points, radii = [ball[:3] for ball in balls], [ball[3] for ball in balls]
    made = flowcert.pores(points, radii, depth=0)

    def is_said(places, witnesses):
        assert contacts(made, places) == [point["contact"] for point in witnesses["points"]]
        for place, point in zip(places, witnesses["points"]):
            position, value = made.exact(place)
            assert same(value) == number(witnesses["value"])
            assert list(map(same, position)) == list(map(number, point["center"]))
            assert made.points["center"][place].tolist() == [x["double"] for x in point["center"]]
            assert made.points["value"][place] == value.double

    assert len(made.chambers) == len(said["chambers"]) and len(made.windows) == len(said["windows"])
    for chamber, other in zip(made.chambers, said["chambers"]):
        is_said(chamber.peaks, other["peak"])
        is_said(chamber.gates, other["gate"] or {"points": []})
        assert same(chamber.gate) == number(other["gate"] and other["gate"]["value"])
        assert same(chamber.exit) == number(other["exit"])
        assert contacts(made, chamber.handles) == other["handles"] and chamber.windows.tolist() == other["windows"]
        assert (chamber.diameter, chamber.limiting_diameter) == (other["diameter"], other["limiting_diameter"])
        assert (chamber.depth, chamber.status(probe)) == (other["depth"], other["is"])
    for window, other in zip(made.windows, said["windows"]):
        is_said([window.point], {"value": other["value"], "points": [other]})
        assert (list(window.rooms), window.diameter) == (other["rooms"], other["diameter"])
    for peaks, other in zip(made.vestibules, said["vestibules"]):
        is_said(peaks, other)
    values = [same(made.exact(i)[1]) for i in range(len(made.points))] + [None]  # that of the gate -1
    intervals = [[values[gate], values[peak]] for gate, peak in made.cavities]
    assert intervals == [[number(gate), number(peak)] for gate, peak in said["cavities"]]
    assert made.hidden.tolist() == said["hidden"]
    assert made.largest_cavity_diameter == said["largest_cavity_diameter"]
    assert made.pore_limiting_diameter == said["pore_limiting_diameter"]
    count = made.cavities_at(probe)
    assert count == said["cavities_at_probe"] == len(flowcert.cavities(points, radii, probe))
    step = [cavities for up_to, cavities in made.cavity_steps() if up_to >= Fraction(probe)]
    assert count == (step[-1] if step else 0)


# ---- Exact numbers

SMALL = strategies.integers(-12, 12)
ROOTS = strategies.sampled_from([2, 3, 5, 6, 7, 10])


def quadratic(a, b, d):
    """(a + b sqrt(d)) / 6, as the library says it; b is not 0."""
    polynomial = (36, -12 * a, a * a - b * b * d)
    divisor = int(np.gcd.reduce(polynomial))
    return flowcert.QuadraticNumber(tuple(x // divisor for x in polynomial), 1 if b > 0 else -1, 0.0, 0.0)


@hypothesis.given(strategies.tuples(SMALL, SMALL.filter(bool), ROOTS), strategies.tuples(SMALL, SMALL, ROOTS))
def test_comparisons_are_exact(x, y):
    with localcontext() as context:
        context.prec = 50
        one, other = (Decimal(a) + b * Decimal(d).sqrt() for a, b, d in (x, y))
        order = 0 if abs(one - other) < Decimal("1e-30") else 1 if one > other else -1
    number, rest = quadratic(*x), quadratic(*y) if y[1] else Fraction(y[0], 6)
    assert (number > rest, number == rest, number < rest) == (order > 0, order == 0, order < 0)
    assert (rest > number, rest == number, rest < number) == (order < 0, order == 0, order > 0)
    assert (number >= rest, number <= rest, number != rest) == (order >= 0, order <= 0, order != 0)
    assert order != 0 or hash(number) == hash(rest)


def test_numbers_and_other_ones():
    root, three_halves = quadratic(0, 6, 2), flowcert.QuadraticNumber((2, -3), 0, 1.5, 3.0)
    assert 2**0.5 > root > np.nextafter(2**0.5, 0) and root > 1 and root < float("inf") and not root < float("nan")
    assert float(three_halves) == three_halves == Fraction(3, 2) == Decimal("1.5") and three_halves != "1.5"
    assert {three_halves: 1}[1.5] == 1 and np.array([three_halves], dtype=float).tolist() == [1.5]
    with pytest.raises(TypeError):
        root < "2"
