"""Certificates with a fault.

STRUCTURED are faults of cells, RANDOM faults of bytes. Each makes another certificate of a `Certified`, or None where
it does not apply. Some of these are right, as where cells of one sphere are flipped.
"""
import math
import re

from certificate_bytes import body_of, decode, encode, facets_of, numbers_in
from exact_delaunay import Volumes, names_of


class Certified:
    """A right certificate of points of integers. It has no hash, which one checker alone compares.

    certificate_of makes one of other points."""

    def __init__(self, points, rng, certificate_of):
        self.points, self.rng, self.certificate_of = points, rng, certificate_of
        self.data, self.names = re.sub(b"sha256 .*\n", b"", certificate_of(points)), names_of(points)
        self.head, _, body = self.data.partition(b"\n\n")
        self.cells, self.numbers = decode(self.data), numbers_in(body)
        self.volume, self.cells_at = Volumes(points, self.cells[0]), {}
        for cell in self.cells:
            for facet in facets_of(cell):
                self.cells_at.setdefault(tuple(sorted(facet)), []).append(cell)
        self.inner, self.outer = (sorted(facet for facet, at in self.cells_at.items() if len(at) == n) for n in (2, 1))

    def of_cells(self, without=(), more=()):
        left = [*more, *(cell for cell in self.cells if cell not in without)]
        # In front is a cell that is not flat, with the orientation of the first one.
        left.sort(key=lambda cell: self.volume(cell) == 0)
        first = left[0] if left else ()
        if len(left) and self.volume(first) * self.volume(self.cells[0]) < 0:
            left[0] = (first[1], first[0], *first[2:])
        return encode(self.points, left) if left else None

    def of_numbers(self, numbers):
        return self.head + b"\n\n" + body_of(numbers)

    def place(self, extra=0):
        return self.rng.randrange(len(self.numbers) + extra)


# ---- Faults of cells


def flip(certified, is_on_top=False, is_on_a_sphere=False):
    """The d+2 points of two cells have two triangulations. If all cells of the one are there, the other one's come."""
    for facet in certified.rng.sample(certified.inner, len(certified.inner)):
        one, other = certified.cells_at[facet]
        if is_on_a_sphere and any(certified.volume.inside_sphere(one, p) for p in other):
            continue
        points = sorted({*one, *other})
        simplices = [tuple(points[:i] + points[i + 1:]) for i in range(len(points))]
        signs = [(-1) ** i * certified.volume(simplex) for i, simplex in enumerate(simplices)]
        side = signs[simplices.index(tuple(sorted(one)))]
        ours = {frozenset(simplex) for simplex, sign in zip(simplices, signs) if sign * side > 0}
        theirs = [simplex for simplex, sign in zip(simplices, signs) if sign * side < 0]
        taken = [cell for cell in certified.cells if frozenset(cell) in ours]
        if len(taken) == len(ours) and len(theirs) > 1:
            return certified.of_cells(() if is_on_top else taken, theirs)
    return None


def flip_on_top(certified):
    return flip(certified, is_on_top=True)


def flip_on_a_sphere(certified):
    return flip(certified, is_on_a_sphere=True)


def hull_cell_taken_off(certified):
    return certified.of_cells(certified.cells_at[certified.rng.choice(certified.outer)])


def cell_taken_out(certified):
    return certified.of_cells([certified.rng.choice(certified.cells)])


def point_lost(certified):
    lost = certified.points[certified.rng.choice(certified.names)]
    kept = [k for k, point in enumerate(certified.points) if point != lost]
    cells = decode(certified.certificate_of([certified.points[k] for k in kept]))
    return encode(certified.points, [tuple(kept[p] for p in cell) for cell in cells]) if cells else None


def third_cell_at_a_facet(certified):
    facet = certified.rng.choice(certified.inner) if certified.inner else ()
    others = set(certified.names).difference(*certified.cells_at.get(facet, ()))
    return certified.of_cells(more=[(*facet, certified.rng.choice(sorted(others)))]) if facet and others else None


def facet_left_unpaired(certified):
    facet = certified.rng.choice(certified.inner) if certified.inner else None
    return encode(certified.points, certified.cells, {frozenset(facet)}) if facet else None


def cell_behind_the_hull(certified):
    facet = certified.rng.choice(certified.outer)
    others = sorted(set(certified.names).difference(facet))
    return encode(certified.points, [*certified.cells, (*facet, certified.rng.choice(others))])


def another_vertex(certified):
    cell = certified.rng.choice(certified.cells)
    others = sorted(set(certified.names).difference(cell))
    k = certified.rng.randrange(len(cell))
    return certified.of_cells([cell], [(*cell[:k], certified.rng.choice(others), *cell[k + 1:])]) if others else None


def first_cell_mirrored(certified):
    (a, b, *others), *cells = certified.cells
    return encode(certified.points, [(b, a, *others), *cells])


def of_moved_points(certified):
    some = [[x + certified.rng.choice((-1, 0, 0, 1)) for x in point] for point in certified.points]
    cells = decode(certified.certificate_of([tuple(point) for point in some]))
    return encode(certified.points, cells) if cells else None


def another_row_of_a_class(certified):
    rows = [k for k in range(len(certified.points)) if k not in certified.names]
    row = certified.rng.choice(rows) if rows else None
    renamed = [tuple(row if row and certified.points[p] == certified.points[row] else p for p in cell)
               for cell in certified.cells]
    return encode(certified.points, renamed) if rows else None


STRUCTURED = (flip, flip_on_a_sphere, flip_on_top, hull_cell_taken_off, cell_taken_out, point_lost,
              third_cell_at_a_facet, facet_left_unpaired, cell_behind_the_hull, another_vertex, first_cell_mirrored,
              of_moved_points, another_row_of_a_class)


def double_cover(rng):
    """Points and a certificate: around a centre, triangles go round several times, or pyramids over them do.

    Neighbours alone see no fault: T7 does."""
    corners = rng.choice([5, 7, 9, 11])
    step = rng.choice([k for k in range(2, (corners + 1) // 2) if math.gcd(k, corners) == 1])
    radius = rng.choice([10, 1000, 10**6])
    points = [(round(radius * math.cos(2 * math.pi * k / corners)), round(radius * math.sin(2 * math.pi * k / corners)),
               0) for k in range(corners)] + [(0, 0, 0)]
    cells = [(corners, k, (k + step) % corners) for k in range(corners)]
    if rng.random() < 0.5:
        points += [(0, 0, round(radius * rng.uniform(0.3, 3))), (0, 0, -round(radius * rng.uniform(0.3, 3)))]
        cells = [(apex, *cell) for cell in cells for apex in (corners + 1, corners + 2)]
    axes = rng.sample(range(3), 3)
    points = [tuple(point[k] for k in axes) for point in points]
    volume = Volumes(points, cells[0])
    if len(cells[0]) == 4 and volume(cells[0]) < 0:
        cells[0] = (cells[0][1], cells[0][0], *cells[0][2:])
    return points, encode(points, cells)


# ---- Faults of bytes


def bit_flipped(certified):
    k = certified.rng.randrange(len(certified.head) + 2, len(certified.data))
    return certified.data[:k] + bytes([certified.data[k] ^ 1 << certified.rng.randrange(8)]) + certified.data[k + 1:]


def number_changed(certified):
    numbers, k = certified.numbers[:], certified.place()
    numbers[k] = certified.rng.choice([0, 1, numbers[k] + 1, numbers[k] + 2, max(0, numbers[k] - 1),
                                       certified.rng.randrange(2 * len(certified.points))])
    return certified.of_numbers(numbers)


def numbers_swapped(certified):
    numbers, j, k = certified.numbers[:], certified.place(), certified.place()
    numbers[j], numbers[k] = numbers[k], numbers[j]
    return certified.of_numbers(numbers)


def number_left_out(certified):
    k = certified.place()
    return certified.of_numbers(certified.numbers[:k] + certified.numbers[k + 1:])


def number_added(certified):
    k, more = certified.place(1), certified.rng.randrange(2 * len(certified.points))
    return certified.of_numbers([*certified.numbers[:k], more, *certified.numbers[k:]])


def cut_short(certified):
    return certified.data[:certified.rng.randrange(len(certified.data))]


def bytes_after_the_end(certified):
    return certified.data + bytes(certified.rng.choices(range(3), k=certified.rng.randint(1, 3)))


def byte_of_the_header(certified):
    k = certified.rng.randrange(len(certified.head) + 2)
    return certified.data[:k] + bytes([certified.rng.choice(b"0123456789 \n-ax\0\xff")]) + certified.data[k + 1:]


def number_of_the_header(certified):
    words = certified.head.split(b" ")
    k = certified.rng.randrange(1, len(words))
    number, *rest = words[k].split(b"\n")
    other = certified.rng.choice([b"0", b"1", b"2", b"3", b"-1", b"", b"0" + number, b"1" + number,
                                  b"%d" % certified.rng.randrange(10**19)])
    return b" ".join([*words[:k], b"\n".join([other, *rest]), *words[k + 1:]]) + certified.data[len(certified.head):]


RANDOM = (bit_flipped, number_changed, numbers_swapped, number_left_out, number_added, cut_short, bytes_after_the_end,
          byte_of_the_header, number_of_the_header)
