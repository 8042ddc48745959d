"""Whether WebAssembly writes what the program writes: records with all parts, and persistence, to the byte. Records of
small inputs have polylines and skeletons, too, which are gigabytes for a scan. Inputs of more than 35,000 points have
no records, and are compared by their persistence.

usage: same_bytes.py FLOWCERT MODULES

FLOWCERT is the program, and MODULES the folder of flowcert_records.js and the modules. Inputs are all of the vectors, a
lattice of 1,000 points, and the files *.xyz up to 110,000 points in FLOWCERT_BENCH_DATA. Inputs that are refused are
refused with the same sentence. Only the compiler differs, which the header of an output names.

Of the larger inputs, the last lines say how much longer WebAssembly takes than the program with one thread, and how
much memory it has: before the limits of all directions, and with everything. Exit status 1 where a byte differs,
flowcert_module.wasm is larger than 800 KB, compressed, or an input takes more than 300 MB, with everything.
"""

import gzip
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_POINTS = 110_000
MOST_WITH_RECORDS = 35_000
MOST_BYTES_OF_MODULE = 800_000
MOST_MEMORY = 300 << 20
PARTS = ("delaunay", "critical", "s2", "u2", "limits", "volumes")


def vector_inputs():
    """The text of each input of the vectors, once, by the id of its first case."""
    inputs = {}
    for path in sorted((ROOT / "spec" / "vectors").glob("*.json")):
        for case in json.loads(path.read_text()).get("cases", []):
            if "points" in case:
                inputs.setdefault("".join(" ".join(row) + "\n" for row in case["points"]), case["id"])
    return {name: text for text, name in inputs.items()}


def lattice(side):
    axis = range(side)
    return "".join(f"{x} {y} {z}\n" for x in axis for y in axis for z in axis)


def write_inputs(folder):
    """The small inputs, and those worth measuring."""
    texts = vector_inputs() | {"lattice_10": lattice(10)}
    for name, text in texts.items():
        (folder / f"{name}.xyz").write_text(text)
    small = [folder / f"{name}.xyz" for name in texts]
    scans = sorted(Path(os.environ.get("FLOWCERT_BENCH_DATA", "/nowhere")).glob("*.xyz"))
    large = [small.pop()] + [scan for scan in scans if len(scan.read_text().splitlines()) <= MOST_POINTS]
    if not scans:
        print("same_bytes: FLOWCERT_BENCH_DATA names no folder with scans: they are not compared")
    return small, large


def native(program, file, out, what):
    """What the program says of a file, as flowcert_records does."""
    pairs = None
    words = ["--polylines", "--skeletons"] if what == "lines" else []
    words += ["--manifolds", "u2,s2,all"] + (["-o", f"{out / file.stem}.jsonl"] if what != "pairs" else [])
    run = subprocess.run([program, "compute", file, "--threads", "1", "--json", *words], capture_output=True, text=True)
    if run.returncode == 0:
        words = ["--threads", "1", "-o", f"{out / file.stem}.pers"]
        pairs = subprocess.run([program, "persistence", file, *words], capture_output=True, text=True)
    refused = [one.stderr for one in (run, pairs or run) if one.returncode != 0]
    if refused:
        return {"error": refused[0].strip().removeprefix("flowcert: ")}
    return {"seconds": json.loads(run.stdout)["seconds"]}


def in_node(program, files, out, what):
    said = subprocess.run(["node", program, out, what, *files], check=True, capture_output=True, text=True).stdout
    return [json.loads(line) for line in said.splitlines()]


def content(path):
    """The bytes of an output, but for the compiler, which its header names."""
    data = path.read_bytes() if path.exists() else b""
    return re.sub(rb'("compiler":"|compiler: )[^";]*', b"", data, count=1)


def compare(program, records, files, folder, what):
    """The first differences, how many bytes are equal, and what both say of each file."""
    differences, equal, said = [], 0, []
    for name in ("native", "node"):
        (folder / name).mkdir(exist_ok=True)
    for file, there in zip(files, in_node(records, files, folder / "node", what), strict=True):
        here = native(program, file, folder / "native", what)
        said.append((here, there))
        # The program says of which file it is, and the library does not.
        if here.get("error") not in (there.get("error"), f"{file}: {there.get('error')}"):
            differences.append(f"{file.stem}: {here.get('error')} | {there.get('error')}")
        is_refused = "error" in here or "error" in there
        for suffix in (".jsonl", ".pers"):
            is_wanted = not is_refused and (suffix == ".pers" or what != "pairs")
            left, right = (content(folder / name / (file.stem + suffix)) for name in ("native", "node"))
            if left != right or (is_wanted and not left):
                differences.append(f"{file.stem}{suffix} differs")
            else:
                equal += len(left)
            for name in ("native", "node"):  # outputs of all inputs would fill a disk
                (folder / name / (file.stem + suffix)).unlink(missing_ok=True)
    return differences, equal, said


def row(file, here, there):
    ratios = [there["seconds"][part] / max(here["seconds"][part], 1e-9) for part in PARTS]
    total = sum(there["seconds"][part] for part in PARTS)
    ratio = total / sum(here["seconds"][part] for part in PARTS)
    cells = "".join(f"{value:10.1f}" for value in (*ratios, ratio))
    memory = "".join(f"{there['memory'][part] / 1e6:9.0f} MB" for part in ("pairs", "written"))
    return f"{file.stem:16}{cells}{total:9.1f} s{memory}"


def main():
    program, modules = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        small, large = write_inputs(folder)
        records = modules / "flowcert_records.js"
        differences, equal, said = compare(program, records, small, folder, "lines")
        refused = sum("error" in here for here, _ in said)
        print(f"same_bytes: {len(small)} inputs of the vectors, {refused} of them refused; {equal} bytes are the same")
        print(f"\n{'':16}" + "".join(f"{part:>10}" for part in (*PARTS, "all")) + "   times the program's, one thread")
        most = 0
        for file in large:  # each in a process of its own, for its memory
            what = "pairs" if len(file.read_text().splitlines()) > MOST_WITH_RECORDS else "records"
            more, equal, [(here, there)] = compare(program, records, [file], folder, what)
            differences += more
            if "error" not in here and "error" not in there:
                print(row(file, here, there) + f"{equal:12} bytes")
                most = max(most, there["memory"]["written"])
    size = len(gzip.compress((modules / "flowcert_module.wasm").read_bytes(), 9))
    print(f"\nsame_bytes: flowcert_module.wasm has {size} bytes, compressed; memory grew to {most} bytes at most")
    print("".join(f"{line}\n" for line in differences[:20]) + f"same_bytes: {len(differences)} outputs differ")
    sys.exit(bool(differences) or size > MOST_BYTES_OF_MODULE or most > MOST_MEMORY)


main()
