"""Every public function of the package, in every mode for doubles that another library may have set in the thread.

Results have the bits that they always have, and the modes are the caller's afterwards.
"""

import ctypes
import dataclasses
import platform
from fractions import Fraction

import numpy as np
import pytest

import flowcert
from flowcert import _exports

LIBM = ctypes.CDLL("libm.so.6")
UPWARD, DOWNWARD, TOWARD_ZERO = 0x800, 0x400, 0xC00  # of x86-64
FLUSHED = 0x8040  # results and operands
pytestmark = pytest.mark.skipif(platform.machine() != "x86_64", reason="the modes' numbers are those of x86-64")

DECIMALS = [
    [0.1, 0.7, 0.3], [1.3, 0.2, 0.9], [0.4, 1.9, 0.6], [1.1, 1.2, 1.7], [0.6, 0.5, 2.3], [2.1, 1.4, 0.2],
    [1.7, 2.2, 1.1], [0.2, 2.4, 1.9],
]  # fmt: skip
TINY = [[x * 2.0**-1068 for x in row] for row in DECIMALS[:6]]


class Mode:
    """While it stands, this thread has the mode."""

    def __init__(self, rounding, flushed):
        self.rounding, self.flushed = rounding, flushed

    def __enter__(self):
        self.before = ctypes.create_string_buffer(32)  # glibc's fenv_t, with MXCSR at its end
        LIBM.fegetenv(self.before)
        LIBM.fesetround(self.rounding)
        now = ctypes.create_string_buffer(32)
        LIBM.fegetenv(now)
        word = int.from_bytes(now.raw[28:], "little") | self.flushed
        LIBM.fesetenv(ctypes.create_string_buffer(now.raw[:28] + word.to_bytes(4, "little"), 32))
        self.set = self.modes()
        return self

    def __exit__(self, *_):
        self.stands = self.modes() == self.set
        LIBM.fesetenv(self.before)

    def modes(self):
        now = ctypes.create_string_buffer(32)
        LIBM.fegetenv(now)
        return int.from_bytes(now.raw[28:], "little") & ~0x3F, now.raw[:2]


MODES = {
    "upward": Mode(UPWARD, 0),
    "downward": Mode(DOWNWARD, 0),
    "toward zero": Mode(TOWARD_ZERO, 0),
    "flushed": Mode(0, FLUSHED),
}


def bits(value):
    """Every bit of a result, comparable."""
    if isinstance(value, np.ndarray) and value.dtype.names:  # there are bytes between its fields
        return [bits(value[name]) for name in value.dtype.names]
    if isinstance(value, (np.ndarray, np.generic)):
        return str(value.dtype), np.shape(value), value.tobytes()
    if dataclasses.is_dataclass(value):
        return [bits(getattr(value, field.name)) for field in dataclasses.fields(value)]
    if isinstance(value, (list, tuple)):
        return [bits(each) for each in value]
    if isinstance(value, dict):
        return [(bits(key), bits(each)) for key, each in value.items()]
    return value.hex() if isinstance(value, float) else repr(value)


def data_set(fc, part):
    return list(_exports._data_set(fc, part, None, 3))


def drawn(plot):
    """What a plot hands to the axes of matplotlib, which need not be there."""
    calls = []

    class Axes:
        def __getattr__(self, name):
            return lambda *words, **options: calls.append((name, words, sorted(options.items())))

    plot(Axes())
    return calls


def calls_of_complex(rows, made):
    """What each public name of FlowComplex is asked, of a complex that is new and of one that has everything."""
    persistence, probe = rows[0][0] / 1024, rows[0][1] / 3
    third = (Fraction(rows[0][0]) / 3, rows[1][1], rows[2][2])
    last = len(made.stationary_points) - 1
    saddle = made.counts[0]
    claim = [
        {"index": int(point["index"]), "center": point["center"], "squared_distance": point["squared_distance"]}
        for point in made.critical_points
    ]
    return {
        "points": lambda fc: fc.points,
        "merged_duplicates": lambda fc: fc.merged_duplicates,
        "threads": lambda fc: fc.threads,
        "stationary_points": lambda fc: fc.stationary_points,
        "critical_points": lambda fc: fc.critical_points,
        "regular_points": lambda fc: fc.regular_points,
        "contacts": lambda fc: fc.contacts,
        "counts": lambda fc: fc.counts,
        "regular_counts": lambda fc: fc.regular_counts,
        "euler_sum": lambda fc: fc.euler_sum,
        "exact": lambda fc: fc.exact(last),
        "persistence": lambda fc: fc.persistence(zero=True),
        "persistence_pairs": lambda fc: fc.persistence_pairs(zero=True),
        "surface": lambda fc: fc.surface(["index2-radius<1.7spacing"]),
        "stable_surfaces": lambda fc: fc.stable_surfaces(),
        "unstable_lines": lambda fc: fc.unstable_lines(),
        "orbit": lambda fc: (fc.orbit(third), fc.orbit(third).vertices),
        "locate": lambda fc: fc.locate([rows[3], rows[4]]),
        "cycles": lambda fc: [fc.cycles(dimension, level="30%", persistence=persistence) for dimension in (0, 1, 2)],
        "represents": lambda fc: [fc.represents([loop], loop.pair) for loop in fc.cycles(persistence=0)],
        "homologous": lambda fc: [fc.homologous([0, 1, 2], [0, 1, 3], level) for level in (persistence, 9)],
        "pockets": lambda fc: fc.pockets(persistence=persistence, probe=probe),
        "volumes": lambda fc: fc.volumes,
        "volume": lambda fc: fc.volume(last),
        "shares": lambda fc: (fc.shares(last), fc.shares(last, exact=True)),
        "hull_volume": lambda fc: fc.hull_volume,
        "lambda_list": lambda fc: (fc.lambda_list(saddle), fc.lambda_list(saddle, exact=True)),
        "unstable_surface": lambda fc: (fc.unstable_surface(saddle), fc.unstable_surface(saddle, exact=True)),
        "connections": lambda fc: fc.connections,
        "is_morse_smale": lambda fc: fc.is_morse_smale,
        "check": lambda fc: fc.check(claim),
        "show": lambda fc: fc.show(cells=True, pockets=persistence).html,
        "plot_diagram": lambda fc: drawn(fc.plot_diagram),
        "plot_barcode": lambda fc: drawn(fc.plot_barcode),
        # What other libraries make of these is their own.
        "to_pyvista": lambda fc: [data_set(fc, part) for part in _exports._PARTS],
        "to_trimesh": lambda fc: data_set(fc, "stable_surfaces"),
        "to_meshio": lambda fc: data_set(fc, "unstable_lines"),
    }


class Atoms:
    """As ASE has them, and MDAnalysis."""

    pbc = [False]
    positions = np.array(DECIMALS[:2])
    elements = ["C", "O"]
    atoms = property(lambda self: self)
    __len__ = lambda self: 2
    get_chemical_symbols = lambda self: self.elements


def public_names(of):
    return {name for name in dir(of) if not name.startswith("_")}


def in_every_mode(name, call):
    usual = bits(call())
    for mode_name, mode in MODES.items():
        with mode:
            result = call()
        assert mode.stands, f"{name} changes the mode: {mode_name}"
        assert bits(result) == usual, f"{name}, {mode_name}"


@pytest.mark.parametrize("rows", [DECIMALS, TINY], ids=["decimals", "tiny"])
def test_of_a_complex(rows):
    made = flowcert.FlowComplex(rows, threads=2)
    calls = calls_of_complex(rows, made)
    assert set(calls) == public_names(flowcert.FlowComplex)
    for name, call in calls.items():
        in_every_mode(name, lambda call=call: call(made))
        in_every_mode(name, lambda call=call: call(flowcert.FlowComplex(rows, threads=1)))


def test_of_the_module(tmp_path):
    file = tmp_path / "points.xyz"
    file.write_text("0.1 0.7 0.3\n1e-320 0.2 4.9e-324\n1.1 123456.7 0.30000000000000004\n")
    claim = [{"index": 0, "center": point} for point in TINY]
    fractions = [[Fraction(x) for x in row] for row in TINY]
    loops = flowcert.FlowComplex(DECIMALS).cycles(longest=1)
    made = flowcert.pores(DECIMALS, "1/3", depth=0)

    def pores():
        again = flowcert.pores(DECIMALS, DECIMALS[0][0], depth=TINY[0][0], threads=2)
        lists = again.points, again.contacts, again.chambers, again.windows, again.cavities, again.cavity_steps()
        places = range(len(again.points))
        return lists, [made.exact(i) for i in places], [made.cavities_at(x) for x in DECIMALS[0]]

    calls = {
        "read_points": lambda: flowcert.read_points(file),
        "read_balls": lambda: [some.tolist() for some in flowcert.read_balls(file, 0.1)],
        "pores": pores,
        "cavities": lambda: flowcert.cavities(TINY, TINY[0][0], TINY[1][1]),
        "generate": lambda: [flowcert.generate(family, case=3) for family in sorted(flowcert.families())],
        "families": lambda: flowcert.families(),
        "from_ase": lambda: [some.tolist() for some in flowcert.from_ase(Atoms())],
        "from_gemmi": lambda: [some.tolist() for some in flowcert.from_gemmi([], "bondi")],
        "from_mdanalysis": lambda: [some.tolist() for some in flowcert.from_mdanalysis(Atoms(), 0.1)],
        "check": lambda: flowcert.check(TINY, claim, tolerance=1e-9, highest_level=2, indices=[0]),
        "FlowComplex": lambda: flowcert.FlowComplex(fractions).points,
        "represents": lambda: flowcert.represents(loops, loops[0].pair),
    }
    types = {name for name in public_names(flowcert) if isinstance(getattr(flowcert, name), type)}
    assert set(calls) == (public_names(flowcert) & set(flowcert.__all__)) - types | {"FlowComplex"}
    for name, call in calls.items():
        in_every_mode(name, call)


def test_no_result_changes_later():
    """A complex that was asked in another mode answers as one that never was."""
    right = flowcert.FlowComplex(DECIMALS).stationary_points["center"]
    complex = flowcert.FlowComplex(DECIMALS)
    complex.counts
    with MODES["upward"]:
        complex.stationary_points
    assert (complex.stationary_points["center"] == right).all()
