#!/usr/bin/env python3
"""The committed terms are those that src/ computes: same_terms.py PROGRAM FOLDER.

Runs PROGRAM into a folder of its own, and compares its files with those of FOLDER, to the byte. Exit status 1 where
they differ.
"""
import pathlib
import subprocess
import sys
import tempfile


def files_of(folder):
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}


def main():
    program, committed = sys.argv[1:]
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([program, made], check=True)
        here, there = files_of(committed), files_of(made)
    differing = sorted(name for name in here.keys() | there.keys() if here.get(name) != there.get(name))
    for name in differing:
        print(f'{committed}/{name} is not what src/ computes; {program} {committed} writes it', file=sys.stderr)
    return 1 if differing else 0


if __name__ == '__main__':
    sys.exit(main())
