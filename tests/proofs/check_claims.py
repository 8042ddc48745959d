#!/usr/bin/env python3
"""Lets the judge of spec/proofs/ say which records of a list are proved: check_claims.py BUILD POINTS CLAIMS.

The judge is built in BUILD/proofs/ if it is not there.
The points are a table of three columns, or an OBJ file. The claims are what `flowcert compute -o` writes, or another
claim that names contact sets (spec/formats/claims.md). A decimal is the number that it spells: there is no tolerance.
Proved is each record for itself: not that none is missing, and nothing of the header, of doubles or of orbits.
What has to be trusted is how this reads: from text to doubles, and from lines to records. weights.py is not trusted.
Exit status: 0 if all records are proved, 1 if some are not, 2 for what cannot be used.
"""
import argparse
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "spec"), str(ROOT / "tests" / "conformance")]
import weights
from proved_program import built
from read_claim import Unreadable, decompressed, read_claim
from stationary_points_from_spec import read_points

sys.set_int_max_str_digits(0)
OTHER_NUMBERS = ("the center is another", "the squared distance is another")


# ---- Reading


def rows_of(text):
    """FC-IN-01 to 05. What cannot be read raises ValueError or OverflowError."""
    lines = text.splitlines()
    if any(line.split()[:1] == ["v"] for line in lines):
        text = "\n".join(line.split(None, 1)[1] for line in lines if line.split()[:1] == ["v"])
    return read_points(text)


def sampled(data, number, seed):
    """The same lines, but of records only so many; those that are left out are empty lines."""
    lines = data.split(b"\n")
    filled = [k for k, line in enumerate(lines) if line.strip()]
    left_out = set(random.Random(seed).sample(filled[1:], max(0, len(filled) - 1 - number)))
    return b"\n".join(b"" if k in left_out else line for k, line in enumerate(lines))


def unjudged(point):
    """Why the judge cannot say anything of a claimed point, or None."""
    if not point.contact:
        return "it names no contact set"
    return "its distance is not squared" if point.distance else None


def numbers_of(point):
    return [*(point.center or []), *([point.squared] if point.squared else [])]


# ---- What the judge reads and says


def power_of_two(value):
    """Mantissa and exponent of a fraction whose denominator is a power of two; the mantissa is odd or zero."""
    zeros = (value.numerator & -value.numerator).bit_length() - 1 if value else 0
    return value.numerator >> zeros, zeros - (value.denominator.bit_length() - 1)


def spelled(numbers):
    return " ".join(format(x, "#x") for x in numbers)


def row_line(row):
    return spelled([x for value in row for x in power_of_two(value)])


def ratios(values):
    return spelled([x for value in values for x in (value.numerator, value.denominator)])


def record_line(point, found):
    """A line of the judge's input: the claimed point, and what was found for it."""
    kind = str(point.index) if point.hull is None else f"{point.index} {point.hull}"
    return ";".join([kind, spelled(point.contact), ratios([value for value, _ in point.center or []]),
                     ratios([point.squared[0]] if point.squared else []), spelled(found[0]), spelled(found[1])])


def found_for(point, rows):
    return weights.certificate([rows[k] for k in point.contact], point.index if point.hull else None)


def verdicts(judge, rows, lines):
    """What the judge says of each line."""
    with tempfile.TemporaryFile("w+") as said:
        with subprocess.Popen([judge], stdin=subprocess.PIPE, stdout=said, text=True) as running:
            running.stdin.write(f"{len(rows)}\n" + "".join(row_line(row) + "\n" for row in rows))
            for line in lines:
                running.stdin.write(line + "\n")
        said.seek(0)
        if running.returncode:
            raise RuntimeError("the judge failed")
        return said.read().splitlines()


def judged(judge, rows, points):
    """For each claimed point, "proved" or why it is not."""
    refused = [unjudged(point) for point in points]
    asked = [point for point, why in zip(points, refused) if not why]
    said = verdicts(judge, rows, (record_line(point, found_for(point, rows)) for point in asked))
    if len(said) != len(asked):
        raise RuntimeError("the judge did not answer")
    answers = iter(said)
    return [why or next(answers) for why in refused]


def options_of():
    parser = argparse.ArgumentParser(prog="./dev proofs --check", description=__doc__.partition(":")[0] + ".",
                                     usage="%(prog)s POINTS CLAIMS [--sample N] [--seed S]")
    parser.add_argument("build", help=argparse.SUPPRESS)
    parser.add_argument("points", metavar="POINTS", help="point file: rows of three numbers, or OBJ")
    parser.add_argument("claims", metavar="CLAIMS", help="what flowcert compute -o wrote for it, or another claim")
    parser.add_argument("--sample", type=int, metavar="N", help="draw so many records; all, without this")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="seed of the draw")
    options = parser.parse_args()
    if options.sample is not None and options.sample < 1:
        parser.error("--sample needs a number from 1")
    return options


def unusable(reason):
    print(f"./dev proofs: {reason}", file=sys.stderr)
    return 2


def main():
    options = options_of()
    try:
        rows = rows_of(decompressed(Path(options.points).read_bytes()).decode())
        data = decompressed(Path(options.claims).read_bytes())
        claim = read_claim(sampled(data, options.sample, options.seed) if options.sample else data, len(rows))
        if claim.head.get("points", len(rows)) != len(rows):
            return unusable(f"a list of {claim.head['points']:,} points, but {len(rows):,} points")
        judge = built("judge", options.build)
    except OSError as error:
        return unusable(f"{error.filename}: {error.strerror}")
    except subprocess.CalledProcessError as error:
        return unusable(f"the judge does not build: {error.stdout}")
    except (ValueError, OverflowError, Unreadable) as error:
        return unusable(error)
    points = claim.points
    try:
        said = judged(judge, rows, points)
    except (BrokenPipeError, RuntimeError):
        return unusable("the judge broke off")
    failed = [(point, why) for point, why in zip(points, said) if why != "proved"]
    for point, why in failed:
        near = why in OTHER_NUMBERS and any(not exact for _, exact in numbers_of(point))
        print(f"not proved: line {point.line}: {why}" + ", where decimals have no tolerance" * near)
    if failed:
        return 1
    regular = sum(point.hull is not None for point in points)
    placeless = sum(not point.center for point in points)
    print(f"proved: {len(points) - regular:,} critical, {regular:,} regular points of {options.claims}"
          + f"; of {placeless:,} it says no position" * bool(placeless))
    return 0


if __name__ == "__main__":
    sys.exit(main())
