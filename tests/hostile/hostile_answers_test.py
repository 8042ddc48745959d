"""Programs under test that answer with what no reader expects: each answer is one wrong case, and the run goes on.

Usage: hostile_answers_test.py FLOWCERT VECTORS
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

FLOWCERT = os.path.abspath(sys.argv[1])
DEEP = "[" * 100_000 + "]" * 100_000
KEYS = {f"k{k}": 0 for k in range(200_000)}
LIMIT = '{"kind":"critical","index":%s,"position":["0","0","0"],"contact":[0],"squared_distance":"0"}'
ANSWERS = {
    "a deep index": '{"segments":[],"limit":%s}' % (LIMIT % DEEP),
    "deep pairs": '{"x":%s,"pairs":[]}' % DEEP,
    "many keys": json.dumps({"format": "flowcert-stationary-points", "format_version": 1, **KEYS}),
    "a line that is nothing": "{nope",
    "a long line": "1" * 5_000_000,
    "no UTF-8": "\udcff\udcfe",
    "nothing": "",
}
found = []


def run(words, **more):
    return subprocess.run([FLOWCERT, *words], capture_output=True, text=True, errors="replace", timeout=300, **more)


def expect(is_so, what, finished):
    if not is_so:
        found.append(f"{what}: status {finished.returncode}, {finished.stdout[-200:]!r} {finished.stderr[-200:]!r}")


def ids_of(cases):
    return [line.split()[1] for line in cases.splitlines() if line.startswith("case ")]


def verify(what, answer):
    """Of five cases the first has this answer, and the others are refused."""
    ids = ids_of(run(["generate", "--cases", "5"]).stdout)
    text = f"answer {ids[0]}\n{answer}\nend\n" + "".join(f"refused {id}\n" for id in ids[1:])
    for option in ([], ["--persistence"]):
        words = [FLOWCERT, "verify", "--cases", "5", "--json", *option]
        given = text.encode("utf-8", "surrogateescape")
        finished = subprocess.run(words, capture_output=True, timeout=300, input=given)
        report = json.loads(finished.stdout or b"{}")
        is_one_case = report.get("refused") == 4 and report.get("unanswered") == 0
        expect(finished.returncode == 1 and is_one_case, f"verify {option} of {what}", finished)


def conformance(what, answer, folder):
    """The program copies this answer, whatever it is asked."""
    (folder / "answer").write_text(answer, errors="surrogateescape")
    copied = f"cat '{folder}/answer' >{{out}}"
    commands = ["--against", f"{copied} # {{in}}", "--persistence-against", f"{copied} # {{in}}",
                "--orbits-against", f"cat '{folder}/answer' # {{in}} {{start}}"]  # fmt: skip
    finished = run(["conformance", "--json", "--vectors", str(folder / "vectors"), *commands])
    report = json.loads(finished.stdout or "{}")
    outcomes = {case["outcome"] for case in report.get("cases", [])}
    expect(finished.returncode == 1 and "crashed" not in outcomes and outcomes, f"conformance of {what}", finished)


def few_vectors(folder):
    """Two cases of each of three groups."""
    vectors = pathlib.Path(sys.argv[2])
    folder.mkdir()
    (folder / "flags.json").write_text((vectors / "flags.json").read_text())
    for group in ("flat-inputs", "orbits", "persistence"):
        content = json.loads((vectors / f"{group}.json").read_text())
        content["cases"] = content["cases"][:2]
        (folder / f"{group}.json").write_text(json.dumps(content))


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        few_vectors(folder / "vectors")
        for what, answer in ANSWERS.items():
            verify(what, answer)
            conformance(what, answer, folder)
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
