"""plot_diagram and plot_barcode draw what persistence() says."""

import math

import flowcert
import numpy as np
import pytest
from conftest import CUBE

SQUARE = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]


@pytest.fixture
def pyplot():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    yield pyplot
    pyplot.close("all")


def drawn_points(ax):
    """(dimension, birth, death), of the points of a diagram; those above the dashed line are infinite."""
    [infinity] = [line.get_ydata()[0] for line in ax.lines if line.get_linestyle() == "--"] or [math.inf]
    found = []
    for line in ax.lines:
        if line.get_marker() == "o":
            dimension = int(line.get_label()[0])
            found += [(dimension, x, math.inf if y == infinity else y) for x, y in line.get_xydata().tolist()]
    return found


def drawn_bars(ax):
    found = []
    for bars in ax.collections:
        dimension = int(bars.get_label()[0])
        for [[x, y], [end, same]] in bars.get_segments():
            assert y == same
            found.append((y, dimension, x, end))
    return found


@pytest.mark.parametrize("points", [SQUARE, CUBE], ids=["square", "cube"])
@pytest.mark.parametrize("squared", [True, False])
def test_a_diagram_has_all_pairs(pyplot, points, squared):
    fc = flowcert.FlowComplex(points)
    ax = fc.plot_diagram(zero=True, squared=squared)
    assert drawn_points(ax) == [(k, *pair) for k, pair in fc.persistence(zero=True, squared=squared)]
    what = "squared distance" if squared else "distance"
    assert (ax.get_xlabel(), ax.get_ylabel()) == (f"birth ({what})", f"death ({what})")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["0: components", "1: tunnels", "2: voids"][
        : len({k for k, _ in fc.persistence(zero=True)})
    ]


def test_axes_are_those_that_are_given(pyplot):
    figure, (left, right) = pyplot.subplots(1, 2)
    fc = flowcert.FlowComplex(CUBE)
    assert fc.plot_diagram(left, dimension=1) is left and fc.plot_barcode(ax=right, dimension=1) is right
    assert pyplot.get_fignums() == [figure.number]
    assert drawn_points(left) == [(1, *pair) for pair in fc.persistence(dimension=1).tolist()]
    assert not [line for line in left.lines if line.get_linestyle() == "--"]  # nothing lasts
    assert [bar[1:] for bar in drawn_bars(right)] == drawn_points(left)
    figure.canvas.draw()


def test_a_barcode_has_a_bar_for_each_pair(pyplot):
    fc = flowcert.FlowComplex(CUBE)
    ax = fc.plot_barcode(squared=False)
    bars = drawn_bars(ax)
    assert [bar[0] for bar in bars] == list(range(len(bars)))
    right = ax.get_xlim()[1]
    pairs = [(k, (birth, math.inf if end == right else end)) for _, k, birth, end in bars]
    assert pairs == fc.persistence(squared=False)
    assert ax.get_xlabel() == "distance"


@pytest.mark.parametrize("points", [np.empty((0, 3)), [[1, 2, 3]]], ids=["none", "one"])
def test_of_almost_nothing(pyplot, points):
    fc = flowcert.FlowComplex(points)
    for ax in (fc.plot_diagram(), fc.plot_barcode()):
        assert np.isfinite([*ax.get_xlim(), *ax.get_ylim()]).all()
        ax.figure.canvas.draw()
    assert drawn_points(fc.plot_diagram()) == [(k, *pair) for k, pair in fc.persistence()]


def test_a_dimension_that_there_is_not(pyplot):
    with pytest.raises(ValueError, match="dimension must be 0, 1 or 2"):
        flowcert.FlowComplex(CUBE).plot_diagram(dimension=3)


def test_examples(pyplot, examples_hold):
    assert examples_hold(flowcert.FlowComplex.plot_diagram) and examples_hold(flowcert.FlowComplex.plot_barcode)
