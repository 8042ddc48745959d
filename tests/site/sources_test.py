"""What the pages are made of: the examples run as they stand there, the plot is the table's, and HTML is right."""
import html
import json
import re
import shutil
import subprocess
import sys

import pytest

from conftest import ROOT

BLOCK = re.compile(r'<div class="highlight-(example|judgement) .*?<pre>(.*?)</pre>.*?'
                   r'<details class="run">.*?<pre>(.*?)</pre>', re.DOTALL)


def text_of(code):
    return html.unescape(re.sub(r"<[^>]*>", "", code))


def test_examples_run_as_they_stand_there(site, build, tmp_path):
    counts = {"example": 0, "judgement": 0}
    for page in sorted((site / "spec").rglob("*.html")):
        for kind, block, commands in BLOCK.findall(page.read_text(encoding="utf-8")):
            block, commands = text_of(block), text_of(commands)
            done = subprocess.run(["bash", "-e", "-c", commands], capture_output=True, text=True, check=False,
                                  cwd=tmp_path, env={"PATH": f"{build}:/usr/bin:/bin"})
            counts[kind] += 1
            if kind == "judgement":
                verdict = re.search(r"^verdict (.*)$", block, re.MULTILINE).group(1)
                assert re.search(rf"^{verdict} \(", done.stdout, re.MULTILINE), f"{block}\n{done.stdout}{done.stderr}"
                continue
            assert done.returncode == 0, block + done.stderr
            header = json.loads(done.stdout.splitlines()[0])
            critical = re.search(r"^critical ([\d ]+)$", block, re.MULTILINE).group(1)
            assert header["critical"] == [int(count) for count in critical.split()], block
    assert counts["example"] > 20 and counts["judgement"] > 10


def test_the_plot_is_that_of_the_table(site, tmp_path):
    pytest.importorskip("matplotlib", reason="there is no matplotlib")
    sys.path.insert(0, str(ROOT / "src/site"))
    import scaling_plot

    table = (ROOT / "tests/bench/README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| [\d,]+ uniform \| [^|]+ \| [\d.]+ \|", table, re.MULTILINE)
    assert sum(map(len, scaling_plot.rows_of(table).values())) == len(rows) > 15
    scaling_plot.draw(table, tmp_path / "same.svg")
    assert (tmp_path / "same.svg").read_bytes() == (site / "_images/scaling.svg").read_bytes()
    scaling_plot.draw(table.replace("| 20.49 |", "| 20.59 |"), tmp_path / "other.svg")
    assert (tmp_path / "other.svg").read_bytes() != (tmp_path / "same.svg").read_bytes()


def test_html_is_right(pages):
    if not shutil.which("tidy"):
        pytest.skip("there is no tidy")
    done = subprocess.run(["tidy", "-q", "-e", "-utf8", "--show-warnings", "no", "--gnu-emacs", "yes",
                           *map(str, pages.values())], capture_output=True, text=True, check=False)
    assert [line for line in done.stderr.splitlines() if ": Error:" in line] == []
