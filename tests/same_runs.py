"""What ./dev same runs: every command, on generated inputs, scans, vectors, claims and the files of tests/inputs.

A run is one call of a program. Its program is `flowcert`, `flowcert-oracle`, `flowcert-proof` or `python3`, by the name
alone: whoever runs it knows the folder. Guarantees: every command that `flowcert --help` lists is in some run, which
the test asks.
"""
import dataclasses
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "conformance"))
import mutated_claims  # noqa: E402

SEEDS = 1000, 2000  # of the generated inputs, level 1
SMALL = 6000        # points of a scan, up to which orbits and exports are compared as well
THINNED = 3000      # points, at least, that are left of a larger scan for them
POSITION = "1/3,0.2,1/7"
POSITIONS = b"0 0 0\n0.3 0.2 0.1\n0.5 0.5 0.5\n-3 2 1e3\n"
ORACLE_POINTS = 12  # of an input of which the oracle tells all stationary points


@dataclasses.dataclass(frozen=True)
class Run:
    name: str                # of the input
    program: str
    words: tuple             # what follows the program
    points: bytes = b""      # on standard input
    files: tuple = ()        # pairs of name and content, in the folder where it runs

    def line(self):
        return f"{self.name}: {self.program} {' '.join(self.words)}"

    def kind(self):
        """The command without its input."""
        return (self.program, *(word for word in self.words if word != self.name))


def commands(source, is_small):
    manifolds = ["--manifolds", "u2,s2", "--stats"]
    yield ["compute", source, "--json", "-o", "points.jsonl"]
    yield ["compute", source, "--manifolds", "s2", "--stats", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, "--manifolds", "all", "--volumes", "shares", "--json", "-o", "all.jsonl"]
    yield ["persistence", source, "--json", "-o", "pairs.pers", "--certificate", "cells.fcert"]
    yield ["pockets", source, "--json"]
    if not is_small:
        return
    yield ["compute", source, *manifolds, "--json", "--polylines", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, *manifolds, "--kernel", "exact", "--search", "linear", "--alone"]
    yield ["compute", source, *manifolds, "--kernel", "lazy", "--polylines", "--skeletons", "-o", "points.jsonl"]
    yield ["compute", source, "--manifolds", "all", "--skeletons", "--sheets", "--volumes", "exact", "-o", "all.jsonl"]
    yield ["compute", source, "--export", "files"]
    yield ["compute", source, "--manifolds", "all", "--export", "files"]
    yield ["persistence", source, "--json", "--zero", "-o", "pairs.pers"]
    yield ["persistence", source, "--json", "--seed-ties", "7"]
    yield ["persistence", source]
    yield ["pockets", source, "--tree", "pockets"]
    yield ["pockets", source, "--csv", "pockets.csv", "--export", "files", "--all"]
    yield ["pores", source, "--radii", "1/4", "--depth", "0", "--json", "--windows-csv", "windows.csv"]
    yield ["stats", source, "--json"]
    yield ["stats", source, "--svg", "pictures"]
    yield ["medial", source, "--json", "--export", "files"]
    yield ["orbit", source, "--from", POSITION, "--json"]
    yield ["orbit", source, "--from", POSITION, "--json", "--search", "linear"]
    yield ["orbit", source, "--from", POSITION, "--kernel", "exact"]
    yield ["explain", source, "--ids", "0,1", "--json"]
    yield ["explain", source, "--at", POSITION]
    yield ["surface", source, "--select", "largest-gaps=3", "-o", "surface.ply"]
    yield ["surface", source, "--select", "persistence>1", "-o", "surface.off", "--json"]
    yield ["view", source, "-o", "page.html", "--cells", "--pockets", "auto"]


def runs_on(name, source, is_small, points=b""):
    for words in commands(source, is_small):
        yield Run(name, "flowcert", tuple(words), points)
    if is_small:
        files = (("positions.xyz", POSITIONS),)
        yield Run(name, "flowcert", ("locate", source, "--positions", "positions.xyz", "--json"), points, files)


def generated(program, count):
    """The points of that many cases, as a point file each."""
    found = []
    for seed in SEEDS:
        command = [program, "generate", "--level", "1", "--seed", str(seed)]
        listing = subprocess.run(command, check=True, capture_output=True)
        lines = iter(listing.stdout.decode().splitlines())
        for line in lines:
            if line.startswith("case "):
                rows = [next(lines) for _ in range(int(line.split()[2]))]
                found.append((line.split()[1], "\n".join(["# a case", *rows, ""]).encode()))
    return found[:count]


def runs_on_generated(inputs):
    for name, points in inputs:
        yield from runs_on(name, "-", True, points)
        files = (("points.xyz", points),)
        if points.count(b"\n") <= ORACLE_POINTS + 1:
            yield Run(name, "flowcert-oracle", ("stationary", "points.xyz", "--json"), b"", files)
        yield Run(name, "flowcert-oracle", ("orbit", "points.xyz", "--from", POSITION, "--json"), b"", files)


def proved_files(program, points):
    """The point file, with the list, the pairs and the certificate of it, if the program takes it."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "points.xyz").write_bytes(points.replace(b"# a case\n", b""))  # comments are not proved
        subprocess.run([program, "compute", "points.xyz", "-o", "list.jsonl", "--certificate", "cells.fcert"],
                       cwd=folder, check=False, capture_output=True)
        pairs = subprocess.run([program, "persistence", "points.xyz", "--json"], cwd=folder, check=False,
                               capture_output=True)
        (folder / "pairs.json").write_bytes(pairs.stdout)
        return {path.name: path.read_bytes() for path in folder.iterdir()}


def with_byte_changed(data, rng):
    place = rng.randrange(len(data))
    return data[:place] + bytes([data[place] ^ 1 << rng.randrange(8)]) + data[place + 1:]


def runs_of_proofs(program, inputs):
    """What is right, and the same with one bit changed in one file."""
    words = ("points.xyz", "cells.fcert", "list.jsonl", "--pairs", "pairs.json")
    for name, points in inputs:
        files, rng = proved_files(program, points), random.Random(name)
        if "cells.fcert" not in files:
            continue
        yield Run(name, "flowcert-proof", words, b"", tuple(files.items()))
        changed = rng.choice(sorted(files))
        files[changed] = with_byte_changed(files[changed], rng)
        yield Run(f"{name}, {changed} changed", "flowcert-proof", words, b"", tuple(files.items()))


def points_of(scan):
    """The lines of a scan's points, as XYZ. Raises ValueError for files that are neither OBJ nor XYZ."""
    keyword = {".obj": 1, ".xyz": 0}.get(scan.suffix)
    if keyword is None:
        raise ValueError(f"{scan} is neither .obj nor .xyz")
    fields = [line.split() for line in scan.read_text().splitlines()]
    rows = [row for row in fields if row and not row[0].startswith("#") and (not keyword or row[0] == "v")]
    return [" ".join(row[keyword:keyword + 3]) for row in rows]


def runs_on_scan(scan, scratch):
    """The runs on a scan and, if it is large, on every so many-th of its points, which are written into scratch."""
    points = points_of(scan)
    is_small = len(points) <= SMALL
    yield from runs_on(scan.name, str(scan.resolve()), is_small)
    if is_small:
        return
    step = len(points) // THINNED
    thinned = scratch / f"{scan.name}-thinned-{step}.xyz"
    thinned.write_text("".join(row + "\n" for row in points[::step]))
    yield from runs_on(thinned.name, str(thinned), True)


# ---- Claims


def vector_cases():
    """All cases of the vectors that have points, by id."""
    found = {}
    for path in sorted((ROOT / "spec" / "vectors").glob("*.json")):
        for case in json.loads(path.read_text()).get("cases", []):
            if case.get("result") != "invalid" and case.get("points"):
                found[case["id"]] = case
    return found


def point_file(rows):
    return "".join(" ".join(row) + "\n" for row in rows).encode()


def checks(name, points, claim):
    files = (("points.xyz", points), ("claim", claim))
    for form in ((), ("--json",)):
        yield Run(name, "flowcert", ("check", "points.xyz", "claim", *form), b"", files)


def runs_on_judgements(cases):
    for one in json.loads((ROOT / "spec" / "judgements.json").read_text())["judgements"]:
        if one.get("case") in cases and "claim" in one:
            claim = "".join(line + "\n" for line in one["claim"]).encode()
            yield from checks(one["id"], point_file(cases[one["case"]]["points"]), claim)


def places_in(value):
    """All lists and objects in a value, itself among them, that are not empty."""
    if isinstance(value, (list, dict)) and value:
        yield value
    for one in value.values() if isinstance(value, dict) else value if isinstance(value, list) else []:
        yield from places_in(one)


def with_place_changed(text, rng):
    """The claim with one value somewhere in it, of any part, left out, repeated, moved or changed a little."""
    head, records = mutated_claims.claim_of(text)
    place = rng.choice([one for record in records for one in places_in(record)])
    key = rng.choice(sorted(place)) if isinstance(place, dict) else rng.randrange(len(place))
    value = place[key]
    if isinstance(value, str) and re.fullmatch(r"-?[0-9]+(/[0-9]+)?", value) and rng.random() < 0.7:
        place[key] = str(Fraction(value) + Fraction(rng.choice([1, -1]), 2 ** rng.choice([1, 20, 44, 60])))
    elif isinstance(value, int) and not isinstance(value, bool) and rng.random() < 0.7:
        place[key] = value + rng.choice([1, -1])
    elif isinstance(place, list) and rng.random() < 0.5:
        place.insert(rng.randrange(len(place) + 1), value if rng.random() < 0.5 else place.pop(key))
    else:
        del place[key]
    return mutated_claims.text_of(head, records)


def right_claim(program, points):
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "claim.jsonl"
        subprocess.run([program, "compute", "-", "-o", target, "--manifolds", "all", "--volumes", "double",
                        "--skeletons", "--sheets", "--polylines"], input=points, check=True, capture_output=True)
        return target.read_text()


def runs_on_mutated_claims(program, cases, count):
    """Claims about the vectors, drawn evenly. The right ones, which are changed, are made by the program."""
    names = sorted(cases)
    for k in range(count):
        case, rng = cases[names[k * len(names) // count]], random.Random(k)
        points = point_file(case["points"])
        text = right_claim(program, points)
        if k % 2 == 0:
            text = with_place_changed(text, rng)
        else:  # mutated() changes points, and what is of infinity is none
            lines = text.splitlines(keepends=True)
            of_points = "".join(line for line in lines if line == lines[0] or '"index":' in line)
            of_infinity = "".join(line for line in lines[1:] if '"index":' not in line)
            text = mutated_claims.mutated(of_points, len(case["points"]), rng) + of_infinity
        yield from checks(f"{case['id']}, change {k}", points, text.encode())


# ---- What needs no points of its own, and what reads files of others


def answers_to(program, asked):
    """Answers to the drawn cases: right, changed, or none, by turns."""
    text = ""
    listing = subprocess.run([program, "generate", *asked], check=True, capture_output=True).stdout.decode()
    lines = iter(listing.splitlines())
    for line in lines:
        words = line.split()
        if words[0] != "case":
            continue
        rows = [next(lines) for _ in range(int(words[2]))]
        rng = random.Random(words[1])
        shape = rng.randrange(8)
        if shape > 0 and rows:
            claim = right_claim(program, "\n".join([*rows, ""]).encode())
            text += f"answer {words[1]}\n{claim if shape > 1 else with_place_changed(claim, rng)}end\n"
    return text.encode()


def runs_without_points(program):
    """Help in all its forms, and the commands that judge programs."""
    listing = subprocess.run([program, "--help"], check=True, capture_output=True).stdout.decode()
    names = re.findall(r"(?m)^  ([a-z]+)  +\S", listing)
    for name in names:
        yield Run(name, "flowcert", (name, "--help"))
    for word in re.findall(r"(?m)^- \*\*(.+?)\*\*", (ROOT / "spec" / "glossary.md").read_text()):
        yield Run(word, "flowcert", ("help", *word.split()))
    with_seed = ("--level", "1", "--seed", "7")
    answers = answers_to(program, with_seed)
    yield Run("no input", "flowcert", ("generate", *with_seed))
    for form in ((), ("--json",)):
        yield Run("answers", "flowcert", ("verify", *with_seed, *form), answers)
        yield Run("no input", "flowcert", ("conformance", "--list", *form))
        yield Run("a program with faults", "flowcert",
                  ("fuzz", "--count", "300", "--seed", "5", "--jobs", "1", "--against", "cat {in}", *form))


def runs_on_files_of_others():
    for path in sorted((ROOT / "tests" / "inputs").iterdir()):
        files = ((path.name, path.read_bytes()),)
        yield Run(path.name, "flowcert", ("compute", path.name, "--json", "-o", "points.jsonl"), b"", files)
        yield Run(path.name, "flowcert", ("compute", path.name, "--skip-invalid", "-o", "points.jsonl"), b"", files)
        yield Run(path.name, "python3", (str(ROOT / "tests" / "same_readers.py"), path.name), b"", files)
