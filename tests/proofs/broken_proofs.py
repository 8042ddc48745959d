#!/usr/bin/env python3
"""Proofs fail where the code would be wrong: broken_proofs.py COMPILED COMPILER [NAME…]

COMPILED is a folder in which the proofs were compiled (check_proofs.py leaves build/proofs). Each change below is made
to a copy of src/, and so is one of each proved constant to 1 % beyond what its proof needs. The terms are printed anew
from that copy, and one file of proofs is compiled with those that differ, which has to fail. Without a change none of
them may differ.
Exit status: 0; 1 where a proof still compiles.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOUNDS, GRID = "src/geometry/filter_bounds.h", "src/geometry/integer_grid.h"
PREDICATES, VECTORS = "src/geometry/predicates.h", "src/geometry/vector3.h"
FORMS, DISTANCES = "src/geometry/tetrahedron_forms.h", "src/geometry/distance_filter.h"
DOUBLED = "src/geometry/double_double.h"
DIRECTIONS, ACROSS = "src/flow/kernels/direction.h", "src/flow/kernels/direction_across.h"
DIRECTION_BOUNDS = "src/flow/kernels/direction_bounds.h"
CROSSING_SPHERE = "src/flow/kernels/crossing_sphere.h"

# NAME: the file, what the proof needs, the value 1 % beyond that (of bits, one more), and the file that fails.
CONSTANTS = [
    ("kUnitRoundoff", BOUNDS, "0x1p-53", "0.99 * 0x1p-53", "filters/Predicates.v"),
    ("kSmallestNorm", BOUNDS, "1e-42", "0.99e-42", "filters/Predicates.v"),
    ("kLargestNorm", BOUNDS, "1.001e42", "1.012e42", "filters/Predicates.v"),
    ("kAngleBound", BOUNDS, "5.001", "4.951", "filters/Predicates.v"),
    ("kOrientationBound", BOUNDS, "8.415", "8.331", "filters/Predicates.v"),
    ("kSideOfPlaneBound", BOUNDS, "19.829", "19.631", "filters/Predicates.v"),
    ("kOutsideSphereBound", BOUNDS, "17.415", "17.241", "filters/Predicates.v"),
    ("kOutsideCircleBound", BOUNDS, "22.829", "22.601", "filters/Predicates.v"),
    ("kCellAngleBound", BOUNDS, "28.001", "27.721", "filters/Cells.v"),
    ("kCellSideBound", BOUNDS, "19.829", "19.631", "filters/Cells.v"),
    ("kFarCellSideBound", BOUNDS, "27.902", "27.623", "filters/Cells.v"),
    ("kExactReach", BOUNDS, "305", "309", "filters/Exact.v"),
    ("kDistanceBound", BOUNDS, "10.04", "9.94", "filters/Distances.v"),
    ("kPositionBound", BOUNDS, "3.465", "3.43", "filters/Distances.v"),
    ("kDistanceUnderflow", BOUNDS, "4e-150", "3.96e-150", "filters/Distances.v"),
    ("kLargestDistance", BOUNDS, "2e151", "2.02e151", "filters/Distances.v"),
    ("kSmallBits", GRID, "18", "19", "widths/Widths.v"),
    ("kNarrowBits", GRID, "61", "62", "widths/Widths.v"),
    ("kWideBits", GRID, "83", "84", "widths/Widths.v"),
    ("kRoundoff", DOUBLED, "15 * 0x1p-106", "14.85 * 0x1p-106", "filters/DoubleDouble.v"),
    ("kSmallestSquare", DIRECTION_BOUNDS, "0.999e-50", "0.989e-50", "filters/Directions.v"),
    ("kLargestSquare", DIRECTION_BOUNDS, "1.001e50", "1.012e50", "filters/Directions.v"),
    ("kExitBound", DIRECTION_BOUNDS, "19.17", "18.978", "filters/DirectionSigns.v"),
    ("kNormalBound", DIRECTION_BOUNDS, "22.06", "21.839", "filters/DirectionSigns.v"),
    ("kOrderBound", DIRECTION_BOUNDS, "6.86", "6.791", "filters/DirectionOrder.v"),
    ("kOrderTurn", DIRECTION_BOUNDS, "0.25", "0.2475", "filters/DirectionOrder.v"),
    ("kLargestError", DIRECTION_BOUNDS, "0.0625", "0.0632", "filters/DirectionOfVector.v"),
    ("kTangentOfSine", DIRECTION_BOUNDS, "2", "1.98", "filters/DirectionOfVector.v"),
    ("kVertexStartBound", DIRECTION_BOUNDS, "21.5", "21.285", "filters/DirectionAtVertex.v"),
    ("kSideStartBound", DIRECTION_BOUNDS, "23.01", "22.779", "filters/DirectionAtSide.v"),
    ("kAngleFormBound", DIRECTION_BOUNDS, "1.3", "1.287", "filters/DirectionAtSide.v"),
    ("kCircleStartBound", DIRECTION_BOUNDS, "24", "23.76", "filters/DirectionOnCircle.v"),
    ("kExitBound", DIRECTION_BOUNDS, "19.3", "19.107", "filters/CrossingBehind.v"),
    ("kAngleFormBound", DIRECTION_BOUNDS, "1.6", "1.584", "filters/CrossingBehind.v"),
    ("kCrossingBound", DIRECTION_BOUNDS, "36.5", "36.135", "filters/CrossingBehind.v"),
    ("kTangentBehind", DIRECTION_BOUNDS, "6", "5.94", "filters/CrossingBehind.v"),
    ("kTangentBehind", DIRECTION_BOUNDS, "8", "8.08", "filters/CrossingBehind.v"),
    ("kHeightBound", DIRECTION_BOUNDS, "5.02", "4.97", "filters/CrossingInputs.v"),
    ("kAreaBound", DIRECTION_BOUNDS, "4.42", "4.376", "filters/CrossingInputs.v"),
    ("kGivenStartBound", DIRECTION_BOUNDS, "4", "3.96", "filters/DirectionGiven.v"),
    ("kCrossingSlack", DIRECTION_BOUNDS, "1.0001", "0.9901", "filters/CrossingPosition.v"),
    ("kExitBound", DIRECTION_BOUNDS, "19.4", "19.206", "filters/CrossingPosition.v"),
    ("kAngleFormBound", DIRECTION_BOUNDS, "1.31", "1.297", "filters/CrossingPosition.v"),
    ("kCoordinateBound", CROSSING_SPHERE, "1.01", "1", "filters/CrossingPosition.v"),
]
# NAME: the file, what is in it, what stands there instead, and the file that fails.
CHANGES = {
    "a sign of the cross product": (VECTORS, "u.y * v.z - u.z * v.y", "u.y * v.z + u.z * v.y", "filters/Predicates.v"),
    "the order of a dot product": (VECTORS, "u.x * v.x + u.y * v.y + u.z * v.z", "u.x * v.x + (u.y * v.y + u.z * v.z)",
                                   "filters/Predicates.v"),
    "a norm of the bound of an angle": (PREDICATES, "Number(kAngleBound * kUnitRoundoff) * n[0] * n[1]",
                                        "Number(kAngleBound * kUnitRoundoff) * n[0]", "filters/Predicates.v"),
    "a sign of the in-sphere polynomial": (PREDICATES, "determinant - dot(", "determinant + dot(",
                                           "filters/Predicates.v"),
    "the reach of a vector on a grid": (PREDICATES, "norm <= kLargestNorm && norm <= reach)", "norm <= kLargestNorm)",
                                        "filters/Unrounded.v"),
    "a factor of the distance's bound": (DISTANCES, "distance * (1 + ", "distance * (0 + ", "filters/Distances.v"),
    "a side of a cell (also in lanes)": (FORMS, "sphere.determinant * sphere.determinant - s1 - s2",
                                         "sphere.determinant * sphere.determinant - s1 + s2", "filters/Cells.v"),
    "an angle of a cell (also in lanes)": (FORMS, "(bc - ab) + (aa - ca)", "(bc - ab) - (aa - ca)", "filters/Cells.v"),
    "a sample's range (also in lanes)": (FORMS, "sphere.in_range & condition(norm >= kSmallestNorm)",
                                         "condition(norm >= kSmallestNorm)", "filters/Spheres.v"),
    "a sign of the error of a sum": (DOUBLED, "(a - (s - t)) + (b - t)", "(a - (s - t)) - (b - t)",
                                     "filters/DoubleDouble.v"),
    "a sign of the error of a product": (DOUBLED, "al * bh) + al * bl", "al * bh) - al * bl", "filters/DoubleDouble.v"),
    "a term of a product of doubled doubles": (DOUBLED, "(x.high_ * y.low_ + x.low_ * y.high_)", "x.high_ * y.low_",
                                               "filters/DoubleDouble.v"),
    "a sign of the order of exits (also in lanes)": (DIRECTIONS, "dot(x.u, i.g) - i.h", "dot(x.u, i.g) + i.h",
                                                     "filters/DirectionOrder.v"),
    "a factor of its bound (also in lanes)": (DIRECTIONS, "return Number(2) * part * part", "return part * part",
                                              "filters/DirectionOrder.v"),
    "an order of factors of its bound (also in lanes)": (
        DIRECTIONS, "factor * (i.squared_size * j.squared_size * (i.squared_size + j.squared_size))",
        "factor * i.squared_size * j.squared_size * (i.squared_size + j.squared_size)", "filters/DirectionOrder.v"),
    "a factor of the size of a bisector (also in lanes)": (
        DIRECTIONS, "Number(2) * (dot(a, a) + dot(b, b))", "(dot(a, a) + dot(b, b))", "filters/DirectionSigns.v"),
    "the roundoff of directions": (DIRECTION_BOUNDS, "kRoundoff = 0x1p-53;", "kRoundoff = 0.99 * 0x1p-53;",
                                   "filters/DirectionSigns.v"),
    "a sign of the projection": (DIRECTIONS, "(y - Number(dot(y, e) / ee) * e)", "(y + Number(dot(y, e) / ee) * e)",
                                 "filters/DirectionOfVector.v"),
    "a length that the bound of a vertex has": (DIRECTIONS, "(na + nb + nc + length(w0) + length(w1))",
                                                "(na + nb + nc + length(w0))", "filters/DirectionStarts.v"),
    "the side of a circle's centre": (DIRECTIONS, "Number(1), Number(-1))", "Number(-1), Number(1))",
                                      "filters/DirectionAtSide.v"),
    "a sign of the map of a crossing (also in lanes)": (ACROSS, "approach * way.drop + Number(2)",
                                                         "approach * way.drop - Number(2)", "filters/CrossingTerms.v"),
    "a factor of a crossing's determinant (also in lanes)": (ACROSS, "Number(4) * angle * height",
                                                              "Number(2) * angle * height", "filters/CrossingTerms.v"),
    "an association in a crossing's error (also in lanes)": (
        ACROSS, "(turn + norm) * x.error + rounding", "turn * x.error + (norm * x.error + rounding)",
        "filters/CrossingTerms.v"),
    "the sign of an area's rounding": (ACROSS, "cross(to_0, to_1)) - rounding", "cross(to_0, to_1)) + rounding",
                                       "filters/CrossingTerms.v"),
    "a range that a start at a circle needs": (
        DIRECTIONS, "Precision<Number>::is_in_range(aa) & Precision<Number>::is_in_range(bb)",
        "Precision<Number>::is_in_range(aa)", "filters/DirectionOnCircle.v"),
}


def changes():
    for name, path, needed, beyond, proof in CONSTANTS:
        yield f"{name}: {beyond} instead of {needed}", path, rf"\b{name} = [^;]*;", f"{name} = {beyond};", proof
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
