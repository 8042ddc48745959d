"""Pages of molecules open with their atoms, without what would hide them, and with the deepest pocket picked: seen
through the atoms before it, its mouths outlined. They name atoms where they name rows.

The barrel's picture: nine rings of atoms as grey balls with sticks, seen half from its end, and between two rings a
disc in the colour of pockets with a dark outline, through the atoms before it. Nothing runs to infinity, nor through
the title.
"""
import math

import pytest

import inputs


@pytest.fixture
def barrel(browser, program):
    page = program.page("barrel", inputs.BARREL.read_text(), ("--pockets", "0", "--atoms", "no water"))
    browser.open(page.path)
    browser.rest()
    return page


@pytest.fixture
def cup(browser, program):
    page = program.page("cup", inputs.cup(), ("--pockets", "0.5"))
    browser.open(page.path)
    browser.rest()
    return page


def pressed(browser):
    return {button.get_attribute("data-layer") for button in browser.find_all("#layers button[aria-pressed='true']")}


def test_the_barrel_opens_with_its_atoms(barrel, browser):
    assert pressed(browser) == {"atoms", "pockets"}
    drawn = browser.ask("drawn")
    assert drawn["balls"] == 126 and drawn["sticks"] >= 9 * 14
    assert [drawn[part] for part in ("points", "s1", "s2_sets", "u2_segments", "infinity_segments")] == [0] * 5
    layers = {"s2": "s2_sets", "u2": "u2_segments", "infinity": "infinity_segments", "index2": "points"}
    for layer in (*layers, "atoms"):
        browser.find(f'button[data-layer="{layer}"]').click()
    browser.rest()
    drawn = browser.ask("drawn")
    assert drawn["balls"] == 0 < min(drawn[part] for part in layers.values())
    for selector in ("#name", "#summary"):
        assert_on_a_backing(browser, selector)


def assert_on_a_backing(browser, selector):
    """What is behind the text is around it, and little is seen through it."""
    is_around, opacity = browser.run("""
      const text = document.querySelector(arguments[0]), behind = text.parentElement;
      const [a, b] = [text, behind].map(e => e.getBoundingClientRect());
      const context = document.createElement('canvas').getContext('2d');
      context.fillStyle = getComputedStyle(behind).backgroundColor;
      context.fillRect(0, 0, 1, 1);
      return [b.left <= a.left && b.top <= a.top && b.right >= a.right && b.bottom >= a.bottom,
              context.getImageData(0, 0, 1, 1).data[3]];""", selector)
    assert is_around and opacity > 200


def is_of_a_pocket(color):
    """Nearly the colour of pockets, alone or over an atom: red and blue, and little green."""
    red, green, blue, _ = color
    return red > green + 30 and blue > green + 20


def test_the_pocket_is_seen_through_the_atoms_before_it(cup, browser):
    peak = browser.ask("picked")
    center = browser.ask("pixel_of", peak)
    before = [{"sample": k} for k in range(len(inputs.cup().splitlines()))
              if browser.ask("away", {"sample": k}) < browser.ask("away", peak) - 0.3]
    at = {k: browser.ask("pixel_of", atom) for k, atom in enumerate(before)}
    atoms = sorted(at.values(), key=lambda pixel: math.dist(pixel, center))[:3]
    assert len(atoms) == 3 and max(math.dist(pixel, center) for pixel in atoms) < 120
    for pixel in (center, *atoms):
        assert is_of_a_pocket(browser.color_at(*pixel))
    browser.ask("set_layer", "pockets", False)
    for pixel in atoms:
        color = browser.color_at(*pixel)
        assert color[3] == 255 and not is_of_a_pocket(color)


def test_mouths_are_outlined(cup, browser):
    """The opening has one dark line around it, which is gone with the pocket."""
    assert 5 <= browser.ask("marked")["outlines"] <= 60
    browser.ask("set_layer", "atoms", False)
    assert browser.count_of_color("outline", 25) > 300
    browser.ask("set_layer", "pockets", False)
    assert browser.count_of_color("outline", 25) == 0


ELEMENTS = {"C": lambda red, green, blue, _: max(red, green, blue) < min(red, green, blue) + 40,
            "N": lambda red, green, blue, _: blue > max(red, green) + 40,
            "O": lambda red, green, blue, _: red > max(green, blue) + 60,
            "S": lambda red, green, blue, _: min(red, green) > blue + 60}


def test_atoms_are_told_by_element_and_name(cup, browser):
    browser.ask("set_layer", "pockets", False)
    atoms = inputs.cup().splitlines()
    for symbol, is_of_element in ELEMENTS.items():
        those = [{"sample": k} for k, line in enumerate(atoms) if line[76:78].strip() == symbol]
        nearest = min(those, key=lambda atom: browser.ask("away", atom))
        assert is_of_element(*browser.color_at(*browser.ask("pixel_of", nearest))), symbol
    symbols = browser.find('button[data-layer="atoms"] .elements').text.split()
    assert symbols[0] == "C" and sorted(symbols) == ["C", "N", "O", "S"]
    names = [f"B SER {line[22:26].strip()} {line[12:16].strip()}" for line in atoms]
    x, y = browser.ask("pixel_of", {"sample": 9})
    browser.click_at(x, y)
    picked = browser.ask("picked")["sample"]
    assert math.dist(browser.ask("pixel_of", {"sample": picked}), (x, y)) < 40
    assert f"{names[picked]} · row {picked} " in browser.find("#page-details .fact-head").text
    saddle = next(r for r in cup.records if r["index"] == 2)
    browser.ask("pick", cup.places[tuple(saddle["contact"])])
    chips = [chip.text for chip in browser.find("#page-details .chips").find_elements("css selector", "button")]
    assert chips == [f"{row} · {names[row]}" for row in saddle["contact"]]
    browser.find("#tab-table").click()
    assert browser.find("#page-table tbody tr:nth-child(10) th").text == f"row 9 · {names[9]}"


def test_sticks_are_at_the_distance_of_bonds(cup, browser):
    """So many pairs of atoms, whose saddle is in the list, are as near as 1.2 times the sum of their radii."""
    radii = {"C": 0.76, "N": 0.71, "O": 0.66, "S": 1.05}
    element = [line[76:78].strip() for line in inputs.cup().splitlines()]
    edges = [(r["contact"], 2 * math.sqrt(r["squared_distance_double"])) for r in cup.records if r["index"] == 1]
    bonds = [ends for ends, length in edges if length <= 1.2 * sum(radii[element[end]] for end in ends)]
    assert 100 < len(bonds) == browser.ask("drawn")["sticks"] < len(edges)
