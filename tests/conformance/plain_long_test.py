#!/usr/bin/env python3
"""No type whose width depends on the system: `long` has 64 bits on one and 32 on another.

usage: plain_long_test.py
       plain_long_test.py --self-test

Guarantees: every source and header of src/, oracle/ and fuzz/ is read, without comments and texts in quotes.
`long long` and `long double` are permitted. Exit status: 0; 1 where a `long` stands, each named with file and line.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NO_CODE = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
PERMITTED = re.compile(r"\blong (?:long|double)\b")


def lines_with_long(text):
    code = PERMITTED.sub("", NO_CODE.sub("", text))
    return [number for number, line in enumerate(code.split("\n"), 1) if re.search(r"\blong\b", line)]


def main():
    files = [path for folder in ("src", "oracle", "fuzz") for ending in ("h", "cpp")
             for path in sorted((ROOT / folder).rglob(f"*.{ending}"))]
    found = [f"{path.relative_to(ROOT)}:{number}: a plain long" for path in files
             for number in lines_with_long(path.read_text(encoding="utf-8"))]
    print("\n".join(found) or f"{len(files)} files, none with a plain long")
    return 1 if found or len(files) < 400 else 0


def self_test():
    text = 'long a;\n// long\nf("long");\nunsigned long long b; long double c;\n'
    text += 'static_cast<unsigned long>(x); g("\\"long");\n'
    assert lines_with_long(text) == [1, 5], lines_with_long(text)
    print("finds a plain long, and not in comments, texts, long long and long double")
    return 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else main())
