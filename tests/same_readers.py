#!/usr/bin/env python3
"""What the Python package reads from a file of points and says of them: ./dev same compares it for two versions.

usage: same_readers.py FILE

Guarantees: doubles are printed in hexadecimal, and rationals whole. Of at most 60 points all is printed: records,
pairs, surfaces, lines, orbits, volumes, λ-lists, connections and pockets. Exit status: 0; 2 if the file is refused.
"""
import dataclasses
import sys
import warnings
from fractions import Fraction

import flowcert
import numpy as np

MOST = 60
POSITION = (Fraction(1, 3), 0.2, Fraction(1, 7))


def plain(value):
    """The value in lists and texts alone, so that printing it hides nothing."""
    if dataclasses.is_dataclass(value):
        return [type(value).__name__, *([f.name, plain(getattr(value, f.name))] for f in dataclasses.fields(value))]
    if isinstance(value, np.ndarray):
        if value.dtype.names:
            return [[name, plain(value[name])] for name in value.dtype.names]
        return [str(value.dtype), list(value.shape), [plain(one) for one in value.ravel().tolist()]]
    if isinstance(value, float):
        return value.hex()
    if isinstance(value, dict):
        return [[plain(key), plain(one)] for key, one in value.items()]
    if isinstance(value, (tuple, list)):
        return [plain(one) for one in value]
    return value if isinstance(value, (int, bool, type(None))) else str(value)


def tell(name, value):
    print(name, plain(value))


def tell_complex(complex_):
    for name in ("stationary_points", "contacts", "counts", "regular_counts", "euler_sum", "volumes", "hull_volume",
                 "connections", "is_morse_smale"):
        tell(name, getattr(complex_, name))
    tell("persistence", complex_.persistence())
    tell("persistence_pairs", complex_.persistence_pairs(zero=True))
    tell("stable_surfaces", complex_.stable_surfaces())
    tell("surface", complex_.surface())
    tell("unstable_lines", complex_.unstable_lines())
    tell("orbit", complex_.orbit(POSITION))
    tell("locate", complex_.locate([[0.3, 0.2, 0.1]]))
    tell("pockets", complex_.pockets())
    for i, record in enumerate(complex_.stationary_points):
        tell(f"exact {i}", complex_.exact(i))
        for name in ("lambda_list", "unstable_surface", "shares", "volume"):
            try:
                tell(f"{name} {i}", getattr(complex_, name)(i))
            except (ValueError, IndexError) as error:
                tell(f"{name} {i}", f"{type(error).__name__}: {error}")


def main():
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        try:
            for skips in (False, True):
                tell("points", flowcert.read_points(sys.argv[1], skip_invalid=skips, return_left_out=True,
                                                    return_atoms=True))
            points = flowcert.read_points(sys.argv[1])
        except ValueError as error:
            print(error)
            return 2
        finally:
            for note in notes:
                print("note:", note.message)
    if len(points) <= MOST:
        tell_complex(flowcert.FlowComplex(points))
    return 0


if __name__ == "__main__":
    sys.exit(main())
