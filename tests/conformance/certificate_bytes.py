"""The bytes of certificates (spec/formats/certificates.md), written and read for tests.

`encode` writes any cells, wrong ones as well. `decode` tells the cells that a certificate says, unless a facet has a
third cell, or one that it was said not to have. Neither asks whether the cells are any good.
"""
import re


def certificate(points, dimension, count, numbers, sha256=None):
    hashed = f"sha256 {sha256}\n" if sha256 else ""
    head = f"flowcert-certificate 1\npoints {len(points)}\n{hashed}dimension {dimension}\ncells {count}\n\n"
    return head.encode() + body_of(numbers)


def body_of(numbers):
    body = bytearray()
    for number in numbers:
        while number >= 128:
            body.append(number % 128 | 128)
            number //= 128
        body.append(number)
    return bytes(body)


def numbers_in(body):
    numbers, value, shift = [], 0, 0
    for byte in body:
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            numbers.append(value)
            value = shift = 0
    return numbers


def facets_of(cell):
    return [frozenset(cell[:i] + cell[i + 1:]) for i in range(len(cell))]


class Gluing:
    """Cells in the order of the format."""

    def __init__(self, first):
        self.cells, self.stack, self.has_third_cell = [], [], False
        self.is_open = {}  # by facet
        self.enter(first, None)

    def enter(self, cell, front):
        self.cells.append(cell)
        for i, facet in enumerate(facets_of(cell)):
            if facet != front:
                is_open = self.is_open.get(facet)
                self.has_third_cell |= is_open is False
                self.is_open[facet] = is_open is None
                if is_open is None:
                    self.stack.append((cell, i, facet))

    def open_facets(self):
        """Open facets: a cell of each, the place of the opposite vertex, the facet. Cells may be entered meanwhile."""
        while self.stack:
            cell, i, facet = self.stack.pop()
            if self.is_open[facet]:
                self.is_open[facet] = False
                yield cell, i, facet

    def enter_behind(self, cell, i, facet, apex):
        cell = list(cell)
        cell[i] = apex
        j, k = [place for place in range(len(cell)) if place != i or len(cell) == 2][:2]
        cell[j], cell[k] = cell[k], cell[j]
        self.enter(tuple(cell), facet)


def encode(points, cells, unpaired=()):
    """The certificate of the cells that are reached from the first one, but not across a facet of `unpaired`.

    Of several cells behind a facet it is the first one that was not entered before."""
    numbers, behind, entered = list(cells[0]), {}, {frozenset(cells[0])}
    for cell in cells:
        for apex, facet in zip(cell, facets_of(cell)):
            behind.setdefault(facet, []).append(apex)
    gluing = Gluing(tuple(cells[0]))
    for cell, i, facet in gluing.open_facets():
        apexes = [] if facet in unpaired else [apex for apex in behind[facet] if facet | {apex} not in entered]
        numbers.append(0 if not apexes else 2 * (apexes[0] - cell[i]) + 1 if apexes[0] > cell[i] else
                       2 * (cell[i] - apexes[0]))
        if apexes:
            entered.add(facet | {apexes[0]})
            gluing.enter_behind(cell, i, facet, apexes[0])
    return certificate(points, len(cells[0]) - 1, len(gluing.cells), numbers)


def decode(data):
    """The cells, or None."""
    head, _, body = data.partition(b"\n\n")
    dimension, count = (int(re.search(rb"\n%b (-?\d+)" % key, head)[1]) for key in (b"dimension", b"cells"))
    numbers = iter(numbers_in(body))
    gluing = Gluing(tuple(next(numbers, -1) for _ in range(dimension + 1))) if count else None
    for cell, i, facet in gluing.open_facets() if count else ():
        code = next(numbers, None)
        if code:
            gluing.enter_behind(cell, i, facet, cell[i] + (code // 2 if code % 2 else -(code // 2)))
        if code is None or gluing.has_third_cell or len(gluing.cells) > count:
            return None
    cells = gluing.cells if count else []
    return cells if len(cells) == count and next(numbers, None) is None else None
