"""The page that computes: files are dropped on it, from a static server and from disk.

Guarantees: what it shows and saves is what the program says of the same file, and so are its sentences. Nothing is
asked for but the page itself.
"""
import base64
import gzip
import json
import random
import re
import struct
import subprocess
import time

import pytest

import inputs
from computing_page import ComputingPage

EXAMPLES = {"bunny_5000.pts": "5,000 points", "cube.xyz": "9 points", "cage.xyz": "168 atoms"}


def ply(points):
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    return head.encode() + b"property double x\nproperty double y\nproperty double z\nend_header\n" + b"".join(
        struct.pack("<3d", *point) for point in points)


FILES = {
    "ball.ply": ply(inputs.octahedra()),
    "ball.xyz": inputs.TEXTS["octahedra"],
    "barrel.pdb": inputs.BARREL.read_text(),
    "ball.xyz.gz": gzip.compress(inputs.TEXTS["octahedra"].encode()),
}


def native(program, path, *words):
    return subprocess.run([program.path, *map(str, words[:1]), str(path), *map(str, words[1:])], capture_output=True,
                          text=True, check=False)


@pytest.mark.parametrize("name", FILES)
def test_a_dropped_file_is_computed_and_drawn(page, program, name):
    path = page.file(name, FILES[name])
    page.compute(path)
    summary = json.loads(program.run("compute", path, "--json"))
    points = f"{summary['points']:,} {'atoms' if name.endswith('pdb') else 'points'}"
    counts = " + ".join(f"{count:,}" for count in summary["critical"])
    assert re.fullmatch(re.escape(f"{name}: {points}; critical points of index 0 to 3: {counts}; computed here in ") +
                        r"\d+\.\d s", page.told())
    with page.frame():
        shown = page.browser.ask("counts")
        assert page.browser.find("#name").text == name
        assert page.browser.run("return flowcert.timings.first_frame_ms") > 0
    assert shown
    notes = [line.split(": ", 2)[2] for line in native(program, path, "compute").stderr.splitlines()]
    assert page.said() == "\n".join(notes)


def test_downloads_are_the_programs_files(page, program):
    path = page.file("ball.xyz.gz", FILES["ball.xyz.gz"])
    page.compute(path)
    folder = page.folder / "native"
    folder.mkdir()
    program.run("compute", path, "-o", folder / "ball.jsonl")
    program.run("persistence", path, "-o", folder / "ball.pers")
    program.run("surface", path, "--select", "index2-radius<auto", "-o", folder / "ball_surface.ply")
    program.run("view", path, "-o", folder / "ball.html")

    def without_maker(content):
        """Without the lines that say which build made it."""
        return [line for line in content.split(b"\n") if b"compiler" not in line and b"cgal" not in line.lower()]

    for kind, name in (("records", "ball.jsonl"), ("persistence", "ball.pers"), ("surface", "ball_surface.ply")):
        saved, content = page.download(kind)
        assert saved == name
        expected = (folder / name).read_bytes()
        assert without_maker(content) == without_maker(expected) and len(without_maker(expected)) > 10
    saved, content = page.download("page")
    assert saved == "ball.html" and b"MIT License" in content
    opening = b'<script type="application/json" id="flowcert-data">'
    assert content.split(opening)[0] == (folder / "ball.html").read_bytes().split(opening)[0]


def test_an_error_is_the_programs_sentence(page, program):
    good = page.file("square.xyz", inputs.TEXTS["square"])
    bad = page.file("bad.xyz", "0 0 0\n1 0\n")
    sentence = native(program, bad, "compute").stderr.strip().replace(str(bad), "bad.xyz")
    page.drop(bad)
    page.rest()
    assert page.state() == "start" and page.said("error") == sentence.partition(": ")[2] != ""
    page.compute(good)
    page.drop(bad)
    page.rest()
    assert page.state() == "shown" and page.said("error") and page.told().startswith("square.xyz: 4 points")


@pytest.mark.parametrize("name, content, begun, named, given, told", [
    ("flat.xyz", "0 0\n2 0\n0 2\n", "", "--z 0", "--z 1", "flat.xyz: 3 points; critical points"),
    ("iron.xyz", "1\niron\nFe 0 0 0\n", "--radii bondi", "--radii bondi,Fe=R", "--radii bondi,Fe=2.04",
     "iron.xyz: 1 atom;"),
    ("wet.pdb", inputs.BARREL.read_text(), None, "--atoms \"no water\"", "--atoms \"no water\"", "wet.pdb: 126 atoms;"),
], ids=["z", "radii", "atoms"])
def test_options_that_a_sentence_names_can_be_given(page, name, content, begun, named, given, told):
    page.drop(page.file(name, content))
    page.rest()
    options = page.browser.find("#options")

    def again(text):
        options.clear()
        options.send_keys(f"{text}\ue007")
        page.rest()

    if begun:
        page.browser.find("#more").click()
        again(begun)
    assert named in page.said("" if begun is None else "error")
    again("--nothing 3")
    assert page.said("error") == "there is no option --nothing here"
    again(given)
    assert page.said("error") == "" and page.told().startswith(told)


def test_progress_is_told_and_can_be_cancelled(page):
    draw = random.Random(1)
    big = page.file("big.xyz", inputs.rows([[draw.random() for _ in range(3)] for _ in range(60_000)]))
    page.drop(big)
    end = time.monotonic() + 60
    while len({part for part, value, _ in page.browser.run("return parts") if 0 < value < 1}) < 2:
        assert time.monotonic() < end and page.state() == "busy"
        time.sleep(0.05)
    assert page.browser.find("#work").is_displayed() and re.fullmatch(r"\d+ s", page.browser.find("#seconds").text)
    page.browser.find("#cancel").click()
    assert page.state() == "start" and page.said() == "big.xyz: cancelled"
    page.browser.run("parts.length = 0")
    page.compute(page.file("square.xyz", inputs.TEXTS["square"]))
    assert page.told().startswith("square.xyz: 4 points")
    known = {"reading", "Delaunay triangulation", "critical points", "unstable manifolds", "stable manifolds",
             "chain complex", "links of saddles", "persistence", "limits of all directions", "merge trees", "page"}
    assert {part for part, _, _ in page.browser.run("return parts")} <= known


def test_escape_cancels(page):
    draw = random.Random(2)
    page.drop(page.file("big.xyz", inputs.rows([[draw.random() for _ in range(3)] for _ in range(60_000)])))
    page.browser.keys("\ue00c")
    assert page.state() == "start" and page.said() == "big.xyz: cancelled"


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples(page, name):
    page.browser.find(f'[data-example="{name}"]').send_keys("\ue007")
    page.rest()
    assert page.told().startswith(f"{name}: {EXAMPLES[name]}")
    with page.frame():
        if name == "cage.xyz":
            assert page.browser.find("[data-chamber] td").text == "5.397020"
        if name == "cube.xyz":
            assert page.browser.ask("counts")["by_kind"] == [9, 13, 6, 1, 4]


def test_molecules_have_radii(page):
    page.compute(page.file("cage.xyz", inputs.CAGE.read_text()))
    assert "critical points" in page.told() and page.browser.find("[data-file=records]").is_displayed()
    for radii in ("bondi", "alvarez", ""):
        page.browser.run("radii.value = arguments[0]; radii.dispatchEvent(new Event('change'))", radii)
        page.rest()
        assert page.browser.find("#radii").get_attribute("value") == radii
        assert page.browser.find("[data-file=records]").is_displayed() == (not radii)
        with page.frame():
            assert bool(page.browser.find_all("[data-chamber]")) == bool(radii)
    page.compute(page.file("square.xyz", inputs.TEXTS["square"]))
    assert not page.browser.find("#radii").is_displayed()


def test_a_file_can_be_dropped_on_the_picture(page):
    page.compute(page.file("square.xyz", inputs.TEXTS["square"]))
    with page.frame():
        pass
    page.drop(page.file("corners.xyz", inputs.TEXTS["cube"]), at=(300, 600))
    page.rest()
    assert page.told().startswith("corners.xyz: 8 points")


def test_one_file_at_a_time(page):
    page.drop(*(page.file(f"{k}.xyz", "0 0 0\n") for k in range(2)))
    assert page.said("error") == "One file at a time."


def test_it_works_from_disk(browser, computing, tmp_path):
    """Worker, module and frame; a drop on the frame, too."""
    path = tmp_path / "flowcert.html"
    path.write_bytes(computing)
    page = ComputingPage(browser, tmp_path)
    page.open(path.as_uri())
    page.compute(page.file("square.xyz", inputs.TEXTS["square"]))
    with page.frame():
        pass
    page.drop(page.file("corners.xyz", inputs.TEXTS["cube"]), at=(300, 600))
    page.rest()
    assert page.told().startswith("corners.xyz: 8 points")


def test_from_file_to_picture_in_time(page, computing, factor):
    """bunny_5000, from the drop to the first frame; the best of three, as other work only ever delays."""
    packed = re.search(rb'id="bunny_5000.pts">([^<]*)<', computing)[1]
    path = page.file("bunny_5000.pts", gzip.decompress(base64.b64decode(packed)))
    times = []
    for _ in range(3):
        page.compute(path)
        with page.frame():
            drawn = page.browser.run("return performance.timeOrigin + flowcert.timings.first_frame_ms")
        times.append(drawn - page.browser.run("return window.dropped"))
        if times[-1] <= 3000:
            break
    print(f"bunny_5000: first frame {min(times):.0f} ms after the drop")
    assert min(times) <= 3000 * factor


def test_a_phone_has_all_of_it(page):
    driver = page.browser.driver
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                           {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True})
    try:
        for _ in range(2):
            assert page.browser.run("return document.documentElement.scrollWidth") <= 390
            page.compute(page.file("cage.xyz", inputs.CAGE.read_text()))
        for part in ("#view", "#radii", "[data-file=page]", "#more"):
            assert page.browser.find(part).rect["width"] > 40
        assert page.browser.find("#view").rect["height"] > 600
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
