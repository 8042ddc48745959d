#!/usr/bin/env python3
"""Shows a header's comments to Doxygen: usage comments.py HEADER, prints the header as Doxygen is to read it.

The headers have plain comments, which Doxygen does not read. Here a comment above something describes it, a comment
behind something describes that thing, and the comment that opens a file describes the file. All of it is text: what
Doxygen would take for markup is escaped, and lines stay lines.
"""
import re
import sys

MARKUP = re.compile(r"(::|[\\@&$#<>%\"|])")


def escaped(text):
    return MARKUP.sub(r"\\\1", text)


def shown(lines):
    """Lines of a header, its comments as Doxygen's."""
    is_opening = True
    for line in lines:
        comment = re.match(r"(\s*)//(?!/)\s?(.*)$", line)
        behind = re.match(r"(.*\S)(\s+)// (.*)$", line)
        if comment and is_opening:
            yield f"/// {escaped(comment[2])}"
        elif comment:
            is_title = comment[2].startswith("----")
            yield f"{comment[1]}//{comment[2]}" if is_title else f"{comment[1]}/// {escaped(comment[2])}"
        elif behind and not re.search(r'"[^"]*//[^"]*"', line):
            yield f"{behind[1]}{behind[2]}///< {escaped(behind[3])}"
        else:
            is_opening = False
            yield line


def main():
    with open(sys.argv[1], encoding="utf-8") as header:
        lines = header.read().splitlines()
    print("/// @file")
    print("\n".join(shown(lines)))


if __name__ == "__main__":
    main()
