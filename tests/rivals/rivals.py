"""./dev rivals: what public programs say of critical points and persistence, judged by flowcert.

    rivals.py FLOWCERT FOLDER [--seconds 30] [--jobs 2] [--seed 1] [--only NAME] [--record FILE]
    rivals.py --self-test

Each program answers the conformance vectors through the pipe, and then a campaign of `flowcert fuzz --against`. Its
persistence pairs are judged by `flowcert conformance`. Standard output is Markdown: one table by flag, and for each
kind of failure the smallest input, which is also a file in FOLDER/smallest/.
--record writes what each program made of each vector, as JSON, for versions.py.
FLOWCERT_RECORDED may name a folder with answers NAME.fc to NAME.xyz that a Giesen-Kühne program has written.

A program is right if flowcert says so: it conforms, also where only that is determined, or is perturbed. An answer is
counted apart, as not claimed, if all that is wrong with it comes of ties. These programs know simplices, and none says
what becomes of a critical point with a larger contact set, or of a regular stationary point.
"""

import argparse
import concurrent.futures
import datetime
import json
import os
import platform
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

import answering

HERE = Path(__file__).resolve().parent
PYTHON = "/usr/bin/python3"  # Debian's, which has Debian's modules
PACKAGES = ["python3-gudhi", "gudhi-utils", "libcgal-dev", "python3-scipy", "tetgen", "libgmp10", "voronota"]
# What is wrong for no other reason than that a critical point is no simplex, or that a stationary point is none.
TIES = {"missed-by-cluster", "contact-incomplete", "collision-as-critical", "claimed-twice", "wrong-counts"}
VECTOR_LIMIT = 600  # seconds
MOST_COLUMNS = 120


class Program:
    def __init__(self, name, command, tolerance="1e-9"):
        self.name = name
        self.command = command  # a list of words
        self.tolerance = tolerance
        self.is_python = command[0] == PYTHON


def programs(cgal):
    gudhi, scipy = str(HERE / "gudhi_alpha.py"), str(HERE / "scipy_delaunay.py")
    # GUDHI's manual promises a relative precision of 1e-5 for the values of `safe`. Campaigns know one tolerance, 1e-9.
    return [Program("gudhi fast", [PYTHON, gudhi, "fast"]),
            Program("gudhi safe", [PYTHON, gudhi, "safe"], "1e-5"),
            Program("gudhi exact", [PYTHON, gudhi, "exact"]),
            Program("gabriel epick", [cgal, "gabriel-epick"]),
            Program("gabriel epeck", [cgal, "gabriel-epeck"]),
            Program("alpha epick", [cgal, "alpha-epick"]),
            Program("alpha epeck", [cgal, "alpha-epeck"]),
            Program("scipy", [PYTHON, scipy, "plain"]),
            Program("scipy joggled", [PYTHON, scipy, "joggled"])]


def diagrams():
    gudhi, tool = str(HERE / "gudhi_alpha.py"), "gudhi-alpha-complex-persistence"
    interface = [Program(f"python3-gudhi {kind}", [PYTHON, gudhi, f"{kind}-persistence"], tolerance)
                 for kind, tolerance in (("fast", "1e-9"), ("safe", "1e-5"), ("exact", "1e-9"))]
    # The command prints six digits, whatever its precision.
    return interface + [Program(" ".join([tool, *options]), [tool, "-m", "0", "-p", "2", *options], "1e-5")
                        for options in (["--fast"], [], ["--exact"])]


# ---- Running ----

class Served:
    """A command for flowcert, with {in} and {out}, that asks the program. A program in Python is loaded only once."""

    def __init__(self, program):
        self.program = program

    def __enter__(self):
        if not self.program.is_python:
            return shlex.join(self.program.command) + " {in} {out}"
        self.folder = tempfile.TemporaryDirectory()
        path = Path(self.folder.name) / "socket"
        self.server = subprocess.Popen([*self.program.command, "--serve", str(path)], stderr=subprocess.DEVNULL,
                                       env={**os.environ, "OPENBLAS_NUM_THREADS": "1"}, start_new_session=True)
        while not path.exists():
            if self.server.poll() is not None:
                raise RuntimeError(f"{self.program.name}: does not start")
            time.sleep(0.05)
        return shlex.join([PYTHON, "-I", "-S", str(HERE / "ask.py"), str(path)]) + " {in} {out}"

    def __exit__(self, *_):
        if self.program.is_python:
            os.killpg(self.server.pid, signal.SIGKILL)
            self.server.wait()
            self.folder.cleanup()


def json_of(words, **more):
    ended = subprocess.run(words, capture_output=True, text=True, check=False, **more)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"{shlex.join(map(str, words))}: {ended.stderr.strip()}")
    return json.loads(ended.stdout)


def kind_of_reason(reason):
    """A refusal's reason without what differs from case to case."""
    words = (reason or "refused").split()
    return " ".join(words[:{"flat:": 1, "QhullError:": 2, "crashed:": 3}.get(words[0], 4)]).rstrip(":")


class Rivals:
    def __init__(self, options):
        self.flowcert = str(Path(options.flowcert).resolve())
        self.folder = Path(options.folder).resolve()
        self.seconds, self.seed = options.seconds, options.seed
        self.vectors = {}
        self.flags = []
        for path in sorted((HERE.parents[1] / "spec/vectors").glob("*.json")):
            content = json.loads(path.read_text())
            self.flags += [flag["flag"] for flag in content.get("flags", [])]
            self.vectors |= {case["id"]: case for case in content.get("cases", []) if case["result"] != "invalid"}

    def run(self, *words, **more):
        return json_of([self.flowcert, *map(str, words)], **more)

    # ---- Vectors

    def ask_vectors(self, program):
        """By vector: (class, {kind: finding}). The classes are right, not claimed, wrong, refused and crashed."""
        kept = self.folder / "kept" / program.name.replace(" ", "-")
        with tempfile.TemporaryFile("w+") as answers:
            with subprocess.Popen([self.flowcert, "generate", "--vectors"], stdout=subprocess.PIPE) as cases:
                subprocess.run(program.command, stdin=cases.stdout, stdout=answers, stderr=subprocess.DEVNULL,
                               timeout=VECTOR_LIMIT, check=True)
            answers.seek(0)
            report = self.run("verify", "--vectors", "--json", "--tolerance", program.tolerance, "--keep", kept,
                              stdin=answers)
        if report["unanswered"]:
            raise RuntimeError(f"{program.name}: {report['unanswered']} vectors have no answer")
        verdicts = {name: ("right", {}) for name in self.vectors}
        for failure in report["failures"]:
            name = failure["id"].split(":")[1]
            verdicts[name] = self.verdict_on(failure, kept / name, program.tolerance)
        return verdicts

    def verdict_on(self, failure, kept, tolerance):
        if failure["verdict"] == "refused":
            kind = kind_of_reason(failure["reason"])
            return ("crashed" if kind.startswith("crashed") else "refused"), {kind: None}
        if failure["verdict"] == "unreadable":
            return "wrong", {"unreadable": None}
        findings = failure["findings"]
        if failure["wrong"] > len(findings):
            findings = self.run("check", f"{kept}.xyz", f"{kept}.claim", "--json", "--tolerance", tolerance)["findings"]
        return class_of([finding for finding in findings if not finding["permitted"]], self.vectors[kept.name])

    # ---- Campaigns

    def campaign(self, program):
        out = self.folder / "campaigns" / program.name.replace(" ", "-")
        ignored = [word for reason in (*sorted(TIES - {"wrong-counts"}), "refusal") for word in ("--ignore", reason)]
        with Served(program) as command:
            return self.run("fuzz", "--json", "--time", self.seconds, "--seed", self.seed, "--time-limit", "5",
                            "--memory-limit", "0", *ignored, "--out", out, "--against", command)

    # ---- Persistence

    def ask_diagrams(self, program):
        own = f"{shlex.quote(self.flowcert)} compute {{in}} -o {{out}}"
        with Served(program) as command:
            style = []
            if not program.is_python:
                command = shlex.join(program.command) + " -o {out} {in}"
                style = ["--in-format", "off"]
            return self.run("conformance", "--json", "--group", "persistence", "--tolerance", program.tolerance, *style,
                            "--memory-limit", "0", "--against", own, "--persistence-against", command)


def is_at_stationary_point(finding, case):
    """Whether the claimed simplex has the centre of a stationary point, whatever it leaves out of its contact set."""
    rows = vector_rows(case)
    facts = sphere_facts(rows, independent_part(rows, finding["contact"]))
    centers = [[Fraction(word) for word in point["center"]] for point in case["expected"]["stationary"]]
    return facts["center"] in centers


def class_of(findings, case=None):
    """The class of an answer that fails, and its first finding of each kind. A vector knows its stationary points."""
    kinds = {}
    for finding in findings:
        if finding["reason"] == "contact-incomplete" and case and not is_at_stationary_point(finding, case):
            finding["reason"] = "contact-incomplete, nothing there"
    for finding in findings:
        kinds.setdefault(finding["reason"], finding)
    if len(kinds) > 1:
        kinds.pop("wrong-counts", None)  # the Euler sum only follows
    return ("not claimed" if set(kinds) <= TIES else "wrong"), kinds


# ---- By exact arithmetic ----

def solved(matrix, right):
    """The solution of a square system in fractions, or none where it is singular."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k] != 0), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i, row in enumerate(rows):
            if i != k and row[k] != 0:
                rows[i] = [a - row[k] * b for a, b in zip(row, rows[k])]
    return [row[-1] for row in rows]


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def squared(point, center):
    return sum((Fraction(x) - c) ** 2 for x, c in zip(point, center))


def sphere_facts(points, ids):
    """What is true of the smallest sphere through these points: fractions, straight from the definition.

    It has no code in common with flowcert and its oracle. None if the points are not affinely independent.
    """
    corners = [[Fraction(x) for x in points[i]] for i in ids]
    edges = [[a - b for a, b in zip(corner, corners[0])] for corner in corners[1:]]
    weights = solved([[2 * dot(u, v) for v in edges] for u in edges], [dot(u, u) for u in edges])
    if weights is None:
        return None
    center = [c + sum(w * e[k] for w, e in zip(weights, edges)) for k, c in enumerate(corners[0])]
    squares = [squared(p, center) for p in points]
    square = squares[ids[0]]
    return {"center": center, "square": square, "weights": [1 - sum(weights), *weights],
            "inside": sum(s < square for s in squares), "on": sum(s == square for s in squares)}


def independent_part(points, ids):
    part = []
    for i in ids:
        if sphere_facts(points, [*part, i]) is not None:
            part.append(i)
    return part


def fact_text(points, ids):
    """`weights 1/2 1/2; 0 inside, 3 on the sphere: a tie`. Repeated points count once."""
    distinct = sorted({tuple(map(float, point)) for point in points})
    ids = [distinct.index(tuple(map(float, points[i]))) for i in ids]
    points = distinct
    facts = sphere_facts(points, ids)
    if facts is None:
        part = sphere_facts(points, independent_part(points, ids))
        verdict = "not critical" if part["inside"] else "a tie"
        return f"no simplex; {part['inside']} inside, {part['on']} on the sphere: {verdict}"
    short = [str(w) if len(str(w)) < 10 else f"{float(w):.3g}" for w in facts["weights"]]
    on = facts["on"]
    if facts["inside"] or min(facts["weights"]) < 0:
        verdict = "not critical"
    elif on > len(ids) or min(facts["weights"]) == 0:
        verdict = "a tie"
    else:
        verdict = f"critical of index {len(ids) - 1}"
    return f"weights {' '.join(short)}; {facts['inside']} inside, {on} on the sphere: {verdict}"


# ---- The report ----

def rows_of_file(path):
    return [[float.fromhex(w) if "x" in w else float(w) for w in line.split()[:3]]
            for line in Path(path).read_text().splitlines() if line.strip() and not line.startswith("#")]


def vector_rows(case):
    return [[float.fromhex(word) for word in row] for row in case["points"]]


def print_table(head, rows):
    widths = [max(len(str(row[k])) for row in [head, *rows]) for k in range(len(head))]
    # A table that is too wide has no blanks, and then no bars at its sides.
    blank = " " if sum(widths) + 3 * len(widths) < MOST_COLUMNS else ""
    side = "|" if sum(widths) + len(widths) < MOST_COLUMNS else ""
    for row in [head, None, *rows]:
        cells = ["-" * width for width in widths] if row is None else [
            str(cell).ljust(width) for cell, width in zip(row, widths)]
        print(side + "|".join(f"{blank}{cell}{blank}" for cell in cells) + side)
    print()


def count_text(count, noun):
    return f"{count} {noun}{'' if count == 1 else 's'}"


CLASSES = ("right", "not claimed", "wrong", "refused", "crashed")


def campaign_counts(campaign):
    """By kind, how many cases of a campaign fail: `fuzz --json` names a property in front of the kind."""
    return {key.split(" ", 1)[-1]: count for key, count in campaign["failures"].items()}


def campaign_class(kind):
    return {"refusal": "refused", "signal": "crashed", "time-limit": "crashed"}.get(kind) or class_of(
        [{"reason": kind}])[0]


def print_by_program(verdicts, campaigns):
    rows = []
    for name, of in verdicts.items():
        count = Counter(outcome for outcome, _ in of.values())
        rows.append([name, len(of), *(count[outcome] for outcome in CLASSES)])
    print_table(["vectors", "n", *CLASSES], rows)
    rows = []
    for name, campaign in campaigns.items():
        count = Counter()
        for kind, number in campaign_counts(campaign).items():
            count[campaign_class(kind)] += number
        cases = max(campaign["cases"], count.total())  # the last one may not have been finished
        rows.append([name, cases, cases - count.total(), count["wrong"], count["crashed"]])
    print_table(["campaign", "n", "right, not claimed or refused", "wrong", "crashed"], rows)


def print_by_flag(flags, vectors, verdicts):
    rows = []
    for flag in flags:
        names = [name for name, case in vectors.items() if flag in case["flags"]]
        if not names:
            continue
        row = [flag, len(names)]
        for of in verdicts.values():
            count = Counter(of[name][0] for name in names)
            row.append(f"{count['right']}+{count['not claimed']}/{count['wrong'] + count['crashed']}")
        rows.append(row)
    print_table(["flag", "n", *(name.replace("gudhi ", "g-").replace("gabriel ", "G-").replace("alpha ", "A-")
                                .replace("scipy joggled", "joggled") for name in verdicts)], rows)


def smallest_of_each_kind(rivals, name, verdicts, campaign):
    """By kind: (number of vectors, number of campaign cases, points, where, contact)."""
    found = {}
    for vector, (_, kinds) in verdicts.items():
        for kind, finding in kinds.items():
            rows = vector_rows(rivals.vectors[vector])
            entry = found.setdefault(kind, [0, 0, None, "", None])
            entry[0] += 1
            if entry[2] is None or len(rows) < len(entry[2]):
                entry[2:] = [rows, vector, finding["contact"] if finding else None]
    for finding in campaign["findings"]:
        entry = found.setdefault(finding["kind"], [0, 0, None, "", None])
        # A batch that was not finished has findings, but no counts.
        entry[1] = max(entry[1], campaign_counts(campaign).get(finding["kind"], 1))
        if entry[2] is None or finding["points"] < len(entry[2]):
            contact = contact_of(rivals, finding["file"], finding["kind"])
            entry[2:] = [rows_of_file(finding["file"]), f"campaign {finding['case']}", contact]
    folder = rivals.folder / "smallest"
    folder.mkdir(parents=True, exist_ok=True)
    for kind, (_, _, rows, where, _) in found.items():
        stem = "".join(c if c.isalnum() else "-" for c in f"{name}-{kind}")[:80].rstrip("-")
        text = "".join(" ".join(map(repr, row)) + "\n" for row in rows)
        (folder / f"{stem}.xyz").write_text(f"# {name}: {kind}; {where}\n{text}")
    return found


def contact_of(rivals, path, kind):
    """The contact set that a campaign's finding is about. Its file has the claim in comments."""
    lines = Path(path).read_text().splitlines()
    if "# the claim:" not in lines:
        return None
    claim = [line[4:] for line in lines[lines.index("# the claim:") + 1:lines.index("# what is wrong with it:")]]
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write("\n".join(claim) + "\n")
        file.flush()
        findings = rivals.run("check", path, file.name, "--json")["findings"]
    return next((finding["contact"] for finding in findings if finding["reason"] == kind), None)


def print_smallest(name, found):
    print(f"{name}:\n")
    for kind, (vectors, cases, points, where, contact) in sorted(found.items(), key=lambda item: -item[1][0]):
        print(f"- `{kind}`: {count_text(vectors, 'vector')}, {cases} drawn; the smallest is {where}, "
              f"{count_text(len(points), 'point')}.")
        if contact and all(i < len(points) for i in contact):
            print(f"  {' '.join(map(str, contact))}: {fact_text(points, contact)}.")
    print()


def diagram_outcome(case):
    kinds = {finding["reason"] for finding in case["persistence_findings"]}
    return "right" if not case["negative"] else "rounding" if kinds == {"rounding"} else case["outcome"]


def print_diagrams(reports):
    rows = []
    for program, report in reports:
        outcomes = {case["id"]: diagram_outcome(case) for case in report["cases"]}
        count = Counter(outcomes.values())
        wrong = [name.removeprefix("persistence-") for name, outcome in outcomes.items() if outcome != "right"]
        others = sum(n for outcome, n in count.items() if outcome not in ("right", "fails", "rounding"))
        rows.append([program.name, program.tolerance, len(outcomes), count["right"], count["rounding"],
                     count["fails"], others, " ".join(wrong[:6]) + (" ..." if len(wrong) > 6 else "")])
    print_table(["program", "tolerance", "cases", "right", "rounding", "fails", "no answer", "which"], rows)


# ---- Recorded answers ----

def print_recorded(rivals, folder):
    if not folder:
        print("No recorded answers: FLOWCERT_RECORDED names no folder.\n")
        return
    rows = []
    for claim in sorted(Path(folder).glob("*.fc")):
        points = claim.with_suffix(".xyz")
        report = rivals.run("check", points, claim, "--json")
        wrong = [finding for finding in report["findings"] if not finding["permitted"]]
        kinds = Counter(finding["reason"] for finding in wrong)
        _, kinds_at_points = class_of([finding for finding in wrong if finding["level"] <= 3])
        verdict = report["verdict"] if not wrong else "not claimed" if set(kinds) <= TIES else "wrong"
        rows.append([claim.stem, verdict, "right" if not kinds_at_points else "wrong",
                     ", ".join(f"{n} {kind}" for kind, n in kinds.most_common(3))])
    print_table(["input", "verdict", "levels 1 to 3", "most of what is wrong"], rows)


# ---- Defects that are known ----

def ended_by(words, source=None):
    status = subprocess.run(words, input=source, capture_output=True, text=True, check=False, timeout=60).returncode
    return signal.Signals(-status).name if status < 0 else f"exit status {status}"


def scipy_crash():
    code = ("from scipy.spatial import Delaunay\ns = 1e151\n"
            "Delaunay([[s, 0, 0], [0, .7 * s, .1 * s], [.2 * s, 0, 1.1 * s], [-.5 * s, -s, -.3 * s]])")
    return ended_by([PYTHON, "-c", code])


def gudhi_nan():
    code = ("import gudhi\nnan = float('nan')\n"
            "gudhi.AlphaComplex(points=[[nan, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]).create_simplex_tree()")
    return ended_by([PYTHON, "-c", code])


def dropped_pairs(runs=200):
    """How many runs of GUDHI's command on four points leave pairs out without -m, and with `-m 0`."""
    tool = "gudhi-alpha-complex-persistence"
    with tempfile.TemporaryDirectory() as folder:
        points, out = f"{folder}/points.off", f"{folder}/out"
        Path(points).write_text("OFF\n4 0 0\n0 0 0\n3 0 0\n0 4 0\n0 0 5\n")

        def bars(*options):
            subprocess.run([tool, *options, "-o", out, points], capture_output=True, check=True)
            return len(Path(out).read_text().splitlines())
        most = bars("-m", "0")
        return [sum(bars(*options) < most for _ in range(runs)) for options in ([], ["-m", "0"])]


def print_defects():
    without, with_option = dropped_pairs()
    print_table(["what", "now"], [
        ["SciPy's Delaunay of four points of size 1e151", scipy_crash()],
        ["`gudhi-alpha-complex-persistence` on four points, 200 runs, pairs dropped",
         f"{without} runs without `-m`, {with_option} with `-m 0`"],
        ["python3-gudhi's AlphaComplex of a point with NaN", gudhi_nan()]])


# ---- All of it ----

def compiled(folder):
    program, source = folder / "cgal_simplices", HERE / "cgal_simplices.cpp"
    if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["g++", "-std=c++17", "-O2", "-frounding-math", "-Wall", "-Wextra", source, "-o", program,
                        "-lgmp", "-lmpfr"], check=True)
    return str(program)


def versions():
    listed = subprocess.run(["dpkg-query", "-W", "-f=${Package} ${Version}\\n", *PACKAGES], capture_output=True,
                            text=True, check=False)
    return listed.stdout.splitlines()


def in_turn(jobs, work, programs_asked, what):
    """`work` of each program, so many at a time; progress goes to standard error."""
    def one(program):
        since = time.monotonic()
        result = work(program)
        print(f"{what}: {program.name}, {time.monotonic() - since:.0f} s", file=sys.stderr, flush=True)
        return result
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(one, programs_asked))


def add_to_record(path, group, outcomes):
    """outcomes: by program and input. The record has them by group, and says what it is of."""
    if path is None:
        return
    record = json.loads(Path(path).read_text()) if Path(path).exists() else {}
    record["system"] = platform.freedesktop_os_release()["PRETTY_NAME"]
    record["packages"] = dict(line.split() for line in versions() if len(line.split()) == 2)
    record.setdefault("groups", {})[group] = outcomes
    Path(path).write_text(json.dumps(record, indent=1) + "\n")


def report(options):
    rivals = Rivals(options)
    for part in ("campaigns", "smallest", "kept"):
        subprocess.run(["rm", "-rf", rivals.folder / part], check=True)
    asked = [p for p in programs(compiled(rivals.folder)) if options.only in (None, p.name)]
    if not asked:
        return
    verdicts = dict(zip([p.name for p in asked], in_turn(options.jobs, rivals.ask_vectors, asked, "vectors")))
    add_to_record(options.record, "critical points", {name: {vector: outcome for vector, (outcome, _) in of.items()}
                                                      for name, of in verdicts.items()})
    campaigns = dict(zip(verdicts, in_turn(options.jobs, rivals.campaign, asked, "campaign")))
    print(f"Of {datetime.date.today()}, with {platform.freedesktop_os_release()['PRETTY_NAME']}:\n")
    print("".join(f"- {line}\n" for line in versions()))
    print("### Critical points, by program\n")
    print_by_program(verdicts, campaigns)
    print("### Critical points, by flag\n")
    print_by_flag(rivals.flags, rivals.vectors, verdicts)
    print("### Kinds of failures\n")
    for name, of in verdicts.items():
        print_smallest(name, smallest_of_each_kind(rivals, name, of, campaigns[name]))
    if options.only is None:
        print("### Persistence\n")
        names = diagrams()
        reports = in_turn(options.jobs, rivals.ask_diagrams, names, "persistence")
        add_to_record(options.record, "persistence", {
            program.name: {case["id"]: diagram_outcome(case) for case in report["cases"]}
            for program, report in zip(names, reports)})
        print_diagrams(list(zip(names, reports)))
        print("### Recorded answers of a Giesen-Kühne program\n")
        print_recorded(rivals, os.environ.get("FLOWCERT_RECORDED"))
        print("### Known defects\n")
        print_defects()


def self_test():
    # One that crashes or raises is no more than a refusal.
    assert answering.in_a_fork(lambda: "0,0,0,0\n") == ("answer", "0,0,0,0\n")
    assert answering.in_a_fork(lambda: [][1]) == ("refused", "IndexError: list index out of range")
    assert answering.in_a_fork(lambda: os.kill(os.getpid(), signal.SIGSEGV)) == ("crashed", signal.SIGSEGV)
    square = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [2, 2, 0]]
    assert fact_text(square, [0, 1]) == "weights 1/2 1/2; 0 inside, 2 on the sphere: critical of index 1"
    assert fact_text(square, [0, 3]) == "weights 1/2 1/2; 0 inside, 4 on the sphere: a tie"
    assert fact_text(square, [0, 1, 2]) == "weights 0 1/2 1/2; 0 inside, 4 on the sphere: a tie"
    assert fact_text([*square, [1, 1, 0]], [0, 3]).endswith("1 inside, 4 on the sphere: not critical")
    assert fact_text([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [0, 1, 2]).startswith("no simplex; ")
    assert fact_text([*square, [0, 0, 0]], [4]) == "weights 1; 0 inside, 1 on the sphere: critical of index 0"
    assert fact_text([*square, [1, 1, 0]], [0, 1, 2, 3]) == "no simplex; 1 inside, 4 on the sphere: not critical"
    obtuse = [[0, 0, 0], [4, 0, 0], [1, 1, 0]]
    assert fact_text(obtuse, [0, 1, 2]).endswith(": not critical")
    tetrahedron = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]
    assert sphere_facts(tetrahedron, [0, 1, 2, 3])["square"] == 3
    finding = lambda reason: {"reason": reason, "contact": [0]}
    assert class_of([finding("missed-by-cluster"), finding("wrong-counts")])[0] == "not claimed"
    assert class_of([finding("missed-by-cluster"), finding("missing")])[0] == "wrong"
    case = {"points": [["0", "0", "0"], ["2", "0", "0"], ["1", "1", "0"]],
            "expected": {"stationary": [{"center": ["1", "0", "0"]}]}}
    edge = lambda ids: [{"reason": "contact-incomplete", "contact": ids}]
    assert class_of(edge([0, 1]), case)[0] == "not claimed" and class_of(edge([0, 2]), case)[0] == "wrong"
    assert list(class_of([finding("wrong-counts"), finding("missing")])[1]) == ["missing"]
    assert kind_of_reason("crashed: signal 11") == "crashed: signal 11"
    assert kind_of_reason("QhullError: QH6154 Qhull precision error: Initial") == "QhullError: QH6154"
    assert kind_of_reason("flat: CGAL has this") == "flat"


def options_of(documentation):
    parser = argparse.ArgumentParser(description=documentation.splitlines()[0])
    parser.add_argument("flowcert", nargs="?")
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", metavar="NAME", help="this program alone, and no persistence")
    parser.add_argument("--record", metavar="FILE", help="write what came of each input into this file, too")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    if not options.self_test and options.folder is None:
        parser.error("FLOWCERT and FOLDER are required")
    return options


def main():
    options = options_of(__doc__)
    if options.self_test:
        self_test()
    else:
        report(options)


if __name__ == "__main__":
    main()
