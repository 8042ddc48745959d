#!/usr/bin/env python3
"""Lines of Markdown have at most 120 columns, so that they can be read and compared in any window.

usage: markdown_lines_test.py [ROOT]
       markdown_lines_test.py --self-test

Guarantees: every Markdown file under ROOT is read, but those in folders of builds and in hidden ones other than
.github. An address (https://...) does not count. Exit status: 0; 1 where a line is too long, and each one is named with
file and line.
"""
import pathlib
import re
import sys
import tempfile

# The site has the same files.
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "src" / "site"))
from gathered_pages import markdown_files  # noqa: E402

MOST = 120
ADDRESS = re.compile(r"https?://[^\s)>]+")


def long_lines(root):
    """Yields a line for each line that is too long."""
    for path in markdown_files(root):
        for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
            columns = len(ADDRESS.sub("", line))
            if columns > MOST:
                yield f"{path.relative_to(root)}:{number}: {columns} columns; at most {MOST}"


def check(root):
    complaints = list(long_lines(root))
    files = len(list(markdown_files(root)))
    if files == 0:
        complaints.append(f"no Markdown file under {root}")
    for complaint in complaints:
        print("FAIL:", complaint)
    if not complaints:
        print(f"{files} Markdown files: no line has more than {MOST} columns")
    return 1 if complaints else 0


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name in ("a", "a/build-x", "a/.git", ".github"):
            (root / name).mkdir()
        address = "https://example.org/" + "x" * MOST
        (root / "a" / "right.md").write_text(f"{'é' * MOST}\n({address}) {'y' * (MOST - 3)}\n", encoding="utf-8")
        for other in ("a/build-x/wide.md", "a/.git/wide.md", "a/wide.txt"):
            (root / other).write_text("x" * 200)
        assert list(long_lines(root)) == [], list(long_lines(root))
        (root / "a" / "wide.md").write_text(f"# A table\n\n| {'x' * MOST} |\n")
        assert list(long_lines(root)) == [f"a/wide.md:3: {MOST + 4} columns; at most {MOST}"], list(long_lines(root))
        (root / ".github" / "wide.md").write_text("x" * (MOST + 1))
        assert len(list(long_lines(root))) == 2, list(long_lines(root))
    print("finds lines that are too long, and counts no address")
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    argument = sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).resolve().parents[2]
    sys.exit(self_test() if argument == "--self-test" else check(pathlib.Path(argument)))
