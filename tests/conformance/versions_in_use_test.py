#!/usr/bin/env python3
"""Which versions of other people's software this build uses, and that none is older than what is known to work.

usage: versions_in_use_test.py NAME=VERSION... [python=INTERPRETER]

Guarantees: prints a line for each of TRIED that the build has, with the oldest and the newest version that were tried;
NumPy and GUDHI are asked of the interpreter. Exit status: 0; 1 where a version is older, or where the compiler, CMake
or CGAL has none. A newer one is said to be, which is no fault.
"""
import re
import subprocess
import sys

# NAME: oldest, newest.
TRIED = {
    "GNU": ("12.2", "16.2"), "Clang": ("14.0", "19.1"), "CMake": ("3.25", "4.3"), "CGAL": ("5.5", "6.2"),
    "pybind11": ("2.10", "3.1"), "numpy": ("1.24", "2.4"), "gudhi": ("3.7", "3.13"),
}  # fmt: skip
ALWAYS_THERE = "CMake", "CGAL"


def parts(version):
    return [int(part) for part in re.findall(r"\d+", version)[:3]]


def verdict(name, version):
    oldest, newest = TRIED[name]
    if parts(version) < parts(oldest):
        return "TOO OLD"
    return "newer than tried" if parts(version)[:len(parts(newest))] > parts(newest) else "tried"


def asked_of(interpreter):
    found = {}
    for name in ("numpy", "gudhi"):
        asked = subprocess.run([interpreter, "-c", f"import {name}; print({name}.__version__)"], capture_output=True,
                               text=True, check=False)  # fmt: skip
        if asked.returncode == 0:
            found[name] = asked.stdout.strip()
    return found


def main():
    given = dict(argument.split("=", 1) for argument in sys.argv[1:])
    interpreter = given.pop("python", "")
    versions = {name: version for name, version in given.items() if version}
    versions.update(asked_of(interpreter) if interpreter else {})
    faults = [f"no version of {name}" for name in ALWAYS_THERE if name not in versions]
    if not {"GNU", "Clang"} & versions.keys():
        faults.append("no version of a known compiler")
    for name, version in versions.items():
        said = verdict(name, version)
        print(f"{name:9} {version:18} {said} ({TRIED[name][0]} to {TRIED[name][1]})")
        if said == "TOO OLD":
            faults.append(f"{name} {version} is older than what was tried")
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
