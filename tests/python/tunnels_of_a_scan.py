"""Draws the longest tunnels of a scan: a loop around each, at a level, over its points.

usage: tunnels_of_a_scan.py SCAN PICTURE.svg [LEVEL]      (SCAN: PLY, OBJ, OFF or text; LEVEL as fc.cycles() has it)
"""

import sys

import flowcert
import numpy as np

COLOURS = ("#d1242f", "#0969da", "#1a7f37", "#bf8700", "#8250df", "#bc4c00", "#1b7c83", "#bf3989", "#57606a", "#24292f")
WIDTH, MARGIN = 1000, 20

points = flowcert.read_points(sys.argv[1])
loops = flowcert.FlowComplex(points).cycles(longest=10, level=sys.argv[3] if len(sys.argv) > 3 else "25%")

# Seen from in front and below, with y up.
turn, tilt = np.radians(25), np.radians(-50)
x, y, z = points.T
x, z = x * np.cos(turn) - z * np.sin(turn), x * np.sin(turn) + z * np.cos(turn)
flat = np.stack([x, z * np.sin(tilt) - y * np.cos(tilt)], axis=1)
low, high = flat.min(axis=0), flat.max(axis=0)
scale = (WIDTH - 2 * MARGIN) / max(high - low)
height = (high - low)[1] * scale + 2 * MARGIN
flat = (flat - low) * scale + MARGIN

with open(sys.argv[2], "w", encoding="ascii") as file:
    file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}">\n')
    file.write('<rect width="100%" height="100%" fill="white"/>\n')
    # A dozen thousand points show the shape as well as all.
    dots = "".join(f"M{x:.1f} {y:.1f}h0" for x, y in flat[:: len(flat) // 12_000 + 1])
    file.write(f'<path d="{dots}" stroke="#b3b9c1" stroke-width="1.5" stroke-linecap="round"/>\n')
    # The longest is drawn last, above the others.
    for loop, colour in reversed(list(zip(loops, COLOURS))):
        for polygon in loop.polygons:
            corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in flat[polygon])
            file.write(f'<polygon points="{corners}" fill="none" stroke="{colour}" stroke-width="3"/>\n')
    file.write("</svg>\n")
for number, loop in enumerate(loops, 1):
    faces = len(loop.surface.faces)
    print(f"{number}: {len(loop.edges)} edges of length {loop.loop_length:.4g}, filled by {faces} triangles")
