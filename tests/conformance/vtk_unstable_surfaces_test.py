"""U1 as sets, and what flows to infinity, as `flowcert compute --export --only sheets,infinity` writes them for VTK.

usage: vtk_unstable_surfaces_test.py FLOWCERT

Each corner lies where its samples say, and no sample is nearer. That is decided in rationals, with bounds for the last
digits that rounding may change. Sheets of a facet that is whole have the area of its fans. PLY has the triangles of the
sheets. The cells of infinity and the volumes of all finite sets add up to the box.
"""
import functools
import json
import math
import os
import subprocess
import sys
import tempfile
from collections import Counter
from fractions import Fraction

from vtkmodules import vtkCommonCore as core
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from vtk_exports_test import (DOUBLE, INPUTS, INT64, SIGNED_CHAR, Faults, arrays_of, bits, box_of, cells_of, check_ply,
                              is_inside, points_of, random_points, read, rounded, signed_volume)

TRACE, RUN, SEGMENT, SHEET = range(4)
CLIPS = {"3": 3, "1": 1, "none": None}
CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
MORE_INPUTS = {
    "cube": CUBE,
    # With runs and segments.
    "chain": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1), (2, 1, 1)],
    "crowd": random_points(8, 80),
    # The centre of the circle is far outside of the box.
    "obtuse": [(0, 0, 0), (10, 0, 0), (5, 0.1, 0)],
}


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def half_ulps(position):
    """What rounding to nearest may have changed of each coordinate."""
    return [Fraction(math.ulp(x)) / 2 for x in position]


def nearness(position, p, q):
    """Half of how much less the squared distance to p is than that to q."""
    way = minus(q, p)
    return -dot(position, way) + (dot(q, q) - dot(p, p)) / 2


class Corners:
    """Tells whether points lie on Voronoi faces, up to the rounding of their coordinates."""

    def __init__(self, samples, box, positions, is_clipped):
        self.samples, self.positions, self.is_clipped = samples, positions, is_clipped
        self.exact = [[Fraction(x) for x in position] for position in positions]
        self.errors = [half_ulps(position) for position in positions]
        self.as_doubles = [[float(x) for x in q] for q in samples]
        self.scale = max((abs(x) for q in self.as_doubles for x in q), default=0) ** 2
        if box is None:
            return
        # A point at which the box cuts has the errors of both ends, one of which may be a direction, and its own.
        largest = max(abs(float(side)) for sides in box for side in sides)
        longest = max(high - low for low, high in box)
        of_cut = Fraction(math.ulp(largest)) + longest * Fraction(1, 2**53)
        self.errors = [[2 * of_cut] * 3 if is_cut else errors for errors, is_cut in zip(self.errors, is_clipped)]

    @functools.cache
    def candidates(self, id):
        """Samples of which one could be nearest: all but those that are much farther, in doubles, than another."""
        squares = [math.dist(self.positions[id], q) ** 2 for q in self.as_doubles]
        least = min(squares)
        return [k for k, square in enumerate(squares) if not square > 1.001 * least + 1e-6 * self.scale]

    @functools.cache
    def is_on(self, id, names):
        """Whether the point is as near to the named samples as to any other."""
        first = self.samples[names[0]]
        for other in {*self.candidates(id), *names}:
            q = self.samples[other]
            bound = dot(self.errors[id], [abs(x) for x in minus(q, first)])
            difference = nearness(self.exact[id], first, q)
            if difference < -bound or (other in names and difference > bound):
                return False
        return True


def normal_of(cell, positions):
    """Twice the area, by the right-hand rule."""
    total = [0.0] * 3
    for b, c in zip(cell[1:], cell[2:]):
        u, v = (minus(positions[id], positions[cell[0]]) for id in (b, c))
        total = [t + x for t, x in zip(total, (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                               u[0] * v[1] - u[1] * v[0]))]
    return total


def sizes_of(data, name):
    measured = vtkCellSizeFilter()
    measured.SetInputData(data)
    measured.Update()
    sizes = measured.GetOutput().GetCellData().GetArray(name)
    return [sizes.GetTuple1(k) for k in range(sizes.GetNumberOfTuples())] if sizes else []


def is_near(total, wanted):
    return abs(total - wanted) <= 1e-9 * abs(wanted)


def marks_of(box):
    return {} if box is None else {"IsClipped": SIGNED_CHAR}


def check_sheets(poly_data, ply, fans, records, samples, box, is_exact, faults):
    """Returns the sorts of parts that there are, and the area of all sheets."""
    positions = points_of(poly_data, faults)
    cells = cells_of(poly_data, len(positions), faults)
    data = poly_data.GetCellData()
    names = sorted(data.GetArrayName(k) for k in range(data.GetNumberOfArrays()))
    faults.expect(names == ["kind", "samples", "source"], f"arrays {names}")
    kinds, sources, triples = (data.GetArray(name) for name in ("kind", "source", "samples"))
    is_right = kinds.GetDataType() == core.VTK_SIGNED_CHAR and triples.GetNumberOfComponents() == 3
    faults.expect(is_right, "types of arrays")
    marks = arrays_of(poly_data.GetPointData(), marks_of(box), len(positions), faults)
    is_clipped = marks.get("IsClipped", [0] * len(positions))
    corners = Corners(samples, box, positions, is_clipped)
    areas, seen = sizes_of(poly_data, "Area"), Counter()
    facet_areas, roots, signed, fan_lists = Counter(), Counter(), 0.0, []
    for k, cell in enumerate(cells):
        kind, record = int(kinds.GetTuple1(k)), records[int(sources.GetTuple1(k))]
        named = [int(name) for name in triples.GetTuple3(k)]
        what = f"part {k}, of kind {kind}"
        seen[kind] += 1
        faults.expect((named[2] == -1) == (kind in (SEGMENT, SHEET)), f"samples of {what}")
        named = [name for name in named if name >= 0]
        faults.expect(named == sorted(set(named)) and len(named) >= 2, f"samples of {what}")
        index = record["index"][0] if record["kind"] == "regular" else record["index"]
        faults.expect(index == 1, f"source of {what}")
        faults.expect(all(corners.is_on(id, tuple(named)) for id in cell), f"{what} is not on the face of {named}")
        faults.expect((len(cell) >= 3) == (kind == SHEET) and (len(cell) > 1 or kind == TRACE), f"corners of {what}")
        if kind != SHEET:
            continue
        way = [float(x) for x in minus(samples[named[1]], samples[named[0]])]
        signed += dot(normal_of(cell, positions), way) / math.hypot(*way) / 2
        fan_lists += [[cell[0], b, c] for b, c in zip(cell[1:], cell[2:])]
        if is_midpoint(record, named, samples):
            roots[int(sources.GetTuple1(k))] += 1
            facet_areas[int(sources.GetTuple1(k))] += areas[k]
    area = sum(areas)
    if is_exact:
        faults.expect(is_near(signed, area), f"sheets have the area {area}, and {signed} seen from their samples")
    for id, position in enumerate(positions):
        if box is not None:
            faults.expect(is_inside(position, box), f"point {id} is not in the box")
            on_side = any(Fraction(x) in sides for x, sides in zip(position, box))
            faults.expect(on_side or not is_clipped[id], f"point {id} is cut inside of the box")
    check_ply(ply, positions, fan_lists, faults)
    if is_exact:
        by_ply = sum(math.hypot(*normal_of(cell, positions)) / 2 for cell in cells_of(ply, len(positions), faults))
        faults.expect(is_near(by_ply, area), f"the triangles have the area {by_ply}, not {area}")
        check_fans(fans, roots, facet_areas, box, faults)
    return {f"kind {kind}" for kind in seen}, area


def is_midpoint(record, pair, samples):
    centre = [Fraction(x) for x in record["center"]]
    return [2 * x for x in centre] == [a + b for a, b in zip(*(samples[name] for name in pair))]


def check_fans(fans, roots, facet_areas, box, faults):
    """Fans have no unbounded regions. So they tell the area where a whole sheet is there without a box."""
    if box is not None:
        return
    sources, by_fans = fans.GetCellData().GetArray("source"), Counter()
    for k, size in enumerate(sizes_of(fans, "Area")):
        by_fans[int(sources.GetTuple1(k))] += size
    for source, count in roots.items():
        faults.expect(count == 1, f"{count} sheets of the first facet of {source}")
        faults.expect(is_near(facet_areas[source], by_fans[source]),
                      f"the facet of {source} has the area {facet_areas[source]}, its fans {by_fans[source]}")


def check_infinity(grid, records, samples, box, dimension, is_exact, faults):
    positions = points_of(grid, faults)
    cells = cells_of(grid, len(positions), faults)
    wanted = {"maximum": INT64, "sample": INT64, "volume": DOUBLE, **marks_of(box)}
    arrays = arrays_of(grid.GetCellData(), wanted, len(cells), faults)
    faults.expect(set(arrays["maximum"]) <= {-1} and set(arrays["volume"]) <= {math.inf}, "limits of cells to infinity")
    signed = 0.0
    for k, cell in enumerate(cells):
        faults.expect(grid.GetCellType(k) == {4: 10, 5: 14}.get(len(cell)), f"type of cell {k}")
        sample = samples[int(arrays["sample"][k])]
        faults.expect(bits(positions[cell[-1]]) == bits(rounded(sample)), f"apex of cell {k}")
        signed += signed_volume([positions[id] for id in cell])
        if box is None:
            continue
        base = [positions[id] for id in cell[:-1]]
        is_on_side = any(all(Fraction(x[axis]) == side for x in base) for axis in range(3) for side in box[axis])
        faults.expect(is_on_side or not arrays["IsClipped"][k], f"mark of cell {k}")
        faults.expect(all(is_inside(positions[id], box) for id in cell), f"cell {k} leaves the box")
    faults.expect(dimension == 3 or not cells, "cells of points that do not span space")
    if dimension == 3 and is_exact:
        total = sum(sizes_of(grid, "Volume"))
        faults.expect(is_near(signed, total), f"cells to infinity have the volume {total}, but {signed} by orientation")
        if box is not None:
            finite = sum(record["volume_double"] for record in records)
            of_box = float(math.prod(high - low for low, high in box))
            faults.expect(abs(total + finite - of_box) <= 1e-9 * of_box, f"{total} + {finite} is not {of_box}")
    return len(cells) > 0


def check_input(flowcert, folder, points, is_exact, faults):
    source = os.path.join(folder, "points.off")
    with open(source, "w", encoding="ascii") as file:
        file.writelines([f"OFF\n{len(points)} 0 0\n"] + ["%r %r %r\n" % point for point in points])
    samples, seen, areas = [tuple(map(Fraction, point)) for point in points], set(), {}
    for clip, factor in CLIPS.items():
        target, output = os.path.join(folder, clip), os.path.join(folder, "records.jsonl")
        run = subprocess.run([flowcert, "compute", source, "--manifolds", "all", "--json", "-o", output,
                              "--export", target, "--only", "fans,infinity,sheets", "--clip", clip],
                             capture_output=True, text=True, timeout=200)
        faults.expect(run.returncode == 0, run.stderr)
        names = ["infinity_cells.vtu", "unstable_fans.vtp", "unstable_surfaces.ply", "unstable_surfaces.vtp"]
        faults.expect(sorted(os.listdir(target)) == names, f"files {os.listdir(target)}")
        with open(output, encoding="utf-8") as file:
            records = [json.loads(line) for line in file][1:]
        box = box_of(samples, factor) if factor and samples else None
        readers = (vtkXMLUnstructuredGridReader(), vtkXMLPolyDataReader(), vtkPLYReader(), vtkXMLPolyDataReader())
        grid, fans, ply, sheets = (read(os.path.join(target, name), reader, faults)
                                   for name, reader in zip(names, readers))
        kinds, areas[clip] = check_sheets(sheets, ply, fans, records, samples, box, is_exact, faults)
        dimension = json.loads(run.stdout)["dimension"]
        has_cells = check_infinity(grid, records, samples, box, dimension, is_exact, faults)
        seen |= kinds | ({f"cells, clip {clip}"} if has_cells else set())
        if dimension in (1, 2) and clip == "3":
            faults.expect(areas[clip] > 0, "no sheets of points that do not span space")
    return seen, areas


def main():
    faults, seen = Faults(), Counter()
    inputs = {**INPUTS, **MORE_INPUTS}
    for name, points in inputs.items():
        before = len(faults.found)
        with tempfile.TemporaryDirectory() as folder:
            found, areas = check_input(sys.argv[1], folder, points, name not in ("far", "subnormal"), faults)
        seen.update(found)
        # The facets of the twelve edges are quarters of planes; the box ends them after 3/2, or after 1/2.
        if name == "cube":
            faults.expect(areas == {"3": 27, "1": 3, "none": 0}, f"areas {areas}")
        faults.found[before:] = [f"{name}: {fault}" for fault in faults.found[before:]]
    for key in [f"kind {kind}" for kind in (TRACE, RUN, SEGMENT, SHEET)] + [f"cells, clip {clip}" for clip in CLIPS]:
        faults.expect(seen[key] > 0, f"no input has {key}")
    for fault in faults.found[:20]:
        print(fault)
    print(f"{len(inputs)} inputs read by VTK {core.vtkVersion.GetVTKVersion()}, {faults.checks} checks, "
          f"{len(faults.found)} faults")
    return 1 if faults.found else 0


if __name__ == "__main__":
    sys.exit(main())
