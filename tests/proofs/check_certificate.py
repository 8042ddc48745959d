#!/usr/bin/env python3
"""Lets the checker of spec/proofs/ say whether a certificate is right: check_certificate.py BUILD POINTS CERTIFICATE.

The checker is built in BUILD/proofs/ if it is not there.
The points are a table of three columns (.xyz) or doubles (.f64). The certificate is what `flowcert compute POINTS
--certificate FILE` writes, in binary. It holds for all points: the cells are a Delaunay triangulation, and so many
stationary points there are. It does not compare a list or the hash of the points, and computes no pairs.
It is slow: 400 points take ten seconds.
What has to be trusted is how checker_main.ml reads both files, and how it counts.
Exit status: 0 if the certificate is proved, 1 if it is rejected, 2 for what cannot be decoded or used.
"""
import argparse
import subprocess
import sys

sys.dont_write_bytecode = True
from proved_program import built


def options_of():
    parser = argparse.ArgumentParser(prog="./dev proofs --certificate", usage="%(prog)s POINTS CERTIFICATE",
                                     description=__doc__.partition(":")[0] + ".")
    parser.add_argument("build", help=argparse.SUPPRESS)
    parser.add_argument("points", metavar="POINTS", help="point file: rows of three numbers (.xyz), or doubles (.f64)")
    parser.add_argument("certificate", metavar="CERTIFICATE", help="what flowcert compute --certificate wrote for it")
    return parser.parse_args()


def main():
    options = options_of()
    try:
        checker = built("checker", options.build)
    except OSError as error:
        print(f"./dev proofs: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as error:
        print(f"./dev proofs: the checker does not build: {error.stdout}", file=sys.stderr)
        return 2
    status = subprocess.run([checker, options.points, options.certificate]).returncode
    return status if status in (0, 1) else 2


if __name__ == "__main__":
    sys.exit(main())
