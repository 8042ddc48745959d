#!/usr/bin/env python3
"""normative_text_test.py [ROOT]        every normative text of the spec has an id
normative_text_test.py --self-test      damages a small page in every way that must fail, and sees it fail

FC-TERM-01: what is not informative is the text of a clause. So in each page of spec/ every block of text belongs to a
clause, or to a paragraph that begins with *Informative*. If a page has no clause, its first paragraph begins so, and
all of it is informative. Examples are informative, too. FC-TERM-02: each theorem of flow_complex.md has a proof in
proofs.md. Every link of these pages and of the manual in src/cli leads to a file. Prints how many lines are which.
"""
# CITES: FC-TERM-01 FC-TERM-02 FC-TERM-03 FC-TERM-04 FC-TERM-05 FC-TERM-06
import re
import sys
import tempfile
from pathlib import Path

CLAUSE = re.compile(r"\*\*FC-[A-Z]+-\d\d\*\* \((determined|permitted variation|must reject)(, theorem)?\)\. \S")
LOOKS_LIKE_ONE = re.compile(r"\**FC-[A-Z]+-\d+\** *\(")
THEOREM = re.compile(r"^\*\*(FC-[A-Z]+-\d\d)\*\* \(determined, theorem\)|^\*Theorem\.\* ", re.MULTILINE)
CLAUSE_ID = re.compile(r"^\*\*(FC-[A-Z]+-\d\d)\*\* \(", re.MULTILINE)
PROOF = re.compile(r"^\*\*(FC-[A-Z]+-\d\d)\.\*\* ", re.MULTILINE)
VERSION = re.compile(r"Version \d+\.\d+, \d{4}-\d\d-\d\d")
FENCE = re.compile(r"```")
LINK = re.compile(r"\]\(([^)#\s]+)")


def blocks(text):
    """Pairs of the line number and the lines of each block: what stands between blank lines, or between fences."""
    found, current, first, in_fence = [], [], 0, False
    for number, line in enumerate(text.split("\n"), 1):
        is_fence = FENCE.match(line) is not None
        if not in_fence and (not line.strip() or is_fence or line.startswith("#")) and current:
            found.append((first, current))
            current = []
        if in_fence or line.strip():
            first = first if current else number
            current.append(line)
        if (in_fence and is_fence) or (not in_fence and line.startswith("#")):
            found.append((first, current))
            current = []
        in_fence = in_fence != is_fence
    return found + ([(first, current)] if current else [])


def complaints_about(name, text, counts):
    state, complaints, is_first = None, [], True
    is_page_informative = False  # the whole of it
    for number, lines in blocks(text):
        where = f"{name}:{number}"
        if lines[0].startswith("#"):
            state = "informative" if is_page_informative else None
        elif VERSION.fullmatch(lines[0]) and len(lines) == 1:
            continue
        elif FENCE.match(lines[0]):
            counts["informative"] += len(lines)
        elif CLAUSE.match(lines[0]):
            state = "normative"
        elif LOOKS_LIKE_ONE.match(lines[0]):
            complaints.append(f"{where}: the head of a clause that is not as they are: {lines[0][:40]}")
        elif lines[0].startswith("*Informative.* "):
            state = "informative"
        elif state is None:
            complaints.append(f"{where}: text without an id, and not marked as informative: {lines[0][:60]}")
        for extra, line in enumerate(lines[1:], 1):
            if CLAUSE.match(line) and not FENCE.match(lines[0]):
                complaints.append(f"{name}:{number + extra}: a clause that does not begin a paragraph")
        if not lines[0].startswith("#") and not FENCE.match(lines[0]):
            counts[state or "without an id"] += len(lines)
            if is_first:
                is_page_informative = state == "informative" and not has_clauses(text)
            is_first = False
    return complaints


def theorems(text):
    """The ids of the clauses that are theorems, or have one."""
    heads = [(one.start(), one[1]) for one in CLAUSE_ID.finditer(text)]
    return [max(head for head in heads if head[0] <= one.start())[1] for one in THEOREM.finditer(text)]


def without_proof(clauses, proofs):
    proved = PROOF.findall(proofs)
    return [f"proofs.md: no proof of {name}" for name in theorems(clauses) if name not in proved]


def broken_links(path):
    targets = [target for target in LINK.findall(path.read_text()) if "://" not in target]
    return [f"{path}: no file is at the link {target}" for target in targets if not (path.parent / target).exists()]


def has_clauses(text):
    return any(CLAUSE.match(line) for line in text.split("\n"))


def new_counts():
    return {"normative": 0, "informative": 0, "without an id": 0}


def pages(root):
    return sorted(root.glob("spec/*.md")) + sorted(root.glob("spec/formats/*.md"))


def check(root):
    complaints, counts = [], new_counts()
    for path in pages(root):
        complaints += complaints_about(str(path.relative_to(root)), path.read_text(), counts)
    for path in pages(root) + sorted(root.glob("src/cli/**/*.md")):
        complaints += broken_links(path)
    with_clauses = [path for path in pages(root) if has_clauses(path.read_text())]
    complaints += without_proof(*((root / "spec" / name).read_text() for name in ("flow_complex.md", "proofs.md")))
    for complaint in complaints:
        print(complaint)
    print(f"{len(with_clauses)} pages with clauses; " + ", ".join(f"{n} lines {what}" for what, n in counts.items()))
    return 1 if complaints or len(with_clauses) < 2 or not counts["normative"] else 0


PAGE = """# Title

Version 1.0, 2026-11-25

*Informative.* An introduction.


## Section

**FC-IN-01** (determined). One.
It goes on.

- a list

*Informative.* A remark.

```example FC-IN-01
title Any

points
```

**FC-IN-02** (must reject, theorem). Two.
"""


def self_test():
    failures = []
    if complaints_about("page", PAGE, new_counts()):
        failures.append("the page is right")
    damages = {
        "an introduction without a mark": ("*Informative.* An", "An"),
        "text under a heading": ("**FC-IN-01** (determined). One.", "One."),
        "text after an example, under a heading": ("*Informative.* A remark.", "## More\n\nA remark."),
        "no level": (" (determined)", ""),
        "another level": ("(determined)", "(mostly)"),
        "a clause inside a paragraph": ("It goes on.\n", "It goes on.\n**FC-IN-03** (determined). Three.\n"),
        "a version that is none": ("Version 1.0, 2026-11-25", "Version one"),
    }
    for what, (before, after) in damages.items():
        if not complaints_about("page", PAGE.replace(before, after), new_counts()):
            failures.append(f"not noticed: {what}")
    if complaints_about("page", "# Title\n\n*Informative.* A page.\n\n## More\n\nText.\n", new_counts()):
        failures.append("an informative page is right")
    clauses = "**FC-IN-01** (determined). One.\n*Theorem.* Two.\n\n**FC-IN-02** (determined, theorem). Three.\n"
    for proofs, missing in (("**FC-IN-01.** So.\n**FC-IN-02.** So.\n", 0), ("**FC-IN-02.** See FC-IN-01.\n", 1), ("", 2)):
        if len(without_proof(clauses, proofs)) != missing:
            failures.append(f"not {missing} theorems without a proof")
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder, "a.md")
        page.write_text("[one](a.md), [two](a.md#part), [three](b.md#part), [four](https://example.org/c.md)\n")
        if len(broken_links(page)) != 1:
            failures.append("other links than one are broken")
    counts = new_counts()
    complaints_about("page", PAGE, counts)
    if counts != {"normative": 4, "informative": 7, "without an id": 0}:
        failures.append(f"other numbers of lines: {counts}")
    print("\n".join(failures) or "all damages noticed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else
             check(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()))
