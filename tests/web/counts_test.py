"""What a page has and draws, counted, against compute, persistence and surface."""
import pytest

import inputs


def kinds(summary):
    regular = summary["regular_stationary"]
    return [*summary["critical"], sum(regular.values())]


@pytest.mark.parametrize("name", inputs.ALL)
def test_counts_are_those_of_the_program(opened, browser, name):
    page = opened(name)
    counts = browser.ask("counts")
    assert counts["points"] == page.summary["points"]
    assert counts["samples"] == page.summary["critical"][0]
    assert counts["by_kind"] == kinds(page.summary)
    assert counts["pairs"] == [d["positive"] + d["lasting"] for d in page.persistence["counts"]]
    surface = page.surface()
    assert counts["s2_sets"] == surface["sets"] == page.summary["critical"][2]
    assert counts["s2_triangles"] == surface["triangles"]
    assert counts["s2_vertices"] == surface["vertices"]
    assert counts["u2_points"] == page.summary["critical"][2]
    assert counts["s1"] == page.summary["critical"][1]


@pytest.mark.parametrize("name", inputs.ALL)
def test_the_scene_draws_all_of_it_at_full_detail(opened, browser, name):
    page = opened(name, "#full")
    browser.rest()
    drawn = browser.ask("drawn")
    surface = page.surface()
    assert drawn["by_kind"] == kinds(page.summary)
    assert drawn["points"] == sum(drawn["by_kind"])
    assert drawn["s1"] == page.summary["critical"][1]
    assert (drawn["s2_sets"], drawn["triangles"]) == (surface["sets"], surface["triangles"])
    assert drawn["u2_lines"] == page.summary["critical"][2]
    limits = [limit for r in page.records if r["index"] == 2 for limit in r["limits"]]
    assert (drawn["infinity_segments"] > 0) == (None in limits)
    assert not drawn["flat"]


@pytest.mark.parametrize("layer, part", [("index1", 1), ("index3", 3), ("samples", 0)])
def test_layers_can_be_left_out(opened, browser, layer, part):
    opened("cube")
    browser.find(f'button[data-layer="{layer}"]').click()
    browser.rest()
    assert browser.ask("drawn")["by_kind"] == [0 if k == part else c for k, c in enumerate([8, 12, 6, 1, 0])]
    assert browser.find(f'button[data-layer="{layer}"]').get_attribute("aria-pressed") == "false"


def test_layers_of_lines_and_surfaces_can_be_left_out(opened, browser):
    opened("cube")
    for layer in ("s1", "s2", "u2"):
        browser.find(f'button[data-layer="{layer}"]').click()
    browser.rest()
    drawn = browser.ask("drawn")
    assert (drawn["s1"], drawn["triangles"], drawn["u2_segments"]) == (0, 0, 0)
    assert drawn["points"] == 27


def test_lines_to_infinity_leave_the_box(opened, browser):
    for name in ("cube", "square", "octahedra"):
        page = opened(name)
        limits = [limit for r in page.records if r["index"] == 2 for limit in r["limits"]]
        ends = browser.ask("line_ends")
        assert len(ends) == len(limits)
        for limit, end in zip(limits, ends):
            outside = max(map(abs, end)) >= 3
            assert outside == (limit is None), (name, limit, end)


def test_lines_to_infinity_are_a_layer_that_is_off_at_first(opened, browser):
    page = opened("octahedra")
    browser.rest()
    button = browser.find('button[data-layer="infinity"]')
    limits = [limit for r in page.records if r["index"] == 2 for limit in r["limits"]]
    assert button.get_attribute("aria-pressed") == "false"
    assert button.find_element("css selector", ".count").text == str(limits.count(None))
    assert browser.find('button[data-layer="u2"] .count').text == str(len(limits) - limits.count(None))
    before = browser.ask("drawn")
    assert before["infinity_segments"] == 0 < before["u2_segments"]
    button.click()
    browser.rest()
    after = browser.ask("drawn")
    assert after["infinity_segments"] >= limits.count(None) and after["u2_segments"] == before["u2_segments"]


def test_lines_are_drawn_inside_the_box_alone(opened, browser):
    opened("square", "#full")
    assert browser.ask("drawn")["infinity_segments"] == 2
    assert browser.run("return flowcert.line_bounds()") == [-3, 3]
