"""What `flowcert cycles --export` writes, opened by VTK itself (src/cli/manual/cycles.md).

usage: vtk_cycles_test.py FLOWCERT [FILE...]

Of each pair, loops.vtp has the edges of its loop, and the boundary of its triangles in loop_surfaces.vtp is the same
edges, mod 2, in halves. Voids are closed, and have their volume by VTK's own sums. Further files of points are tested
as the inputs here: all pairs of them.
"""
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict

from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from vtk_exports_test import DOUBLE, INPUTS, INT64, Faults, arrays_of, cells_of, nearest, points_of, random_points, read
from vtk_pockets_test import check_surface, is_near

CASES = [*((name, points) for name, points in INPUTS.items() if name not in ("far", "subnormal")),
         ("crowd", random_points(7, 200)),
         ("octahedra", sorted({tuple(2 * c[k] + (s if k == axis else 0) for k in range(3))
                               for c in INPUTS["lattice"] for axis in range(3) for s in (-1, 1)}))]
LEVELS = ("birth", "25%", "death")
PAIR = {"pair": INT64, "squared_birth": DOUBLE, "squared_death": DOUBLE, "squared_level": DOUBLE}


def check_values(arrays, cycles, faults):
    for k, pair in enumerate(arrays["pair"]):
        cycle = cycles[int(pair)]
        expected = (cycle["birth"]["squared_distance"], cycle["death"]["squared_distance"], cycle["squared_level"])
        values = tuple(arrays[name][k] for name in ("squared_birth", "squared_death", "squared_level"))
        faults.expect(values == tuple(map(nearest, expected)), f"values of cell {k}")


def lines_by_pair(poly_data, cycles, rows, faults):
    positions = points_of(poly_data, faults)
    lines = cells_of(poly_data, len(positions), faults)
    samples = arrays_of(poly_data.GetPointData(), {"sample": INT64}, len(positions), faults)["sample"]
    arrays = arrays_of(poly_data.GetCellData(), PAIR, len(lines), faults)
    faults.expect(all(tuple(p) == rows[int(s)] for p, s in zip(positions, samples)), "positions of samples")
    check_values(arrays, cycles, faults)
    edges = defaultdict(set)
    for pair, line in zip(arrays["pair"], lines):
        faults.expect(line[0] == line[-1] and len(set(line)) == len(line) - 1 > 2, "a line is no polygon")
        edges[int(pair)] ^= {frozenset((int(samples[a]), int(samples[b]))) for a, b in zip(line, line[1:])}
    return edges


def boundaries_by_pair(poly_data, cycles, contacts, faults):
    count = poly_data.GetNumberOfPoints()
    points = arrays_of(poly_data.GetPointData(), {"sample": INT64, "SquaredDistance": DOUBLE}, count, faults)
    triangles = cells_of(poly_data, count, faults)
    arrays = arrays_of(poly_data.GetCellData(), dict(PAIR, saddle=INT64), len(triangles), faults)
    check_values(arrays, cycles, faults)
    halves, of_pair = defaultdict(set), defaultdict(set)
    for pair, saddle, (a, b, c) in zip(arrays["pair"], arrays["saddle"], triangles):
        halves[int(pair)] ^= {frozenset(edge) for edge in ((a, b), (b, c), (c, a))}
        of_pair[int(pair)].add(contacts[int(saddle)])
    for number, cycle in enumerate(cycles):
        faults.expect(of_pair[number] == set(map(tuple, cycle["surface"])), f"saddles of pair {number}")
    edges = defaultdict(set)
    for pair, some in halves.items():
        ends = defaultdict(list)
        for half in some:
            midpoint, sample = sorted(half, key=lambda k: points["sample"][k])
            faults.expect(points["sample"][midpoint] == -1 < points["sample"][sample], "a half edge")
            ends[midpoint].append(int(points["sample"][sample]))
        for both in ends.values():
            faults.expect(len(set(both)) == 2 == len(both), f"pair {pair} has a loose half")
            edges[pair].add(frozenset(both))
    return edges


def run(flowcert, *words):
    done = subprocess.run([flowcert, *words], capture_output=True, text=True, timeout=900, check=False)
    return done.stdout if done.returncode == 0 else sys.exit(done.stderr)


def check_loops(flowcert, source, target, level, faults):
    words = ["cycles", source, "--persistence", "0", "--level", level, "--json", "--export", target]
    cycles = json.loads(run(flowcert, *words))["cycles"]
    output = os.path.join(target, "records.jsonl")
    run(flowcert, "compute", source, "-o", output)
    with open(output, encoding="utf-8") as file:
        records = [json.loads(line) for line in file][1:]
    contacts = [tuple(record["contact"]) for record in records]
    rows = {contact[0]: tuple(record["center_double"])
            for contact, record in zip(contacts, records) if len(contact) == 1}
    expected = {k: set(map(frozenset, cycle["edges"])) for k, cycle in enumerate(cycles)}
    for name, edges_of in (("loops.vtp", lambda data: lines_by_pair(data, cycles, rows, faults)),
                           ("loop_surfaces.vtp", lambda data: boundaries_by_pair(data, cycles, contacts, faults))):
        edges = edges_of(read(os.path.join(target, name), vtkXMLPolyDataReader(), faults))
        faults.expect(edges == expected, f"{name} at {level} has other edges")
    return len(cycles)


def check_voids(flowcert, source, target, faults):
    words = ["cycles", source, "--dimension", "2", "--persistence", "0", "--level", "0%", "--json", "--export", target]
    cycles = json.loads(run(flowcert, *words))["cycles"]
    grid = read(os.path.join(target, "voids.vtu"), vtkXMLUnstructuredGridReader(), faults)
    cells = cells_of(grid, grid.GetNumberOfPoints(), faults)
    arrays = arrays_of(grid.GetCellData(), dict(PAIR, maximum=INT64, sample=INT64, volume=DOUBLE), len(cells), faults)
    check_values(arrays, cycles, faults)
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    measured = sizes.GetOutput().GetCellData().GetArray("Volume")
    volumes = Counter()
    for k, pair in enumerate(arrays["pair"]):
        volumes[int(pair)] += measured.GetTuple1(k)
    for number, cycle in enumerate(cycles):
        faults.expect(is_near(volumes[number], cycle["volume"]), f"void {number}: volume {volumes[number]}")
        name = f"pair_{number}.ply"
        check_surface(read(os.path.join(target, name), vtkPLYReader(), faults), cycle, faults, name)
    return len(cycles)


def main():
    faults, loops, voids = Faults(), 0, 0
    for name, points in CASES:
        before = len(faults.found)
        with tempfile.TemporaryDirectory() as folder:
            source = os.path.join(folder, "points.off")
            with open(source, "w", encoding="ascii") as file:
                file.writelines([f"OFF\n{len(points)} 0 0\n"] + ["%r %r %r\n" % point for point in points])
            for level in LEVELS:
                loops += check_loops(sys.argv[1], source, os.path.join(folder, level), level, faults)
            voids += check_voids(sys.argv[1], source, os.path.join(folder, "voids"), faults)
        faults.found[before:] = [f"{name}: {fault}" for fault in faults.found[before:]]
    for source in sys.argv[2:]:
        with tempfile.TemporaryDirectory() as folder:
            more = check_loops(sys.argv[1], source, folder, "25%", faults)
        print(f"{source}: {more} loops, {len(faults.found)} faults so far", flush=True)
        loops += more
    faults.expect(loops > 1000 and voids > 40, "too few pairs")
    for fault in faults.found[:20]:
        print(fault)
    print(f"{len(CASES)} inputs, {loops} loops, {voids} voids, {faults.checks} checks, {len(faults.found)} faults")
    return 1 if faults.found else 0


if __name__ == "__main__":
    sys.exit(main())
