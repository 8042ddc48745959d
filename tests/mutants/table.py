"""The table of mutants: reading it, checking that every entry still applies, and applying one.

Guarantees: an entry that no longer fits its file (its old text is not there exactly once) is an error, so that the
table cannot rot unseen. No mutant is run here: run.py does.
"""
import collections
import json
import pathlib
import re

TABLE = pathlib.Path(__file__).with_name("mutants.json")
LEAST = 60
# Whatever may be wrong with other programs, what judges them must not be: these folders have many mutants of their own.
JUDGING = ("src/certify/", "fuzz/judge/", "fuzz/properties/stable_pieces", "oracle/", "tests/vectors/")
LEAST_OF_JUDGING = 80
ROOTS = ("src/", "fuzz/commands/", "fuzz/judge/", "fuzz/properties/", "oracle/", "spec/", "tests/vectors/")
FIELDS = {"id", "file", "old", "new", "wrong"}
# Names of ctest's tests that a fault is tried by where no quick test reaches its file: commands, Python, judge.py.
TESTS = "tests"
# An equivalent mutant behaves as the original does for all inputs. An accepted one does not, and is left alive.
REASONS = {"equivalent", "accepted"}


def read(path=TABLE):
    return json.loads(path.read_text(encoding="utf-8"))


def faults_of_entry(entry, text):
    """What is wrong with one entry, given the text of its file (None: there is no such file)."""
    missing, unknown = FIELDS - entry.keys(), entry.keys() - FIELDS - REASONS - {TESTS}
    if missing or unknown:
        return [f"fields missing: {sorted(missing)}, unknown: {sorted(unknown)}"]
    faults = []
    if not re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", entry["id"]):
        faults.append("the id is not in kebab case")
    if not entry["wrong"].endswith("."):
        faults.append("no sentence says what is wrong")
    if REASONS <= entry.keys():
        faults.append("two reasons")
    if any(not entry[kind].endswith(".") for kind in REASONS & entry.keys()):
        faults.append("a reason is not a sentence")
    if entry["old"] == entry["new"]:
        faults.append("the new text is the old one")
    if not entry["file"].startswith(ROOTS) or text is None:
        faults.append(f"there is no {entry['file']} in {', '.join(ROOTS)}")
    elif (times := text.count(entry["old"])) != 1:
        faults.append(f"its old text is in {entry['file']} {times} times, not once")
    return faults


def faults_of(entries, root, least=LEAST, least_of_judging=LEAST_OF_JUDGING):
    """What is wrong with the table, one line each."""
    texts = {}
    for name in {entry.get("file", "") for entry in entries}:
        path = root / name
        texts[name] = path.read_text(encoding="utf-8") if path.is_file() else None
    faults = [f"{entry.get('id')}: {fault}" for entry in entries
              for fault in faults_of_entry(entry, texts[entry.get("file", "")])]
    ids = collections.Counter(entry.get("id") for entry in entries)
    faults += [f"{name}: {count} entries have this id" for name, count in ids.items() if count > 1]
    if len(entries) < least:
        faults.append(f"{len(entries)} mutants; at least {least} are asked")
    judging = sum(entry.get("file", "").startswith(JUDGING) for entry in entries)
    if judging < least_of_judging:
        faults.append(f"{judging} mutants in {', '.join(JUDGING)}; at least {least_of_judging} are asked")
    return faults


def mutated(entry, text):
    before, after = text.split(entry["old"])
    return before + entry["new"] + after


def folder_of(entry):
    """The layer of src/; else "commands", "judge", "oracle", "spec" or "vectors"."""
    first, second = entry["file"].split("/")[:2]
    return first if first in ("oracle", "spec") else second
