"""The blocks of a page of the tutorial: commands, Python, files, and what they print.

Guarantees: every fenced block of a page is one of these, or PageError says in which line it is not:

- ```console has commands, each after `$ `; lines that begin with `> ` go on with it. The lines below a command are what
  it prints, on standard output and standard error.
- ```python is run in one session for the page. The ```text block after it, with one empty line between, is what it
  prints; without such a block it prints nothing.
- ```python NAME is saved as NAME, and not run. The paragraph before says that name.

`blocks_of` reads them, in order, and `with_outputs` writes other outputs into the page.
"""

import dataclasses
import re
from typing import List, Optional


class PageError(ValueError):
    pass


@dataclasses.dataclass
class Block:
    kind: str  # "command", "python" or "file"
    source: str  # with a line end
    line: int  # of its source, from 1
    output: str  # "" where it prints nothing
    place: slice  # of the lines of the page that the output takes, in its fences if it is Python's
    name: Optional[str] = None  # of a file


def _fenced(lines):
    """(words after the fence, first line, line of the closing fence), from 0."""
    opened = None
    for at, line in enumerate(lines):
        if not line.startswith("```"):
            continue
        if opened is None:
            opened = line[3:].split(), at + 1
        elif line == "```":
            yield (*opened, at)
            opened = None
        else:
            raise PageError(f"line {at + 1}: a fence in a block")
    if opened:
        raise PageError(f"line {opened[1]}: a block that does not end")


def _commands(lines, first, last):
    at = first
    while at < last:
        if not lines[at].startswith("$ "):
            raise PageError(f"line {at + 1}: no command begins the block")
        end = at + 1
        while end < last and lines[end].startswith("> "):
            end += 1
        below = end
        while below < last and not lines[below].startswith("$ "):
            below += 1
        source = "".join(line[2:] + "\n" for line in lines[at:end])
        yield Block("command", source, at + 1, "".join(line + "\n" for line in lines[end:below]), slice(end, below))
        at = below


def blocks_of(text: str) -> List[Block]:
    lines = text.splitlines()
    blocks: List[Block] = []
    for words, first, last in _fenced(lines):
        source = "".join(line + "\n" for line in lines[first:last])
        if words == ["console"]:
            blocks += _commands(lines, first, last)
        elif words == ["python"]:
            blocks.append(Block("python", source, first + 1, "", slice(last + 1, last + 1)))
        elif len(words) == 2 and words[0] == "python":
            said = "\n".join(lines[: first - 1]).rstrip().split("\n\n")[-1]
            if f"`{words[1]}`" not in said:
                raise PageError(f"line {first}: the paragraph before does not say `{words[1]}`")
            blocks.append(Block("file", source, first + 1, "", slice(last + 1, last + 1), words[1]))
        elif words == ["text"]:
            before = blocks[-1] if blocks else None
            if before is None or before.kind != "python" or before.place != slice(first - 2, first - 2):
                raise PageError(f"line {first}: no Python is above this output")
            before.output, before.place = source, slice(first - 2, last + 1)
        else:
            raise PageError(f"line {first}: not console, python or text")
    return blocks


def with_outputs(text: str, outputs: List[str]) -> str:
    """The page with these outputs in the place of its own, one for each block."""
    lines = text.splitlines()
    for block, output in reversed(list(zip(blocks_of(text), outputs))):
        made = output.splitlines()
        if block.kind == "python" and made:
            made = ["", "```text", *made, "```"]
        lines[block.place] = made
    return "\n".join(lines) + "\n"


def pictures_of(text: str) -> List[str]:
    """The pictures that a page shows."""
    return re.findall(r"^!\[[^\]]+\]\(([^)]+)\)$", text, re.MULTILINE)
