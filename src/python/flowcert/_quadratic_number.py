"""Exact radii and coordinates between balls."""

import math
import numbers
import operator
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, Tuple

from . import _exact


def _sign(x):
    return (x > 0) - (x < 0)


def _sign_of_sum(a, b, d):
    """Of a + b sqrt(d)."""
    one, other = _sign(a), _sign(b) if d else 0
    return (one or other) if one * other >= 0 else one * _sign(a * a - b * b * d)


def _comparison(holds):
    def compare(self, other):
        if isinstance(other, numbers.Real):
            if not isinstance(other, numbers.Rational) and not math.isfinite(other):
                return holds(0.0, float(other))
            c, e, f = _exact.exact(other, "other"), 0, 0
        elif isinstance(other, QuadraticNumber):
            c, e, f = other._parts()
        else:
            return NotImplemented
        # The sign of a + b sqrt(d) - c - e sqrt(f).
        a, b, d = self._parts()
        a -= c
        one, last = _sign_of_sum(a, b, d), _sign(-e) if f else 0
        if one * last >= 0:
            return holds(one or last, 0)
        return holds(one * _sign_of_sum(a * a + b * b * d - e * e * f, 2 * a * b, d), 0)

    return compare


@dataclass(frozen=True, eq=False)
class QuadraticNumber:
    """An exact number, which is a root of a polynomial of degree 1 or 2 with integer coefficients.

    polynomial  a tuple of int: (a, b, c) of a x^2 + b x + c = 0, or (a, b) of a x + b = 0 if the number is rational;
                a is positive, and only 1 and -1 divide all of them
    root        1 for the greater root, -1 for the smaller one, 0 if the number is rational
    double      float, the nearest one, as float(number); infinite where it would overflow
    twice       float, the one nearest to twice the number: of a radius the diameter

    Comparisons are exact: with each other, and with int, Fraction, and float, which is the double that it is. Different
    numbers can have the same double.

    >>> [chamber] = pores([[2, 2, 2], [2, -2, -2], [-2, 2, -2], [-2, -2, 2]], radii=1).chambers
    >>> chamber.peak
    QuadraticNumber(polynomial=(1, 2, -11), root=1, double=2.4641016151377544)
    >>> chamber.gate < chamber.peak < Fraction("2.47"), chamber.peak == chamber.peak.double
    (True, False)
    """

    polynomial: Tuple[int, ...]
    root: int
    double: float
    twice: float = field(repr=False)

    def _parts(self) -> Tuple[Any, Any, Any]:
        """a, b and d of a + b sqrt(d)."""
        if self.root == 0:
            b, c = self.polynomial
            return Fraction(-c, b), 0, 0
        a, b, c = self.polynomial
        return Fraction(-b, 2 * a), self.root, Fraction(b * b - 4 * a * c, 4 * a * a)

    def __float__(self) -> float:
        return self.double

    def __hash__(self) -> int:
        return hash((self.polynomial, self.root) if self.root else self._parts()[0])

    __eq__ = _comparison(operator.eq)
    __lt__ = _comparison(operator.lt)
    __le__ = _comparison(operator.le)
    __gt__ = _comparison(operator.gt)
    __ge__ = _comparison(operator.ge)
