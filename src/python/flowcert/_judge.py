"""Whether critical points that somebody has computed are right."""

import json
import operator
import os
import re
from dataclasses import dataclass
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Dict, Iterable, Optional, Tuple

import numpy as np

from . import _core, _exact
from ._read_points import file_name

_HEADER = {"format": "flowcert-stationary-points", "format_version": 1}
_INTEGERS = ("index", "contact", "samples", "limits")
_NUMBERS = ("center", "squared_distance", "volume")
# What a record of the exchange format may have besides: such a line, parsed, is a record here.
_MORE = (
    "kind", "center_double", "squared_distance_double", "volume_double", "u2", "stable", "skeleton", "surface",
    "shares", "shares_double", "lambda", "connections", "u1",
)  # fmt: skip
_KEYS = _INTEGERS + _NUMBERS + _MORE


@dataclass(frozen=True)
class Finding:
    """What is wrong with a claim, or how it varies where it may.

    level      1 well formed; 2 what is claimed is critical; 3 nothing missing, nothing twice; 4 incidences; 5 geometry
    reason     a word or two with hyphens: "missing", "wrong-index"
    permitted  whether it is a variation that does not make the claim wrong
    decided    False for a variation of which only necessary conditions are known to hold
    clause     of the specification: "FC-CRIT-05 (b)"
    record     the place in the claim, from 0, if the claim is a list or an array and has it; or None
    line       the line of the claim, from 1, if the claim is a file and has it; or None
    contact    rows of the points: the contact set as claimed, or as it is if the point is missing
    claimed    what is claimed, in words
    truth      what is true, in words
    sentence   what is wrong, in a plain sentence or two, and whether it is a bug or a convention
    """

    level: int
    reason: str
    permitted: bool
    decided: bool
    clause: str
    record: Optional[int]
    line: Optional[int]
    contact: Tuple[int, ...]
    claimed: str
    truth: str
    sentence: str

    def __str__(self) -> str:
        place = "claim"
        if self.record is not None:
            place = f"claim[{self.record}]"
        elif self.line is not None:
            place = f"claim:{self.line}"
        word = "wrong" if not self.permitted else "permitted" if self.decided else "not decided"
        return (
            f"{place}: {word}, level {self.level}: {self.reason} [{self.clause}]: claimed {self.claimed}; "
            f"truth: {self.truth}"
        )


@dataclass(frozen=True)
class CheckReport:
    """What a claim is worth. print(report) tells it line by line.

    verdict         "conforms", "conforms where determined", "perturbed" (some of it is what a perturbation of the
                    points makes), or "fails"
    is_exact        False if decimals were claimed, which are matched within the tolerance
    parts           what the claim tells of the flow complex and was judged on, such as ("points", "U2")
    statement       "conforms to 1.2, points + U2, exact" (FC-CLAIM-22), or of decimals "approximate within 1e-09";
                    None if no part is told, or if decimals were judged with a tolerance above 1e-6
    claimed_counts  of critical points of index 0 to 3, as listed in the claim
    true_counts     as they are; zeros if only level 1 was checked
    levels          {1: ..., 5: ...}: whether each conforms; None where nothing is claimed that it could judge
    not_judged      what is claimed and was not judged, in words
    not_decided     what was judged by necessary conditions alone, in words
    findings        a tuple of Finding, by level, then by place in the claim
    """

    verdict: str
    is_exact: bool
    parts: Tuple[str, ...]
    statement: Optional[str]
    claimed_counts: Tuple[int, int, int, int]
    true_counts: Tuple[int, int, int, int]
    levels: Dict[int, Optional[bool]]
    not_judged: Tuple[str, ...]
    not_decided: Tuple[str, ...]
    findings: Tuple[Finding, ...]

    @property
    def fails(self) -> bool:
        """Whether anything is wrong, as the exit status 1 of `flowcert check` says."""
        return self.verdict == "fails"

    def __str__(self) -> str:
        lines = [str(finding) for finding in self.findings]
        lines += [f"not judged: {what}" for what in self.not_judged]
        lines += [f"not decided: {what}" for what in self.not_decided]
        return "\n".join([*lines, f"{self.verdict} ({'exact' if self.is_exact else 'approximate'})"])


def check(core, claim, *, tolerance=1e-9, highest_level=5, indices=(0, 1, 2, 3), threads=None, unlimited=False):
    """The report on a claim about the points of a complex of the library."""
    numbers = options(tolerance, highest_level, indices)
    if threads is not None:
        raise ValueError("threads must be given to the FlowComplex, which has its own")
    text, is_path, is_list = _text_of(claim)
    try:
        answer = _core.check(core, text, is_path, *numbers, bool(unlimited))
    except ValueError as error:
        raise ValueError(_with_record(str(error)) if is_list else str(error)) from None
    return _report(answer, is_list)


@_exact.in_ieee_doubles
def options(tolerance, highest_level, indices):
    """The same as numbers that the library takes, which says what range the tolerance has."""
    try:
        tolerance = float(tolerance)
    except (OverflowError, TypeError, ValueError):
        raise ValueError("tolerance must be from 0 to 0.001") from None
    highest_level = _whole(highest_level, range(1, 6), "highest_level must be an integer from 1 to 5")
    refusal = "indices must be integers from 0 to 3"
    try:
        indices = list(indices)
    except TypeError:
        raise ValueError(refusal) from None
    return tolerance, highest_level, [_whole(index, range(4), refusal) for index in indices]


def _whole(value, allowed, refusal):
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(refusal) from None
    if number not in allowed:
        raise ValueError(refusal)
    return number


def _with_record(message):
    """The header that a list gets is line 1."""
    return re.sub(r"^claim:(\d+):", lambda match: f"claim[{int(match[1]) - 2}]:", message)


def _report(answer, is_list):
    findings = []
    for fields in answer.pop("findings"):
        line = fields.pop("line")
        record = line - 2 if is_list and line is not None and line > 1 else None
        contact = tuple(fields.pop("contact"))
        findings.append(Finding(record=record, line=None if is_list else line, contact=contact, **fields))
    levels = dict(enumerate(answer.pop("levels"), 1))
    for key in ("not_judged", "not_decided"):
        answer[key] = tuple(answer[key])
    return CheckReport(levels=levels, findings=tuple(findings), **answer)


# ---- Claims as text


@_exact.in_ieee_doubles
def _text_of(claim):
    """(text or path, whether it is a path, whether a list was written as text)"""
    if isinstance(claim, (str, os.PathLike)):
        return file_name(claim), True, False
    if hasattr(claim, "read"):
        claim = claim.read()
        claim = claim.encode() if isinstance(claim, str) else claim
    if isinstance(claim, (bytes, bytearray, memoryview)):
        return bytes(claim), False, False
    if isinstance(claim, (np.ndarray, np.void)) and claim.dtype.names:
        records = map(_row, np.atleast_1d(claim))
    elif isinstance(claim, Iterable) and not isinstance(claim, (dict, np.ndarray)):
        records = claim
    else:
        raise ValueError("claim must be a list of dicts, a structured array, the name of a file, or its content")
    lines = [json.dumps(_HEADER)]
    lines += [_line(record, place) for place, record in enumerate(records)]
    return "\n".join(lines).encode() + b"\n", False, True


def _row(row):
    """A row of a structured array as a dict. A regular stationary point has the index -1 and a kind."""
    fields = {name: row[name] for name in row.dtype.names if name in ("index", "center", "squared_distance")}
    if fields.get("index") == -1 and "kind" in row.dtype.names:
        fields["index"] = row["kind"]
    return fields


def _line(record, place):
    if not hasattr(record, "items"):
        raise ValueError(f"claim[{place}] must be a dict")
    fields = {}
    for key, value in record.items():
        if key in _INTEGERS:
            value = _integer(value, place)
        elif key in _NUMBERS:
            value = _number(value, place)
        elif key not in _KEYS:
            raise ValueError(f"claim[{place}] has the key {key!r}; the keys are {', '.join(_KEYS)}")
        fields[key] = value
    try:
        return json.dumps(fields)
    except (TypeError, ValueError) as error:
        raise ValueError(f"claim[{place}]: {error}") from None


def _plain(value):
    """Arrays and tuples as lists, NumPy's numbers as Python's."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    return list(value) if isinstance(value, tuple) else value


def _number(value, place):
    """Exact numbers become strings, as the format has them, and strings stay; floats stay decimals."""
    value = _plain(value)
    if isinstance(value, list):
        return [_number(each, place) for each in value]
    if isinstance(value, str):
        return value
    if isinstance(value, Rational) and not isinstance(value, bool):
        return _exact.decimal(Fraction(value))
    if isinstance(value, Real) and not isinstance(value, bool) and abs(float(value)) < float("inf"):
        return float(value)
    raise ValueError(f"claim[{place}]: center, squared_distance and volume must be finite numbers, not {value!r}")


def _integer(value, place):
    value = _plain(value)
    if value is None:
        return None  # a limit at infinity
    if isinstance(value, (list, set, frozenset, range)):
        return [_integer(each, place) for each in value]
    if isinstance(value, Integral) and not isinstance(value, bool):
        return int(value)
    raise ValueError(f"claim[{place}]: an index or a row must be an integer, not {value!r}")
