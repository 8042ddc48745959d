"""GUDHI's alpha complex, by its Python interface (Debian's python3-gudhi).

KIND is a precision, fast, safe or exact: the critical simplices. They are the simplices whose value in the filtration
is more than those of their facets and less than those of their cofacets. What GUDHI delivers is the filtration, and
this is the usual way to read critical points off it.
KIND-persistence: the persistence diagram, as lines `dimension birth death`.
KIND-cells: the simplices of the highest dimension, as lines of ids, for triangulations.py.
"""

from itertools import combinations
from math import isfinite

import gudhi

import answering

PRECISIONS = ("fast", "safe", "exact")


def tree_of(rows, precision):
    return gudhi.AlphaComplex(points=rows, precision=precision).create_simplex_tree()


def critical_simplices(tree):
    value_of = {tuple(sorted(simplex)): value for simplex, value in tree.get_filtration()}
    paired = set()
    for simplex, value in value_of.items():
        for facet in combinations(simplex, len(simplex) - 1):
            if facet and value_of[facet] >= value:
                paired |= {simplex, facet}
    return [(simplex, value) for simplex, value in value_of.items() if simplex not in paired]


def cell_lines(tree):
    simplices = [simplex for simplex, _ in tree.get_simplices()]
    most = max(map(len, simplices), default=0)
    return "".join(" ".join(map(str, simplex)) + "\n" for simplex in simplices if len(simplex) == most > 1)


def answer_of(kind, rows):
    precision, _, what = kind.partition("-")
    tree = tree_of(rows, precision)
    if what == "persistence":
        pairs = tree.persistence(homology_coeff_field=2, min_persistence=0, persistence_dim_max=True)
        return "".join(f"{dimension} {birth!r} {death!r}\n" for dimension, (birth, death) in pairs)
    if what == "cells":
        return cell_lines(tree)
    # A value beyond the doubles is inf, and is not claimed.
    return "".join(f"{len(simplex) - 1},,,,{value if isfinite(value) else ''},{','.join(map(str, simplex))}\n"
                   for simplex, value in critical_simplices(tree))


if __name__ == "__main__":
    answering.main([p + what for what in ("", "-persistence", "-cells") for p in PRECISIONS], answer_of)
