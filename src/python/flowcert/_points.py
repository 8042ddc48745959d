"""Anything that has n rows of three numbers, as the array that the library takes.

No coordinate is ever rounded: what is no double is refused.
"""

import decimal
import numbers
import operator
import os

import numpy as np

from . import _exact

_LARGEST_EXACT = 2**53  # every integer up to this one is a double
_MOST_THREADS = 1024


@_exact.in_ieee_doubles
def point_rows(points):
    """The aligned (n, 3) array of doubles in C order; points itself where it is one."""
    return np.require(_float64(rows_of_three(points, "read_points({})")), requirements=["C", "A"])


def rows_of_three(points, reader):
    """The (n, 3) array, of any type. reader is what messages call for the name of a file."""
    if isinstance(points, (str, bytes, os.PathLike)):
        name = repr(os.fsdecode(points))
        raise TypeError(f"points is the name of a file, {name}: flowcert.{reader.format(name)} has its points")
    array = as_array(points, "points")
    if array.ndim == 2 and array.shape[1] == 2:
        raise ValueError("points must have three coordinates: numpy.insert(points, 2, 0, axis=1) makes their z 0")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points must have the shape (n, 3), not {array.shape}")
    return array


def as_array(values, name):
    if np.ma.is_masked(values):
        raise ValueError(f"{name} has masked values")
    if hasattr(values, "__array__"):
        return np.asarray(values)
    # NumPy would round integers in a list that has floats as well.
    return np.array(values, dtype=object)


def _float64(array):
    """The same numbers as doubles; the array itself where it has doubles."""
    kind = array.dtype.kind
    if kind == "f":
        return _from_floats(array)
    if kind in "iu":
        return _from_integers(array)
    if kind == "O":
        return _from_objects(array)
    raise ValueError(f"points must be real numbers, not of type {array.dtype}")


def _from_floats(array):
    if array.dtype.itemsize <= 8:
        return array.astype(np.float64, copy=False)
    with np.errstate(over="ignore"):  # a value beyond the doubles is refused below
        rounded = array.astype(np.float64)
    _refuse(array, (rounded != array) & ~np.isnan(array))
    return rounded


def _from_integers(array):
    doubles = array.astype(np.float64)
    if array.dtype.itemsize == 8 and array.size > 0 and np.abs(doubles).max() >= _LARGEST_EXACT:
        # An integer is a double iff no more than 53 bits are left without the zeros at its end.
        magnitude = np.where(array < 0, ~array.astype(np.uint64) + np.uint64(1), array.astype(np.uint64))
        lowest_bit = np.maximum(magnitude & (~magnitude + np.uint64(1)), np.uint64(1))
        _refuse(array, magnitude // lowest_bit > np.uint64(_LARGEST_EXACT))
    return doubles


def _from_objects(array):
    values = array.ravel().tolist()
    if set(map(type, values)) != {float}:
        values = [_double(value) for value in values]
    return np.array(values, dtype=np.float64).reshape(array.shape)


def _double(value):
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (numbers.Real, decimal.Decimal, np.floating)):
        raise ValueError(f"points must be real numbers, not {shown(value)}")
    try:
        double = float(value)
    except OverflowError:
        raise ValueError(f"{shown(value)} in points is beyond the largest double") from None
    if double != value and double == double:
        raise ValueError(f"{shown(value)} in points is not exactly a double")
    return double


def _refuse(array, is_wrong):
    if is_wrong.any():
        raise ValueError(f"{shown(array[is_wrong][0])} in points is not exactly a double")


def thread_count(threads):
    """As the library takes it: 0 are all cores."""
    if threads is None:
        return 0
    threads = operator.index(threads)
    if not 1 <= threads <= _MOST_THREADS:
        raise ValueError(f"threads must be from 1 to {_MOST_THREADS}")
    return threads


def shown(value):
    try:
        text = " ".join(str(value).split())  # of one line
    except ValueError:  # Python prints no integer of more than 4,300 digits
        return "a long integer"
    return text if len(text) <= 40 else f"{text[:20]}...{text[-10:]}"
