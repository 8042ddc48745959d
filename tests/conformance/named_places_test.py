#!/usr/bin/env python3
"""The pages in .github name tests, files and folders that are there, and each promise of SECURITY.md has a test.

usage: named_places_test.py
       named_places_test.py --self-test

Guarantees: a name in backquotes with a slash is a file or folder of the project, or FOLDER/NAME of ctest: then
tests/FOLDER/CMakeLists.txt registers it, or fuzz/corpus has the seeds. Links lead to files. A name with a word in
capitals or a star stands for many, and is not looked for. Exit status: 0; 1 where something is not there.
"""
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAME = re.compile(r"`([A-Za-z_.]+/[\w./*-]*)`")
LINK = re.compile(r"\]\(([^)#]+)")
PATTERN = re.compile(r"\*|[A-Z]{4}")


def is_test(root, name):
    """A test's name is its file's, with _test or without."""
    folder, stem = name.split("/", 1)
    if folder == "fuzz":
        return (root / "fuzz/corpus" / stem.removesuffix("_corpus")).is_dir()
    table = root / "tests" / folder / "CMakeLists.txt"
    return table.exists() and re.search(rf"\b{stem.removesuffix('_test')}(_test)?\b", table.read_text()) is not None


def complaints(root, page):
    text = (root / page).read_text(encoding="utf-8")
    for name in NAME.findall(text):
        if not PATTERN.search(name) and not (root / name).exists() and not is_test(root, name):
            yield f"{page}: there is no {name}"
    for link in LINK.findall(text):
        if not (root / page).parent.joinpath(link).exists():
            yield f"{page}: the link {link} leads nowhere"
    if page.endswith("SECURITY.md"):
        promises = re.findall(r"^- .*\n(?:  .*\n)*", text, flags=re.MULTILINE)
        yield from (f"{page}: no test for: {one[:60]}" for one in promises if not re.search(r"^  Tests: `", one, re.M))
        if not promises:
            yield f"{page}: no promise"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("tests/unit", "fuzz/corpus/read_x", ".github"):
            (root / name).mkdir(parents=True)
        (root / "tests/unit/CMakeLists.txt").write_text("TESTS a_test b_test")
        page = root / ".github/SECURITY.md"
        right = "- One.\n  Tests: `unit/a_test`, `fuzz/read_x_corpus`, `tests/unit/`, `fuzz/*_corpus`.\n- [Two](..).\n"
        page.write_text(right + "  Tests: `unit/b`.\n")
        assert list(complaints(root, ".github/SECURITY.md")) == []
        page.write_text(right.replace("a_test", "c_test").replace("read_x", "read_y").replace("(..)", "(none.md)"))
        found = [one.split(": ", 1)[1] for one in complaints(root, ".github/SECURITY.md")]
        assert found == ["there is no unit/c_test", "there is no fuzz/read_y_corpus", "the link none.md leads nowhere",
                         "no test for: - [Two](none.md).\n"], found
    print("finds names and links of what is not there, and promises without a test")
    return 0


def main():
    pages = sorted(str(path.relative_to(ROOT)) for path in (ROOT / ".github").glob("*.md"))
    found = [one for page in pages for one in complaints(ROOT, page)]
    print("\n".join(found) or f"{len(pages)} pages: all that they name is there")
    return 1 if found or not pages else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
