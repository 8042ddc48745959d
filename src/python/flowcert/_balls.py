"""Balls as the library takes them: no coordinate and no radius is ever rounded."""

from fractions import Fraction

import numpy as np

from . import _exact
from ._points import as_array, rows_of_three, shown


@_exact.in_ieee_doubles
def ball_rows(points, radii):
    """[[x, y, z, radius], ...], hexadecimal."""
    rows = rows_of_three(points, "read_balls({}, 'bondi')").tolist()
    array = as_array(radii, "radii")
    if array.ndim == 0:
        last = [_radius(array.tolist(), "radii")] * len(rows)
    elif array.shape == (len(rows),):
        last = [_radius(radius, f"radius {row}") for row, radius in enumerate(array.tolist())]
    else:
        raise ValueError(f"radii must be one number, or one for each of {len(rows)} points, not {array.shape}")
    return [
        [*(_exact.hexadecimal(number(x, f"point {row}")) for x in place), radius]
        for row, (place, radius) in enumerate(zip(rows, last))
    ]


def _radius(value, name):
    radius = number(value, name)
    if radius <= 0:
        raise ValueError(f"{name}: {shown(value)} is not above 0")
    return _exact.hexadecimal(radius)


def number(value, name):
    """The number that a text says, "1.70" or "17/10", or that anything else is, as a Fraction."""
    try:
        if not isinstance(value, (bool, np.bool_)):
            return Fraction(value) if isinstance(value, str) else _exact.exact(value, name)
    except (ValueError, ZeroDivisionError):
        pass
    raise ValueError(f"{name}: {shown(value)} is not a finite number")


def length(value, name):
    """The same of a probe or a depth."""
    made = number(value, name)
    if made < 0:
        raise ValueError(f"{name}: not 0 or more")
    return made
