#!/usr/bin/env python3
"""Every fourth case of the conformance vectors, for tests that start a program for each case.

usage: thinned_vectors.py VECTORS COMMAND...

Runs the command, in which {vectors} is the folder of the thinned ones.
Guarantees: every group and all flags' definitions are there; the first case of a group is. In a whole run
(FLOWCERT_PROPERTY_SCALE of 4 or more, as ./dev test --slow sets it) no case is left out. Exit status: the command's.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

EVERY = 4


def is_whole_run():
    return float(os.environ.get("FLOWCERT_PROPERTY_SCALE", "1")) >= 4


def write_thinned(vectors, folder):
    for path in sorted(Path(vectors).glob("*.json")):
        group = json.loads(path.read_text(encoding="utf-8"))
        if "cases" in group and not is_whole_run():
            group["cases"] = group["cases"][::EVERY]
            (Path(folder) / path.name).write_text(json.dumps(group), encoding="utf-8")
        else:
            shutil.copy(path, folder)


def main():
    with tempfile.TemporaryDirectory(prefix="thinned-") as folder:
        write_thinned(sys.argv[1], folder)
        return subprocess.run([word.replace("{vectors}", folder) for word in sys.argv[2:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
