"""The figures in the prose of the tutorial's pages, and where each comes from.

Guarantees: a number in the prose is in a block of its page, or is the rounding of one that is, or a function below
computes it or the phrase that it is in, from what the page's blocks have made and from files.
No such numbers are in targets of links, codes such as FC-CERT-03, references such as "page 2", commands in the text.

FIGURES has a function for each page. It takes who has done the page, and what was printed, and returns {a number as the
prose has it: what it is; or a phrase of the prose: whether it is true}.
"""

import decimal
import itertools
import json
import re

import numpy as np
import page_blocks  # tutorial_test.py says where
import pictures
from pictures import ROOT

# A comma is between thousands in "5,954", and not in "[207,356]".
NUMBER = re.compile(
    r"(?<!\w)(?<![A-Za-z_][-.])(?:(?<![\[,])\d{1,3}(?:,\d{3})+(?!\d)|\d+)(?:\.\d+)?(?:e[-+]?\d+)?"
)


def prose_of(text):
    """The page without its blocks, in one line."""
    prose = " ".join(re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL).split())
    prose = re.sub(r"\]\([^)]*\)", "]", prose)
    return re.sub(r"`[^`]*`", lambda inline: "``" if " " in inline[0] else inline[0], prose)


def number(word):
    return decimal.Decimal(word.replace(",", ""))


def is_rounding(word, value):
    """Whether the word is the value, to as many digits as the word has."""
    said = number(word)
    return abs(said - decimal.Decimal(value)) <= decimal.Decimal(1).scaleb(said.as_tuple().exponent) / 2


def faults(text, stated):
    """What is wrong with the figures of a page, a line for each."""
    prose, found = prose_of(text), []
    numbers = {word: float(value) for word, value in stated.items() if NUMBER.fullmatch(word)}
    for phrase in [words for words in stated if words not in numbers]:
        prose, count = re.subn(rf"(?<!\w){re.escape(phrase)}(?!\w|[.,]\d)", "…", prose)
        if not count:
            found.append(f"the page does not say: {phrase}")
        elif not stated[phrase]:
            found.append(f"this is not true: {phrase}")
    said = NUMBER.findall(re.sub(r"\b(page|section) \d+", "…", prose, flags=re.IGNORECASE))
    shown = " ".join(block.source + block.output for block in page_blocks.blocks_of(text))
    values = set(map(number, NUMBER.findall(shown)))
    for word in dict.fromkeys(said):
        if word not in numbers and not any(is_rounding(word, value) for value in values):
            found.append(f"no block shows {word}")
    for word, value in numbers.items():
        if word not in said:
            found.append(f"the page does not say: {word}")
        elif not is_rounding(word, value):
            found.append(f"{word} is {value}")
    return found


def told(text, words):
    """The number after these words at the begin of a line."""
    return float(re.search(rf"^ *{words} +([\d.,]+)", text, re.MULTILINE)[1].replace(",", ""))


def lines_in(paths):
    return sum(path.read_bytes().count(b"\n") for path in paths)


def is_about(said, value):
    return abs(value - said) <= said / 10


def flow_complex(reader, printed):
    texts = [path.read_text(encoding="utf-8") for path in (ROOT / "src/site/tutorial").glob("*.md")]
    scans, proteins = (sum(f"/usr/share/{folder}/" in text for text in texts) for folder in ("glmark2", "pymol"))
    simplices = simplices_of_the_pyramid(reader)
    critical = [told(printed, f"critical points of index {index}") for index in range(4)]
    ring = re.search(r"^ +1 +0\.414 +1\.000 +1\.414  2 3 ", printed, re.MULTILINE)
    version = re.search(r"^Version (\S+),", (ROOT / "spec" / "flow_complex.md").read_text(encoding="utf-8"), re.M)[1]
    return {
        "These seven pages": len(texts) == 7,
        "Four pages read a scan of Debian's `glmark2-data`, and one a protein": (scans, proteins) == (4, 1),
        "twelve points of a plane": len(pictures.PLANE) == 12,
        "Nineteen critical points": sum(critical) == 19,
        "the 5 points, the 8 edges of the pyramid, its 5 faces, and its inside": critical == [5, 8, 5, 1],
        "5 points, 9 edges, 7 triangles and 2 tetrahedra, 23 simplices": simplices == [5, 9, 7, 2],  # 23 together
        "whose version is 1.2": version == "1.2",
        "At radius 1 the edge of points 2 and 3": ring,
    }


def simplices_of_the_pyramid(reader):
    """How many points, edges, triangles and tetrahedra its triangulation has. All of them are in the alpha complex."""
    reader.run("flowcert compute pyramid.xyz --certificate pyramid.fcert")
    points, certificate = (str(reader.folder / name) for name in ("pyramid.xyz", "pyramid.fcert"))
    proof = pictures.module(ROOT / "spec" / "proof.py")
    cells = proof.read_certificate(certificate, proof.Points(points))[0].cells
    parts = {frozenset(part) for cell in cells for k in (1, 2, 3, 4) for part in itertools.combinations(cell, k)}
    return [sum(len(part) == k for part in parts) for k in (1, 2, 3, 4)]


def critical_points(reader, printed):
    fc, edge = reader.names.fc, reader.names.edge
    critical = fc.critical_points
    circles = np.sqrt(critical["squared_distance"][critical["index"] == 2]) / edge
    maxima = critical[critical["index"] == 3]
    nine = maxima[np.argsort(-maxima["squared_distance"])[:9]]
    contacts = [tuple(fc.contacts[slice(*point["contact_offsets"])].tolist()) for point in nine]
    return {
        "More than nine circles of ten have a radius below the median edge": 0.9 < np.mean(circles < 1) < 1,
        "The greatest radius is 28 edges": is_rounding("28", max(circles)),
        "with three empty balls": len(pictures.balls_apart(nine)) == 3,
        "The nine greatest maxima lie in the body": room_of(fc, contacts[0]) == set(contacts),
    }


def room_of(fc, largest):
    """The maxima of the room of the largest one, by contact sets, as it is where the first way out of it opens.

    Saddles are passed from the widest down, and each joins the rooms at both of its sides.
    """
    critical = fc.critical_points
    saddles = critical[critical["index"] == 2]
    rooms = {}
    for saddle in saddles[np.argsort(-saddles["squared_distance"])]:
        a, b, c = fc.points[fc.contacts[slice(*saddle["contact_offsets"])][:3]]
        normal = np.cross(b - a, c - a)
        step = normal * np.sqrt(saddle["squared_distance"] / (normal @ normal)) / 1000
        limits = [fc.orbit(saddle["center"] + side * step).limit for side in (1, -1)]
        one, other = (rooms.setdefault(end, {end}) for end in (limit and limit.contact for limit in limits))
        if None in one | other and largest in one | other:
            return one if largest in one else other
        one |= other
        rooms.update((end, one) for end in one)


def tunnels_and_voids(reader, printed):
    fc = reader.names.fc
    pairs = [fc.persistence_pairs(dimension=dimension, squared=False) for dimension in (0, 1, 2)]
    pairs = [some[np.argsort(some["birth"] - some["death"])] for some in pairs]
    # The first of them are the torus's: one component, two tunnels, one void.
    gaps = np.concatenate([(some["death"] - some["birth"])[count:] for some, count in zip(pairs, (1, 2, 1))])
    first, second = pairs[1]["death"][:2]
    nearest = np.argsort(np.hypot(*fc.points.T[:2]))[:40]
    rows = re.findall(r"^ +([12])  (\S+)  (\S+)  (\S+)  \d", printed, re.MULTILINE)
    [(length, birth)] = [row[1:3] for row in rows if row[0] == "2"]
    deaths = [float(row[3]) for row in rows if row[0] == "1"]
    colours = re.search(r"^COLOURS = .*", (ROOT / "tests/python/tunnels_of_a_scan.py").read_text(), re.MULTILINE)[0]
    return {
        "The first tunnel dies at 2": is_rounding("2.000", first),
        "The second dies at 1": is_rounding("1.000", second),
        "with lengths below 0.2": max(gaps) < 0.2,
        "the 40 innermost points": set(fc.cycles(longest=1)[0].polygons[0]) == set(nearest),
        "loops of ten colours": len(set(re.findall(r"#\w{6}", colours))) == 10,
        "The void, of length 0.404": is_rounding("0.404", length),
        "born at 0.114": is_rounding("0.114", birth),
        "later than each of these tunnels dies": max(deaths) < float(birth),
        "the ten longest loops": "--longest N=10 " in reader.run("flowcert cycles --help"),
    }


def cavities_and_pores(reader, printed):
    cage, protease = reader.names.cage, reader.names.protease
    [chamber], [site, *below] = cage.chambers, protease.chambers[:3]
    wider = [site.diameter / room.diameter for room in below]
    places = protease.points["value"], protease.points["center"]
    gates = np.where(protease.cavities[:, 0] < 0, -np.inf, places[0][protease.cavities[:, 0]])
    peaks, centers = (column[protease.cavities[:, 1]] for column in places)

    def cavities(low, high):
        """The least and the greatest number of cavities, for probes from low to high."""
        radii = np.concatenate([[low, high], gates, peaks])
        radii = radii[(low <= radii) & (radii <= high), None]
        counts = ((gates < radii) & (radii <= peaks)).sum(axis=1)
        return counts.min(), counts.max()

    def statuses(room, *probes):
        return [room.status(probe) for probe in probes]

    # The rooms of the probes that are caught: was an atom of the drug in the widest ball of each?
    rooms = (peaks > float(site.gate)) & (gates < float(site.peak))
    to_drug = np.linalg.norm(centers[rooms, None] - reader.names.drug, axis=2).min(axis=1)
    windows = {cage.windows[k].diameter for k in chamber.windows}
    return {
        "168": (reader.folder / "cage.xyz").read_text().split()[0],
        "0.88": chamber.depth,
        "the four windows: they are equal to the last digit": (len(chamber.windows), len(windows)) == (4, 1),
        "at most 1.814": statuses(chamber, "1.814", "1.815") == ["open", "closed"],
        "up to 2.698 it is caught": statuses(chamber, "2.698", "2.699") == ["closed", "too small"],
        "Chamber 0 is twice as wide as those below it": all(is_rounding("2", ratio) for ratio in wider),
        "ninety near 0.9": round(cavities(0.85, 0.95)[1], -1) == 90,
        "hardly any near 2": cavities(1.75, 2.25)[1] == 1,
        "one to four from 2.5 to 3.4": cavities(2.5, 3.4) == (1, 4),
        "from 3.445 down to 2.527": (
            statuses(site, "3.446", "3.445", "2.527", "2.526") == ["too small", "closed", "closed", "open"]
        ),
        "the site splits into up to four rooms": cavities(2.527, 3.445)[1] == 4 and all(to_drug < peaks[rooms]),
        "hardly anything, and below 1.7 there are": cavities(1.7, 2.5)[1] <= 2 and cavities(1.5, 1.7)[1] > 10,
    }


def surface(reader, printed):
    import flowcert

    table = (reader.folder / "table.txt").read_text()
    spacing, threshold = told(table, "spacing"), told(table, "radii below")
    critical = flowcert.FlowComplex(flowcert.read_points(pictures.BUNNY)).critical_points
    radius = np.sqrt(critical["squared_distance"])
    bubbles = critical[(critical["index"] == 3) & (radius < threshold)]
    middles = middles_of_edges((reader.folder / "bunny.ply").read_bytes())
    at_bubbles = np.zeros(len(middles), bool)
    for bubble in bubbles:
        squared = ((middles - bubble["center"]) ** 2).sum(axis=1)
        at_bubbles |= squared <= bubble["squared_distance"] * (1 + 1e-9)
    vertices, edges, faces = (told(printed, words) for words in ("vertices", "edges of two triangles", "triangles"))
    return {
        "one heap near 1": is_rounding("1", np.median(radius[critical["index"] == 2]) / spacing),
        "1.41": 2 * np.median(radius[critical["index"] == 1]) / spacing,
        "780": len(bubbles),
        "A thousand samples of a sphere": lines_in([reader.folder / "sphere.xyz"]) == 1000,
        "= 2, as on a sphere": vertices - edges + faces == 2,
        "nearly all of the 6,094 edges": len(middles) == 6094 and at_bubbles.mean() > 0.95,
    }


def middles_of_edges(ply):
    """Of the edges of more than two triangles."""
    header, _, body = ply.partition(b"end_header\n")
    vertices, faces = map(int, re.findall(rb"^element \w+ (\d+)", header, re.MULTILINE))
    places = np.frombuffer(body, "<f8", 3 * vertices).reshape(-1, 3)
    corners = np.frombuffer(body, [("size", "u1"), ("corners", "<i4", 3)], faces, places.nbytes)["corners"]
    ends = np.sort(corners[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)).astype(np.int64)
    edges, counts = np.unique(ends[:, 0] * vertices + ends[:, 1], return_counts=True)
    one, other = np.divmod(edges[counts > 2], vertices)
    return (places[one] + places[other]) / 2


def judge(reader, printed):
    files = (ROOT / "spec" / "vectors").glob("*.json")
    questions = sum(len(json.loads(path.read_text(encoding="utf-8")).get("cases", [])) for path in files)
    rounding, infinite, right = (told(printed, words) for words in ("rounding", "unreadable", "fails:"))
    [row] = re.findall(r"^  all +(\d+) +(\d+) +(\d+)$", printed, re.MULTILINE)
    cases, conform, perturbed = map(int, row)
    return {
        "the middle of the side from 0 to 2 is a saddle": "the saddle of edge 0 2 " in printed,
        "1,504": questions,
        "Eight of 72 answers are wrong": right == 72 - 8,
        "six by rounding and two by a number that is infinite": (rounding, infinite) == (6, 2),
        "Nothing is wrong now, and more than half": conform + perturbed == cases < 2 * perturbed,
    }


def prove(reader, printed):
    sources = [path for kind in ("*.cpp", "*.h") for path in (ROOT / "src").rglob(kind)]
    size, cells = (reader.folder / "thin.fcert").stat().st_size, told(printed, "proved: these")
    return {
        "about 60,000 lines of C++": is_about(60_000, lines_in(sources)),
        "about 600 lines of Python": is_about(600, lines_in([ROOT / "spec" / "proof.py"])),
        "about two bytes each": is_rounding("2", size / cells),
    }


FIGURES = {page.__name__: page for page in (
    flow_complex, critical_points, tunnels_and_voids, cavities_and_pores, surface, judge, prove
)}  # fmt: skip
