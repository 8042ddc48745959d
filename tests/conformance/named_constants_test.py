#!/usr/bin/env python3
"""Constants of error bounds have names, and are in the table of what is proved: named_constants_test.py

A literal such as 0x1p-40 in src/ may only stand in the declaration of a constexpr constant, whose name starts with k.
Each of these constants is named in spec/proofs/README.md, with what is proved of it, or among those of which nothing
is. Before it looks at the sources, the test tries itself on three lines. Exit status: 0; 1 where something is wrong.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LITERAL = re.compile(r"\b0x[0-9a-fA-F.]+p-[0-9]+")
DECLARATION = re.compile(r"\bconstexpr double ")
NAME = re.compile(r"\b(k[A-Z]\w*) = ")


def code_of(text):
    """Statements with the numbers of their lines, without comments and strings."""
    for block in re.findall(r"/\*.*?\*/", text, flags=re.DOTALL):
        text = text.replace(block, "\n" * block.count("\n"))
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)
    line = 1
    for statement in re.split(r"(?<=[;{}])", text):
        yield line + len(statement) - len(statement.lstrip("\n")), statement
        line += statement.count("\n")


def judge(text):
    """Lines with a literal that has no name, and the names of those that have one."""
    unnamed, names = [], []
    for line, statement in code_of(text):
        if not LITERAL.search(statement):
            continue
        parts = re.split(r",\s*(?=k[A-Z]\w* = )", statement)
        found = [NAME.search(part) for part in parts if LITERAL.search(part)]
        if DECLARATION.search(statement) and all(found):
            names += [one[1] for one in found]
        else:
            unnamed.append(line)
    return unnamed, names


def main():
    sample = ("constexpr double kA = 0x1p-40, kB = 2;  // 0x1p-3\n"
              "double f() { return x * 0x1p-40; }\n"
              'const char* text = "0x1p-1";\n')
    assert judge(sample) == ([2], ["kA"]), judge(sample)
    page = (ROOT / "spec" / "proofs" / "README.md").read_text()
    wrong, count = [], 0
    for path in sorted((ROOT / "src").rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        unnamed, names = judge(path.read_text())
        place = path.relative_to(ROOT)
        wrong += [f"{place}:{line}: a constant of a bound without a name" for line in unnamed]
        wrong += [f"{place}: {name} is not in spec/proofs/README.md" for name in names if f"`{name}`" not in page]
        count += len(names)
    print("\n".join(wrong) or f"{count} constants, each of them named and in the table")
    return 1 if wrong or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
