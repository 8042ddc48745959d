"""Exact numbers between fractions.Fraction and the library."""

import math
from fractions import Fraction

import numpy as np

from . import _core


def fraction(ratio):
    """From (numerator, denominator)."""
    return Fraction(*ratio)


def fractions(ratios):
    return tuple(fraction(ratio) for ratio in ratios)


def hexadecimal(value):
    """The same number as the library reads it, "-1f/3"."""
    return f"{value.numerator:x}/{value.denominator:x}"


def decimal(value):
    """The same number in decimals, "-31/3". Python itself refuses those of more than 4,300 digits."""
    return _core.decimal_text(hexadecimal(value))


def exact(value, name):
    """The number as a Fraction; name is what messages call it."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{name} has a coordinate that is not a finite number")
    if isinstance(value, str):
        raise ValueError(f"{name} must be numbers; for {value!r} write Fraction({value!r}) or a float")
    try:
        return Fraction(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be numbers, not {value!r}") from None
