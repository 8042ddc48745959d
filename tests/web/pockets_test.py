"""Pages with pockets say what `pockets --json` writes of them, and draw the pocket of the picked point with its mouths.
Other pages say nothing of pockets."""
import json

import pytest

import inputs

# Two chambers with a mouth between them, and a cell with six mouths to the outside.
CHAMBERS = "".join(f"{x} {y} {z}\n" for z in (0, 2, 4) for x, y in ((-1, -1), (-1, 1), (1, -1), (1, 1))) + "0 0 -0.5\n"
TEXTS = {name: inputs.text(name) for name in ("cube", "octahedra", "line", "none")}
TEXTS["chambers"] = CHAMBERS


@pytest.fixture
def with_pockets(browser, program):
    """with_pockets(name): the page of an input with pockets, opened, and what the program says of them."""

    def open_page(name, *options, persistence="0"):
        words = ("--pockets", persistence, *options)
        page = program.page("-".join([name, "pockets", *options, persistence]), TEXTS[name], words)
        browser.open(page.path)
        told = json.loads(program.run("pockets", page.source, "--persistence", persistence, "--json"))
        return page, told["pockets"]

    return open_page


def told_pockets(browser):
    return [part.get_attribute("data-pocket") for part in browser.find_all("#page-details [data-pocket]")]


@pytest.mark.parametrize("name", ["cube", "octahedra", "chambers"])
def test_points_of_a_pocket_tell_it_and_draw_it(with_pockets, browser, name):
    page, pockets = with_pockets(name)
    assert pockets
    for number, pocket in enumerate(pockets):
        for point in pocket["cell"]:
            browser.ask("pick", page.places[tuple(point["contact"])])
            assert told_pockets(browser) == [str(number)]
            text = browser.find_all("#page-details [data-pocket]")[0].text
            assert f"{len(pocket['mouths'])} mouths" in text and f"of {len(pocket['maxima'])} maxima" in text
            marked = browser.ask("marked")
            assert marked["pocket"] >= 4 and marked["mouths"] > 0
        browser.ask("set_layer", "pockets", False)
        assert browser.ask("marked")["pocket"] == 0
        browser.ask("set_layer", "pockets", True)


def test_a_mouth_tells_all_pockets_beside_it(with_pockets, browser):
    page, pockets = with_pockets("chambers")
    inner = [mouth for mouth in pockets[0]["mouths"] if -1 not in mouth["between"]]
    assert inner
    browser.ask("pick", page.places[tuple(inner[0]["contact"])])
    assert told_pockets(browser) == [str(number) for number in inner[0]["between"]]
    assert "mouth of these" in browser.find_all("#page-details")[0].text


def test_the_table_has_all_pockets_and_picks_them(with_pockets, browser):
    page, pockets = with_pockets("chambers")
    browser.find_all("#tab-pockets")[0].click()
    rows = browser.find_all("#page-pockets tbody tr")
    assert len(rows) == len(pockets) > 1
    depths = []
    for row in rows:
        number = int(row.find_elements("css selector", "th")[0].text)
        depth, volume, mouths, widest = [cell.text for cell in row.find_elements("css selector", "td")]
        told = pockets[number]
        depths.append(told["depth"])
        assert float(depth) == pytest.approx(told["depth"], rel=1e-3)
        assert float(volume) == pytest.approx(told["volume"], rel=1e-3)
        assert float(widest) == pytest.approx(told["widest_path"]["radius"], rel=1e-3)
        assert int(mouths) == len(told["mouths"])
    assert depths == sorted(depths, reverse=True)
    browser.ask("pick", None)
    for click, row in ((lambda row: row.find_element("css selector", "button").click(), rows[0]),
                       (lambda row: row.find_elements("css selector", "td")[2].click(), rows[1]),
                       (lambda row: row.send_keys("\ue007"), rows[0])):
        click(row)
        number = int(row.find_element("css selector", "th").text)
        assert list(page.name(browser.ask("picked"))) == pockets[number]["peaks"][0]["contact"]
        assert browser.ask("marked")["pocket"] > 0
        assert [r for r in rows if r.get_attribute("aria-current") == "true"] == [row]


def test_the_deepest_pocket_is_picked_at_first(with_pockets, browser):
    page, pockets = with_pockets("chambers")
    deepest = max(pockets, key=lambda pocket: pocket["depth"])
    assert list(page.name(browser.ask("picked"))) == deepest["peaks"][0]["contact"]
    assert told_pockets(browser) == [str(pockets.index(deepest))]
    assert browser.find("#tab-pockets").get_attribute("aria-selected") == "true"
    marked = browser.ask("marked")
    assert marked["pocket"] >= 4 and marked["outlines"] >= 3


def test_merged_and_left_out_pockets(with_pockets, browser):
    _page, all_pockets = with_pockets("chambers")
    _page, merged = with_pockets("chambers", persistence="100")
    assert len(merged) < len(all_pockets)
    _page, _told = with_pockets("chambers", "--most-pockets", "1")
    browser.find_all("#tab-pockets")[0].click()
    assert len(browser.find_all("#page-pockets tbody tr")) == 1
    browser.find_all("#tab-about")[0].click()
    assert f"1 of {len(all_pockets)} pockets" in browser.find_all("#page-about")[0].text


@pytest.mark.parametrize("name", ["line", "none"])
def test_inputs_without_pockets_say_so(with_pockets, browser, name):
    with_pockets(name)
    browser.find_all("#tab-pockets")[0].click()
    assert "There is no pocket" in browser.find_all("#page-pockets")[0].text


def test_other_pages_say_nothing_of_pockets(browser, program):
    browser.open(program.page("cube-plain", TEXTS["cube"]).path)
    assert browser.find_all("#tab-pockets") == []
    browser.ask("pick", {"record": 0})
    assert told_pockets(browser) == []
