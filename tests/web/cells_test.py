"""Pages with cells say the volumes and connections that compute --manifolds all writes; other pages say nothing of it."""
import json
import math
import re

import pytest

import inputs

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
