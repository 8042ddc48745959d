"""What the program says of an input: its page, and what other commands say, each asked once.

Guarantees: nothing here knows how the page works; expected values come from `compute`, `persistence` and `surface`.
A record is named by its contact set, a tuple of rows.
"""
import base64
import functools
import json
import pathlib
import struct
import subprocess
import zlib
from fractions import Fraction

import inputs

LETTERS = {"f64": "d", "f32": "f", "u32": "I", "u8": "B"}
NONE = 0xFFFFFFFF
OPENING = '<script type="application/json" id="flowcert-data">'


def numbers(blob):
    letter = LETTERS[blob["type"]]
    planes = zlib.decompress(base64.b64decode(blob["data"])) if blob["data"] else b""
    rows = bytearray(len(planes))
    size, count = struct.calcsize("<" + letter), blob["count"]
    for plane in range(size):
        rows[plane::size] = planes[plane * count:(plane + 1) * count]
    return struct.unpack(f"<{count}{letter}", rows)


class Program:
    def __init__(self, path, folder):
        self.path = str(pathlib.Path(path).resolve())
        self.folder = folder
        self.pages = {}

    def run(self, *words, statuses=(0,)):
        done = subprocess.run([self.path, *map(str, words)], capture_output=True, check=False)
        assert done.returncode in statuses, done.stderr.decode()
        return done.stdout.decode()

    def page(self, name, text, options=(), statuses=(0,)):
        if name not in self.pages:
            source = pathlib.Path(inputs.BUNNY)
            if text is not None:
                source = self.folder / f"{name}.xyz"
                source.write_text(text)
            path = self.folder / f"{name}.html"
            self.run("view", source, "-o", path, *options, statuses=statuses)
            self.pages[name] = Page(self, source, path)
        return self.pages[name]


class Page:
    """A page, and what the commands say of its input."""

    def __init__(self, program, source, path):
        self.program, self.source, self.path = program, source, path

    @functools.cached_property
    def data(self):
        text = self.path.read_text()
        begin = text.index(OPENING) + len(OPENING)
        return json.loads(text[begin:text.index("</script>", begin)])

    @functools.cached_property
    def summary(self):
        return json.loads(self.program.run("compute", self.source, "--json"))

    @functools.cached_property
    def persistence(self):
        return json.loads(self.program.run("persistence", self.source, "--json"))

    def surface(self, *selections):
        words = [word for selection in selections for word in ("--select", selection)]
        file = self.program.folder / "surface.ply"
        return json.loads(self.program.run("surface", self.source, "--json", "-o", file, *words))

    @functools.cached_property
    def records(self):
        """All lines of compute -o, with limits of orbits."""
        file = self.program.folder / "records.jsonl"
        self.program.run("compute", self.source, "--manifolds", "u2", "-o", file)
        lines = file.read_text().splitlines()[1:]
        file.unlink()
        return [json.loads(line) for line in lines]

    @functools.cached_property
    def names(self):
        """The page's own records, as contact sets of rows; then samples, likewise."""
        records = self.data["records"]
        offsets, contacts = numbers(records["contact_offsets"]), numbers(records["contacts"])
        rows = numbers(self.data["sample_rows"])
        named = [tuple(rows[s] for s in contacts[a:b]) for a, b in zip(offsets, offsets[1:])]
        return named, [(row,) for row in rows]

    def name(self, point):
        """The contact set of {record: n} or {sample: n}, as the page names points."""
        records, samples = self.names
        return records[point["record"]] if "record" in point else samples[point["sample"]]

    @functools.cached_property
    def places(self):
        """{contact set: {record: n} or {sample: n}}."""
        records, samples = self.names
        found = {name: {"sample": i} for i, name in enumerate(samples)}
        found.update({name: {"record": i} for i, name in enumerate(records)})
        return found

    @functools.cached_property
    def pairs(self):
        """(dimension, birth, death) of each pair, in the page's order; an end is (squared distance, contact set), or
        None. They are those of persistence --json."""

        def end(value):
            return value and (Fraction(value["squared_distance"]), tuple(value["contact"]))

        told = {(p["dimension"], end(p["birth"]), end(p["death"])) for p in self.persistence["pairs"]}
        by_names = {(d, birth[1], death and death[1]): (d, birth, death) for d, birth, death in told}
        assert len(by_names) == len(told) == self.data["pairs"]["dimension"]["count"]
        return [by_names[key] for key in self.listed_pairs()]

    def listed_pairs(self):
        """The page's pairs: dimension, and two contact sets, or None."""
        records, samples = self.names
        columns = [numbers(self.data["pairs"][key]) for key in ("dimension", "birth", "birth_sample", "death")]
        for dimension, birth, sample, death in zip(*columns):
            begin = records[birth] if sample == NONE else samples[sample]
            yield dimension, begin, None if death == NONE else records[death]
