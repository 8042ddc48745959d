"""What `flowcert compute --export` writes, opened by VTK itself (src/cli/manual/exports.md).

usage: vtk_exports_test.py FLOWCERT

Every position and value has to be the double nearest to the exact one of the records of the same run, to the bit;
arrays their names and types; counts those of the summary; and vertices of surfaces one iff their exact positions are.
Where orbits leave the box is computed again, in rationals. The cells of each stable set have its volume, by VTK's own
sums, and fans the limits of λ-lists. The two triangles at a manifold edge go along it in opposite directions, unless a
search of all ways to turn the component finds none.
"""
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction

from vtkmodules import vtkCommonCore as core
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

SIGNED_CHAR, INT64, DOUBLE = "Int8", "Int64", "Float64"
POINT_ARRAYS = {"CellDimension": SIGNED_CHAR, "CellId": INT64, "CriticalType": SIGNED_CHAR, "FaceDimension": SIGNED_CHAR,
                "IsRegular": SIGNED_CHAR, "SquaredDistance": DOUBLE}
SEPARATRIX_ARRAYS = {"SourceId": INT64, "SeparatrixId": INT64, "SeparatrixType": SIGNED_CHAR,
                     "SeparatrixFunctionMaximum": DOUBLE, "SeparatrixFunctionMinimum": DOUBLE,
                     "SeparatrixFunctionDifference": DOUBLE}
LINE_ARRAYS = dict(SEPARATRIX_ARRAYS, DestinationId=INT64, Side=SIGNED_CHAR, ToInfinity=SIGNED_CHAR)
SURFACE_ARRAYS = dict(SEPARATRIX_ARRAYS, HasInterval=SIGNED_CHAR)


def random_points(seed, count):
    numbers = random.Random(seed)
    return [tuple(numbers.random() for _ in range(3)) for _ in range(count)]


INPUTS = {
    "empty": [],
    "one": [(1, 2, 3)],
    "two": [(1, 2, 3), (0.1, 0.2, 0.3)],
    "collinear": [(0, 0, 0), (1, 1, 1), (3, 3, 3), (3, 3, 3)],
    "coplanar": [(0, 0, 0), (4, 0, 0), (1, 3, 0), (5, 3.5, 0), (9, 0, 0)],
    "right triangle": [(0, 0, 0), (3, 0, 0), (0, 4, 0)],
    "lattice": [(x, y, z) for x in range(3) for y in range(3) for z in range(3)],
    "kind 1-3": [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, 1)],
    # Surfaces with parts of dimension 3.
    "interval": [(-2, 0, 0), (2, 0, 0), (0, -1, 1), (0, -1, -1), (0, 5, 0)],
    # Positions that differ by less than doubles there can tell.
    "far": [tuple(2.0**53 + 2 * random.Random(100 * k + i).randrange(4) for i in range(3)) for k in range(12)],
    "subnormal": [(5e-324, -5e-324, -2e-323), (1e-323, 0, -1.5e-323), (1e-323, 5e-324, -2.5e-323), (0, 0, -2e-323),
                  (0, 5e-324, -1.5e-323)],
    "random": random_points(1, 60),
    "flat": [(x, y, 0.0) for x, y, _ in random_points(2, 30)],
}


class Faults:
    def __init__(self):
        self.found, self.checks = [], 0

    def expect(self, is_right, what):
        self.checks += 1
        if not is_right:
            self.found.append(what)


def nearest(text):
    value = Fraction(text)
    return value.numerator / value.denominator + 0.0  # Python rounds this correctly; no negative zero


def rounded(position):
    return tuple(nearest(text) for text in position)


def bits(position):
    return struct.pack("<3d", *position)


def read(path, reader, faults):
    problems = []
    reader.AddObserver("ErrorEvent", lambda *_: problems.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: problems.append("warning"))
    reader.SetFileName(path)
    reader.Update()
    faults.expect(not problems and reader.GetErrorCode() == 0, f"VTK cannot read {os.path.basename(path)}: {problems}")
    return reader.GetOutput()


def arrays_of(data, expected, count, faults):
    """The named arrays as lists, when names and types are those expected."""
    names = {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}
    faults.expect(names == set(expected), f"arrays {sorted(names)}")
    result = {}
    for name, wanted in expected.items():
        array = data.GetArray(name)
        kind = {core.VTK_SIGNED_CHAR: SIGNED_CHAR, core.VTK_DOUBLE: DOUBLE, core.VTK_LONG: INT64,
                core.VTK_LONG_LONG: INT64}.get(array.GetDataType())
        faults.expect(kind == wanted, f"{name} is {array.GetDataTypeAsString()}")
        faults.expect(array.GetNumberOfTuples() == count and array.GetNumberOfComponents() == 1, f"size of {name}")
        result[name] = [array.GetTuple1(k) for k in range(array.GetNumberOfTuples())]
    return result


def points_of(poly_data, faults):
    points = poly_data.GetPoints()
    faults.expect(points is None or points.GetDataType() == core.VTK_DOUBLE, "positions are no doubles")
    positions = [poly_data.GetPoint(k) for k in range(poly_data.GetNumberOfPoints())]
    faults.expect(all(math.isfinite(x) for position in positions for x in position), "a position is infinite")
    return positions


def cells_of(poly_data, point_count, faults):
    cells = []
    for k in range(poly_data.GetNumberOfCells()):
        ids = poly_data.GetCell(k).GetPointIds()
        cells.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
    faults.expect(all(0 <= id < point_count for cell in cells for id in cell), "a cell has an id out of range")
    return cells


def check_critical_points(poly_data, records, faults):
    positions = points_of(poly_data, faults)
    faults.expect(len(positions) == len(records) == poly_data.GetNumberOfVerts() == poly_data.GetNumberOfCells(),
                  "count of stationary points")
    faults.expect(cells_of(poly_data, len(positions), faults) == [[k] for k in range(len(records))], "vertices")
    arrays = arrays_of(poly_data.GetPointData(), POINT_ARRAYS, len(records), faults)
    for k, (record, position) in enumerate(zip(records, positions)):
        is_regular = record["kind"] == "regular"
        face, hull = record["index"] if is_regular else (record["index"], record["index"])
        faults.expect(bits(position) == bits(record["center_double"]) == bits(rounded(record["center"])), f"centre {k}")
        expected = {"CellId": k, "CellDimension": hull, "FaceDimension": face, "IsRegular": int(is_regular),
                    "CriticalType": 5 if is_regular else face, "SquaredDistance": record["squared_distance_double"]}
        faults.expect({name: values[k] for name, values in arrays.items()} == expected, f"arrays of record {k}")


def check_function(arrays, k, minimum, maximum, what, faults):
    """Squared distances, exact; None is infinite."""
    faults.expect(arrays["SeparatrixType"][k] == 2, f"type of {what}")
    faults.expect(arrays["SeparatrixFunctionMinimum"][k] == nearest(minimum), f"minimum of {what}")
    wanted = (math.inf, math.inf) if maximum is None else (nearest(maximum), nearest(Fraction(maximum) - Fraction(minimum)))
    faults.expect((arrays["SeparatrixFunctionMaximum"][k], arrays["SeparatrixFunctionDifference"][k]) == wanted,
                  f"maximum or difference of {what}")


def squared_distance(position, samples):
    return min(sum((Fraction(x) - y) ** 2 for x, y in zip(position, sample)) for sample in samples)


def box_of(points, factor):
    """The sides of the box, low and high of each axis, as doubles."""
    lows, highs = ([choose(axis) for axis in zip(*points)] for choose in (min, max))
    longest = max(high - low for low, high in zip(lows, highs))
    sides = []
    for low, high in zip(lows, highs):
        half = factor * ((high - low) or longest) / 2
        sides.append(tuple(Fraction(float((low + high) / 2 + way * half)) for way in (-1, 1)))
    return sides


def is_inside(position, box):
    return all(low <= Fraction(x) <= high for x, (low, high) in zip(position, box))


def normal_of(record, samples):
    """To side 1 of a critical point of index 2."""
    a, b, c = (samples[name] for name in record["contact"][:3])
    u, v = ([y - x for x, y in zip(a, other)] for other in (b, c))
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def last_direction(record, side, samples):
    """Of an orbit to infinity, as doubles: the largest coordinate is 1."""
    segments = record["u2"][side]
    if len(segments) == 1:
        way = [(1 if side else -1) * x for x in normal_of(record, samples)]
    else:
        way = [Fraction(x) - Fraction(d) for x, d in zip(segments[-2]["end"], segments[-1]["driver"])]
    largest = max(map(abs, way))
    return [Fraction(float(x / largest)) for x in way]


def clipped(record, side, exact, samples, box):
    """The positions of an orbit to infinity that ends where it leaves the box."""
    points = [rounded(p) for p in exact]
    kept = next((k for k, p in enumerate(points) if not is_inside(p, box)), len(points))
    start = [Fraction(x) for x in points[kept - 1]]
    way = last_direction(record, side, samples) if kept == len(points) else \
        [Fraction(x) - y for x, y in zip(points[kept], start)]
    length = min(((high if w > 0 else low) - x) / w for x, w, (low, high) in zip(start, way, box) if w != 0)
    end = tuple(float(x + length * w) + 0.0 for x, w in zip(start, way))
    return points[:kept] + ([end] if end != points[kept - 1] else [])


def check_lines(poly_data, records, summary, samples, factor, faults):
    """factor: of the box; None where nothing is cut. Returns the places at which orbits are cut, in words."""
    positions, seen = points_of(poly_data, faults), set()
    cells = cells_of(poly_data, len(positions), faults)
    faults.expect(len(cells) == summary["u2"]["orbits"] == 2 * summary["critical"][2], "count of orbits")
    arrays = arrays_of(poly_data.GetCellData(), LINE_ARRAYS, len(cells), faults)
    box = box_of(samples, factor) if factor and samples else None
    wanted = {"SquaredDistance": DOUBLE} if box is None else {"IsClipped": SIGNED_CHAR, "SquaredDistance": DOUBLE}
    point_arrays = arrays_of(poly_data.GetPointData(), wanted, len(positions), faults)
    distances = point_arrays["SquaredDistance"]
    faults.expect(sum(arrays["ToInfinity"]) == summary["u2"]["to_infinity"], "count of orbits to infinity")
    faults.expect(poly_data.GetNumberOfVerts() == sum(len(cell) == 1 for cell in cells), "count of orbits without a line")
    saddles = [k for k, record in enumerate(records) if record["index"] == 2]
    faults.expect(sorted(zip(arrays["SourceId"], arrays["Side"])) == [(s, side) for s in saddles for side in (0, 1)],
                  "sources and sides")
    by_contact = {tuple(record["contact"]): k for k, record in enumerate(records)}
    for k, cell in enumerate(cells):
        source, side = int(arrays["SourceId"][k]), int(arrays["Side"][k])
        record, what = records[source], f"orbit {source}, {side}"
        limit = record["limits"][side]
        destination = -1 if limit is None else by_contact[tuple(limit)]
        faults.expect(arrays["SeparatrixId"][k] == 2 * saddles.index(source) + side, f"id of {what}")
        faults.expect((arrays["DestinationId"][k], arrays["ToInfinity"][k]) == (destination, int(limit is None)),
                      f"destination of {what}")
        check_function(arrays, k, record["squared_distance"],
                       None if limit is None else records[destination]["squared_distance"], what, faults)
        exact = [record["center"]] + [segment["end"] for segment in record["u2"][side] if segment["end"]]
        is_cut = box is not None and limit is None
        expected = clipped(record, side, exact, samples, box) if is_cut else [rounded(p) for p in exact]
        faults.expect([bits(positions[id]) for id in cell] == [bits(p) for p in expected], f"positions of {what}")
        whole = len(cell) - (1 if is_cut and len(cell) > 1 else 0)
        squared = [nearest(squared_distance(p, samples)) for p in exact[:whole]]
        squared += [nearest(squared_distance(positions[id], samples)) for id in cell[whole:]]
        faults.expect([distances[id] for id in cell] == squared, f"distances of {what}")
        if box is None:
            continue
        marks = [point_arrays["IsClipped"][id] for id in cell]
        faults.expect(marks == [0] * (len(cell) - 1) + [int(is_cut)], f"marks of {what}")
        faults.expect(all(is_inside(positions[id], box) for id in cell), f"{what} leaves the box")
        if is_cut:
            seen.add("cut in its last segment" if len(expected) > len(exact) else
                     "cut before its last segment" if len(expected) > 1 else "cut where it starts")
    return seen


def exact_triangles(record, points):
    """The triangles of a skeleton, as sets of three exact positions."""
    for segment in record["skeleton"]["segments"]:
        for sample in segment["samples"]:
            yield frozenset([tuple(map(Fraction, points[sample])), tuple(map(Fraction, segment["front"])),
                             tuple(map(Fraction, segment["back"]))])


def check_surfaces(poly_data, records, summary, points, faults):
    positions = points_of(poly_data, faults)
    cells = cells_of(poly_data, len(positions), faults)
    faults.expect(poly_data.GetNumberOfPolys() == len(cells) and all(len(cell) == 3 for cell in cells), "not all triangles")
    arrays = arrays_of(poly_data.GetCellData(), SURFACE_ARRAYS, len(cells), faults)
    faults.expect(arrays["HasInterval"].count(0) == summary["s2"]["triangles"], "count of triangles")
    found, exact, vertices = Counter(), Counter(), Counter()
    saddles = [k for k, record in enumerate(records) if record["index"] == 2]
    for k, cell in enumerate(cells):
        source = int(arrays["SourceId"][k])
        record = records[source]
        faults.expect(arrays["SeparatrixId"][k] == saddles.index(source), f"id of triangle {k}")
        faults.expect(arrays["HasInterval"][k] == record["stable"]["has_interval"], f"flag of triangle {k}")
        check_function(arrays, k, "0", record["squared_distance"], f"triangle {k}", faults)
        found[(source, *sorted(bits(positions[id]) for id in cell))] += 1
    for source in saddles:
        for triangle in exact_triangles(records[source], points):
            vertices.update(triangle)
            exact[(source, *sorted(bits(rounded(p)) for p in triangle))] += 1
    faults.expect(found == exact, "triangles are not those of the skeletons")
    squared = {p: nearest(squared_distance(p, points)) for p in vertices}
    distances = arrays_of(poly_data.GetPointData(), {"SquaredDistance": DOUBLE}, len(positions), faults)["SquaredDistance"]
    faults.expect(Counter((bits(p), d) for p, d in zip(positions, distances)) ==
                  Counter((bits(rounded(p)), d) for p, d in squared.items()), "vertices are not those of the skeletons")
    degrees = Counter(id for cell in cells for id in cell)
    faults.expect(sorted((bits(positions[id]), n) for id, n in degrees.items()) ==
                  sorted((bits(rounded(p)), n) for p, n in vertices.items()), "vertices are not shared as exactly equal")
    return positions, cells


def check_orientation(cells, faults):
    """Returns the number of components without orientation."""
    uses = {}
    for k, cell in enumerate(cells):
        for a, b in zip(cell, cell[1:] + cell[:1]):
            uses.setdefault(frozenset((a, b)), []).append((k, a < b))
    neighbours = {}
    for (first, *others) in uses.values():
        for (k, up), (m, other_up) in ([(first, others[0]), (others[0], first)] if len(others) == 1 else []):
            neighbours.setdefault(k, []).append((m, up == other_up))
    turned, without = {}, 0
    for start in range(len(cells)):
        if start in turned:
            continue
        turned[start], todo, component, can = False, [start], [start], True
        while todo:
            k = todo.pop()
            for m, is_other_way in neighbours.get(k, []):
                if m not in turned:
                    turned[m] = turned[k] != is_other_way
                    todo.append(m)
                    component.append(m)
                can = can and turned[m] == (turned[k] != is_other_way)
        without += not can
        faults.expect(not can or not any(turned[k] for k in component), f"triangles from {start} on are not oriented")
    return without


def check_ply(poly_data, positions, cells, faults):
    """VTK keeps a PLY file's coordinates as floats."""
    faults.expect(poly_data.GetNumberOfPoints() == len(positions), "vertices of the PLY file")
    as_floats = [struct.unpack("<3f", struct.pack("<3f", *position)) for position in positions]
    faults.expect([poly_data.GetPoint(k) for k in range(poly_data.GetNumberOfPoints())] == as_floats, "PLY positions")
    faults.expect(cells_of(poly_data, len(positions), faults) == cells, "triangles of the PLY file")


def signed_volume(corners):
    """Of a tetrahedron, or of a pyramid over a quadrangle. Positive in VTK's orientation."""
    *base, apex = corners
    total = 0.0
    for second, third in zip(base[1:], base[2:]):
        a, b, c = ([x - y for x, y in zip(corner, base[0])] for corner in (second, third, apex))
        total += (c[0] * (a[1] * b[2] - a[2] * b[1]) + c[1] * (a[2] * b[0] - a[0] * b[2]) +
                  c[2] * (a[0] * b[1] - a[1] * b[0])) / 6
    return total


def check_cells(grid, records, points, is_exact, faults):
    """Returns whether there is a pyramid over a quadrangle."""
    positions = points_of(grid, faults)
    cells = cells_of(grid, len(positions), faults)
    wanted = {"maximum": INT64, "sample": INT64, "volume": DOUBLE}
    arrays = arrays_of(grid.GetCellData(), wanted, len(cells), faults)
    measured = vtkCellSizeFilter()
    measured.SetInputData(grid)
    measured.Update()
    sizes = measured.GetOutput().GetCellData().GetArray("Volume")
    by_vtk, by_corners = Counter(), Counter()
    for k, cell in enumerate(cells):
        kind = {4: 10, 5: 14}.get(len(cell))  # VTK_TETRA, VTK_PYRAMID
        faults.expect(grid.GetCellType(k) == kind, f"type of cell {k}")
        record, sample = int(arrays["maximum"][k]), int(arrays["sample"][k])
        faults.expect(arrays["volume"][k] == records[record]["volume_double"], f"volume of cell {k}")
        faults.expect(bits(positions[cell[-1]]) == bits(rounded(points[sample])), f"apex of cell {k}")
        volume = signed_volume([positions[id] for id in cell])
        faults.expect(volume > 0 or not is_exact, f"cell {k} has volume {volume}")
        by_corners[record] += volume
        by_vtk[record] += sizes.GetTuple1(k)
    for record, fields in enumerate(records):
        volume = fields["volume_double"]
        # A volume below the doubles is 0.
        faults.expect((volume > 0) <= (record in by_vtk) and (not is_exact or (volume > 0) == (record in by_vtk)),
                      f"set of record {record}")
        for total in (by_vtk[record], by_corners[record]) if is_exact else ():
            faults.expect(abs(total - volume) <= 1e-9 * volume, f"volume of record {record}: {total}, not {volume}")
    faults.expect(not is_exact or len(set(positions)) == len(positions), "points of cells are not shared")
    return any(len(cell) == 5 for cell in cells)


def check_fans(poly_data, records, is_exact, faults):
    positions = points_of(poly_data, faults)
    cells = cells_of(poly_data, len(positions), faults)
    data = poly_data.GetCellData()
    faults.expect(data.GetNumberOfArrays() == 3 and poly_data.GetNumberOfPolys() == len(cells), "fans")
    limits, samples, sources = (data.GetArray(name) for name in ("limit", "samples", "source"))
    faults.expect(samples.GetNumberOfComponents() == 2, "samples of fans")
    for k, cell in enumerate(cells):
        record, limit = records[int(sources.GetTuple1(k))], int(limits.GetTuple1(k))
        faults.expect(set(samples.GetTuple2(k)) <= set(record["contact"]), f"samples of fan {k}")
        faults.expect(len(cell) == 3 and bits(rounded(record["center"])) in [bits(positions[id]) for id in cell],
                      f"source of fan {k}")
        # An arc between two directions is in the λ-list.
        label = None if limit < 0 else records[limit]["contact"]
        faults.expect(label in record["lambda"]["arcs"], f"limit of fan {k}")
    faults.expect(not is_exact or len(set(positions)) == len(positions), "points of fans are not shared")
    return len(cells) > 0


def check_whole_complex(flowcert, source, folder, points, is_exact, faults):
    target, output = os.path.join(folder, "whole"), os.path.join(folder, "whole.jsonl")
    run = subprocess.run([flowcert, "compute", source, "--export", target, "-o", output, "--manifolds", "all",
                          "--only", "fans,cells"], capture_output=True, text=True, timeout=200)
    faults.expect(run.returncode == 0, run.stderr)
    names = sorted(os.listdir(target))
    faults.expect(names == ["stable_cells.vtu", "unstable_fans.vtp"], f"files {names}")
    with open(output, encoding="utf-8") as file:
        records = [json.loads(line) for line in file][1:]
    grid = read(os.path.join(target, "stable_cells.vtu"), vtkXMLUnstructuredGridReader(), faults)
    fans = read(os.path.join(target, "unstable_fans.vtp"), vtkXMLPolyDataReader(), faults)
    return {"pyramid": check_cells(grid, records, points, is_exact, faults),
            "fan": check_fans(fans, records, is_exact, faults)}


def lines_alone(flowcert, source, target, clip, faults):
    run = subprocess.run([flowcert, "compute", source, "--export", target, "--only", "lines", "--clip", clip],
                         capture_output=True, text=True, timeout=200)
    faults.expect(run.returncode == 0, run.stderr)
    faults.expect(os.listdir(target) == ["unstable_lines.vtp"], f"files {os.listdir(target)}")
    return read(os.path.join(target, "unstable_lines.vtp"), vtkXMLPolyDataReader(), faults)


def check_input(flowcert, folder, points, is_exact, faults):
    """Returns, by name, which of the things that matter the input had. is_exact: doubles tell volumes and places."""
    source, target, output = (os.path.join(folder, name) for name in ("points.off", "files", "records.jsonl"))
    with open(source, "w", encoding="ascii") as file:
        file.writelines([f"OFF\n{len(points)} 0 0\n"] + ["%r %r %r\n" % point for point in points])
    run = subprocess.run([flowcert, "compute", source, "--export", target, "--json", "-o", output, "--manifolds", "u2,s2",
                          "--polylines", "--skeletons"], capture_output=True, text=True, timeout=200)
    faults.expect(run.returncode == 0, run.stderr)
    summary = json.loads(run.stdout)
    with open(output, encoding="utf-8") as file:
        records = [json.loads(line) for line in file][1:]
    names = ["critical_points.vtp", "stable_surfaces.ply", "stable_surfaces.vtp", "unstable_lines.vtp"]
    faults.expect(sorted(os.listdir(target)) == names, f"files {os.listdir(target)}")
    opened = [read(os.path.join(target, name), vtkPLYReader() if name.endswith("ply") else vtkXMLPolyDataReader(), faults)
              for name in names]
    samples = [tuple(map(Fraction, point)) for point in points]
    check_critical_points(opened[0], records, faults)
    seen = check_lines(opened[3], records, summary, samples, 3, faults)
    for clip, factor in (("none", None), ("1", 1), ("7/2", Fraction(7, 2))):
        lines = lines_alone(flowcert, source, os.path.join(folder, clip.replace("/", "-")), clip, faults)
        seen |= check_lines(lines, records, summary, samples, factor, faults)
    positions, cells = check_surfaces(opened[2], records, summary, samples, faults)
    check_orientation(cells, faults)
    check_ply(opened[1], positions, cells, faults)
    return {**dict.fromkeys(seen, True),
            **check_whole_complex(flowcert, source, folder, samples, is_exact, faults),
            "regular": any(record["kind"] == "regular" for record in records),
            "interval": any(record.get("stable", {}).get("has_interval") for record in records if record["index"] == 2),
            "infinity": summary["u2"]["to_infinity"] > 0,
            "long line to infinity": any(limit is None and len(record["u2"][side]) > 1 for record in records
                                         for side, limit in enumerate(record.get("limits", []))),
            "equal doubles": len(set(positions)) < len(positions)}


def main():
    faults, seen = Faults(), Counter()
    for name, points in INPUTS.items():
        before = len(faults.found)
        with tempfile.TemporaryDirectory() as folder:
            is_exact = name not in ("far", "subnormal")
            found = check_input(sys.argv[1], folder, points, is_exact, faults)
            seen.update(key for key, value in found.items() if value)
        faults.found[before:] = [f"{name}: {fault}" for fault in faults.found[before:]]
    for key in ("regular", "interval", "infinity", "long line to infinity", "equal doubles", "cut before its last segment",
                "cut in its last segment", "pyramid", "fan"):
        faults.expect(seen[key] > 0, f"no input has {key}")
    for fault in faults.found[:20]:
        print(fault)
    print(f"{len(INPUTS)} inputs read by VTK {core.vtkVersion.GetVTKVersion()}, {faults.checks} checks, "
          f"{len(faults.found)} faults")
    return 1 if faults.found else 0


if __name__ == "__main__":
    sys.exit(main())
