#!/usr/bin/env python3
"""The pictures of the tutorial, a page one each, made of what the program of a build computes.

usage: pictures.py FLOWCERT FOLDER [PICTURE…]       (without names: all)

Guarantees: nothing is drawn by hand but what says so in its place; the Python package is that of the same build.
SVG needs no browser; the PNG are of viewer pages, in headless Chromium, as ./dev web --pictures takes them.
Needs Debian's glmark2-data and pymol-data; for PNG also chromium-driver and python3-selenium.
"""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUNNY = "/usr/share/glmark2/models/bunny.obj"
PROTEASE = "/usr/share/pymol/data/tut/1hpv.pdb"

# Points of a plane in general position, for pictures of what happens in space.
PLANE = ((1, 2), (2, 8), (5, 4), (7, 10), (9, 1), (10, 6), (13, 9), (14, 3), (17, 6), (18, 11), (19, 1), (7, 7))
RADIUS = 2.8  # of the discs: some edges and triangles are there, and others not yet

INK, GREY, LIGHT, RED, BLUE = "#24292f", "#8c959f", "#d0d7de", "#d1242f", "#0969da"
HUES = ("#fde2e4", "#dbeafe", "#dcfce7", "#fef3c7", "#ede9fe", "#cffafe", "#ffe4cc", "#e2e8f0", "#fce7f3", "#ecfccb")


class Drawing:
    """An SVG of shapes in the coordinates of the data, y up."""

    def __init__(self, low, high, width):
        self.scale = width / (high[0] - low[0])
        self.low, self.top = low, high[1]
        self.size = width, round((high[1] - low[1]) * self.scale)
        self.parts = []

    def at(self, place):
        return (place[0] - self.low[0]) * self.scale, (self.top - place[1]) * self.scale

    def disc(self, place, radius, style):
        x, y = self.at(place)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" {style}/>')

    def dot(self, place, size, colour):
        self.disc(place, size / self.scale, f'fill="{colour}"')

    def line(self, places, style):
        corners = " ".join("{:.1f},{:.1f}".format(*self.at(place)) for place in places)
        self.parts.append(f'<polyline points="{corners}" fill="none" {style}/>')

    def polygon(self, places, style):
        corners = " ".join("{:.1f},{:.1f}".format(*self.at(place)) for place in places)
        self.parts.append(f'<polygon points="{corners}" {style}/>')

    def dots(self, places, colour, size):
        path = "".join("M{:.1f} {:.1f}h0".format(*self.at(place)) for place in places)
        self.parts.append(f'<path d="{path}" stroke="{colour}" stroke-width="{size}" stroke-linecap="round"/>')


def write(path, *drawings):
    """Drawings side by side."""
    width = sum(drawing.size[0] for drawing in drawings)
    height = max(drawing.size[1] for drawing in drawings)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">',
             '<rect width="100%" height="100%" fill="white"/>']  # fmt: skip
    left = 0
    for drawing in drawings:
        lines += [f'<svg x="{left}" width="{drawing.size[0]}" height="{height}">', *drawing.parts, "</svg>"]
        left += drawing.size[0]
    path.write_text("\n".join([*lines, "</svg>", ""]), encoding="ascii")


class Maker:
    """What the pictures are made with."""

    def __init__(self, program, scratch):
        self.program = pathlib.Path(program).resolve()
        self.scratch = scratch
        sys.path.insert(0, str(self.program.parent / "python"))

    def run(self, *words, statuses=(0,)):
        done = subprocess.run([self.program, *map(str, words)], cwd=self.scratch, check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip
        if done.returncode not in statuses:
            sys.exit(done.stderr)

    def plane(self):
        """The flow complex of PLANE, and the triangles of its certificate as spec/proof.py reads them."""
        import flowcert

        rows = [(x, y, 0) for x, y in PLANE]
        points, certificate = self.scratch / "plane.xyz", self.scratch / "plane.fcert"
        points.write_text("".join("{} {} {}\n".format(*row) for row in rows))
        self.run("compute", points, "--certificate", certificate)
        proof = module(ROOT / "spec" / "proof.py")
        found, _ = proof.read_certificate(str(certificate), proof.Points(str(points)))
        fc = flowcert.FlowComplex(rows)
        assert not any(fc.regular_counts.values())
        return fc, [tuple(cell) for cell in found.cells]


def module(path):
    specification = importlib.util.spec_from_file_location(path.stem, path)
    found = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(found)
    return found


def circle_of(triangle):
    """(centre, radius) of the circle through three of PLANE."""
    (ax, ay), (bx, by), (cx, cy) = (PLANE[i] for i in triangle)
    bx, by, cx, cy = bx - ax, by - ay, cx - ax, cy - ay
    twice = 2 * (bx * cy - by * cx)
    x = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / twice
    y = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / twice
    return (ax + x, ay + y), (x * x + y * y) ** 0.5


def plane_drawing(width):
    return Drawing((-2, -2), (22, 14), width)


def flow_complex(maker, path):
    fc, triangles = maker.plane()
    critical = fc.critical_points
    edges = {}  # with the radius at which the alpha complex has them
    for triangle in triangles:
        for pair in ((0, 1), (0, 2), (1, 2)):
            edge = tuple(sorted(triangle[i] for i in pair))
            edges[edge] = min(edges.get(edge, RADIUS * 9), circle_of(triangle)[1])
    gabriel = {}
    for point in critical[critical["index"] == 1]:
        edge = tuple(fc.contacts[slice(*point["contact_offsets"])].tolist())
        gabriel[edge] = edges[edge] = point["squared_distance"] ** 0.5

    left = plane_drawing(560)
    for place in PLANE:
        left.disc(place, RADIUS, f'fill="{LIGHT}" fill-opacity="0.5" stroke="{GREY}"')
    for triangle in triangles:
        if circle_of(triangle)[1] <= RADIUS:
            left.polygon([PLANE[i] for i in triangle], f'fill="{BLUE}" fill-opacity="0.35"')
    for edge, radius in edges.items():
        if radius <= RADIUS:
            left.line([PLANE[i] for i in edge], f'stroke="{BLUE}" stroke-width="2"')

    right = plane_drawing(560)
    vertices, faces, saddles, _ = fc.stable_surfaces()
    hues = dict(zip(sorted(set(saddles.tolist())), HUES * 3))
    for face, saddle in zip(faces, saddles.tolist()):
        right.polygon([vertices[i] for i in face], f'fill="{hues[saddle]}" stroke="{hues[saddle]}"')
    for edge in gabriel:
        right.line([PLANE[i] for i in edge], f'stroke="{INK}" stroke-width="2"')
        (ax, ay), (bx, by) = (PLANE[i] for i in edge)
        for side in (1, -1):  # both ways out of the saddle, from a little beside it
            start = (ax + bx) / 2 - side * (by - ay) / 4096, (ay + by) / 2 + side * (bx - ax) / 4096
            way = [start]
            for segment in fc.orbit([*start, 0]).segments:
                if segment.end is not None:
                    way.append(tuple(map(float, segment.end[:2])))
                else:
                    away = [float(s) - float(d) for s, d in zip(segment.start, segment.driver)]
                    size = (away[0] ** 2 + away[1] ** 2) ** 0.5
                    way.append(tuple(float(s) + 40 * a / size for s, a in zip(segment.start[:2], away)))
            # Drawn from its end, so that dashes of two ways that become one lie upon each other.
            right.line(way[::-1], f'stroke="{RED}" stroke-dasharray="4 3"')
    for point in critical:
        colour, size = ((INK, 4.5), (RED, 3.5), (BLUE, 5))[point["index"]]
        right.dot(point["center"], size, colour)
    for place in PLANE:
        left.dot(place, 4.5, INK)
    write(path, left, right)


def balls_apart(maxima):
    """(centre, radius) of their balls, the largest first, without those that overlap one before."""
    found = []
    for maximum in sorted(maxima, key=lambda point: -point["squared_distance"]):
        center, radius = maximum["center"], maximum["squared_distance"] ** 0.5
        if all(((center - other) ** 2).sum() ** 0.5 >= radius + size for other, size in found):
            found.append((center, radius))
    return found


def critical_points(_, path):
    import flowcert

    points = flowcert.read_points(BUNNY)
    fc = flowcert.FlowComplex(points)
    [body] = fc.cycles(2, longest=1, level="birth")
    maxima = fc.critical_points[body.maxima]
    drawing = Drawing(points.min(axis=0)[:2] - 0.1, points.max(axis=0)[:2] + 0.1, 760)
    drawing.dots(points[::4], LIGHT, 2)
    for center, radius in balls_apart(maxima):
        drawing.disc(center, radius, f'fill="{BLUE}" fill-opacity="0.25" stroke="{BLUE}"')
        drawing.dot(center, 3, INK)
    write(path, drawing)


def tunnels_and_voids(maker, path):
    example = ROOT / "tests" / "python" / "tunnels_of_a_scan.py"
    subprocess.run([sys.executable, example, BUNNY, path], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "PYTHONPATH": str(maker.program.parent / "python")})  # fmt: skip


def cavities_and_pores(maker, path):
    shutil.copy(PROTEASE, maker.scratch / "1hpv.pdb")
    maker.run("pores", "1hpv.pdb", "--radii", "bondi", "--atoms", "no water,no ligands", "--curve", path.resolve())


def prove(maker, path):
    _, triangles = maker.plane()
    drawing = plane_drawing(760)
    for triangle in triangles:
        drawing.disc(*circle_of(triangle), f'fill="none" stroke="{LIGHT}"')
    for triangle in triangles:
        drawing.polygon([PLANE[i] for i in triangle], f'fill="none" stroke="{GREY}"')
    # The two triangles of a side in the middle, with their circles.
    side = {2, 11}
    for triangle, colour in zip([t for t in triangles if side < set(t)], (BLUE, RED)):
        drawing.polygon([PLANE[i] for i in triangle], f'fill="{colour}" fill-opacity="0.15" stroke="{INK}"')
        drawing.disc(*circle_of(triangle), f'fill="none" stroke="{colour}" stroke-width="2"')
    drawing.line([PLANE[i] for i in side], f'stroke="{INK}" stroke-width="3"')
    for place in PLANE:
        drawing.dot(place, 4.5, INK)
    write(path, drawing)


BARE = "for (const id of ['foot', 'tools']) document.getElementById(id).style.display = 'none';"


def of_page(words, prepare, script="", statuses=(0,)):
    """A picture of the page that `flowcert view` writes, in headless Chromium, without its buttons."""

    def make(maker, path):
        sys.path.insert(0, str(ROOT / "tests" / "web"))
        web, browsers = module(ROOT / "tests" / "web" / "pictures.py"), importlib.import_module("browser")
        prepare(maker.scratch)
        page = maker.scratch / "page.html"
        maker.run("view", *words, "-o", page, statuses=statuses)
        with browsers.Browser() as browser:
            browser.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                "width": web.SIZE[0], "height": web.SIZE[1], "deviceScaleFactor": 1, "mobile": False})  # fmt: skip
            browser.open(page)
            browser.run(BARE + script)
            browser.rest()
            web.save(browser, path)

    return make


def write_triangle(scratch):
    (scratch / "triangle.xyz").write_text("0 0 0\n3 0 0\n0 4 0\n")
    (scratch / "claim.csv").write_text("index,x,y,z\n1,1.5,0,0\n1,1.5,2,0\n")


PICTURES = {
    "flow_complex.svg": flow_complex,
    "critical_points.svg": critical_points,
    "tunnels_and_voids.svg": tunnels_and_voids,
    "cavities_and_pores.svg": cavities_and_pores,
    "surface.png": of_page([BUNNY], lambda scratch: None, "flowcert.full_detail(true);"),
    "judge.png": of_page(["triangle.xyz", "--claim", "claim.csv", "--indices", "1"], write_triangle,
                         "document.querySelector('.finding').click();", (0, 1)),  # the first finding
    "prove.svg": prove,
}


def main():
    if len(sys.argv) < 3 or any(name not in PICTURES for name in sys.argv[3:]):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        maker = Maker(sys.argv[1], pathlib.Path(scratch))
        for name in sys.argv[3:] or PICTURES:
            PICTURES[name](maker, folder / name)


if __name__ == "__main__":
    main()
