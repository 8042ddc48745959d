#!/usr/bin/env python3
"""The arrows between the project's folders that the compiler lets through, judged by what it really read.

usage: folder_arrows_test.py BUILD_DIR        (a Ninja build)
       folder_arrows_test.py --self-test

The layers of src/ are the compiler's: an include upwards is not found (src/CMakeLists.txt), so nothing is asked here of
one layer's includes of another. Guarantees: every other file of the project that an object's compilation read lies in a
folder that the object's folder may see, itself or through others. It fails as well where the table has a cycle, where
a folder is not in it, and where a source was not compiled, but for those that a build may leave out. Exit status: 0;
1 where an arrow is wrong.
"""
import collections
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

LAYERS = ["src/geometry", "src/voronoi", "src/flow", "src/morse", "src/io", "src/certify", "src/cli"]

# FOLDER: the folders that it may include, beside the layer below it. It may also read what those include.
ARROWS = {
    "src/flow": ["src/flow/kernels"],
    "src/flow/kernels": ["src/voronoi"],
    "src/certify/claims": ["src/certify"],
    "src/certify/programs": ["src/certify"],
    "src/cli": ["src/certify/programs"],
    "src/python": ["src/certify"],
    "src/web/module": ["src/certify"],
    "oracle": [],
    "oracle/fast": ["oracle"],
    "oracle/program": ["oracle/fast"],
    "oracle/proof": [],
    "fuzz/inputs": ["src/geometry"],
    "fuzz/properties": ["fuzz/inputs", "oracle/fast", "oracle/proof", "src/io"],
    "fuzz/campaign": ["fuzz/properties", "oracle/program"],
    "fuzz/judge": ["fuzz/properties", "src/certify/programs"],
    "fuzz/commands": ["fuzz/campaign", "fuzz/judge", "src/cli"],
    "fuzz/commands/mpi": ["fuzz/commands"],
    "fuzz/targets": ["fuzz/properties", "oracle/program", "src/certify/claims"],
    "tests": ["src/certify"],
    "tests/vectors": ["tests", "fuzz/inputs", "oracle/program"],
    "tests/conformance": ["tests", "tests/vectors", "src/certify"],
    "tests/proofs": ["src/flow"],
    "tests/property": ["tests", "fuzz/campaign", "fuzz/judge", "src/certify"],
    "tests/hostile": ["tests"],
    "tests/unit": ["tests/property", "tests/vectors", "fuzz/campaign", "fuzz/judge", "src/cli"],
    "tests/bench": ["tests/property"],
    "tests/web_module": ["src/certify"],
}
# The program's main file alone puts together what the other folders keep apart.
COMPOSITION = {"src/cli/main.cpp": ["fuzz/commands"], "src/python/generators.cpp": ["fuzz/inputs"]}

PARTS = ("src", "oracle", "fuzz", "tests")
# Sources, or folders of them, that a build with all tests may leave out.
LEFT_OUT = {
    "fuzz/commands/mpi": "MPI is not everywhere; ./dev mpi builds it",
    "fuzz/targets/make_seeds.cpp": "it made fuzz/corpus, and no test runs it",
    "src/python": "the Python package needs pybind11",
    "src/web/module": "./dev wasm compiles it, by emscripten",
    "tests/bench": "benchmarks; ./dev bench builds them",
    "tests/rivals": "./dev rivals compiles it",
    "tests/web_module": "./dev wasm compiles it, by emscripten",
    "tests/conformance/mpi_campaign_test.cpp": "it tests what MPI builds",
}


def with_layers(arrows, layers):
    """The table with an arrow from each layer to the one below it."""
    below = dict(zip(layers, [None, *layers]))
    return {
        folder: [*arrows.get(folder, []), *([below[folder]] if below.get(folder) else [])]
        for folder in [*layers, *(folder for folder in arrows if folder not in below)]
    }


def closure(arrows):
    """FOLDER: itself and all folders that it reaches. Raises ValueError where a folder reaches itself."""
    reached = {}

    def visit(folder, path):
        if folder in path:
            raise ValueError("a cycle: " + " -> ".join([*path, folder]))
        if folder not in reached:
            below = [visit(other, [*path, folder]) for other in arrows[folder]]
            reached[folder] = {folder}.union(*below)
        return reached[folder]

    for folder in arrows:
        visit(folder, [])
    return reached


def folder_of(file):
    """The folder of a file, relative to ROOT. Public headers belong to their layer."""
    return str(pathlib.PurePosixPath(file).parent).split("/include")[0]


def layer_of(folder, layers):
    return next((layer for layer in layers if folder == layer or folder.startswith(layer + "/")), None)


def wrong_arrows(read_by, reached, composition, layers):
    """read_by: SOURCE: the files that compiling it read. Yields a line for each wrong arrow but those of two layers."""
    for source, files in sorted(read_by.items()):
        allowed = set(reached.get(folder_of(source), ()))
        if not allowed:
            yield f"{source}: its folder is not in the table"
        for folder in composition.get(source, ()):
            allowed |= reached[folder]
        own = layer_of(folder_of(source), layers)
        for file in sorted(files):
            other = layer_of(folder_of(file), layers)
            if (not own or not other or own == other) and folder_of(file) not in allowed:
                yield f"{source} reads {file}: {folder_of(source)} must not include {folder_of(file)}"


def read_by_sources(build):
    """From ninja's record: SOURCE: the project's files that were read. A batch of sources read them together."""
    record = subprocess.run(["ninja", "-C", build, "-t", "deps"], check=True, capture_output=True, text=True).stdout
    known = {}

    def relative(name):
        if name not in known:
            path = (pathlib.Path(build) / name).resolve()
            known[name] = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else None
        return known[name]

    read_by = collections.defaultdict(set)
    for block in record.split("\n\n"):
        head, *lines = block.splitlines() or [""]
        if "STALE" in head:
            continue
        files = {file for line in lines if (file := relative(line.strip()))}
        files = {file for file in files if file.split("/")[0] in PARTS}
        for source in files:
            if source.endswith(".cpp"):
                read_by[source] |= files
    return read_by


def project_sources():
    return {str(path.relative_to(ROOT)) for part in PARTS for path in (ROOT / part).rglob("*.cpp")}


def unseen(sources, seen, left_out):
    """Yields a line for each source that was not compiled and may not be left out, and for each idle exception."""
    for source in sorted(sources - seen):
        if not {source, folder_of(source)} & left_out.keys():
            yield f"{source}: it was not compiled"
    for place in sorted(left_out.keys() - sources - set(map(folder_of, sources))):
        yield f"{place}: there is no such source that a build may leave out"


def check(build):
    reached = closure(with_layers(ARROWS, LAYERS))
    read_by = read_by_sources(build)
    complaints = list(wrong_arrows(read_by, reached, COMPOSITION, LAYERS))
    complaints += unseen(project_sources(), set(read_by), LEFT_OUT)
    seen = {folder_of(source) for source in read_by}
    for complaint in complaints:
        print("FAIL:", complaint)
    if not complaints:
        print(f"{len(read_by)} sources in {len(seen)} folders: every arrow is in the table, which has no cycle")
    return 1 if complaints else 0


def self_test():
    reached = closure({"a": [], "b": ["a"], "c": ["b"], "d": []})
    assert reached["c"] == {"a", "b", "c"}
    right = {"b/x.cpp": {"b/x.cpp", "a/include/p/y.h"}, "c/main.cpp": {"c/main.cpp", "d/z.h", "a/y.h"}}
    assert list(wrong_arrows(right, reached, {"c/main.cpp": ["d"]}, [])) == []
    assert list(wrong_arrows({"a/x.cpp": {"b/y.h"}}, reached, {}, [])) == ["a/x.cpp reads b/y.h: a must not include b"]
    assert list(wrong_arrows({"c/x.cpp": {"d/z.h"}}, reached, {"c/main.cpp": ["d"]}, [])) != []
    assert list(wrong_arrows({"e/x.cpp": set()}, reached, {}, [])) == ["e/x.cpp: its folder is not in the table"]
    layered = with_layers({"a/in": ["d"], "b": ["a/in"], "d": []}, ["a", "b"])
    assert layered == {"a": [], "b": ["a/in", "a"], "a/in": ["d"], "d": []}, layered
    reached = closure(layered)
    # The compiler keeps a from seeing b. It does not keep a from a part of its own, nor from what is no layer.
    assert list(wrong_arrows({"a/x.cpp": {"b/y.h"}}, reached, {}, ["a", "b"])) == []
    assert list(wrong_arrows({"a/x.cpp": {"a/in/y.h"}}, reached, {}, ["a", "b"])) != []
    assert list(wrong_arrows({"a/x.cpp": {"d/y.h"}}, reached, {}, ["a", "b"])) != []
    sources = {"a/x.cpp", "b/main.cpp", "c/x.cpp"}
    assert list(unseen(sources, sources, {})) == []
    assert list(unseen(sources, {"a/x.cpp"}, {"b/main.cpp": "", "c": ""})) == []
    assert list(unseen(sources, {"a/x.cpp"}, {"b": ""})) == ["c/x.cpp: it was not compiled"]
    assert list(unseen(sources, sources, {"d": ""})) == ["d: there is no such source that a build may leave out"]
    try:
        closure({"a": ["b"], "b": ["a"]})
    except ValueError as error:
        assert str(error) == "a cycle: a -> b -> a"
    else:
        raise AssertionError("a cycle is not found")
    print("finds arrows upwards, folders that it does not know, cycles, and sources that were not compiled")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(self_test() if sys.argv[1] == "--self-test" else check(sys.argv[1]))
