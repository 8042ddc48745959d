"""Pages with cells say the volumes and connections that compute --manifolds all writes, and draw the cell or the
surface U1 of the picked point. Other pages say nothing of it."""
import json
import math
import re

import pytest

import inputs
from program import numbers

TEXTS = {name: inputs.text(name) for name in ("cube", "octahedra", "half-octahedron", "both-sides", "line", "huge")}
TEXTS["flows-to-a-saddle"] = "0 5 0\n-3 0 -2\n3 0 -2\n0 0 12\n0 -5 0\n"
TEXTS["chain"] = "0 0 0\n1 0 0\n1 1 0\n1 1 1\n2 1 1\n"


@pytest.fixture
def with_cells(browser, program):
    """with_cells(name): the page of an input with cells, opened, and what the program writes of all points."""

    def open_page(name, *options):
        page = program.page("-".join([name, "cells", *options]), TEXTS[name], ("--cells", *options))
        browser.open(page.path)
        file = program.folder / "all.jsonl"
        program.run("compute", page.source, "--manifolds", "all", "-o", file)
        return page, [json.loads(line) for line in file.read_text().splitlines()[1:]]

    return open_page


def ways(orbits, families):
    told = []
    if orbits:
        told.append("1 orbit" if orbits == 1 else f"{orbits} orbits")
    if families:
        told.append("1 family of orbits" if families == 1 else f"{families} families of orbits")
    return ", ".join(told)


def told_connections(browser):
    lines = browser.find_all("#page-details [data-to]")
    return [(line.get_attribute("data-to"), line.text.replace("\n", " ")) for line in lines]


def number_of(contact, records):
    return "infinity" if contact is None else str([r["contact"] for r in records].index(contact))


@pytest.mark.parametrize("name", TEXTS)
def test_volumes_and_connections_are_told(with_cells, browser, name):
    page, records = with_cells(name)
    for record in records:
        browser.ask("pick", page.places[tuple(record["contact"])])
        volumes = [part.get_attribute("data-volume") for part in browser.find_all("#page-details [data-volume]")]
        expected = math.inf if record["volume_double"] is None else record["volume_double"]
        assert [float(volume.replace("Infinity", "inf")) for volume in volumes] == ([expected] if expected else [])
        told = told_connections(browser)
        connections = record.get("connections", [])
        assert len(told) == min(24, len(connections))  # so many are listed
        for (to, text), connection in zip(told, connections):
            assert to == number_of(connection["to"], records)
            assert text.endswith(" " + ways(connection["orbits"], connection["families"])), text
            assert ("infinity" in text) == (to == "infinity")


def test_the_volume_is_read_as_a_number_with_its_unit(with_cells, browser):
    page, _ = with_cells("flows-to-a-saddle")
    browser.ask("pick", page.places[0, 3, 4])
    text = browser.find("#page-details").text.replace("\n", " ")
    assert re.search(r"Volume of what flows here V ≈ 50 ?input units, cubed", text), text


def test_a_limit_is_picked_by_a_click(with_cells, browser):
    page, records = with_cells("flows-to-a-saddle")
    browser.ask("pick", page.places[0, 1, 2])
    number = number_of([0, 3, 4], records)
    browser.find(f'#page-details [data-to="{number}"] button').click()
    assert page.name(browser.ask("picked")) == (0, 3, 4)


def around(page, place):
    """Triangles of a cell, and its neighbours, by the page's data."""
    faces = page.data["cells"]["faces"]
    between, offsets = numbers(faces["between"]), numbers(faces["triangle_offsets"])
    number = numbers(page.data["records"]["numbers"])[place]
    mine = [i for i in range(len(offsets) - 1) if number in between[2 * i:2 * i + 2]]
    beyond = [between[2 * i] + between[2 * i + 1] - number for i in mine]
    return sum(offsets[i + 1] - offsets[i] for i in mine), beyond


@pytest.mark.parametrize("name", [name for name in TEXTS if name != "line"])
def test_a_picked_maximum_has_its_cell_drawn(with_cells, browser, name):
    page, records = with_cells(name)
    drawn = numbers(page.data["cells"]["drawn"])
    assert {i for i, contact in enumerate(page.names[0]) if [r for r in records if r["contact"] == list(contact)
                                                            and r["index"] == 3]} <= set(drawn)
    for place in drawn:
        browser.ask("pick", {"record": place})
        count, beyond = around(page, place)
        assert browser.run("return flowcert.marked().cell") == count >= 4
        rows = browser.find_all("#page-details .neighbours tr")
        assert len(rows) == min(24, len(beyond))
        if len(beyond) == 1:
            assert "infinity" in rows[0].text
        elif place == drawn[0]:
            row = next(row for row in rows if "record" in row.text)
            number = row.find_element("css selector", "th").text.split()[1]
            row.find_element("css selector", "td").click()
            assert f"record {number} of the list" in browser.find("#page-details .fact-head").text
    browser.ask("pick", {"sample": 0})
    parts = ("cell", "surface", "lines", "pocket", "mouths", "outlines", "cycle", "loop")
    assert browser.run("return flowcert.marked()") == dict.fromkeys(parts, 0)


@pytest.mark.parametrize("name", TEXTS)
def test_a_picked_saddle_of_index_1_has_its_surface_drawn(with_cells, browser, name):
    page, _ = with_cells(name)
    u1 = page.data["cells"]["u1"]
    sheets, corners, lines = (numbers(u1[key]) for key in ("sheet_offsets", "corner_offsets", "line_offsets"))
    places = numbers(u1["record"])
    assert places
    for k, place in enumerate(places):
        browser.ask("pick", {"record": place})
        drawn = browser.run("return flowcert.marked()")
        # A sheet of n corners is n - 2 triangles.
        count = corners[sheets[k + 1]] - corners[sheets[k]] - 2 * (sheets[k + 1] - sheets[k])
        assert drawn["surface"] == count > 0
        assert drawn["lines"] == lines[k + 1] - lines[k]
        told = browser.find("#page-details [data-sheets]").get_attribute("data-sheets")
        assert int(told) == sheets[k + 1] - sheets[k]


def test_layers_of_the_picked_point_are_turned_off(with_cells, browser):
    page, _ = with_cells("cube")
    maximum = {"record": numbers(page.data["cells"]["drawn"])[0]}
    saddle = {"record": numbers(page.data["cells"]["u1"]["record"])[0]}
    for layer, point, part in (("s3", maximum, "cell"), ("u1", saddle, "surface")):
        button = browser.find(f'[data-layer="{layer}"]')
        browser.ask("pick", point)
        assert browser.run("return flowcert.marked()")[part] > 0
        button.click()
        assert browser.run("return flowcert.marked()")[part] == 0
        button.click()
        assert browser.run("return flowcert.marked()")[part] > 0


# How many pixels of the scene are far more red than blue.
RED = """
flowcert.redraw_now();
const scene = document.getElementById('scene');
const gl = scene.getContext('webgl2');
const pixels = new Uint8Array(4 * scene.width * scene.height);
gl.readPixels(0, 0, scene.width, scene.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
let count = 0;
for (let i = 0; i < pixels.length; i += 4) count += pixels[i] > 1.6 * pixels[i + 2] && pixels[i + 3] > 60;
return count;
"""


def test_a_cell_is_seen(with_cells, browser):
    page, _ = with_cells("cube")
    for layer in ("s1", "s2", "u2", "samples", "index1", "index2", "index3"):
        browser.ask("set_layer", layer, False)
    browser.ask("pick", {"record": numbers(page.data["cells"]["drawn"])[0]})
    browser.rest()
    with_cell = browser.run(RED)
    browser.ask("set_layer", "s3", False)
    browser.rest()
    assert with_cell > 10000 > 100 > browser.run(RED)


def test_a_page_says_how_many_are_drawn(with_cells, browser):
    page, _ = with_cells("octahedra", "--most-cells", "2", "--most-unstable", "5")
    assert browser.find('[data-layer="s3"] .count').text == f"2 of {page.data['cells']['of']}"
    assert browser.find('[data-layer="u1"] .count').text == f"5 of {page.data['cells']['u1']['of']}"
    drawn = set(numbers(page.data["cells"]["drawn"]))
    volumes = numbers(page.data["cells"]["volumes"])
    other = next(i for i, volume in enumerate(volumes) if volume > 0 and i not in drawn)
    browser.ask("pick", {"record": other})
    assert browser.run("return flowcert.marked().cell") == 0
    assert "not in this page, which has 2 of" in browser.find("#page-details").text
    edges = set(numbers(page.data["cells"]["u1"]["record"]))
    other = next(i for i, name in enumerate(page.names[0]) if len(name) == 2 and i not in edges)
    browser.ask("pick", {"record": other})
    assert "Its U1 is not in this page, which has 5 of" in browser.find("#page-details").text


def test_limits_that_the_page_has_left_out_are_named(with_cells, browser):
    page, records = with_cells("octahedra", "--most", "3")
    here = {*map(tuple, page.names[0])}
    left_out = 0
    for record in [r for r in records if tuple(r["contact"]) in here]:
        browser.ask("pick", page.places[tuple(record["contact"])])
        for (to, text), connection in zip(told_connections(browser), record.get("connections", [])):
            is_left_out = connection["to"] is not None and tuple(connection["to"]) not in here
            assert ("not in this page" in text) == is_left_out
            assert to == number_of(connection["to"], records)
            left_out += is_left_out
    assert left_out > 0


def test_other_pages_say_nothing_of_cells(opened, browser):
    page = opened("cube")
    for record in page.records:
        browser.ask("pick", page.places[tuple(record["contact"])])
        assert browser.find_all("#page-details [data-volume], #page-details [data-to]") == []
