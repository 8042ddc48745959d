#!/usr/bin/env python3
"""proof_text_test.py FLOWCERT PROOF ROOT

Text that is not as flowcert writes it decides nothing: `flowcert-proof` and spec/proof.py end with 2 where a reader of
JSON would see something else than they compare, and the program ends with 2 where a file cannot be read.
"""
# CITES: FC-FILE-51 FC-IN-05
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FLOWCERT, PROOF, ROOT = sys.argv[1], sys.argv[2], Path(sys.argv[3])
TETRAHEDRON = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
failures = []


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def expect(status, what, *arguments, with_python=True):
    checkers = [[PROOF], [sys.executable, ROOT / "spec/proof.py"]]
    for checker in checkers if with_python else checkers[:1]:
        result = run(*checker, *arguments)
        if result.returncode != status or result.stderr.count("\n") != (status == 2):
            failures.append(what)
            print("FAIL:", what, checker[-1], result.returncode, result.stdout, result.stderr)


def changed_lists(text):
    """Lists that are not as flowcert writes them, each with what is changed."""
    hidden = ',"left_out":["x\\\\","],{},"zz":["\\\\""]'
    first_double = r'("center_double":\[)[^,]*'
    for what, pattern, new in (
            ("a key hidden behind an escape", r'("input_sha256":"\w*")', r"\1" + hidden.format('"morse_smale":true')),
            ("a count hidden behind an escape", r'("input_sha256":"\w*")',
             r"\1" + hidden.format('"critical":[9,9,9,9]')),
            ("a brace for a comma", '"index":0,', '"index":0{'),
            ("a comma for a brace", '\n{"index"', '\n,"index"'),
            ("a brace in the header", '"format_version":1,', '"format_version":1{'),
            ("a key of two words", '"points"', '"version commit":1,"points"'),
            ("a zero too many", first_double, r"\g<1>00"),
            ("no digit after the point", first_double, r"\g<1>0."),
            ("no digit before the point", first_double, r"\g<1>.0"),
            ("a plus", first_double, r"\g<1>+0"),
            ("another object", r"\n\Z", "{}\n"),
            ("no last newline", r"\n\Z", ""),
            ("other ends of lines", "\n", "\r\n")):
        changed = re.sub(pattern, new, text, count=1)
        assert changed != text, what
        yield what, changed


def main():
    with tempfile.TemporaryDirectory() as name:
        scan, cells, records, pairs, exact_pairs, text = [
            Path(name) / file for file in ("a.xyz", "a.fcert", "a.jsonl", "a.pers", "a.json", "changed")]
        scan.write_text(TETRAHEDRON)
        run(FLOWCERT, "compute", scan, "-o", records, "--certificate", cells)
        run(FLOWCERT, "persistence", scan, "-o", pairs)
        exact_pairs.write_text(run(FLOWCERT, "persistence", scan, "--json").stdout)
        expect(0, "what flowcert writes", scan, cells, records)
        for file in (pairs, exact_pairs):
            expect(0, "pairs that flowcert writes", scan, cells, "--pairs", file, with_python=False)
        for what, changed in changed_lists(records.read_text()):
            text.write_bytes(changed.encode())
            expect(2, what, scan, cells, text)
        text.write_text(re.sub(',"version":.*?,"points"', ',"points"', records.read_text(), count=1))
        expect(0, "a list of an unknown program", scan, cells, text)
        for what, changed in (("a byte of 0", re.sub("(?m)^0 0 inf$", "0 0 inf\0 or not", pairs.read_text())),
                              ("a comma for a brace", exact_pairs.read_text().replace('"pairs":[{', '"pairs":[,')),
                              ("another key", exact_pairs.read_text().replace('"has_zero"', '"left":1,"has_zero"'))):
            text.write_text(changed)
            expect(2, "pairs with " + what, scan, cells, "--pairs", text, with_python=False)
        text.with_suffix(".xyz").write_text("")
        expect(2, "no points in text", text.with_suffix(".xyz"), cells)
        expect(2, "a folder for a certificate", scan, name)
        expect(2, "a folder for a list", scan, cells, name)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
