"""Whether critical points that somebody has computed are right."""

from typing import Any, Iterable, Optional

from . import _judge
from ._flow_complex import FlowComplex
from ._judge import CheckReport


def check(
    points: Any,
    claim: Any,
    *,
    tolerance: float = 1e-9,
    highest_level: int = 5,
    indices: Iterable[int] = (0, 1, 2, 3),
    threads: Optional[int] = None,
    unlimited: bool = False,
) -> CheckReport:
    """Whether critical points that you have computed are right, by exact arithmetic, and which are not.

    points: (n, 3), as FlowComplex takes them; or a FlowComplex.

    claim: one of these.

    - A list of dicts, one for each critical point, with the keys index (0 to 3; for a regular stationary point its
      kind, a pair), contact (rows of the points), center (three numbers), squared_distance, samples, limits. Needed
      are index, and contact or center. Integers, Fractions and strings, "1/3", are exact; floats are matched within
      the tolerance. All keys of a record of `flowcert compute -o` are known, so that json.loads of its line is one.
    - A structured array with index, center and, if it has them, squared_distance and kind; as critical_points. Those
      that have infinities, because a number overflowed, are refused; a list may have exact().
    - A str or a path: the name of a file of stationary points, as JSON Lines, CSV, VTP or Giesen and Kühne's text, or
      of pockets as JSON. `flowcert check` reads persistence diagrams, cycles and pores, too.
    - bytes, or an open file: the content of such a file.

    tolerance: floats match within this part of the critical point's radius; 0 to 0.001. Above 1e-6 there is a verdict
      on them, but no statement that they conform.
    highest_level: levels above this one are not checked; 1 to 5.
    indices: critical points of other indices are not judged.
    threads: as in FlowComplex; a FlowComplex has its own.
    unlimited: also read a compressed claim that grows to more than a hundred times its size; and as in FlowComplex.

    A claim that is wrong is no error; the report says so. One that cannot be read is a ValueError.

    >>> claim = [{"index": 0, "contact": [0]}, {"index": 0, "contact": [1]}, {"index": 1, "center": [1, 0, 0]}]
    >>> check([[0, 0, 0], [2, 0, 0]], claim).verdict
    'conforms'
    """
    # What is wrong with the options is said first.
    tolerance, highest_level, indices = _judge.options(tolerance, highest_level, indices)
    options = {"tolerance": tolerance, "highest_level": highest_level, "indices": indices, "unlimited": unlimited}
    if isinstance(points, FlowComplex):
        return points.check(claim, threads=threads, **options)
    return FlowComplex(points, threads=threads, unlimited=unlimited).check(claim, **options)
