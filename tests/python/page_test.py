"""show(): the page is that of `flowcert view`, to the byte, and a notebook has it in a frame of its own."""

import html.parser
import pathlib

import flowcert
import pytest
from conftest import CUBE, flowcert_says

INPUTS = pathlib.Path(__file__).parents[1] / "inputs"


def test_the_page_is_that_of_the_program(xyz):
    path = xyz(CUBE)
    fc = flowcert.FlowComplex(CUBE)
    assert fc.show(name=str(path)).html == flowcert_says("view", path, "-o", "-")
    options = {"cells": True, "pockets": "1/5", "most": 3}
    words = ("--cells", "--pockets", "1/5", "--most", 3)
    assert fc.show(name=str(path), **options).html == flowcert_says("view", path, *words, "-o", "-")


@pytest.mark.filterwarnings("ignore")
def test_the_page_of_a_molecule_has_the_names_of_its_atoms():
    path = INPUTS / "barrel.pdb"
    points, atoms = flowcert.read_points(path, return_atoms=True)
    page = flowcert.FlowComplex(points).show(name=str(path), atoms=atoms)
    assert page.html == flowcert_says("view", path, "-o", "-")


@pytest.mark.filterwarnings("ignore")
def test_the_page_of_balls_is_that_of_the_program():
    path = INPUTS / "cage.xyz"
    *balls, atoms = flowcert.read_balls(path, "bondi", return_atoms=True)
    page = flowcert.pores(*balls, depth="1/2").show(name=str(path), atoms=atoms, probe="1.4")
    said = flowcert_says("view", path, "--radii", "bondi", "--depth", "1/2", "--probe", "1.4", "-o", "-")
    # The program tells how the radii were said.
    assert page.html == said.replace('"radii":"bondi"', '"radii":"as given"')


class Frame(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))


def test_a_notebook_has_it_in_a_frame():
    page = flowcert.FlowComplex([[0, 0, 0], [2, 0, 0]]).show(name='<b> & "quotes"', height=321)
    [(tag, attributes)] = Frame(page._repr_html_()).tags
    assert tag == "iframe" and attributes["srcdoc"] == page.html
    assert "allow-scripts" in attributes["sandbox"] and "allow-same-origin" not in attributes["sandbox"]
    assert "height:321px" in attributes["style"]
    assert repr(page) == f"<flowcert.Page of {len(page.html) / 1e6:.1f} MB: save(path) writes it>"


def test_the_complex_itself_stays_small_in_a_notebook():
    assert len(flowcert.FlowComplex(CUBE)._repr_html_()) < 3000


def test_the_example_saves_a_page(examples_hold, tmp_path):
    assert examples_hold(flowcert.Page.save) and (tmp_path / "page.html").stat().st_size > 100_000


def test_a_page_is_saved_whole_or_not_at_all(tmp_path):
    page = flowcert.FlowComplex(CUBE).show()
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page.html
    page.html = "\ud800"  # cannot be written
    with pytest.raises(UnicodeEncodeError):
        page.save(tmp_path / "page.html")
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]
    assert len((tmp_path / "page.html").read_text(encoding="utf-8")) > 1
    with pytest.raises(FileNotFoundError):
        page.save(tmp_path / "none" / "page.html")


@pytest.mark.parametrize(
    "options, words",
    [
        ({"most": 0}, "most: less than 1"),
        ({"pockets": "1x"}, "pockets:1: not a number"),
        ({"atoms": ["C"] * 8}, "atoms must be what read_points"),
    ],
)
def test_what_cannot_be_shown(options, words):
    with pytest.raises(ValueError, match=words):
        flowcert.FlowComplex(CUBE).show(**options)


@pytest.mark.filterwarnings("ignore")
def test_atoms_are_one_for_each_point():
    atoms = flowcert.read_points(INPUTS / "barrel.pdb", return_atoms=True)[1]
    with pytest.raises(ValueError, match="atoms must be one for each of 8 points, not "):
        flowcert.FlowComplex(CUBE).show(atoms=atoms)
    with pytest.raises(ValueError, match="atoms must be one for each of 4 points, not "):
        flowcert.pores(CUBE[:4], 0.1).show(atoms=atoms)
