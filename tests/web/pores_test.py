"""Pages of balls list the chambers between them with their windows, and draw the picked one. Values are those of
`pores --json`."""
import json

import pytest

import inputs


@pytest.fixture
def cage(browser, program):
    """The cage's page, opened, and what `pores` says of it."""
    page = program.page("cage", inputs.CAGE.read_text(), inputs.CAGE_OPTIONS)
    browser.open(page.path)
    return json.loads(program.run("pores", page.source, *inputs.CAGE_OPTIONS, "--json"))


def cells(row):
    return [cell.text for cell in row.find_elements("css selector", "td")]


def test_the_cage_has_a_chamber_with_four_windows(cage, browser):
    chambers = [cells(row) for row in browser.find_all("[data-chamber]")]
    assert chambers == [["5.397020", "1.814499", "1.814499", "4", "closed"]]
    assert browser.find("[data-chamber]").get_attribute("aria-current") == "true"
    rows = browser.find_all("[data-window]")
    assert [cells(row)[:2] for row in rows] == 4 * [["3.628998", "the outside"]]
    assert [cells(row)[2] for row in rows] == [", ".join(f"{ball} · C" for ball in window["contact"])
                                               for window in cage["windows"]]
    facts = browser.find("#page-pores").text
    peak = cage["chambers"][0]["peak"]
    assert "5.397020177310042" in facts and str(peak["value"]["double"]) in facts
    assert "the greater root of 1000000 x² + 3400000 x - 16456891" in facts
    rows[1].find_element("css selector", "td").click()
    assert [row.get_attribute("aria-current") for row in rows] == [None, "true", None, None]
    facts = browser.find("#pores-window")
    assert "between chamber 0 and the outside" in facts.text and "13927/1000" in facts.text
    touched = facts.find_elements("css selector", ".chips button")
    assert [chip.text for chip in touched] == [f"{ball} · C" for ball in cage["windows"][1]["contact"]]
    touched[0].click()
    ball = cage["windows"][1]["contact"][0]
    assert browser.ask("picked") == {"sample": ball}
    assert browser.find("#page-atom").text.split("\n")[0] == f"{ball} · C" and "1.7" in browser.find("#page-atom").text
    browser.find("#tab-about").click()
    assert "cage.xyz" in browser.find("#page-about").text


def test_the_chamber_is_drawn_within_the_atoms(cage, browser):
    drawn = browser.ask("drawn")
    assert (drawn["balls"], drawn["sticks"]) == (168, 0)
    marked = browser.ask("marked")
    assert marked["pocket"] > 1000 and marked["mouths"] == marked["outlines"] == 4 * 96
    pink, dark = browser.count_of_color("pockets"), browser.count_of_color("outline", 25)
    assert pink > 1000 and dark > 500
    browser.find("[data-window]").click()
    assert browser.count_of_color("outline", 25) > dark + 50
    browser.find('button[data-layer="pockets"]').click()
    assert browser.ask("marked")["mouths"] == 0 == browser.count_of_color("pockets")
    browser.find('button[data-layer="atoms"]').click()
    browser.rest()
    assert browser.ask("drawn")["balls"] == 0


def test_balls_without_a_chamber_say_so(browser, program):
    browser.open(program.page("two-balls", "0 0 0\n4 0 0\n", ["--radii", "1"]).path)
    assert "There is no chamber of depth 1/10 or more here" in browser.find("#page-pores").text
    assert browser.ask("drawn")["balls"] == 2
    browser.find("#scene").send_keys("n")
    browser.ask("pick", {"sample": 1})
    assert "radius" in browser.find("#page-atom").text
