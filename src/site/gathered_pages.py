#!/usr/bin/env python3
"""The repository's Markdown, as one tree of pages for Sphinx.

usage: gathered_pages.py --check          (whether each page is in one list of pages/, and links lead to what is there)
       gathered_pages.py --self-test

Guarantees: every Markdown file that is no build's is a page, in the folder that PLACES names, or else in its own one.
Links between pages lead to the same pages and anchors as before. A file that a page links, and that is no page, is
copied beside it; a folder becomes a page that lists its files. A link to what is not there stays, so that Sphinx says
it. Nothing within fences and backquotes is changed.
"""
import os
import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# FOLDER of the repository: folder of the site. The longest one that fits decides.
PLACES = {
    "src/site/pages": "",
    "src/site/tutorial": "tutorial",
    "src/cli/manual": "manual",
    "spec": "spec",
    ".github": "contributing",
}
# The npm package has this file beside its README.
ELSEWHERE = {"src/web/package/LICENSE": "LICENSE"}
CODE = re.compile(r"(^(?P<fence>`{3,}).*?^(?P=fence)\s*$|`[^`\n]+`)", re.MULTILINE | re.DOTALL)
TOCTREE = re.compile(r"^```\{toctree\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# What make.py and the tutorial's pictures.py draw.
MADE = re.compile(r"scaling\.svg$|^[a-z_]+\.(svg|png)$")
LINK = re.compile(r"\]\(([^)\s#]+)(#[^)\s]*)?\)")


def markdown_files(root):
    for path in sorted(root.rglob("*.md")):
        folders = path.relative_to(root).parts[:-1]
        if not any(folder.startswith((".", "build")) and folder != ".github" for folder in folders):
            yield path


def place_of(name):
    """Where a file of the repository is in the site."""
    for folder in sorted(PLACES, key=len, reverse=True):
        if name.startswith(folder + "/"):
            return os.path.normpath(os.path.join(PLACES[folder], name[len(folder) + 1:]))
    return name


class Gathered:
    def __init__(self, root, output):
        self.root, self.output = pathlib.Path(root).resolve(), pathlib.Path(output)

    def gather(self):
        """Writes all pages, and returns their names in the site."""
        return [self.page(path) for path in markdown_files(self.root)]

    def page(self, path):
        name = str(path.relative_to(self.root))
        made = self.output / place_of(name)
        made.parent.mkdir(parents=True, exist_ok=True)
        parts = CODE.split(path.read_text(encoding="utf-8"))
        # Of three parts, the second one is code, and the third one its fence.
        for at in range(0, len(parts), 3):
            parts[at] = LINK.sub(lambda link: self.link(name, *link.groups("")), parts[at])
        made.write_text("".join(part or "" for at, part in enumerate(parts) if at % 3 != 2), encoding="utf-8")
        return place_of(name)

    def link(self, page, target, anchor):
        name = os.path.normpath(pathlib.PurePath(page).parent / target)
        path = pathlib.Path(os.path.normpath(self.root / ELSEWHERE.get(name, name)))
        if "://" in target or not path.exists() or not path.is_relative_to(self.root):
            return f"]({target}{anchor})"
        name = place_of(str(path.relative_to(self.root)))
        if path.is_dir():
            name = self.folder(path, name)
        elif path.suffix != ".md":
            self.copy(path, name)
        return f"]({os.path.relpath(name, os.path.dirname(place_of(page)) or '.')}{anchor})"

    def copy(self, path, name):
        (self.output / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, self.output / name)

    def folder(self, path, name):
        """The page of a folder."""
        page = f"{name}/files.md"
        (self.output / page).parent.mkdir(parents=True, exist_ok=True)
        lines = ["---\norphan: true\n---\n", f"# Files in {path.name}\n"]
        for file in sorted(each for each in path.iterdir() if each.is_file()):
            self.copy(file, f"{name}/{file.name}")
            lines.append(f"- [{file.name}]({file.name})")
        (self.output / page).write_text("\n".join(lines) + "\n", encoding="utf-8")
        return page


def complaints(root):
    """Yields a line for each link that leads nowhere, and for each page that not exactly one list of pages/ has."""
    with tempfile.TemporaryDirectory() as scratch:
        output = pathlib.Path(scratch)
        pages = Gathered(root, output).gather()
        listed = []
        for page in pages:
            text = (output / page).read_text(encoding="utf-8")
            for block in TOCTREE.findall(text):
                listed += [line for line in block.splitlines() if line and not line.startswith(":")]
            for target, _ in LINK.findall("".join(CODE.split(text)[::3])):
                if "://" not in target and not (output / page).parent.joinpath(target).exists():
                    if not MADE.match(target):
                        yield f"{page}: the link {target} leads nowhere"
        for name in sorted({page.removesuffix(".md") for page in pages} - {"index"}):
            if listed.count(name) != 1:
                yield f"{name}.md: {listed.count(name)} lists of src/site/pages/ have it, and not one"


def check():
    found = list(complaints(ROOT))
    print("\n".join(f"FAIL: {line}" for line in found) or "every page is in one list, and every link leads somewhere")
    return 1 if found else 0


def self_test():
    with tempfile.TemporaryDirectory() as scratch:
        root, output = pathlib.Path(scratch, "root"), pathlib.Path(scratch, "output")
        for name in ("src/site/pages", "src/cli/manual", "spec/schemas", "build/x", ".github"):
            (root / name).mkdir(parents=True)
        for name in ("src/cli/manual/view.md", "build/x/left_out.md", "src/tool.h", "spec/schemas/a.json"):
            (root / name).write_text("# A\n")
        (root / "src/site/pages/index.md").write_text(
            "[a](../../cli/manual/view.md#b) `[](tool.h)`\n```cpp\n[c](../../tool.h)\n```\n"
            "[d](../../tool.h) [e](none.md)\n")
        (root / "spec/page.md").write_text("[a](schemas) [b](../src/cli/manual/view.md) [c](#d) [e](https://x.org/y)\n")
        assert Gathered(root, output).gather() == ["spec/page.md", "manual/view.md", "index.md"]
        assert (output / "index.md").read_text() == (
            "[a](manual/view.md#b) `[](tool.h)`\n```cpp\n[c](../../tool.h)\n```\n[d](src/tool.h) [e](none.md)\n")
        assert (output / "src/tool.h").is_file() and (output / "spec/schemas/a.json").is_file()
        assert (output / "spec/page.md").read_text() == (
            "[a](schemas/files.md) [b](../manual/view.md) [c](#d) [e](https://x.org/y)\n")
        assert "[a.json](a.json)" in (output / "spec/schemas/files.md").read_text()
        (root / "src/site/pages/index.md").write_text(
            "[a](none.md) ![b](scaling.svg)\n```{toctree}\nspec/page\n```\n")
        assert list(complaints(root)) == [
            "index.md: the link none.md leads nowhere",
            "manual/view.md: 0 lists of src/site/pages/ have it, and not one"], list(complaints(root))
    print("links lead to where the pages are, code stays as it is, and what is in no list is found")
    return 0


if __name__ == "__main__":
    modes = {"--check": check, "--self-test": self_test}
    sys.exit(modes[sys.argv[1]]() if len(sys.argv) == 2 and sys.argv[1] in modes else __doc__)
