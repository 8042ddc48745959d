"""A picked pair's loop with its surface, or its void, is drawn as `cycles --json` tells it, at the level of the slider.
Nothing of it stays when something else is picked."""
import json
import math
from fractions import Fraction

import pytest

import inputs

KEYS = {"left": "\ue012", "end": "\ue010", "home": "\ue011"}
ORDINARY = inputs.rows((i * 37 % 101, i * 61 % 97, i * 53 % 89) for i in range(60))


@pytest.fixture
def page(browser, program):
    page = program.page("cycles", ORDINARY)
    browser.open(page.path)
    return page


def told(page, dimension, level=25):
    """{place of a pair in the page: what `cycles` says of it}."""
    words = ("--dimension", dimension, "--longest", "100", "--level", f"{level}%", "--json")
    cycles = json.loads(page.program.run("cycles", page.source, *words))["cycles"]
    places = {(birth[1], death and death[1]): k for k, (_, birth, death) in enumerate(page.pairs)}
    return {places[tuple(cycle["birth"]["contact"]), tuple(cycle["death"]["contact"])]: cycle for cycle in cycles}


def drawn(browser):
    marked = browser.ask("marked")
    return marked["loop"], marked["cycle"]


def test_a_click_on_a_pair_draws_its_loop_at_the_slider_s_level(page, browser):
    slider = browser.find("#level")
    assert not slider.is_displayed()
    at = {level: told(page, 1, level) for level in (0, 25, 99)}
    pair, cycle = next((pair, cycle) for pair, cycle in at[25].items()
                       if len(at[0][pair]["edges"]) > len(cycle["edges"]) > len(at[99][pair]["edges"]))
    browser.click_at(*browser.ask("diagram_pixel_of", pair))
    counts = {25: drawn(browser)}
    assert counts[25][0] == len(cycle["edges"]) >= 3 and counts[25][1] > 0
    assert browser.count_of_color("outline") > 100
    distance = math.sqrt(Fraction(cycle["squared_level"]))
    words = browser.find("#level-line").text.split()
    assert words[1] == "25%," and float(words[3]) == pytest.approx(distance, rel=1e-3)
    for key, level in (("home", 0), ("end", 100), ("left", 99)):
        slider.send_keys(KEYS[key])
        assert slider.get_attribute("value") == str(level)
        counts[level] = drawn(browser)
        if level < 100:
            assert counts[level][0] == len(at[level][pair]["edges"])
    assert counts[0] > counts[25] > counts[100]
    browser.ask("level", 25)
    assert drawn(browser) == counts[25]
    browser.ask("pick", {"sample": 0})
    assert drawn(browser) == (0, 0) and not slider.is_displayed()


def test_a_pair_of_dimension_2_draws_its_void(page, browser):
    for pair in told(page, 2):
        browser.ask("pick_pair", pair)
        loop, triangles = drawn(browser)
        assert loop == 0 and triangles >= 4
    assert "a void within" in browser.find("#level-line").text
    assert browser.count_of_color("cycle", 90) > 100


def test_a_point_of_a_pair_draws_it_when_it_is_asked_for(page, browser):
    pair, cycle = next(iter(told(page, 1).items()))
    browser.ask("pick", page.places[tuple(cycle["death"]["contact"])])
    assert drawn(browser) == (0, 0)
    next(b for b in browser.find_all("#page-details button") if b.text == "Draw its loop").click()
    assert drawn(browser)[0] == len(cycle["edges"])


def test_pairs_without_a_cycle_in_the_page_say_so(browser, program):
    page = program.page("cycles-of-many", inputs.rows((i * 37 % 101, i * 61 % 97, i * 53 % 89) for i in range(90)))
    browser.open(page.path)
    shown = told(page, 1)
    assert len(shown) == 100
    left_out = next(k for k, (dimension, _, _) in enumerate(page.pairs) if dimension == 1 and k not in shown)
    browser.ask("pick_pair", left_out)
    assert drawn(browser) == (0, 0) and not browser.find("#level").is_displayed()
    assert "Its loop is not in this page, which has those of 100 of the longest pairs." in \
        browser.find("#page-details").text


def test_cycles_of_degenerate_inputs_are_drawn(opened, made, browser):
    opened("octahedra")
    for dimension in (1, 2):
        for pair, cycle in told(made("octahedra"), dimension).items():
            browser.ask("pick_pair", pair)
            loop, triangles = drawn(browser)
            assert loop == len(cycle.get("edges", [])) and triangles > 0
