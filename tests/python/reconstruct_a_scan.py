"""Reconstructs a shape from its samples, as the paper does: by the stable manifolds of saddles with small circles.

usage: reconstruct_a_scan.py SCAN SHAPE.off      (SCAN: PLY, OBJ, OFF or text)
"""

import sys

import flowcert
import numpy as np

fc = flowcert.FlowComplex(flowcert.read_points(sys.argv[1]))

# A saddle of index 1 is the midpoint of two neighbours, at half their distance from both.
midpoints = fc.critical_points[fc.critical_points["index"] == 1]
spacing = 2 * np.sqrt(np.median(midpoints["squared_distance"]))

# Circles through neighbours on the shape are about as small. Those across its inside are larger.
vertices, faces = fc.surface(select=f"index2-radius<{spacing}")

with open(sys.argv[2], "w", encoding="ascii") as file:
    file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
    np.savetxt(file, vertices, fmt="%.17g")
    np.savetxt(file, np.insert(faces, 0, 3, axis=1), fmt="%d")
print(f"{len(vertices):,} vertices, {len(faces):,} triangles; circles below {spacing:.4g}")
