"""The oracle on the witness of a scan's longest tunnel: accepted, and refused with one member of each part gone.

usage: bunny_witness_test.py FLOWCERT ORACLE [SCAN]

SCAN is the Stanford bunny of Debian's glmark2-data if none is given; the oracle takes nine minutes then to accept.
"""
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

BUNNY = "/usr/share/glmark2/models/bunny.obj"


def changed(cycle, part, member):
    """The cycle without this member of a part of its witness."""
    result = copy.deepcopy(cycle)
    result["witness"][part].remove(member)
    return result


def main(program, oracle, scan=BUNNY):
    found = json.loads(subprocess.check_output([program, "cycles", scan, "--longest", "1", "--witness", "--json"]))
    cycle = found["cycles"][0]
    witness = cycle["witness"]
    print({part: len(members) for part, members in witness.items()}, flush=True)
    # An edge of a polygon that is met, and none of the loop.
    edge = next(e for e in witness["cocycle"]
                if e not in witness["loop"] and any(set(e) <= set(saddle) for saddle in witness["met"]))
    cases = {"accepted": cycle,
             "refused: not-a-cycle": changed(cycle, "loop", witness["loop"][0]),
             "refused: odd-boundary": changed(cycle, "cocycle", edge),
             "refused: surface-boundary": changed(cycle, "surface", witness["surface"][0])}
    found["cycles"] = list(cases.values())
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "cycles.json"
        path.write_text(json.dumps(found))
        done = subprocess.run([oracle, "witness", scan, str(path)], capture_output=True, text=True, check=False)
    print(done.stdout, done.stderr)
    assert done.returncode == 1, done.returncode
    verdicts = [line.split(": ", 1)[1] for line in done.stdout.splitlines()]
    assert verdicts == list(cases), verdicts


if __name__ == "__main__":
    main(*sys.argv[1:])
