"""Pages of the tutorial as notebooks for Jupyter: text cells, code cells, and a last cell that shows the viewer's page.

usage: notebooks.py PAGES FOLDER [--execute]

PAGES is the folder of the tutorial's pages, which stay the only source. A notebook has no other text than its page, and
no other Python but the last cell. With --execute, jupyter-nbconvert runs each notebook in FOLDER, so that it has its
outputs, and flowcert has to be importable; FLOWCERT is the folder of the repository, as for the pages. The exit status
is 1 where a cell does not print what its page says, which is told line by line. Needs Debian's python3-nbformat; to
execute, jupyter-nbconvert and python3-ipykernel.

Guarantees: a notebook is the same to the byte for the same page.
"""

import argparse
import pathlib
import re
import subprocess
import sys

import nbformat

# What the last cell of each notebook shows, by the page's name.
SHOWN = {
    "critical_points": 'flowcert.FlowComplex(points[::20]).show(name="every 20th point of the bunny")',
    "tunnels_and_voids": 'fc.show(name="torus")',
    "cavities_and_pores": 'protease.show(name="1hpv", atoms=names, probe="1.4")',
}
LAST_TEXT = "## See it\n\nThe viewer's page; [its manual](../manual/view.html) says what is what."


def blocks_of(pages: pathlib.Path, text: str):
    """The blocks of a page, as the tutorial's own tests read them."""
    sys.path.insert(0, str(pages))
    import page_blocks

    sys.path.remove(str(pages))
    return page_blocks.blocks_of(text)


def _in_the_site(lines) -> str:
    """The text of these lines, without blocks that only copy files. Pages and pictures are in a folder beside that of
    the notebooks.
    """
    text = re.sub(r"^```console\n(\$ cp .*\n)+```\n", "", "\n".join(lines), flags=re.MULTILINE).strip()
    text = re.sub(r"\]\(([a-z_]+)\.md(#[^)]*)?\)", r"](../tutorial/\1.html\2)", text)
    return re.sub(r"\]\(([a-z_]+\.(?:svg|png))\)", r"](../tutorial/\1)", text)


def notebook_of(pages: pathlib.Path, name: str):
    """The notebook of a page, and what each of its code cells prints."""
    text = (pages / f"{name}.md").read_text(encoding="utf-8")
    lines = text.splitlines()
    cells, prints = [], []

    def add_text(text: str) -> None:
        if text:
            cells.append(nbformat.v4.new_markdown_cell(text, id=f"cell-{len(cells)}"))

    def add_code(source: str, output: str) -> None:
        cells.append(nbformat.v4.new_code_cell(source, id=f"cell-{len(cells)}"))
        prints.append(output)

    at, copies = 0, []
    for block in blocks_of(pages, text):
        if block.kind == "command":
            # Commands and what they print stay text, but Python needs the files that they bring.
            if block.source.startswith("cp "):
                copies.append(f"!{block.source.rstrip()}")
            continue
        add_text(_in_the_site(lines[at : block.line - 2]))
        if copies:
            add_code("\n".join(copies), "")
            copies = []
        source = block.source.rstrip("\n")
        if block.kind == "file":
            add_code(f"%%writefile {block.name}\n{source}", f"Writing {block.name}\n")
        else:
            add_code(source, block.output)
        # Behind the fence that ends the block, or that of its output.
        at = max(block.line + block.source.count("\n"), block.place.stop)
    add_text(_in_the_site(lines[at:]))
    add_text(LAST_TEXT)
    add_code(SHOWN[name], "")
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": kernel}), prints


def execute(path: pathlib.Path) -> None:
    """Runs the notebook, which then has its outputs."""
    command = ["jupyter-nbconvert", "--to", "notebook", "--execute", "--inplace", "--log-level=ERROR", str(path)]
    subprocess.run(command, check=True)


def differences(notebook, prints) -> list:
    """A line for each code cell of an executed notebook that printed something else."""
    found = []
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    for number, (cell, expected) in enumerate(zip(cells, prints)):
        printed = "".join(output.text for output in cell.outputs if output.output_type == "stream")
        if printed != expected:
            found.append(f"code cell {number}: printed {printed!r}, and not {expected!r}")
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--execute", action="store_true")
    parser.add_argument("--only", choices=sorted(SHOWN), action="append", help="these alone")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    status = 0
    for name in arguments.only or SHOWN:
        path = arguments.folder / f"{name}.ipynb"
        notebook, prints = notebook_of(arguments.pages, name)
        nbformat.write(notebook, path)
        if not arguments.execute:
            continue
        execute(path)
        for line in differences(nbformat.read(path, as_version=4), prints):
            print(f"{path.name}: {line}", file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
