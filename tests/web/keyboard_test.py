"""Everything works without a mouse: the scene, plots, tabs and buttons, and what they say to screen readers."""
import math

import pytest
from selenium.webdriver.common.keys import Keys


def focus(browser, selector):
    browser.run("document.querySelector(arguments[0]).focus()", selector)


@pytest.mark.parametrize("keys", [Keys.ARROW_LEFT, Keys.ARROW_UP, "+", "-", Keys.SHIFT + Keys.ARROW_RIGHT])
def test_keys_move_the_camera(opened, browser, keys):
    opened("cube")
    home = browser.ask("camera")
    focus(browser, "#scene")
    browser.find("#scene").send_keys(keys)
    assert browser.ask("camera") != home
    browser.find("#scene").send_keys(Keys.HOME)
    assert browser.ask("camera") == pytest.approx(home)


def test_keys_go_from_point_to_point(opened, browser):
    page = opened("cube")
    scene = browser.find("#scene")
    seen = []
    for _ in range(27):
        scene.send_keys("n")
        seen.append(page.name(browser.ask("picked")))
    assert set(seen) == set(page.places)
    scene.send_keys("p")
    assert page.name(browser.ask("picked")) == seen[-2]
    assert browser.find("#live").get_attribute("textContent").startswith("Picked ")
    before = browser.ask("camera")
    scene.send_keys(Keys.ENTER)
    browser.rest()
    assert browser.ask("camera") != before
    scene.send_keys(Keys.ESCAPE)
    assert browser.ask("picked") is None


def test_keys_brush_a_rectangle(opened, browser):
    page = opened("octahedra")
    diagram = browser.find("#diagram")
    diagram.send_keys(Keys.ARROW_LEFT)
    steps = 0
    while len(browser.ask("brushed")) == 0 and steps < 200:
        diagram.send_keys(Keys.SHIFT + Keys.ARROW_RIGHT, Keys.SHIFT + Keys.ARROW_DOWN)
        steps += 1
    brushed = browser.ask("brushed")
    assert brushed
    assert len(browser.ask("shown")["points"]) == len({e for p in brushed for e in page.pairs[p][1:] if e})
    assert "pairs brushed" in browser.find("#brush-line").text
    diagram.send_keys(Keys.ESCAPE)
    assert browser.ask("brushed") == []


def test_keys_go_through_pairs(opened, browser):
    page = opened("pyramid")
    diagram = browser.find("#diagram")
    lengths = []
    for _ in page.pairs:
        diagram.send_keys("n")
        _, birth, death = page.pairs[browser.ask("pair_of", browser.ask("picked"))]
        lengths.append(math.sqrt(death[0]) - math.sqrt(birth[0]) if death else math.inf)
    assert lengths == sorted(lengths, reverse=True) and len(lengths) > 3
    diagram.send_keys(Keys.ENTER)
    assert browser.ask("brushed") == [browser.ask("pair_of", browser.ask("picked"))]


def test_letters_switch_views(opened, browser):
    opened("bunny")
    scene = browser.find("#scene")
    assert browser.ask("drawn")["flat"]
    scene.send_keys("f")
    browser.rest()
    assert not browser.ask("drawn")["flat"]
    theme = browser.run("return document.documentElement.dataset.theme")
    scene.send_keys("t")
    assert browser.run("return document.documentElement.dataset.theme") != theme
    scene.send_keys("?")
    assert browser.find("#keys").is_displayed()
    browser.keys(Keys.ESCAPE)
    assert not browser.find("#keys").is_displayed()


def test_escape_closes_the_list_of_keys_alone(opened, browser):
    page = opened("cube")
    browser.ask("pick", page.places[(0, 1)])
    browser.find("#scene").send_keys("?")
    browser.keys(Keys.ESCAPE)
    assert not browser.find("#keys").is_displayed()
    assert page.name(browser.ask("picked")) == (0, 1)


def test_tabs_are_tabs(opened, browser):
    opened("cube")
    browser.find("#tab-details").send_keys(Keys.ARROW_RIGHT)
    assert browser.find("#tab-table").get_attribute("aria-selected") == "true"
    assert browser.find("#page-table table").is_displayed()
    assert not browser.find("#page-details").is_displayed()


def test_everything_can_be_reached_and_has_a_name(opened, browser):
    opened("cube")
    nameless = browser.run("""
      return [...document.querySelectorAll('button, select, input, canvas[tabindex], [role=tab]')]
        .filter(e => !(e.textContent.trim() || e.getAttribute('aria-label')) || e.tabIndex < -1)
        .map(e => e.outerHTML)""")
    assert nameless == []
    reached = set()
    browser.run("document.body.focus()")
    for _ in range(60):
        browser.keys(Keys.TAB)
        reached.add(browser.run("const e = document.activeElement; return e.id || e.dataset.layer || e.className"))
    assert {"scene", "diagram", "histogram", "threshold", "tool-theme", "tool-picture", "s2", "tab-details"} <= reached
