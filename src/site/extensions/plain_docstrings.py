"""Docstrings of the Python package, which are plain text, for Sphinx's autodoc, which reads reStructuredText.

Guarantees: no character of a docstring is taken for markup. What is indented stays as it is, line by line, and a
session with `>>>` is Python. In signatures a long union of NumPy's has its own name.
"""
import re

from numpy.typing import ArrayLike

try:
    from sphinx.util.typing import stringify_annotation
except ImportError:  # before Sphinx 6.2, as of Debian 12
    from sphinx.util.typing import stringify as stringify_annotation

MARKUP = re.compile(r"([\\*`|_])")


def as_restructured_text(lines):
    """The lines, so that they read the same. A block is told by its first line."""
    made, is_literal, is_session = [], False, False
    for at, line in enumerate(lines):
        is_first = bool(line) and (at == 0 or not lines[at - 1])
        if is_first or (line and not line.startswith(" ")):
            is_session = line.startswith(">>>") or (is_session and not is_first)
        if line.startswith(" ") and not is_session:
            if not is_literal:
                made += ["", "::", ""]
            is_literal = True
            made.append("   " + line)
        elif line:
            if is_literal:
                made.append("")
            is_literal = False
            made.append(line if is_session else MARKUP.sub(r"\\\1", line))
        else:
            made.append(line)
    return made


def process(app, what, name, given, options, lines):
    lines[:] = [*as_restructured_text(lines), ""]


def shorten(app, what, name, given, options, signature, returned):
    def short(text):
        return text and text.replace(stringify_annotation(ArrayLike), "ArrayLike").replace("~typing.", "")

    return short(signature), short(returned)


def setup(app):
    app.connect("autodoc-process-docstring", process)
    app.connect("autodoc-process-signature", shorten)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
