"""Facts of points are those that compute -o writes: positions and distances as fractions, contacts, limits, pairs."""
import math
import random
import re
from fractions import Fraction

import pytest

import inputs


def framed_radius(page, record):
    """The distance of a record, in the unit of its page."""
    return math.sqrt(Fraction(record["squared_distance"]) / Fraction(page.data["unit"]) ** 2)


def is_same(told, record):
    return told["center"] == record["center"] and told["squared_distance"] == record["squared_distance"]


@pytest.mark.parametrize("name", inputs.SMALL)
def test_every_record_is_exact(opened, browser, name):
    page = opened(name)
    for record in page.records:
        place = page.places[tuple(record["contact"])]
        assert is_same(browser.ask("exact", place), record), record
        assert abs(browser.ask("radius", place) - framed_radius(page, record)) <= 1e-14, record


def test_records_of_a_scan_are_exact(opened, browser):
    page = opened("bunny")
    drawn = random.Random(19).sample(page.records, 600)
    for record in drawn:
        place = page.places[tuple(record["contact"])]
        assert is_same(browser.ask("exact", place), record), record
        assert abs(browser.ask("radius", place) - framed_radius(page, record)) <= 1e-12, record


def facts(browser):
    return [row.get_attribute("data-exact") for row in browser.find_all("#page-details dd[data-exact]")]


@pytest.mark.parametrize("name", ["cube", "octahedra", "pyramid", "half-octahedron"])
def test_a_click_shows_the_exact_position(opened, browser, name):
    """Points that nothing hides, clicked with the mouse at the pixel where they are."""
    page = opened(name)
    browser.rest()
    at = {tuple(r["contact"]): browser.ask("pixel_of", page.places[tuple(r["contact"])]) for r in page.records}
    clicked = 0
    for record in page.records:
        x, y = at[tuple(record["contact"])]
        others = [p for key, p in at.items() if key != tuple(record["contact"])]
        is_apart = min((abs(x - a) + abs(y - b) for a, b in others), default=100) > 30
        if not is_apart or browser.run("return document.elementFromPoint(...arguments).id", x, y) != "scene":
            continue
        browser.click_at(x, y)
        assert page.name(browser.ask("picked")) == tuple(record["contact"])
        assert facts(browser) == [*record["center"], record["squared_distance"]]
        clicked += 1
        if clicked == 8:
            break
    assert clicked >= 3


def test_a_click_on_the_surface_of_a_scan_shows_its_point(opened, browser):
    page = opened("bunny")
    browser.rest()
    box = browser.find("#scene").rect
    browser.click_at(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    picked = page.name(browser.ask("picked"))
    record = next(r for r in page.records if tuple(r["contact"]) == picked)
    assert record["index"] == 2
    assert facts(browser) == [*record["center"], record["squared_distance"]]
    browser.rest()


def test_what_is_said_of_a_point(opened, browser):
    page = opened("cube")
    browser.ask("pick", page.places[tuple(range(8))])
    text = browser.find("#page-details").text
    for words in ("Maximum, index 3", "1/2", "3/4", "input units, squared", "FC-CRIT-02", "FC-CRIT-05",
                  "come in from 6 saddles"):
        assert words in text, words
    chips = [chip.text for chip in browser.find_all("#page-details .chips")[0].find_elements("css selector", "button")]
    assert chips == [str(row) for row in range(8)]


def test_regular_stationary_points_have_their_clause(opened, browser):
    page = opened("half-octahedron")
    regular = next(r for r in page.records if r["kind"] == "regular")
    browser.ask("pick", page.places[tuple(regular["contact"])])
    text = browser.find("#page-details").text
    assert "kind {}-{}".format(*regular["index"]) in text and "FC-CRIT-03" in text and "It is in no pair" in text


@pytest.mark.parametrize("name", ["cube", "pyramid", "octahedra"])
def test_limits_by_side_are_those_of_the_program(opened, browser, name):
    page = opened(name)
    for record in [r for r in page.records if r["index"] == 2]:
        browser.ask("pick", page.places[tuple(record["contact"])])
        lines = [line.text for line in browser.find_all("#page-details .line") if line.text.startswith("U2, side")]
        assert len(lines) == 2
        for side, limit in enumerate(record["limits"]):
            text = lines[side].replace("\n", " ")
            assert text.startswith(f"U2, side {side}: ends at")
            if limit is None:
                assert "infinity" in text
            else:
                place = page.places[tuple(limit)]["record"]
                number = browser.run("return arguments[0]", place) + page.summary["critical"][0]
                assert f"record {number:d} " in text.replace(",", "")


def names_of_incoming(page, record):
    """What the page says of the saddles of which orbits end at a record."""
    samples = page.summary["critical"][0]
    sides = {}
    for saddle in page.records:
        for side, limit in enumerate(saddle.get("limits") or []):
            if limit == record["contact"]:
                sides.setdefault(page.places[tuple(saddle["contact"])]["record"] + samples, []).append(side)
    return {f"record {n}, {'sides 0 and 1' if len(s) == 2 else f'side {s[0]}'}" for n, s in sides.items()}


@pytest.mark.parametrize("name", ["cube", "both-sides"])
def test_saddles_whose_orbits_come_in_are_told_with_their_sides(opened, browser, name):
    page = opened(name)
    double = 0
    for record in page.records:
        expected = names_of_incoming(page, record)
        if not expected:
            continue
        browser.ask("pick", page.places[tuple(record["contact"])])
        told = {e.text.strip() for e in browser.find_all("#page-details button.chip") if "side" in e.text}
        assert told <= expected and len(told) == min(24, len(expected))  # so many are listed
        double += sum("sides 0 and 1" in text for text in told)
    assert (double > 0) == (name == "both-sides")


def test_long_fractions_are_shortened_and_copied_whole(opened, browser):
    page = opened("tiny")
    record = max(page.records, key=lambda r: len(r["center"][0]))
    browser.ask("pick", page.places[tuple(record["contact"])])
    shown = browser.find("#page-details dd[data-exact]")
    value = shown.find_element("css selector", ".value").text
    assert "…" in value and len(value) < 70 < len(record["center"][0])
    assert facts(browser) == [*record["center"], record["squared_distance"]]
    browser.run("window.copied = null; document.execCommand = () => (window.copied = getSelection().toString(), true);"
                "Object.defineProperty(navigator, 'clipboard', {value: {writeText: t => (window.copied = t, "
                "Promise.resolve())}})")
    shown.find_element("css selector", ".copy").click()
    assert browser.run("return window.copied") == record["center"][0]


@pytest.mark.parametrize("name", ["huge", "huge-cube", "tiny"])
def test_distances_whose_squares_are_no_doubles_are_told(opened, browser, name):
    page = opened(name)
    for record in [r for r in page.records if r["index"] in (1, 2)]:
        browser.ask("pick", page.places[tuple(record["contact"])])
        text = browser.find("#page-details").text.replace("\n", " ")
        exact = Fraction(record["squared_distance"])
        power = math.log10(exact.numerator) - math.log10(exact.denominator)
        for name_of_value, expected in (("d²", power), ("d", power / 2)):
            near = re.search(rf" {name_of_value} [^≈]*≈ ([\d.]+)e(-?\d+)", text)
            assert near, text
            assert math.log10(float(near[1])) + int(near[2]) == pytest.approx(expected, abs=0.003), text


def test_the_table_has_the_same_facts(opened, browser):
    page = opened("octahedra")
    browser.find("#tab-table").click()
    cells = []
    while True:
        rows = browser.run("return [...document.querySelectorAll('#page-table tbody tr')].map(row => "
                           "[...row.children].map(cell => cell.textContent))")
        if cells and rows[0] == cells[-len(rows)]:
            break
        cells += rows
        before = browser.run("return document.querySelector('#page-table tbody').textContent")
        browser.find('#page-table button[aria-label="Next page"]').click()
        if browser.run("return document.querySelector('#page-table tbody').textContent") == before:
            break
    assert len(cells) == len(page.records)
    for row, record in zip(cells, page.records):
        index = record["index"]
        assert row[1] == (str(index) if isinstance(index, int) else f"{index[0]}-{index[1]}")
        assert [float(x) for x in row[2:5]] == record["center_double"]
        assert float(row[5]) == pytest.approx(math.sqrt(record["squared_distance_double"]), rel=1e-3)
        assert row[6].split(" (")[0].replace(" …", "").split() == [str(c) for c in record["contact"][:8]]


def test_rows_of_the_table_pick_points(opened, browser):
    page = opened("cube")
    browser.find("#tab-table").click()
    browser.find('#page-table select option[value="3"]').click()
    button = browser.find("#page-table tbody button")
    button.click()
    assert page.name(browser.ask("picked")) == tuple(range(8))


def test_a_row_of_the_table_picks_wherever_it_is_clicked(opened, browser):
    page = opened("cube")
    browser.find("#tab-table").click()
    rows = browser.find_all("#page-table tbody tr")
    rows[3].find_elements("css selector", "td")[2].click()
    assert page.name(browser.ask("picked")) == (3,)
    assert rows[3].get_attribute("aria-current") == "true"
    rows[10].send_keys("\ue007")
    assert page.name(browser.ask("picked")) == tuple(page.records[10]["contact"])


def test_lengths_of_pairs_are_differences_of_distances(opened, browser):
    page = opened("octahedra")
    for _, birth, death in [p for p in page.pairs if p[2]][::9]:
        browser.ask("pick", page.places[death[1]])
        text = browser.find("#page-details").text
        born, dies = math.sqrt(birth[0]), math.sqrt(death[0])
        told = re.search(r"distance ([\d.]+) to ([\d.]+); length ([\d.]+), input units$", text, re.MULTILINE)
        assert told, text
        assert [float(x) for x in told.groups()] == pytest.approx([born, dies, dies - born], abs=1e-3)
