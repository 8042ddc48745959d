"""Whether cells are a Delaunay triangulation of points, found without certificates, by trying all points."""
from collections import Counter
from itertools import combinations

from certificate_bytes import facets_of


def determinant(matrix):
    if not matrix:
        return 1
    first, *rest = matrix
    return sum((-1) ** k * x * determinant([row[:k] + row[k + 1:] for row in rest]) for k, x in enumerate(first) if x)


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def names_of(points):
    return [k for k, point in enumerate(points) if points.index(point) == k]


class Volumes:
    """Volumes, up to one factor, of simplices in the affine hull of a first one, which is not flat."""

    def __init__(self, points, first):
        self.points, self.first, self.dimension = points, first, len(first) - 1
        self.axes = next((axes for axes in combinations(range(3), self.dimension) if self.along(axes, first)), None)

    def along(self, axes, simplex):
        start, *others = (self.points[p] for p in simplex)
        return determinant([[v[k] for k in axes] for v in (minus(p, start) for p in others)])

    def __call__(self, simplex):
        return self.along(self.axes, simplex)

    def inside_sphere(self, cell, p):
        """Positive inside the sphere of the cell, 0 on it: the volume of what is lifted to a paraboloid."""
        from_p = [minus(self.points[q], self.points[p]) for q in cell]
        lifted = [[*(v[k] for k in self.axes), dot(v, v)] for v in from_p]
        return determinant(lifted) * self(cell) * (-1) ** self.dimension

    def are_in_hull(self, names):
        """Whether points are in the affine hull: determinants of Gram are 0."""
        edges = [[minus(self.points[q], self.points[self.first[0]]) for q in (*self.first[1:], p)] for p in names]
        return self.dimension == 3 or not any(determinant([[dot(a, b) for b in v] for a in v]) for v in edges)

    def of_convex_hull(self, names):
        """Points are added one by one, each with the facets that see it."""
        if self.dimension == 1:
            return max(abs(self((p, q))) for p in names for q in names)
        facets = []  # (p, *w) has a positive volume for points outside
        for i, p in enumerate(self.first):
            w = self.first[:i] + self.first[i + 1:]
            facets.append(w if self((p, *w)) < 0 else (w[1], w[0], *w[2:]))
        total = abs(self(self.first))
        for p in names:
            seen = [w for w in facets if self((p, *w)) > 0]
            total += sum(self((p, *w)) for w in seen)
            ridges = Counter(ridge for w in seen for ridge in facets_of(w))
            facets = [w for w in facets if w not in seen] + [
                (*w[:i], p, *w[i + 1:]) for w in seen for i, ridge in enumerate(facets_of(w)) if ridges[ridge] == 1]
        return total


def is_delaunay(points, cells):
    """All points are tried at all cells. A facet is on the hull, or has a cell on either side, and volumes add up."""
    names = names_of(points)
    if not cells:
        return len(names) < 2
    volume = Volumes(points, cells[0])
    if not volume.axes or not volume.are_in_hull(names) or {p for cell in cells for p in cell} != set(names):
        return False
    sign = 1 if volume.dimension == 3 or volume(cells[0]) > 0 else -1
    if any(volume(cell) * sign <= 0 for cell in cells):
        return False
    opposite = {}
    for cell in cells:
        for p, facet in zip(cell, facets_of(cell)):
            opposite.setdefault(facet, []).append(p)
    for facet, (p, *others) in opposite.items():
        here, there = volume((p, *facet)), [volume((q, *facet)) for q in others or names]
        if len(others) > 1 or any(here * other >= 0 if others else here * other < 0 for other in there):
            return False
    return (sum(abs(volume(cell)) for cell in cells) == volume.of_convex_hull(names)
            and all(volume.inside_sphere(cell, p) <= 0 for cell in cells for p in names))
