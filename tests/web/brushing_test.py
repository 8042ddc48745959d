"""Brushed pairs, picked pairs and thresholds, linked with the scene; expected sets come from persistence --json."""
import math
from decimal import Context, Decimal
from fractions import Fraction

import pytest
from selenium.webdriver.common.keys import Keys

import inputs


def expected(page, chosen):
    """The points of pairs, and those of them that have an S2."""
    ends = [end for pair in chosen for end in pair[1:] if end]
    critical = {tuple(r["contact"]): r["index"] for r in page.records}
    points = {name for _, name in ends}
    return points, {name for name in points if critical[name] == 2}


def shown(page, browser):
    view = browser.ask("shown")
    return {page.name(p) for p in view["points"]}, {page.name({"record": r}) for r in view["sets"]}


def length_of(pair):
    return math.sqrt(pair[2][0]) - math.sqrt(pair[1][0])


def within(pair, rectangle):
    birth, death = pair[1][0], pair[2][0] if pair[2] else math.inf
    low_birth, high_birth, low_death, high_death = rectangle
    return low_birth <= birth <= high_birth and low_death <= death <= high_death


@pytest.mark.parametrize("name", ["cube", "octahedra", "pyramid", "half-octahedron", "bunny"])
def test_a_rectangle_shows_exactly_its_pairs(opened, browser, name):
    page = opened(name)
    finite = sorted({float(p[2][0]) for p in page.pairs if p[2]})
    births = sorted({float(p[1][0]) for p in page.pairs})
    # Between values, so that rounding of squared distances does not matter.
    cut = (finite[len(finite) // 2 - 1] + finite[len(finite) // 2]) / 2 if len(finite) > 1 else finite[0] * 2
    top = births[-1] * 1.5 + 1
    for rectangle in [(-1, top, -1, cut), (1e-200, top, cut, finite[-1] * 2), (-1, top, cut, 1e200)]:
        browser.ask("brush_rectangle", *(side / page.data["unit"] ** 2 for side in rectangle))
        chosen = [p for p in page.pairs if within(p, rectangle)]
        assert len(browser.ask("brushed")) == len(chosen)
        if chosen:
            assert shown(page, browser) == expected(page, chosen)


def test_a_drag_brushes_what_is_under_it(opened, browser):
    page = opened("octahedra")
    pairs = browser.run("return Array.from({length: flowcert.counts().pairs.reduce((a, b) => a + b)}, (_, i) => i)")
    at = {pair: browser.ask("diagram_pixel_of", pair) for pair in pairs}
    place = next(at[pair] for pair in pairs if page.pairs[pair][0] == 1)
    browser.drag((place[0] - 12, place[1] - 12), (place[0] + 12, place[1] + 12))
    browser.rest()
    inside = [p for pair, p in enumerate(page.pairs)
              if abs(at[pair][0] - place[0]) < 12 and abs(at[pair][1] - place[1]) < 12]
    assert 0 < len(inside) < len(pairs) and shown(page, browser) == expected(page, inside)
    drawn = browser.ask("drawn")
    assert drawn["points"] == len(expected(page, inside)[0])
    assert drawn["s2_sets"] == len(expected(page, inside)[1])
    browser.find("#clear-brush").click()
    browser.rest()
    assert browser.ask("brushed") == []
    assert browser.ask("drawn")["points"] == len(page.records)


def test_brushed_pairs_of_a_big_input_are_drawn_exactly(opened, browser):
    page = opened("bunny")
    lengths = {i: length_of(p) for i, p in enumerate(page.pairs) if p[0] == 1}
    order = sorted(lengths, key=lengths.get, reverse=True)[:100]
    browser.ask("brush_pairs", order)
    browser.rest()
    chosen = [page.pairs[i] for i in order]
    assert shown(page, browser) == expected(page, chosen)
    drawn = browser.ask("drawn")
    assert not drawn["flat"] and drawn["s2_sets"] == 100 and drawn["points"] == 200


def between(values, part):
    """A number between two that follow one another, or the only one."""
    k = int(part * (len(values) - 1))
    return (values[k] + values[min(k + 1, len(values) - 1)]) / 2


def decimal(value):
    """A fraction as text, to 30 digits."""
    return str((Decimal(value.numerator) / Decimal(value.denominator)).normalize(Context(prec=30)))


@pytest.mark.parametrize("name", ["cube", "octahedra", "pyramid", "far", "huge", "huge-cube", "tiny", "bunny"])
def test_thresholds_select_what_surface_selects(opened, browser, name):
    page = opened(name)
    unit = Fraction(page.data["unit"])
    framed = sorted({math.sqrt(Fraction(r["squared_distance"]) / unit**2) for r in page.records if r["index"] == 2})
    browser.ask("full_detail", True)
    for part in (0.1, 0.5, 0.9):
        radius = between(framed, part)
        browser.ask("threshold", "radius", radius)
        browser.rest()
        selected = page.surface(f"index2-radius<{decimal(Fraction(radius) * unit)}")
        assert (browser.ask("drawn")["s2_sets"], browser.ask("drawn")["triangles"]) == \
               (selected["selected"], selected["triangles"])
    # In the frame, as squares may be beyond the doubles.
    framed_pairs = [[p[0], *((end and (end[0] / unit**2,)) for end in p[1:])] for p in page.pairs if p[2] and p[0] > 0]
    lengths = [0.0]
    for length in sorted(map(length_of, framed_pairs)):
        if length > lengths[-1] + 1e-9:
            lengths.append(length)
    length = between(lengths, 0.5)
    browser.ask("threshold", "persistence", length)
    browser.rest()
    selected = page.surface(f"persistence>{decimal(Fraction(length) * unit)}")
    assert browser.ask("drawn")["s2_sets"] == selected["selected"]


def test_the_slider_is_live_and_has_a_keyboard(opened, browser):
    opened("bunny")
    browser.rest()
    before = browser.ask("drawn")["s2_sets"]
    frames = browser.ask("frames")
    slider = browser.find("#threshold")
    slider.send_keys(*[Keys.ARROW_LEFT] * 120)
    browser.rest()
    assert browser.ask("drawn")["s2_sets"] < before
    assert browser.ask("frames") >= frames + 2
    assert slider.get_attribute("aria-valuetext").startswith("distance below")
    assert slider.get_attribute("aria-valuetext").endswith(" input units")
    browser.find('button[data-mode="persistence"]').click()
    slider.send_keys(Keys.ARROW_RIGHT)
    assert slider.get_attribute("aria-valuetext").startswith("persistence above")
    assert slider.get_attribute("aria-valuetext").endswith(" input units")
    browser.find('button[data-mode="radius"]').click()
    slider.send_keys(Keys.END)
    browser.rest()
    assert len(browser.ask("shown")["sets"]) == browser.ask("counts")["s2_sets"]


def test_picking_a_point_picks_its_pair(opened, browser):
    page = opened("cube")
    for pair, (_, birth, death) in enumerate(page.pairs):
        for _, name in filter(None, (birth, death)):
            assert browser.ask("pair_of", page.places[name]) in range(len(page.pairs))
        if death:
            assert browser.ask("pair_of", page.places[birth[1]]) == pair
            assert browser.ask("pair_of", page.places[death[1]]) == pair


def test_a_click_in_the_diagram_picks_the_pair(opened, browser):
    page = opened("cube")
    pair = next(i for i, p in enumerate(page.pairs) if p[0] == 2)
    browser.click_at(*browser.ask("diagram_pixel_of", pair))
    assert page.name(browser.ask("picked")) in {page.pairs[pair][1][1], page.pairs[pair][2][1]}
    assert browser.ask("pair_of", browser.ask("picked")) == pair


def test_a_drag_over_the_histogram_brushes_its_bars(opened, browser):
    page = opened("octahedra")
    box = browser.find("#histogram").rect
    left, right = box["x"] + 56, box["x"] + box["width"] - 10
    middle = box["y"] + box["height"] / 3
    browser.drag((left + 0.9 * (right - left), middle), (right - 1, middle))
    radii = {tuple(r["contact"]): r["squared_distance_double"] for r in page.records if r["index"] == 2}
    largest = max(radii.values())
    chosen = [p for p in page.pairs if any(end and radii.get(end[1]) == largest for end in p[1:])]
    assert chosen and shown(page, browser) == expected(page, chosen)


@pytest.mark.parametrize("name", inputs.SMALL)
def test_every_critical_point_is_shown_by_its_pair_alone(opened, browser, name):
    page = opened(name)
    for pair in range(len(page.pairs)):
        browser.ask("brush_pairs", [pair])
        assert shown(page, browser) == expected(page, [page.pairs[pair]])
