"""Degenerate inputs, as `flowcert generate` draws them."""

import operator
from typing import Dict

import numpy as np
from numpy.typing import NDArray

from . import _core


def families() -> Dict[str, str]:
    """The families of degenerate inputs: name and description.

    >>> "lattice-2" in families()
    True
    """
    return _core.families()


def generate(family: str, seed: int = 1, *, level: int = 1, case: int = 0) -> NDArray[np.float64]:
    """Draws an input of a family: an (n, 3) array of doubles, the same on every machine.

    It is the case that ``flowcert generate --family FAMILY --seed SEED --level LEVEL --case CASE --xyz`` prints.

    family: a name of families(). seed: 0 to 2**64 - 1. level: 1 to 3; cases of level 1 have up to 8 points mostly,
    of level 2 up to 10, of level 3 up to 12, and some of them hundreds. case: 0 to 9,999,999; each is another input.

    >>> points = generate("lattice-2", seed=7)
    >>> FlowComplex(points).euler_sum
    1
    """
    seed, level, case = (operator.index(number) for number in (seed, level, case))
    if not 0 <= seed < 2**64:
        raise ValueError("seed must be from 0 to 2**64 - 1")
    if not 0 <= case < 2**63 or not 0 < level < 4:
        raise ValueError("level must be 1, 2 or 3, and case 0 to 9999999")
    try:
        return _core.generate(family, seed, level, case)
    except TypeError:
        raise ValueError("family must be a name of families()") from None
