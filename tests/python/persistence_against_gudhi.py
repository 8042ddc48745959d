"""Compares the persistence of the flow complex with that of GUDHI's alpha complex. They are the same by a theorem.

usage: persistence_against_gudhi.py SCAN      (PLY, OBJ, OFF or text)
"""

import sys

import flowcert
import gudhi

points = flowcert.read_points(sys.argv[1])
ours = flowcert.FlowComplex(points).persistence()
theirs = gudhi.AlphaComplex(points=points, precision="exact").create_simplex_tree().persistence()

# GUDHI rounds its values, so a pair may be a little off, or have a length a little above zero.
for dimension, name in enumerate(("components", "tunnels", "voids")):
    diagrams = [[interval for d, interval in pairs if d == dimension] for pairs in (ours, theirs)]
    distance = gudhi.bottleneck_distance(*diagrams)
    print(f"{name}: {len(diagrams[0]):,} and {len(diagrams[1]):,} pairs, bottleneck distance {distance:.2g}")
