"""Exact numbers between fractions.Fraction and the library."""

import functools
from decimal import Decimal
from fractions import Fraction

import numpy as np

from . import _core


def in_ieee_doubles(function):
    """The function, called with doubles as IEEE 754 says, whatever modes another library has set in this thread."""

    @functools.wraps(function)
    def called(*arguments):
        return _core.in_ieee_doubles(function, *arguments)

    return called


def fraction(ratio):
    """From (numerator, denominator)."""
    return Fraction(*ratio)


def fractions(ratios):
    return tuple(fraction(ratio) for ratio in ratios)


def hexadecimal(value):
    """The same number as the library reads it, "-1f/3"."""
    return f"{value.numerator:x}/{value.denominator:x}"


def nearest_double(text):
    """From what hexadecimal() gives."""
    numerator, denominator = text.split("/")
    return int(numerator, 16) / int(denominator, 16)


def decimal(value):
    """The same number in decimals, "-31/3". Python itself refuses those of more than 4,300 digits."""
    return _core.decimal_text(hexadecimal(value))


def words(value, name):
    """What commands take: a str as it is, or a number, exactly."""
    text = value if isinstance(value, str) else decimal(exact(value, name))
    return text.encode(errors="replace")


@in_ieee_doubles
def exact(value, name):
    """The number as a Fraction; name is what messages call it."""
    if isinstance(value, np.generic) and not isinstance(value, np.longdouble):
        value = value.item()
    if isinstance(value, str):
        raise ValueError(f"{name} must be numbers; for {value!r} write Fraction({value!r}) or a float")
    try:
        # Fraction takes no long double, though it is exact.
        return Fraction(*value.as_integer_ratio()) if isinstance(value, np.longdouble) else Fraction(value)
    except (OverflowError, TypeError, ValueError):
        if isinstance(value, (float, np.longdouble, Decimal)):
            raise ValueError(f"{name} has a coordinate that is not a finite number") from None
        shown = " ".join(repr(value).split())  # an array has several lines
        raise ValueError(f"{name} must be numbers, not {shown}") from None
