#!/usr/bin/env python3
"""The pictures of README.md, taken anew from pages that the program makes.

usage: pictures.py FLOWCERT FOLDER

Guarantees: the bunny's reconstruction, a degenerate input with its highest maximum picked, a cage of atoms with its
windows, and the bunny's longest tunnels, which an example of the Python package draws; PNG, at most 300 KB each.
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

import browser as browsers
import inputs
from program import Program

SIZE = (1000, 630)
MOST = 300_000
TUNNELS = pathlib.Path(__file__).resolve().parents[1] / "python" / "tunnels_of_a_scan.py"


def compressed(png):
    """The same picture, its data compressed as well as zlib can."""
    head, at, data, tail = png[:8], 8, b"", b""
    while at < len(png):
        size, kind = struct.unpack_from(">I4s", png, at)
        chunk = png[at:at + 12 + size]
        if kind == b"IDAT":
            data += chunk[8:-4]
        elif data:
            tail += chunk
        else:
            head += chunk
        at += len(chunk)
    body = b"IDAT" + zlib.compress(zlib.decompress(data), 9)
    return head + struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body)) + tail


def take(browser, page, path, prepare=None):
    browser.open(page.path)
    if prepare:
        prepare(page)
    browser.rest()
    save(browser, path)


def save(browser, path):
    path.write_bytes(compressed(browser.driver.get_screenshot_as_png()))
    if path.stat().st_size > MOST:
        sys.exit(f"{path}: {path.stat().st_size:,} bytes; at most {MOST:,}")
    print(f"{path}: {path.stat().st_size:,} bytes")


def take_tunnels(browser, build, folder, path):
    """At the size of the picture that is drawn."""
    drawn = folder / "tunnels.svg"
    subprocess.run([sys.executable, TUNNELS, inputs.BUNNY, drawn], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "PYTHONPATH": str(build / "python")})
    width, height = re.search(r'viewBox="0 0 (\d+) (\d+)"', drawn.read_text()).groups()
    browser.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": int(width), "height": int(height), "deviceScaleFactor": 1, "mobile": False})
    browser.driver.get(drawn.as_uri())
    save(browser, path)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary, browsers.Browser() as browser:
        browser.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": SIZE[0], "height": SIZE[1], "deviceScaleFactor": 1, "mobile": False})
        program = Program(sys.argv[1], pathlib.Path(temporary))

        def smooth(_):
            browser.ask("full_detail", True)

        def pick_highest(page):
            browser.find("#tool-theme").click()
            maxima = [r for r in page.records if r["index"] == 3]
            highest = max(maxima, key=lambda r: r["squared_distance_double"])
            browser.ask("pick", page.places[tuple(highest["contact"])])

        take(browser, program.page("bunny", None), folder / "bunny.png", smooth)
        take(browser, program.page("cube-with-tents", inputs.PICTURE), folder / "degenerate.png", pick_highest)
        cage = program.page("cage", inputs.CAGE.read_text(), inputs.CAGE_OPTIONS)
        take(browser, cage, folder / "cage.png")
        take_tunnels(browser, pathlib.Path(sys.argv[1]).resolve().parent, pathlib.Path(temporary),
                     folder / "tunnels.png")


if __name__ == "__main__":
    main()
