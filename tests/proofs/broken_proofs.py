#!/usr/bin/env python3
"""Proofs fail where the code would be wrong: broken_proofs.py COMPILED COMPILER [NAME…]

COMPILED is a folder in which the proofs were compiled (check_proofs.py leaves build/proofs). Each change below is made
to a copy of src/, with 1 % beyond what is proved for a constant. The terms are printed anew from that copy, and one
file of proofs is compiled with those that differ, which has to fail. Without a change none of them may differ.
Exit status: 0; 1 where a proof still compiles.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOUNDS = "src/geometry/filter_bounds.h"
PREDICATES, VECTORS = "src/geometry/predicates.h", "src/geometry/vector3.h"
FORMS, DISTANCES = "src/geometry/tetrahedron_forms.h", "src/geometry/distance_filter.h"

# NAME: what the proof needs, the value 1 % beyond that, and the file that fails.
CONSTANTS = {
    "kUnitRoundoff": ("0x1p-53", "0.99 * 0x1p-53", "filters/Predicates.v"),
    "kSmallestNorm": ("1e-42", "0.99e-42", "filters/Predicates.v"),
    "kLargestNorm": ("1.001e42", "1.012e42", "filters/Predicates.v"),
    "kAngleBound": ("5.001", "4.951", "filters/Predicates.v"),
    "kOrientationBound": ("8.415", "8.331", "filters/Predicates.v"),
    "kSideOfPlaneBound": ("19.829", "19.631", "filters/Predicates.v"),
    "kOutsideSphereBound": ("17.415", "17.241", "filters/Predicates.v"),
    "kOutsideCircleBound": ("22.829", "22.601", "filters/Predicates.v"),
    "kCellAngleBound": ("28.001", "27.721", "filters/Cells.v"),
    "kCellSideBound": ("19.829", "19.631", "filters/Cells.v"),
    "kFarCellSideBound": ("27.902", "27.623", "filters/Cells.v"),
    "kExactReach": ("305", "309", "filters/Exact.v"),
    "kDistanceBound": ("10.04", "9.94", "filters/Distances.v"),
    "kPositionBound": ("3.465", "3.43", "filters/Distances.v"),
    "kDistanceUnderflow": ("4e-150", "3.96e-150", "filters/Distances.v"),
    "kLargestDistance": ("2e151", "2.02e151", "filters/Distances.v"),
}
# NAME: the file, what is in it, what stands there instead, and the file that fails.
CHANGES = {
    "a sign of the cross product": (VECTORS, "u.y * v.z - u.z * v.y", "u.y * v.z + u.z * v.y", "filters/Predicates.v"),
    "the order of a dot product": (VECTORS, "u.x * v.x + u.y * v.y + u.z * v.z", "u.x * v.x + (u.y * v.y + u.z * v.z)",
                                   "filters/Predicates.v"),
    "a norm of the bound of an angle": (PREDICATES, "Number(kAngleBound * kUnitRoundoff) * n[0] * n[1]",
                                        "Number(kAngleBound * kUnitRoundoff) * n[0]", "filters/Predicates.v"),
    "a sign of the in-sphere polynomial": (PREDICATES, "determinant - dot(", "determinant + dot(",
                                           "filters/Predicates.v"),
    "a factor of the distance's bound": (DISTANCES, "distance * (1 + ", "distance * (0 + ", "filters/Distances.v"),
    "a side of a cell (also in lanes)": (FORMS, "sphere.determinant * sphere.determinant - s1 - s2",
                                         "sphere.determinant * sphere.determinant - s1 + s2", "filters/Cells.v"),
    "an angle of a cell (also in lanes)": (FORMS, "(bc - ab) + (aa - ca)", "(bc - ab) - (aa - ca)", "filters/Cells.v"),
    "a sample's range (also in lanes)": (FORMS, "sphere.in_range & condition(norm >= kSmallestNorm)",
                                         "condition(norm >= kSmallestNorm)", "filters/Spheres.v"),
}


def changes():
    for name, (needed, beyond, proof) in CONSTANTS.items():
        yield f"{name}: {beyond} instead of {needed}", BOUNDS, rf"\b{name} = [^;]*;", f"{name} = {beyond};", proof
    for name, (path, old, new, proof) in CHANGES.items():
        yield name, path, re.escape(old), new.replace("\\", r"\\"), proof


def print_terms(tree, compiler, folder):
    program = tree / "terms"
    sources = sorted(str(path) for path in (tree / "tests" / "proofs").glob("*.cpp"))
    folders = [f"-I{tree}{part}" for part in ("", "/src", "/src/geometry/include", "/src/flow/include")]
    options = ["-std=c++20", "-O0", *folders, "-o", str(program), "-lfmt", "-lgmp"]
    subprocess.run([compiler, *sources, *options], check=True)
    subprocess.run([str(program), str(folder)], check=True)


def changed_terms(tree, compiler, folder):
    """Puts the terms of this tree into a folder of proofs, but for those that are there: their names."""
    differing = []
    with tempfile.TemporaryDirectory() as made:
        print_terms(tree, compiler, pathlib.Path(made))
        for path in pathlib.Path(made).iterdir():
            there = folder / "code" / "generated" / path.name
            if there.read_bytes() != path.read_bytes():
                shutil.copyfile(path, there)
                differing.append(path.name)
    return differing


def still_compiles(tree, compiler, compiled, proof):
    """Whether the proofs of a file hold with the terms of this tree (.vok). Other files' proofs are not tried."""
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made) / "proofs"
        subprocess.run(["cp", "-a", str(compiled), str(folder)], check=True)  # with the times of its files
        if not changed_terms(tree, compiler, folder):
            return True
        return subprocess.run(["make", proof + "ok"], cwd=folder, capture_output=True).returncode == 0


def main():
    compiled, compiler, *names = sys.argv[1:]
    still = []
    with tempfile.TemporaryDirectory() as made:
        tree = pathlib.Path(made)
        for part in ("src", "tests/proofs"):
            shutil.copytree(ROOT / part, tree / part)
        differing = changed_terms(tree, compiler, pathlib.Path(compiled))
        if differing:
            sys.exit(f"{compiled} was compiled with other terms: {', '.join(differing)}")
        for name, path, old, new, proof in changes():
            if names and not any(part in name for part in names):
                continue
            file = tree / path
            text = file.read_text()
            changed, count = re.subn(old, new, text)
            if count == 0:
                sys.exit(f"{name}: {path} has nothing to change")
            file.write_text(changed)
            if still_compiles(tree, compiler, compiled, proof):
                still.append(name)
            file.write_text(text)
            print(f"{'STILL COMPILES' if name in still else 'fails'}: {name} ({proof})", flush=True)
    return 1 if still else 0


if __name__ == "__main__":
    sys.exit(main())
