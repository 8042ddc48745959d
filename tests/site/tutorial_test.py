"""The tutorial does what it says: its commands and its Python, in order, print what its pages show, to the byte.

Guarantees: every block of a page is run (src/site/tutorial/page_blocks.py says what a block is), in a folder of the
page's own, with the programs and the package of one build: that of FLOWCERT_BUILD, or build/. FLOWCERT is the clone's
folder, as the first page has it.
Python is pasted line by line into an interactive session, as a reader does it.
An output that differs in one character is a failure, and so is a page without outputs, or without one picture.
A number in the prose that no block shows and nothing computes is one, too (figures_of_pages.py).
A page that reads a file of a Debian package which is not there is skipped.

    tutorial_test.py --accept [PAGE…]      writes what is printed now into the pages
"""

import code
import contextlib
import io
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import xml.etree.ElementTree

import pytest

ROOT = pathlib.Path(__file__).parents[2]
BUILD = pathlib.Path(os.environ.get("FLOWCERT_BUILD", ROOT / "build"))
TUTORIAL = ROOT / "src" / "site" / "tutorial"
sys.path[:0] = [str(TUTORIAL), str(BUILD / "python")]

import figures_of_pages  # noqa: E402
import page_blocks  # noqa: E402
import pictures  # noqa: E402

PAGES = ("flow_complex", "critical_points", "tunnels_and_voids", "cavities_and_pores", "surface", "judge", "prove")
PACKAGES = {"/usr/share/glmark2": "glmark2-data", "/usr/share/pymol": "pymol-data"}


def text_of(page):
    return (TUTORIAL / f"{page}.md").read_text(encoding="utf-8")


class Reader:
    """Who does what a page says, in a folder."""

    def __init__(self, folder):
        self.folder, self.session = folder, code.InteractiveConsole()
        path = f"{BUILD}:{os.environ['PATH']}"
        self.environment = {**os.environ, "FLOWCERT": str(ROOT), "PATH": path, "LC_ALL": "C"}

    @property
    def names(self):
        """What the session has, by name."""
        return types.SimpleNamespace(**self.session.locals)

    def do(self, block):
        """What is printed."""
        if block.kind == "file":
            (self.folder / block.name).write_text(block.source, encoding="utf-8")
            return ""
        if block.kind == "python":
            return self.paste(block.source)
        return self.run(block.source)

    def run(self, commands):
        """What they print."""
        finished = subprocess.run(
            ["bash", "-c", commands], cwd=self.folder, env=self.environment, check=False, text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
        return finished.stdout

    def paste(self, source):
        """What python3 prints, errors included. A loop at the end takes one more empty line."""
        printed = io.StringIO()
        with contextlib.chdir(self.folder), contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
            goes_on = [self.session.push(line) for line in [*source.splitlines(), ""]][-1]
        return printed.getvalue() + "...\n" * goes_on


def missing_package(text):
    return next((package for path, package in PACKAGES.items() if path in text and not os.path.exists(path)), None)


@pytest.fixture(scope="module", params=PAGES)
def done(request, tmp_path_factory):
    """A page, who has done what it says, and what was printed for each block."""
    page = request.param
    package = missing_package(text_of(page))
    if package:
        pytest.skip(f"{package} is missing")
    reader = Reader(tmp_path_factory.mktemp(page))
    return page, reader, [reader.do(block) for block in page_blocks.blocks_of(text_of(page))]


def test_a_page_prints_what_it_shows(done):
    page, _, outputs = done
    blocks = page_blocks.blocks_of(text_of(page))
    assert sum(block.output != "" for block in blocks) >= 2
    for block, output in zip(blocks, outputs):
        assert output == block.output, f"{page}.md:{block.line}: {block.source}"


def test_figures_in_the_prose_are_true(done):
    page, reader, outputs = done
    stated = figures_of_pages.FIGURES[page](reader, "".join(outputs))
    found = figures_of_pages.faults(text_of(page), stated)
    assert not found, "\n".join([f"{page}.md", *found])


def test_all_pages_are_tested():
    assert {path.stem for path in TUTORIAL.glob("*.md")} == set(PAGES) == set(figures_of_pages.FIGURES)


@pytest.mark.parametrize("page", PAGES)
def test_a_page_has_one_picture_that_is_made(page):
    made = [picture for picture in pictures.PICTURES if picture.startswith(page)]
    assert page_blocks.pictures_of(text_of(page)) == made and len(made) == 1


@pytest.mark.parametrize("page", PAGES)
def test_a_page_leads_to_the_next(page):
    links = re.findall(r"\]\((\w+)\.md\)", text_of(page).splitlines()[-1])
    assert links == [dict(zip(PAGES, PAGES[1:])).get(page, PAGES[0])]
    for number, name in re.findall(r"\[page (\d)\]\((\w+)\.md\)", text_of(page), re.IGNORECASE):
        assert PAGES[int(number) - 1] == name


def circles_in(path):
    """[(x, y, radius, colour of the inside)], in the units of the picture."""
    circles = xml.etree.ElementTree.parse(path).iter("{http://www.w3.org/2000/svg}circle")
    return [(*(float(circle.get(key)) for key in ("cx", "cy", "r")), circle.get("fill")) for circle in circles]


def test_pictures_of_a_plane_show_what_is_true(tmp_path):
    maker = pictures.Maker(BUILD / "flowcert", tmp_path)
    fc, triangles = maker.plane()
    pictures.flow_complex(maker, tmp_path / "flow_complex.svg")
    drawn = circles_in(tmp_path / "flow_complex.svg")
    for colour, index in ((pictures.RED, 1), (pictures.BLUE, 2)):
        assert sum(circle[3] == colour for circle in drawn) == fc.counts[index] > 8
    pictures.prove(maker, tmp_path / "prove.svg")
    drawn = circles_in(tmp_path / "prove.svg")
    points = [circle[:2] for circle in drawn if circle[3] == pictures.INK]
    circles = [circle[:3] for circle in drawn if circle[3] == "none"]
    assert len(points) == len(pictures.PLANE) and len(circles) == len(triangles) + 2
    for x, y, radius in circles:
        distances = sorted(math.dist((x, y), point) for point in points)
        assert distances[0] > radius - 1 and distances[2] < radius + 1 < distances[3]


def test_changed_outputs_are_seen(tmp_path):
    """A page of each kind of block, with a digit that is not what is printed."""
    page = "```console\n$ echo 12\n12\n$ echo a \\\n> b\na b\n```\n\n```python\nprint(3)\n```\n\n```text\n4\n```\n"
    command, longer, python = blocks = page_blocks.blocks_of(page)
    outputs = [Reader(tmp_path).do(block) for block in blocks]
    assert outputs == ["12\n", "a b\n", "3\n"]
    assert (command.output, longer.output, python.output) == ("12\n", "a b\n", "4\n")
    assert page_blocks.with_outputs(page, outputs) == page.replace("4", "3")
    without = page.replace("12\n12", "12").split("\n\n```text")[0] + "\n"
    assert page_blocks.with_outputs(page, ["", "a b\n", ""]) == without


def test_wrong_figures_are_seen():
    """A page with each sort of figure, and with one that is changed."""
    page = "Of 1,234 rows 0.67 are [good](page_9.md), by FC-CERT-03 and `do 8`, see page 5; 7 circles.\n\n"
    page += "```console\n$ echo 1234 0.6666\n1234 0.6666\n```\n"
    stated = {"7": 7.2, "Of 1,234 rows": True}

    def faults(old="", new="", **more):
        return figures_of_pages.faults(page.replace(old, new), {**stated, **more})

    assert faults() == []
    assert faults("1,234 rows", "1,235 rows") == ["the page does not say: Of 1,234 rows", "no block shows 1,235"]
    assert faults("0.67", "0.66") == ["no block shows 0.66"]
    assert faults("7 c", "6 c") == ["no block shows 6", "the page does not say: 7"]
    assert faults(**{"7": 7.6}) == ["7 is 7.6"]
    assert faults(**{"circles": False}) == ["this is not true: circles"]


def test_what_cannot_be_pasted_is_seen(tmp_path):
    """An interactive session ends a loop at an empty line, and nowhere else."""
    reader = Reader(tmp_path)
    assert reader.paste("for x in (1, 2):\n    print(x)\n\nprint(3)\n") == "1\n2\n3\n"
    assert "SyntaxError" in reader.paste("for x in (1, 2):\n    print(x)\nprint(3)\n")
    assert "IndentationError" in reader.paste("def f():\n    print(1)\n\n    print(2)\n")
    assert reader.paste("print(\n") == "...\n"


@pytest.mark.parametrize("page", ["```console\nno command\n```\n", "```text\nof nothing\n```\n", "```sh\nls\n```\n",
                                  "```python\n", "Save it.\n\n```python mine.py\n```\n"])  # fmt: skip
def test_a_page_of_another_form_is_refused(page):
    with pytest.raises(page_blocks.PageError):
        page_blocks.blocks_of(page)


def accept():
    for page in sys.argv[2:] or PAGES:
        text = text_of(page)
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(pathlib.Path(folder))
            outputs = [reader.do(block) for block in page_blocks.blocks_of(text)]
        (TUTORIAL / f"{page}.md").write_text(page_blocks.with_outputs(text, outputs), encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:2] != ["--accept"]:
        sys.exit(__doc__)
    accept()
