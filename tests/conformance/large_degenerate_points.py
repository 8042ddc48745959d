"""Degenerate inputs of 1,000 points and more, all of integers: lattices, spheres, circles, cylinders, capsules, planes
of lattices, lines, and scans that are rounded to a grid."""
import itertools
import math

CUBE = sorted(itertools.product(range(13), repeat=3))


def lattice(rng):
    sides = [rng.randint(9, 12) for _ in range(3)]
    return [p for p in CUBE if all(x < side for x, side in zip(p, sides))] + CUBE[-300:]


def piece_of_lattice(rng):
    return rng.sample(CUBE, rng.randint(1000, 1400))


def on_sphere(rng, squares=(2609, 2834, 2966, 3134)):
    square = rng.choice(squares)
    side = range(-math.isqrt(square), math.isqrt(square) + 1)
    rest = ((x, y, square - x * x - y * y) for x in side for y in side)
    return [(x, y, z) for x, y, zz in rest if zz >= 0 and math.isqrt(zz)**2 == zz
            for z in {math.isqrt(zz), -math.isqrt(zz)}]


def on_circle(primes):
    """All points of integers on the circle with the product of these primes as its squared radius, each 1 mod 4.

    They are the products of primes of Gauss, (a, b) with a^2 + b^2 = p, and their mirror images."""
    points = {(1, 0), (0, 1), (-1, 0), (0, -1)}
    for p in primes:
        a, b = next((a, b) for a in range(1, p) for b in range(a, p) if a * a + b * b == p)
        points = {(x * a - y * c, x * c + y * a) for x, y in points for c in (b, -b)}
    return sorted(points)


def circle(rng):
    return [(x, y, 0) for x, y in on_circle((5, 5, 5, 13, 13, 17, 29, 37, 41, 53))] + [(0, 0, 0)] * rng.randint(0, 1)


def cylinder(rng):
    height = rng.randint(1, 50)
    return [(x, y, height * z) for x, y in on_circle((5, 5, 13, 13, 17)) for z in range(rng.randint(14, 18))]


def capsule(rng):
    height = rng.randint(1, 4)
    ends = [(x, y, z + math.copysign(8 * height, z) * (z != 0)) for x, y, z in on_sphere(rng, (2834, 3314))]
    return [(x, y, int(z)) for x, y, z in ends] + [
        (x, y, height * k) for x, y, z in ends if z == 0 for k in range(-8, 9) if k != 0]


def planes_of_lattices(rng):
    count, (u, v) = rng.randint(1, 3), ([rng.randint(-3, 3) for _ in range(3)] for _ in range(2))
    u, v = (u, v) if any((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])) else (
        (1, 2, 2), (2, -2, 1))
    side = math.isqrt(1000 // count) + rng.randint(2, 4)
    return [tuple(a * x + b * y + 5 * c * (k == 2) for k, (x, y) in enumerate(zip(u, v)))
            for a in range(side) for b in range(side) for c in range(count)]


def line(rng):
    direction = [rng.randint(-9, 9) for _ in range(2)] + [rng.randint(1, 9)]
    return [tuple(k * x for x in direction) for k in rng.sample(range(5000), 1000)]


def scan(rng):
    """The points of a torus, a sphere or a sheet, until 1,000 of the grid are there."""
    kind, radius, points = rng.randrange(3), rng.randint(14, 24), set()
    size = rng.randint(1000, 1300)
    while len(points) < size:
        a, b = (rng.uniform(0, 2 * math.pi) for _ in range(2))
        out = radius + 6 * math.cos(b)
        where = ((out * math.cos(a), out * math.sin(a), 6 * math.sin(b)),
                 (radius * math.cos(a) * math.sin(b), radius * math.sin(a) * math.sin(b), radius * math.cos(b)),
                 (8 * a, 8 * b, (a - 3)**2 - (b - 3)**2 / 2))[kind]
        points.add(tuple(map(round, where)))
    return sorted(points)


KINDS = (scan, cylinder, planes_of_lattices, lattice, piece_of_lattice, on_sphere, circle, capsule, line)


def draw(number, rng):
    """The name of a kind, and points: shuffled, some of them twice, moved and scaled by a power of two."""
    kind = KINDS[number % len(KINDS)]
    points = kind(rng)
    points += rng.choices(points, k=rng.choice((0, 0, 5)))
    rng.shuffle(points)
    move, scale = [rng.randint(-1000, 1000) * rng.randint(0, 1) for _ in range(3)], 2.0**rng.randint(-30, 30)
    assert len(points) >= 1000, kind
    return kind.__name__, [tuple(scale * (x + y) for x, y in zip(point, move)) for point in points]
