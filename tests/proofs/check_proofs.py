#!/usr/bin/env python3
"""Compiles the proofs of spec/proofs/ and compares them with their table: check_proofs.py BUILD.

Works in BUILD/proofs/. Fails where a proof is left out (Admitted), where a row of README.md names no theorem or has
another number of axioms, where there is an axiom that the page does not name, or where a constant of filter_bounds.h is
not on it. Needs coqc and coq_makefile. Exit status: 0; 1 where something is wrong.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCE = ROOT / "spec" / "proofs"
ROW = re.compile(r"^- `([\w.]+)`: .*; (\d+) axioms?\.$", re.MULTILINE)


def fail(message):
    sys.exit(f"proofs: {message}")


def left_out(folder):
    """Places where something is taken for granted."""
    for path in sorted(folder.rglob("*.v")):
        text = re.sub(r"\(\*.*?\*\)", "", path.read_text(), flags=re.DOTALL)
        for word in re.findall(r"\b(Admitted|admit|Axiom|Parameter|Conjecture)\b", text):
            yield f"{path.relative_to(folder)}: {word}"


def compile_all(folder):
    subprocess.run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], cwd=folder, check=True)
    if subprocess.run(["make", "-j2"], cwd=folder).returncode != 0:
        fail("a proof does not compile")


def axioms_of(folder, theorems):
    """The names of the axioms that each theorem rests on."""
    modules = sorted({name.rpartition(".")[0] for name in theorems})
    lines = [f"From Flowcert Require {module}." for module in modules]
    lines += [f"Print Assumptions Flowcert.{name}." for name in theorems]
    (folder / "Audit.v").write_text("\n".join(lines) + "\n")
    finished = subprocess.run(["coqc", "-R", ".", "Flowcert", "Audit.v"], cwd=folder, capture_output=True, text=True)
    if finished.returncode != 0:
        fail(f"a row of the table names no theorem: {finished.stderr}")
    parts = re.split(r"^(?:Axioms:|Closed under the global context)$", finished.stdout, flags=re.MULTILINE)
    return [set(re.findall(r"^([\w.]+)\s*(?::|$)", part, flags=re.MULTILINE)) for part in parts[1:]]


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = build / "proofs"
    shutil.copytree(SOURCE, folder, dirs_exist_ok=True)
    omitted = list(left_out(SOURCE))
    if omitted:
        fail("; ".join(omitted))
    compile_all(folder)
    page = (SOURCE / "README.md").read_text()
    rows = ROW.findall(page)
    allowed = set(re.findall(r"^- `([\w.]+)`$", page.partition("## Axioms")[2], flags=re.MULTILINE))
    found = axioms_of(folder, [name for name, _ in rows])
    if len(found) != len(rows):
        fail(f"{len(rows)} rows, but the axioms of {len(found)} theorems")
    wrong = [f"{name} rests on {', '.join(sorted(axioms - allowed))}"
             for (name, _), axioms in zip(rows, found) if not axioms <= allowed]
    wrong += [f"{name} rests on {len(axioms)} axioms, not {count}"
              for (name, count), axioms in zip(rows, found) if len(axioms) != int(count)]
    if wrong:
        fail("\nproofs: ".join(wrong))
    header = (ROOT / "src" / "geometry" / "filter_bounds.h").read_text()
    for constant in re.findall(r"^inline constexpr double (k\w+)", header, flags=re.MULTILINE):
        if f"`{constant}`" not in page:
            fail(f"{constant} of filter_bounds.h is not in the table")
    print(f"proofs: {len(rows)} theorems, {len(allowed)} axioms, nothing left out")


if __name__ == "__main__":
    main()
