"""Notebooks of the tutorial: what they are made of, what is found where one prints something else, and the real ones.

The real ones are run by jupyter-nbconvert, and each cell has to print what its page says.
"""

import html
import os
import pathlib
import shutil
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PAGES = ROOT / "src" / "site" / "tutorial"
BUNNY, PROTEASE = "/usr/share/glmark2/models/bunny.obj", "/usr/share/pymol/data/tut/1hpv.pdb"
FILES = {"critical_points": BUNNY, "tunnels_and_voids": None, "cavities_and_pores": PROTEASE}

PAGE = """\
# A title

A link to [another page](other.md#part), and text.

```console
$ cp "$FLOWCERT"/tests/inputs/cage.xyz .
$ cp "$FLOWCERT"/CITATION.cff .
```

```python
import os
import flowcert

fc = flowcert.FlowComplex([[0, 0, 0], [2, 0, 0]])
print(fc.counts, sorted(os.listdir("."))[:2])
```

```text
(2, 1, 0, 0) ['CITATION.cff', 'cage.xyz']
```

![A picture, with
two lines.](picture.svg)

```console
$ flowcert help mouth
some words
```

```python
fc.euler_sum
```

The end.
"""


@pytest.fixture
def notebooks(monkeypatch):
    pytest.importorskip("nbformat", reason="no nbformat: python3-nbformat has it")
    monkeypatch.syspath_prepend(str(ROOT / "src" / "site"))
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setenv("FLOWCERT", str(ROOT))
    import notebooks

    return notebooks


@pytest.fixture
def nbconvert():
    pytest.importorskip("ipykernel", reason="no kernel: python3-ipykernel has it")
    if shutil.which("jupyter-nbconvert") is None:
        pytest.skip("no jupyter-nbconvert: Debian's package of this name has it")


@pytest.fixture
def pages(tmp_path, notebooks, monkeypatch):
    """A folder with the page above, in the place of a real one."""
    folder = tmp_path / "pages"
    folder.mkdir()
    shutil.copy(PAGES / "page_blocks.py", folder)
    (folder / "small.md").write_text(PAGE, encoding="utf-8")
    monkeypatch.setattr(notebooks, "SHOWN", {"small": 'fc.show(name="two")'})
    return folder


def test_a_notebook_has_its_page(notebooks, pages):
    notebook, prints = notebooks.notebook_of(pages, "small")
    cells = [(cell.cell_type, cell.source) for cell in notebook.cells]
    kinds = "".join(kind[0] for kind, _ in cells)
    assert kinds == "mccmcmmc"
    texts = [source for kind, source in cells if kind == "markdown"]
    assert texts[0] == "# A title\n\nA link to [another page](../tutorial/other.html#part), and text."
    assert "](../tutorial/picture.svg)" in texts[1] and "$ flowcert help mouth\nsome words" in texts[1]
    assert texts[2] == "The end." and "```python" not in "".join(texts) and "```text" not in "".join(texts)
    codes = [source for kind, source in cells if kind == "code"]
    assert codes[0].splitlines() == ['!cp "$FLOWCERT"/tests/inputs/cage.xyz .', '!cp "$FLOWCERT"/CITATION.cff .']
    assert codes[1].startswith("import os\n") and codes[2:] == ["fc.euler_sum", 'fc.show(name="two")']
    assert prints == ["", "(2, 1, 0, 0) ['CITATION.cff', 'cage.xyz']\n", "", ""]
    assert notebooks.notebook_of(pages, "small") == (notebook, prints)


def shown(notebook):
    """The page in the frame that the last cell shows."""
    [output] = notebook.cells[-1].outputs
    frame = output.data["text/html"]
    assert frame.startswith('<iframe srcdoc="') and frame.endswith("</iframe>")
    return html.unescape(frame[len('<iframe srcdoc="') : frame.index('" sandbox=')])


def test_a_notebook_is_executed_and_compared(notebooks, nbconvert, pages, tmp_path):
    import flowcert
    import nbformat

    (tmp_path / "run").mkdir()
    notebook, prints = notebooks.notebook_of(pages, "small")
    path = tmp_path / "run" / "small.ipynb"
    nbformat.write(notebook, path)
    notebooks.execute(path)
    executed = nbformat.read(path, as_version=4)
    assert notebooks.differences(executed, prints) == []
    assert shown(executed) == flowcert.FlowComplex([[0, 0, 0], [2, 0, 0]]).show(name="two").html
    changed = [prints[0], prints[1].replace("(2,", "(3,"), *prints[2:]]
    [line] = notebooks.differences(executed, changed)
    assert line.startswith(f"code cell 1: printed {prints[1]!r}, and not ") and "(3, 1, 0, 0)" in line


@pytest.mark.parametrize("name", FILES)
def test_the_notebooks_of_the_tutorial(notebooks, nbconvert, name, tmp_path, capsys, monkeypatch):
    if FILES[name] and not os.path.exists(FILES[name]):
        pytest.skip(f"{FILES[name]} is not there")
    import nbformat

    assert set(notebooks.SHOWN) == set(FILES)
    monkeypatch.setattr(sys, "argv", ["notebooks.py", str(PAGES), str(tmp_path), "--execute", "--only", name])
    status = notebooks.main()
    assert (status, capsys.readouterr().err) == (0, "")
    executed = nbformat.read(tmp_path / f"{name}.ipynb", as_version=4)
    assert len(executed.cells) > 6 and "<title>" in shown(executed)
