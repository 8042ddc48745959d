"""Clauses of the specification, for Sphinx: anchors, links to them, and commands for their examples.

Guarantees: a paragraph that begins with a clause's id in bold has that id as its anchor, `flow_complex.html#FC-IN-03`,
and is in the index and in what the search finds; so is an item of a list of withdrawn ids. Every other mention of an id
in text is a link to it. A mention of an id that no page defines, and an id that two define, is a warning.
Below each block `example` or `judgement` stands what runs it in a shell.
"""
import html
import re
import shlex
from fractions import Fraction

from docutils import nodes
from pygments.lexers.special import TextLexer
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

ID = re.compile(r"\bFC-[A-Z]+-\d\d\b")
OPENING = re.compile(r"FC-[A-Z]+-\d\d(?=, withdrawn )")
# Links within these would be links in links, or in what is copied.
CLOSED = (nodes.reference, nodes.title, nodes.literal, nodes.literal_block, nodes.raw, addnodes.pending_xref)
log = logging.getLogger(__name__)


def clause_of(paragraph):
    """The id that a paragraph defines, with the node that has it; or None."""
    first = next((child for child in paragraph.children if child.astext()), None)
    if isinstance(first, nodes.strong) and ID.fullmatch(first.astext()):
        return first.astext(), first
    if isinstance(first, nodes.Text) and isinstance(paragraph.parent, nodes.list_item):
        if found := OPENING.match(first.astext()):
            return found.group(), None
    return None


def sections_of(block):
    """{heading: lines} of an example or a judgement; {"": lines} is what is before them."""
    found, heading = {"": []}, ""
    for line in block.splitlines():
        if line in ("points", "claim", "expect"):
            heading = line
            found[heading] = []
        elif line.startswith("verdict "):
            heading = "expect"
            found[heading] = [line]
        else:
            found[heading].append(line)
    return found


def as_decimals(row):
    """The same doubles; a judgement may have them as fractions, which no file of points has."""
    return " ".join(repr(float(Fraction(x))) if "/" in x else x for x in row.split())


def here_document(lines):
    return "<<'END'\n" + "".join(line + "\n" for line in lines) + "END\n"


def commands_of(language, block):
    """What runs a block in a shell, from an empty folder; the program is on its path."""
    found = sections_of(block)
    text = "cat > points.xyz " + here_document(map(as_decimals, found["points"]))
    if language == "judgement":
        return text + "flowcert check points.xyz - " + here_document(found["claim"])
    words = [line.split() for line in found["expect"]]
    text += "flowcert compute points.xyz -o -\n"
    for line in words:
        if line[0] == "orbit":
            text += f"flowcert orbit points.xyz --from {shlex.quote(','.join(line[1:4]))}\n"
    if any(line[0] == "pair" for line in words):
        text += "flowcert persistence points.xyz -o -\n"
    if any(line[0] in ("limits", "boundary") for line in words):
        text += "flowcert compute points.xyz --manifolds u2 --manifolds s2 -o -\n"
    return text


class Clauses(SphinxTransform):
    default_priority = 500

    def apply(self):
        clauses = self.env.flowcert_clauses
        for paragraph in list(self.document.findall(nodes.paragraph)):
            if not (found := clause_of(paragraph)):
                continue
            name, strong = found
            if name in clauses:
                log.warning("%s is defined in %s, too", name, clauses[name], location=paragraph)
            clauses[name] = self.env.docname
            paragraph["ids"].append(name)
            if strong is not None:
                link = nodes.reference("", "", refid=name, internal=True, classes=["clause"])
                strong.replace_self(link)
                link += strong
            entry = addnodes.index(entries=[("single", name, name, "main", None)])
            paragraph.parent.insert(paragraph.parent.index(paragraph), entry)
        for block in list(self.document.findall(nodes.literal_block)):
            if block.get("language") in ("example", "judgement"):
                commands = html.escape(commands_of(block["language"], block.astext()))
                details = f'<details class="run"><summary>Run it</summary><pre>{commands}</pre></details>'
                block.parent.insert(block.parent.index(block) + 1, nodes.raw("", details, format="html"))


def link_mentions(app, doctree, docname):
    clauses = app.env.flowcert_clauses
    for text in list(doctree.findall(nodes.Text)):
        above, is_closed = text.parent, False
        while above is not None and not is_closed:
            is_closed, above = isinstance(above, CLOSED), above.parent
        mentions = [] if is_closed else list(ID.finditer(text.astext()))
        if not mentions:
            continue
        parts, at = [], 0
        for mention in mentions:
            name = mention.group()
            if name not in clauses:
                log.warning("there is no clause %s", name, location=text.parent)
                continue
            parts.append(nodes.Text(text.astext()[at:mention.start()]))
            address = app.builder.get_relative_uri(docname, clauses[name]) + "#" + name
            parts.append(nodes.reference("", name, refuri=address, internal=True))
            at = mention.end()
        text.parent.replace(text, [*parts, nodes.Text(text.astext()[at:])])


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app.env, "flowcert_clauses", {}))
    app.connect("doctree-resolved", link_mentions)
    app.add_transform(Clauses)
    for language in ("example", "judgement"):
        app.add_lexer(language, TextLexer)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
