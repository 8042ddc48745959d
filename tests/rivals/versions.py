"""What several versions of other programs make of the same inputs, from the records of `./dev rivals --suite`.

    versions.py RECORD RECORD...
    versions.py --self-test

A record is what rivals.py and triangulations.py write with --record; the oldest system comes first. Standard output is
Markdown: the versions of the packages, a table for each group of questions with a row for each program and system, and
what got better or worse from one system to the next, input by input. Only inputs that both systems were asked are
compared. An outcome is better if it stands before the other one in ORDER.
"""

import json
import sys
from collections import Counter
from pathlib import Path

import rivals

# From good to bad. A refusal is honest.
ORDER = ("right", "proved", "not claimed", "rounding", "refused", "refuted", "wrong", "fails", "unreadable", "crashed")
MOST_NAMES = 4


def place(outcome):
    return ORDER.index(outcome) if outcome in ORDER else len(ORDER)


def short(system):
    """`Debian GNU/Linux 12 (bookworm)` is bookworm, and `Debian GNU/Linux forky/sid` sid."""
    return system.partition("(")[2].partition("/")[0].rstrip(")") or system.rpartition("/")[2]


def print_packages(records):
    names = sorted({name for record in records for name in record["packages"]})
    rivals.print_table(["package", *(short(record["system"]) for record in records)],
                       [[name, *(record["packages"].get(name, "-") for record in records)] for name in names])


def print_counts(group, records):
    """A row for each program and system; a column for each outcome that there is."""
    asked = [record for record in records if group in record["groups"]]
    found = {outcome for record in asked for of in record["groups"][group].values() for outcome in of.values()}
    columns = sorted(found, key=lambda outcome: (place(outcome), outcome))
    rows = []
    for name in dict.fromkeys(name for record in asked for name in record["groups"][group]):
        for record in asked:
            count = Counter(record["groups"][group].get(name, {}).values())
            rows.append([name, short(record["system"]), count.total(), *(count[one] for one in columns)])
    rivals.print_table(["program", "system", "n", *columns], rows)


def changes(older, newer):
    """By pair of outcomes that differ, the inputs."""
    found = {}
    for name in older.keys() & newer.keys():
        if older[name] != newer[name]:
            found.setdefault((older[name], newer[name]), []).append(name)
    return found


def print_changes(group, records):
    for older, newer in zip(records, records[1:]):
        for name, of in newer["groups"].get(group, {}).items():
            found = changes(older["groups"].get(group, {}).get(name, {}), of)
            for (before, after), inputs in sorted(found.items(), key=lambda one: (-len(one[1]), one[0])):
                verdict = "better" if place(after) < place(before) else "worse"
                some = " ".join(sorted(inputs)[:MOST_NAMES]) + (" ..." if len(inputs) > MOST_NAMES else "")
                print(f"- {name}, {short(older['system'])} to {short(newer['system'])}, {verdict}: "
                      f"{rivals.count_text(len(inputs), 'input')} {before} before, {after} now.\n  {some}")
    print()


def report(records):
    print_packages(records)
    for group in dict.fromkeys(group for record in records for group, of in record["groups"].items() if of):
        print(f"### {group[0].upper()}{group[1:]}\n")
        print_counts(group, records)
        print_changes(group, records)


def self_test():
    assert short("Debian GNU/Linux 12 (bookworm)") == "bookworm" and short("Debian GNU/Linux forky/sid") == \
        "sid" and short("Debian GNU/Linux trixie (trixie/sid)") == "trixie"
    assert place("right") < place("not claimed") < place("refused") < place("wrong") < place("crashed") < place("new")
    assert changes({"a": "right", "b": "wrong", "c": "wrong"}, {"a": "right", "b": "right", "d": "wrong"}) == {
        ("wrong", "right"): ["b"]}


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) < 2:
        sys.exit(__doc__)
    else:
        report([json.loads(Path(path).read_text()) for path in sys.argv[1:]])
