"""Finds weights and a linear form that show the kind of a stationary point: certificates for the judge of spec/proofs/.

Nobody has to trust this. The judge, which is proved, checks what it finds, and a wrong answer is not proved.
A certificate has a weight for each point of the contact set, and a linear form that is least on the face with the
stationary point inside. On that face the weights are positive, elsewhere zero. Points are triples of fractions.
"""
import itertools
import math
from fractions import Fraction


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def times(k, a):
    return (k * a[0], k * a[1], k * a[2])


def plus(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def in_integers(vectors):
    """Integer vectors that are a common multiple of these."""
    scale = math.lcm(*(x.denominator for v in vectors for x in v))
    return [tuple(x.numerator * (scale // x.denominator) for x in v) for v in vectors]


def reduced(numbers):
    divisor = math.gcd(*numbers) or 1
    return [x // divisor for x in numbers]


def center_of(points):
    """The center of the smallest sphere through points, or some other place where none goes through them."""
    found = []  # differences, and of each its part that is orthogonal to those before it
    for v in (minus(p, points[0]) for p in points[1:]):
        normal = v
        for _, n in found:
            normal = minus(normal, times(Fraction(dot(v, n)) / dot(n, n), n))
        if any(normal):
            found.append((v, normal))
    center = (0, 0, 0)
    for v, n in found:  # along each normal to the plane that halves v
        center = plus(center, times((Fraction(dot(v, v)) / 2 - dot(v, center)) / dot(v, n), n))
    return plus(points[0], center)


# ---- Weights


def cone_coefficients(vectors, target):
    """Numbers that are not negative, and a divisor: the target as a combination of one to three independent vectors."""
    if len(vectors) == 1:
        a, = vectors
        found, divisor = [dot(a, target)], dot(a, a)
    elif len(vectors) == 2:
        a, b = vectors
        n = cross(a, b)
        found, divisor = [dot(cross(target, b), n), dot(cross(a, target), n)], dot(n, n)
    else:
        a, b, c = vectors
        divisor = dot(a, cross(b, c))
        found = [dot(target, cross(b, c)), dot(a, cross(target, c)), dot(a, cross(b, target))]
        if divisor < 0:
            found, divisor = [-x for x in found], -divisor
    if not divisor or min(found) < 0:
        return None
    total = (0, 0, 0)
    for k, v in zip(found, vectors):
        total = plus(total, times(k, v))
    return (found, divisor) if total == times(divisor, target) else None


def positive_weights(vectors):
    """Positive integers that combine integer vectors to zero, or None."""
    target = (0, 0, 0)
    for v in vectors:
        target = minus(target, v)
    if not any(target):
        return [1] * len(vectors)
    ordered = sorted(range(len(vectors)), key=lambda k: -dot(vectors[k], target))
    for count, size in itertools.product((8, 40, len(ordered)), (1, 2, 3)):  # few of those in its direction suffice
        for chosen in itertools.combinations(ordered[:count], size):
            if found := cone_coefficients([vectors[k] for k in chosen], target):
                weights = [found[1]] * len(vectors)
                for k, coefficient in zip(chosen, found[0]):
                    weights[k] += coefficient
                return reduced(weights)
    return None


# ---- Forms


def form_at_edge(vectors):
    """A form that is zero at two opposite vectors, and positive at all others."""
    known = set(vectors)
    axis = next((v for v in vectors if times(-1, v) in known), None)
    if axis is None:
        return None
    sides = [minus(times(dot(axis, axis), v), times(dot(axis, v), axis)) for v in vectors if any(cross(axis, v))]
    first = last = sides[0] if sides else None
    for side in sides:
        if dot(axis, cross(first, side)) < 0:
            first = side
        if dot(axis, cross(last, side)) > 0:
            last = side
    if first is None or not dot(axis, cross(first, last)):
        return first
    return plus(cross(axis, first), cross(last, axis))


def form_at_polygon(vectors):
    """A form that is zero in a plane through two vectors, and not negative elsewhere."""
    for a, b in itertools.combinations(vectors, 2):
        n = cross(a, b)
        if any(n):
            for form in (n, times(-1, n)):
                if all(dot(form, v) >= 0 for v in vectors):
                    return form
    return None


def certificate_at_face(vectors, face_dimension):
    form = (0, 0, 0)
    if face_dimension is not None:
        form = (form_at_edge if face_dimension == 1 else form_at_polygon)(vectors)
    if form is None:
        return None
    on_face = [dot(form, v) == 0 for v in vectors]
    found = positive_weights([v for v, on in zip(vectors, on_face) if on])
    if not found:
        return None
    left = iter(found)
    return [next(left) if on else 0 for on in on_face], tuple(reduced(form))


def certificate(points, face_dimension):
    """Weights and a form for a contact set, or such as are surely refused.

    The dimension of the face is None for a critical point. If it is another one, the certificate shows that.
    """
    center = center_of(points)
    vectors = in_integers([minus(p, center) for p in points])
    for dimension in [face_dimension, *({None, 1, 2} - {face_dimension})]:
        if found := certificate_at_face(vectors, dimension):
            return found
    return [0] * len(points), (0, 0, 0)
