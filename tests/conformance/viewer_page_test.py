#!/usr/bin/env python3
"""The page in src/viewer/page.html, as text: what it promises to everyone who opens a page made from it.

usage: viewer_page_test.py [ROOT]
       viewer_page_test.py --self-test

Guarantees: no node and no browser is needed. The line of the data is there once; no element, style or script asks for
anything; both licences are there, whole; versions are those of package.json; the page is not older than its sources.
Exit status: 0, or 1 with each complaint.
"""
import importlib.util
import json
import pathlib
import re
import sys

DATA_LINE = '\n<script type="application/json" id="flowcert-data">null</script>\n'
# What makes a browser ask a host. Names of XML namespaces, which begin with http://, ask nothing.
LOADS = {
    "an attribute that loads": re.compile(r"""<[a-z][^<>]*\s(?:src|href|srcset|poster|action|data)\s*=""", re.I),
    "an element that loads": re.compile(r"<(?:link|iframe|object|embed|base|img)\b", re.I),
    "a style that loads": re.compile(r"@import|url\(\s*[\"']?(?!#|data:)[a-z/]", re.I),
    "a script that imports": re.compile(r"\bimport\s*\(|\bimportScripts\s*\(|\bnew\s+(?:WebSocket|EventSource)\b"),
    "an address": re.compile(r"""["'`(]\s*https?://(?!www\.w3\.org/)"""),
}
REFRESH = re.compile(r"http-equiv\s*=\s*[\"']?refresh", re.I)


def parts_of(page):
    """(before the script, the script, behind it)."""
    begin = page.rindex("<script>\n") + len("<script>\n")
    end = page.index("</script>", begin)
    return page[:begin], page[begin:end], page[end:]


def sources_digest(source):
    """As the page's maker computes it."""
    sys.dont_write_bytecode = True
    spec = importlib.util.spec_from_file_location("bundle", source / "bundle.py")
    bundle = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(bundle)
    return bundle.sources_digest(source)


def complaints(page, package, licences, digest):
    if page.count(DATA_LINE) != 1:
        yield "the line of the data must be there once"
    if page.count("</script") != 2 or not page.endswith("</script>\n</body>\n</html>\n"):
        yield "</script must end the data and the one script, and occur nowhere else"
    head, script, _ = parts_of(page)
    comment, _, markup = head.partition("-->")
    for what, pattern in LOADS.items():
        text = script if what.startswith("a script") else markup
        if what.startswith("an address"):
            text = markup + script
        for found in pattern.finditer(text):
            yield f"{what}: {text[found.start():found.start() + 60]!r}"
    if REFRESH.search(markup) or "default-src 'none'" not in markup:
        yield "the policy must forbid every source, and nothing may refresh"
    if "fetch(" in script and "connect-src" in markup:
        yield "the policy must not allow connections"
    versions = (f"<!-- flowcert viewer {package['version']}, with three.js {package['dependencies']['three']}. ")
    if versions not in comment:
        yield f"the comment must begin with {versions!r}"
    if f"\nSHA-256 of its sources: {digest}\n" not in comment:
        yield "the page is not made of the sources that are here: run ./dev viewer"
    for licence in licences:
        if licence not in comment:
            yield f"a licence is missing: {licence.splitlines()[0]}"


def check(root):
    source = root / "src" / "viewer"
    page = (source / "page.html").read_text(encoding="utf-8")
    package = json.loads((source / "package.json").read_text())
    lock = json.loads((source / "package-lock.json").read_text())
    found = list(complaints(page, package, [(source / "LICENSE").read_text(), three_licence(source)],
                            sources_digest(source)))
    if lock["packages"]["node_modules/three"]["version"] != package["dependencies"]["three"]:
        found.append("package-lock.json has another three.js than package.json")
    for complaint in found:
        print("FAIL:", complaint)
    if not found:
        print(f"src/viewer/page.html, {len(page):,} characters, asks for nothing")
    return 1 if found else 0


def three_licence(source):
    """MIT's text as in our own licence, with the names that three.js has."""
    own = (source / "LICENSE").read_text()
    words = own[own.index("Permission"):].split()
    page = (source / "page.html").read_text(encoding="utf-8")
    begin = page.index("The MIT License\n\nCopyright © 2010-")
    text = page[begin:page.index("-->", begin)]
    assert text[text.index("Permission"):].split() == words, "three's licence is not whole"
    return text


def self_test():
    package = {"version": "1.2.3", "dependencies": {"three": "0.1.0"}}
    right = ("<!doctype html>\n<!-- flowcert viewer 1.2.3, with three.js 0.1.0. x\nSHA-256 of its sources: abc\nOURS\nTHEIRS\n-->\n<html>\n"
             "<meta content=\"default-src 'none'\">" + DATA_LINE +
             '<script>\nx="http://www.w3.org/2000/svg"\n</script>\n</body>\n</html>\n')
    licences = ["OURS", "THEIRS"]
    assert list(complaints(right, package, licences, "abc")) == [], list(complaints(right, package, licences, "abc"))
    assert list(complaints(right, package, licences, "abd"))
    for old, new in [(DATA_LINE, ""), (DATA_LINE, DATA_LINE * 2), ("<html>", "<html><img src='x'>"), ("0.1.0", "0.1.1"),
                     ("OURS", ""), ("THEIRS", "HEIRS"), ("<html>", "<style>@import 'x'</style>"), ("'none'", "*"),
                     ("<html>", "<style>a{b:url(x.png)}</style>"), ('x="', 'import("x");y="'), ('x="', 'y="</script>'),
                     ("<html>", '<link rel="icon" href="x">'), ('x="', 'y="https://example.org";x="')]:
        assert old in right
        assert list(complaints(right.replace(old, new), package, licences, "abc")), (old, new)
    print("finds what a page must not have, and what it must")
    return 0


if __name__ == "__main__":
    if len(sys.argv) > 2:
        sys.exit(__doc__)
    argument = sys.argv[1] if len(sys.argv) == 2 else pathlib.Path(__file__).resolve().parents[2]
    sys.exit(self_test() if argument == "--self-test" else check(pathlib.Path(argument)))
