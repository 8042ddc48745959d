"""What FlowComplex takes as points, what it refuses, and in which words."""

import array
import decimal
import gc
import pathlib
import tracemalloc
import weakref
from fractions import Fraction

import flowcert
import numpy as np
import pytest
from conftest import CUBE, sphere_sample

ROWS = np.array([[0, 0, 0], [3, 0, 0], [0, 4, 1], [2, 2, 7]], dtype=float)


def answer(points):
    fc = flowcert.FlowComplex(points)
    return fc.stationary_points.tobytes(), fc.contacts.tobytes(), fc.persistence()


@pytest.mark.parametrize(
    "points",
    [
        ROWS.tolist(),
        tuple(map(tuple, ROWS.astype(int).tolist())),
        [ROWS[0], *ROWS[1:].tolist()],
        [[Fraction(int(x)) for x in row] for row in ROWS],
        [[decimal.Decimal(int(x)) for x in row] for row in ROWS],
        ROWS.astype(np.float32),
        ROWS.astype(np.float16),
        ROWS.astype(np.longdouble),
        ROWS.astype(np.int8),
        ROWS.astype(np.uint64),
        ROWS.astype(">f8"),
        ROWS.astype(">i4"),
        ROWS.astype(object),
        np.asfortranarray(ROWS),
        np.repeat(ROWS, 2, axis=0)[::2],
        np.column_stack([ROWS, ROWS])[:, :3],
        ROWS[::-1][::-1],
        ROWS.view(np.recarray),
        np.ma.array(ROWS),
        np.frombuffer(b"x" + ROWS.tobytes(), dtype=np.uint8)[1:].view(float).reshape(-1, 3),
    ],
    ids=lambda points: f"{type(points).__name__}-{getattr(points, 'dtype', '')}",
)
def test_all_that_has_the_same_numbers_is_the_same(points):
    assert answer(points) == answer(ROWS)


def test_readonly_arrays_and_other_buffers_are_read():
    readonly = ROWS.copy()
    readonly.setflags(write=False)
    assert answer(readonly) == answer(ROWS)
    flat = memoryview(array.array("d", ROWS.ravel()))
    assert answer(np.asarray(flat).reshape(-1, 3)) == answer(ROWS)


def test_float32_is_exact():
    points = np.array([[0.1, 0, 0], [0, 0.2, 0]], dtype=np.float32)
    position, _ = flowcert.FlowComplex(points).exact(2)
    assert position[0] == Fraction(float(np.float32(0.1))) / 2 != Fraction(0.1) / 2


@pytest.mark.parametrize("dtype", [np.int64, np.uint64, object])
def test_integers_are_exact_or_refused(dtype):
    exact = np.array([[2**53, 0, 0], [2**62 + 2**10, 0, 0]], dtype=dtype)
    fc = flowcert.FlowComplex(exact)
    assert fc.exact(2)[0][0] == Fraction(2**53 + 2**62 + 2**10, 2)
    with pytest.raises(ValueError, match=r"^9007199254740993 in points is not exactly a double$"):
        flowcert.FlowComplex(np.array([[0, 0, 0], [2**53 + 1, 0, 0]], dtype=dtype))


def test_the_least_and_the_largest_integers():
    assert flowcert.FlowComplex(np.array([[-(2**63), 0, 0]])).points[0, 0] == -(2.0**63)
    for value, dtype in ((2**63 - 1, np.int64), (2**64 - 1, np.uint64), (-(2**63) + 1, np.int64)):
        with pytest.raises(ValueError, match=f"^{value} in points is not exactly a double$"):
            flowcert.FlowComplex(np.array([[value, 0, 0]], dtype=dtype))


@pytest.mark.parametrize(
    "points, message",
    [
        # NumPy would make doubles of these lists, and round.
        ([[2**53 + 1, 0.5, 0]], "9007199254740993 in points is not exactly a double"),
        ([[2**64 + 1, 0, 0]], "18446744073709551617 in points is not exactly a double"),
        ([[10**400, 0, 0]], "1" + "0" * 19 + "..." + "0" * 10 + " in points is beyond the largest double"),
        ([[16**4000, 0, 0]], "a long integer in points is beyond the largest double"),
        ([[Fraction(1, 3), 0, 0]], "1/3 in points is not exactly a double"),
        ([["1", 0, 0]], "points must be real numbers, not 1"),
        ([["1\n2", 0, 0]], "points must be real numbers, not 1 2"),
        ([[None, 0, 0]], "points must be real numbers, not None"),
        ([[True, 0, 0]], "points must be real numbers, not True"),
        ([[1j, 0, 0]], "points must be real numbers, not 1j"),
        (np.zeros((2, 3), dtype=bool), "points must be real numbers, not of type bool"),
        (np.zeros((2, 3), dtype=complex), "points must be real numbers, not of type complex128"),
        (np.zeros((2, 3), dtype="U1"), "points must be real numbers, not of type <U1"),
        (np.zeros((2, 3), dtype="M8[s]"), "points must be real numbers, not of type datetime64[s]"),
        (np.array([[np.longdouble(1) / 3, 0, 0]]), "0.33333333333333333334 in points is not exactly a double"),
        (np.ma.array(ROWS, mask=ROWS > 3), "points has masked values"),
        (np.zeros(3), "points must have the shape (n, 3), not (3,)"),
        (np.zeros((4, 2)), "points must have three coordinates: numpy.insert(points, 2, 0, axis=1) makes their z 0"),
        (np.zeros((4, 4)), "points must have the shape (n, 3), not (4, 4)"),
        (np.zeros((2, 3, 3)), "points must have the shape (n, 3), not (2, 3, 3)"),
        (np.float64(1), "points must have the shape (n, 3), not ()"),
        ([[0, 0, 0], [1, 1]], "points must have the shape (n, 3), not (2,)"),
        ([], "points must have the shape (n, 3), not (0,)"),
        (None, "points must have the shape (n, 3), not ()"),
    ],
)
def test_what_cannot_be_used_is_refused_in_one_line(points, message):
    with pytest.raises(ValueError) as refused:
        flowcert.FlowComplex(points)
    assert str(refused.value) == message


@pytest.mark.parametrize("name", ["points.xyz", b"points.xyz", pathlib.Path("points.xyz")])
def test_the_name_of_a_file_is_told_who_reads_it(name):
    with pytest.raises(TypeError) as refused:
        flowcert.FlowComplex(name)
    message = "points is the name of a file, 'points.xyz': flowcert.read_points('points.xyz') has its points"
    assert str(refused.value) == message


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.longdouble, object])
def test_what_is_not_finite_is_refused_with_its_row(value, dtype):
    points = ROWS.astype(dtype)
    points[2, 1] = value
    with pytest.raises(ValueError, match=r"^point 2 has a coordinate that is not a finite number$"):
        flowcert.FlowComplex(points)


def test_a_longdouble_beyond_the_doubles_is_refused():
    with pytest.raises(ValueError, match="is not exactly a double"):
        flowcert.FlowComplex(np.array([[np.longdouble("1e400"), 0, 0]]))


def test_threads():
    for threads in (0, -1, 1025):
        with pytest.raises(ValueError, match=r"^threads must be from 1 to 1024$"):
            flowcert.FlowComplex(ROWS, threads=threads)
    with pytest.raises(TypeError):
        flowcert.FlowComplex(ROWS, threads=1.5)
    assert flowcert.FlowComplex(ROWS, threads=3).threads == 3
    assert flowcert.FlowComplex(ROWS).threads >= 1


@pytest.mark.parametrize("dtype", [float, np.float32, int, object])
def test_no_points(dtype):
    fc = flowcert.FlowComplex(np.empty((0, 3), dtype=dtype))
    assert (fc.counts, fc.euler_sum, fc.merged_duplicates) == ((0, 0, 0, 0), 0, 0)
    assert set(fc.regular_counts.values()) == {0}
    assert (len(fc.critical_points), len(fc.contacts), fc.points.shape) == (0, 0, (0, 3))
    assert fc.persistence() == [] == fc.persistence(zero=True)
    assert len(fc.persistence_pairs()) == 0
    for mesh in (fc.surface(), fc.surface("index2-radius<1")):
        assert (mesh.vertices.shape, mesh.faces.shape) == ((0, 3), (0, 3))
    assert fc.stable_surfaces().saddles.shape == (0,)
    lines = fc.unstable_lines()
    assert (lines.vertices.shape, lines.offsets.tolist(), lines.limits.shape) == ((0, 3), [0], (0,))
    assert fc.check([]).verdict == "conforms"
    assert "points" in fc._repr_html_()
    with pytest.raises(ValueError, match=r"^there are no points$"):
        fc.orbit([0, 0, 0])
    with pytest.raises(ValueError, match=r"^there is no stationary point 0; there are 0$"):
        fc.exact(0)


def test_repeated_points_go_by_their_first_row():
    points = np.array([[1, 0, 0], [0, 0, 0], [1, 0, 0], [-0.0, 0, 0]])
    fc = flowcert.FlowComplex(points)
    assert (fc.merged_duplicates, fc.counts) == (2, (2, 1, 0, 0))
    assert fc.contacts.tolist() == [0, 1, 0, 1]
    assert (fc.points == points).all() and not np.signbit(fc.points).any()


def test_the_array_may_change_afterwards():
    points = ROWS.copy()
    fc = flowcert.FlowComplex(points)
    points[:] = np.nan
    assert fc.counts == flowcert.FlowComplex(ROWS).counts
    assert (fc.points == ROWS).all()


def test_an_array_of_doubles_is_not_copied_and_not_kept():
    points = np.zeros((100_000, 3))
    tracemalloc.start()
    try:
        fc = flowcert.FlowComplex(points)
        _, peak = tracemalloc.get_traced_memory()  # NumPy tells it what it allocates
        assert peak < points.nbytes / 100
        tracemalloc.reset_peak()
        flowcert.FlowComplex(points.astype(np.float32))
        _, peak = tracemalloc.get_traced_memory()
        assert peak >= points.nbytes
    finally:
        tracemalloc.stop()
    kept = weakref.ref(points)
    del points
    gc.collect()
    assert kept() is None
    assert fc.merged_duplicates == 99_999


def test_arrays_outlive_the_complex_and_what_it_keeps_cannot_be_written_to():
    fc = flowcert.FlowComplex(sphere_sample(50))
    points, contacts, lines, surface = fc.critical_points, fc.contacts, fc.unstable_lines(), fc.surface()
    assert np.shares_memory(points, fc.stationary_points) and fc.contacts is contacts
    del fc
    gc.collect()
    assert points["index"].max() == 3
    for each in (points, contacts):
        with pytest.raises(ValueError, match="read-only"):
            each[...] = 0
    for each in (*lines, *surface):
        each[...] = 0


def test_subsets_keep_their_contact_sets():
    fc = flowcert.FlowComplex(CUBE)
    maximum = fc.critical_points[fc.critical_points["index"] == 3]
    assert len(maximum) == 1
    first, last = maximum[0]["contact_offsets"]
    assert fc.contacts[first:last].tolist() == list(range(8))
    assert maximum[0]["center"].tolist() == [0.5, 0.5, 0.5]
    assert maximum[0]["squared_distance"] == 0.75
