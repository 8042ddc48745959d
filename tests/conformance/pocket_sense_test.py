"""Pockets of a protein, for sense: what `flowcert pockets` and `locate` say, against a grid and random positions.

usage: pocket_sense_test.py FLOWCERT [FILE]

Without FILE, a barrel of eight alpha helices is made, open, and with a cap at one end and at both. As PDB, mmCIF and
XYZ it has the same pockets. FILE is a point file of a real one; FLOWCERT_SENSE_STEPS is how fine the grid is.

A path along a grid of step h stays outside of balls around the atoms that are smaller by h/2 than what its nodes are
away from atoms, and any path has such a grid path within h sqrt(3)/2. So a flood of the grid encloses the radius of the
widest path between two bounds, and no tolerance is needed. Random positions are shared out as the volumes say.
"""
import heapq
import json
import math
import os
import random
import subprocess
import sys
import tempfile

STEPS = int(os.environ.get("FLOWCERT_SENSE_STEPS", "26"))
POSITIONS = 3000


def barrel(caps):
    """Backbone atoms of eight helices around the z axis, and plates of atoms that close so many ends."""
    atoms = []
    for helix in range(8):
        turn = 2 * math.pi * helix / 8
        for residue in range(14):
            # Radius of the atom in the helix, its angle and its height within the residue, in degrees and Å.
            for name, radius, angle, height in (("N", 1.55, -27, -0.9), ("CA", 2.29, 0, 0.0), ("C", 1.66, 27, 1.1),
                                                ("O", 2.05, 40, 2.2), ("CB", 3.3, -15, -0.5)):
                phi = math.radians(100 * residue + angle) + helix
                x = 12 * math.cos(turn) + radius * math.cos(phi)
                y = 12 * math.sin(turn) + radius * math.sin(phi)
                atoms.append((name, helix, residue, (x, y, 1.5 * residue + height)))
    for end in range(caps):
        z = (-4.0, 24.0)[end]
        plate = [(3.0 * i, 3.0 * j, z) for i in range(-5, 6) for j in range(-5, 6) if i * i + j * j <= 25]
        atoms += [("CA", 8 + end, k, position) for k, position in enumerate(plate)]
    return [(name, chain, residue, tuple(round(c, 3) for c in at)) for name, chain, residue, at in atoms]


def pdb_text(atoms):
    lines = [f"ATOM  {k + 1:5d}  {name:<3} ALA {'ABCDEFGHIJ'[chain]}{residue + 1:4d}    "
             f"{at[0]:8.3f}{at[1]:8.3f}{at[2]:8.3f}  1.00  0.00           {name[0]}"
             for k, (name, chain, residue, at) in enumerate(atoms)]
    return "\n".join(lines) + "\nEND\n"


def mmcif_text(atoms):
    keys = ("group_PDB", "id", "type_symbol", "label_atom_id", "label_asym_id", "label_seq_id", "Cartn_x", "Cartn_y",
            "Cartn_z")
    head = "data_barrel\nloop_\n" + "".join(f"_atom_site.{key}\n" for key in keys)
    return head + "".join(f"ATOM {k + 1} {name[0]} {name} {'ABCDEFGHIJ'[chain]} {residue + 1} {at[0]} {at[1]} {at[2]}\n"
                          for k, (name, chain, residue, at) in enumerate(atoms)) + "#\n"


def xyz_text(positions):
    return "".join("%r %r %r\n" % at for at in positions)


class Distances:
    """Distances to the nearest atom, by cells of a few Å."""

    def __init__(self, atoms, cell=4.0):
        self.cell, self.atoms_in = cell, {}
        for at in atoms:
            self.atoms_in.setdefault(self.cell_of(at), []).append(at)
        self.reach = max(max(abs(k) for k in cell) for cell in self.atoms_in) + 1

    def cell_of(self, at):
        return tuple(math.floor(c / self.cell) for c in at)

    def shell(self, center, ring):
        """The cells whose greatest step from this one is `ring`."""
        span = range(-ring, ring + 1)
        for i in span:
            for j in span:
                for k in span if ring in (abs(i), abs(j)) else (-ring, ring):
                    yield center[0] + i, center[1] + j, center[2] + k

    def __call__(self, at):
        center, best, ring = self.cell_of(at), math.inf, 0
        # What is in further rings is farther away than (ring - 1) cells.
        while best > (ring - 1) * self.cell:
            for cell in self.shell(center, ring):
                for atom in self.atoms_in.get(cell, ()):
                    best = min(best, math.dist(at, atom))
            ring += 1
        return best


def box_of(atoms):
    return [(min(axis), max(axis)) for axis in zip(*atoms)]


def widest_on_grid(distance, atoms, peak):
    """The step h, and the largest r such that grid nodes with d >= r lead from a node beside `peak` out of the box."""
    box = box_of(atoms)
    step = max(high - low for low, high in box) / STEPS
    counts = [math.floor((high - low) / step) + 3 for low, high in box]
    place = [low - step for low, _ in box]
    node = lambda index: tuple(place[axis] + step * index[axis] for axis in range(3))
    values, start = {}, tuple(round((peak[axis] - place[axis]) / step) for axis in range(3))
    for i in range(counts[0]):
        for j in range(counts[1]):
            for k in range(counts[2]):
                values[i, j, k] = distance(node((i, j, k)))
    # From the outer nodes inwards, the widest first: that of a node is then the widest way to it.
    is_outer = lambda index: any(c in (0, count - 1) for c, count in zip(index, counts))
    heap = [(-math.inf, index) for index in values if is_outer(index)]
    heapq.heapify(heap)
    best = {}
    while heap:
        width, index = heapq.heappop(heap)
        if index in best:
            continue
        best[index] = -width
        if index == start:
            break
        for axis in range(3):
            for way in (-1, 1):
                beside = tuple(c + way if a == axis else c for a, c in enumerate(index))
                if beside in values and beside not in best:
                    heapq.heappush(heap, (-min(-width, values[beside]), beside))
    return step, min(best[start], values[start])


class Checks:
    def __init__(self):
        self.count, self.faults = 0, []

    def expect(self, is_right, what):
        self.count += 1
        if not is_right:
            self.faults.append(what)


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True, timeout=600, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return done.stdout


def check_widest(told, atoms, distance, checks):
    """The widest path of the whole, from its own peak."""
    widest = told["pore_limiting_radius"]["radius"]
    pocket = next(p for p in told["pockets"] if p["widest_path"]["radius"] == widest)
    peak = [value_of(c) for c in pocket["peaks"][0]["center"]]
    step, on_grid = widest_on_grid(distance, atoms, peak)
    # The way from the peak to the node beside it is inside the peak's ball, but may be narrower than the path.
    to_node = pocket["peaks"][0]["radius"] - step * math.sqrt(3) / 2
    low, high = min(on_grid - step / 2, to_node), on_grid + step * math.sqrt(3) / 2
    checks.expect(low <= widest <= high, f"widest path {widest}, not in [{low}, {high}]")
    return low, widest, high


def value_of(text):
    top, _, bottom = text.partition("/")
    return int(top) / int(bottom or "1")


def check_positions(flowcert, source, folder, told, atoms, distance, checks):
    box = box_of(atoms)
    size = math.prod(high - low for low, high in box)
    drawn = random.Random(5)
    positions = [tuple(drawn.uniform(low, high) for low, high in box) for _ in range(POSITIONS)]
    queries = os.path.join(folder, "queries.xyz")
    with open(queries, "w", encoding="ascii") as file:
        file.write(xyz_text(positions))
    lines = run(flowcert, "locate", source, "--positions", queries, "--json").splitlines()[1:]
    pocket_of = {tuple(part["contact"]): number for number, pocket in enumerate(told["pockets"])
                 for part in pocket["cell"]}
    hits = [0] * len(told["pockets"])
    for at, line in zip(positions, map(json.loads, lines)):
        number = pocket_of.get(tuple(line["contact"] or ()))
        near = distance(at)
        nearest = atoms[line["nearest"][0]]
        checks.expect(math.isclose(near, math.dist(at, nearest), rel_tol=1e-12), f"nearest samples of {at}")
        if number is None:
            continue
        hits[number] += 1
        checks.expect(near <= told["largest_cavity_radius"]["radius"] * (1 + 1e-12), f"a larger ball at {at}")
    for number, pocket in enumerate(told["pockets"]):
        expected = POSITIONS * pocket["volume"] / size
        # Six standard deviations, and one more for rare ones.
        checks.expect(abs(hits[number] - expected) <= 6 * math.sqrt(expected) + 6,
                      f"pocket {number}: {hits[number]} of {POSITIONS} positions, not {expected:.1f}")
    return sum(hits)


def check(flowcert, source, folder, atoms, checks, persistence):
    told = json.loads(run(flowcert, "pockets", source, "--json", "--persistence", persistence))
    checks.expect(len(told["pockets"]) > 0, "no pocket")
    distance = Distances(atoms)
    for pocket in told["pockets"]:
        peak = pocket["peaks"][0]
        at = [value_of(c) for c in peak["center"]]
        checks.expect(math.isclose(distance(at), peak["radius"], rel_tol=1e-9), f"radius at {at}")
    low, widest, high = check_widest(told, atoms, distance, checks)
    hits = check_positions(flowcert, source, folder, told, atoms, distance, checks)
    run(flowcert, "check", source, write(folder, "pockets.json", json.dumps(told)))
    print(f"{os.path.basename(source)}: {len(told['pockets'])} pockets, largest cavity "
          f"{told['largest_cavity_radius']['radius']:.3f}, widest path {widest:.3f} in [{low:.3f}, {high:.3f}], "
          f"{hits} of {POSITIONS} positions in pockets")
    return told


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)
    return path


def without_names(told):
    """The same without what a file calls its atoms."""
    for pocket in told["pockets"]:
        for key in ("atoms", "residues"):
            pocket.pop(key, None)
    return told


def check_barrels(flowcert, folder, checks):
    for caps in (0, 1, 2):
        atoms = barrel(caps)
        positions = [at for *_, at in atoms]
        source = write(folder, f"barrel_{caps}.pdb", pdb_text(atoms))
        told = check(flowcert, source, folder, positions, checks, "0.1")
        for name, text in ((f"barrel_{caps}.cif", mmcif_text(atoms)), (f"barrel_{caps}.xyz", xyz_text(positions))):
            other = json.loads(run(flowcert, "pockets", write(folder, name, text), "--json", "--persistence", "0.1"))
            checks.expect(without_names(other) == without_names(told), f"{name} has other pockets")
        # The lumen is as wide as the barrel less a helix, and closed for a probe of 3 Å where both ends are.
        if caps == 2:
            checks.expect(7 < told["largest_cavity_radius"]["radius"] < 10, "the lumen's radius")
            checks.expect(told["pore_limiting_radius"]["radius"] < 6, "the lumen is not closed")
        part = json.loads(run(flowcert, "pockets", source, "--json", "--chains", "A,B"))
        checks.expect(part["points"] == 140, f"chains A and B have {part['points']} atoms")


def main():
    flowcert, checks = sys.argv[1], Checks()
    with tempfile.TemporaryDirectory() as folder:
        if len(sys.argv) > 2:
            with open(sys.argv[2], encoding="ascii") as file:
                atoms = [tuple(map(float, line.split()[:3])) for line in file if line.strip() and line[0] != "#"]
            check(flowcert, sys.argv[2], folder, atoms, checks, "1")
        else:
            check_barrels(flowcert, folder, checks)
    for fault in checks.faults[:20]:
        print(fault)
    print(f"{checks.count} checks, {len(checks.faults)} faults")
    return 1 if checks.faults else 0


if __name__ == "__main__":
    sys.exit(main())
