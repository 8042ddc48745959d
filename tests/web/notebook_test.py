"""The viewer's page in the frame that a notebook shows: it draws there, can be picked in, and asks nobody."""

import os
import pathlib
import subprocess

import pytest

from browser import WAIT

CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
PROGRAM = f"import flowcert; print(flowcert.FlowComplex({CUBE}).show(height=500)._repr_html_())"


@pytest.fixture(scope="module")
def frame(request):
    package = pathlib.Path(request.config.getoption("--flowcert")).parent / "python"
    if not (package / "flowcert").is_dir():
        pytest.skip(f"{package} has no Python package; ./dev build makes it")
    settings = {**os.environ, "PYTHONPATH": str(package), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(["/usr/bin/python3", "-c", PROGRAM], check=True, stdout=subprocess.PIPE, text=True,
                          env=settings).stdout


def test_the_page_works_in_a_frame(browser, frame, tmp_path):
    (tmp_path / "notebook.html").write_text(
        f"<!doctype html><title>A notebook</title><div>{frame}</div>", encoding="utf-8"
    )
    browser.go(tmp_path / "notebook.html")
    box = browser.find("iframe")
    assert box.size["height"] == 500
    browser.driver.switch_to.frame(box)
    browser.driver.execute_async_script(WAIT)
    browser.rest()
    counts = browser.ask("counts")
    assert counts["points"] == 8 and counts["by_kind"][:4] == [8, 12, 6, 1]
    assert browser.run("return document.getElementById('scene').clientHeight") > 100
    # The notebook is out of its reach.
    assert browser.run("try { return String(parent.document); } catch (error) { return error.name; }") == "SecurityError"
    browser.driver.switch_to.default_content()
