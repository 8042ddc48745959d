#!/usr/bin/env python3
"""fuzz/oss-fuzz/ serves every fuzz target, and each with what belongs to it.

usage: oss_fuzz_test.py BUILD_DIR CMAKE
       oss_fuzz_test.py --self-test CMAKE

build.sh runs here with a compiler and a cmake that only pretend, and make a file for each target that BUILD_DIR has.
Guarantees: then $OUT has each target, all of its seeds, its words if there are any, and its options, and nothing else.
The compiler is the environment's, and so are the flags of linker and engine. Seeds and words are those of a target.
Dockerfile has the packages that ./dev build installs; the image and the sanitizers are those that project.yaml names.
Exit status: 0; 1 where one of these is not so.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = ROOT / "fuzz/corpus"
IN_IMAGE = {"cmake", "g++"}
CMAKE = """#!/bin/sh
case "$1" in
  -E) exec "$REAL_CMAKE" "$@" ;;
  --build)
    echo "$*" >>"$WORK/asked"
    mkdir -p "$2/fuzz"
    for name in $NAMES; do echo "$name" >"$2/fuzz/fuzz_$name"; done ;;
  *) for word in "$@"; do echo "$word" >>"$WORK/asked"; done ;;
esac
"""
COMPILER = """#!/bin/sh
echo archive >"$WORK/${1#-print-file-name=}"
echo "$WORK/${1#-print-file-name=}"
"""


def read(path):
    return path.read_text(encoding="utf-8")


def first(pattern, text):
    return re.search(pattern, text, re.MULTILINE)[1]


def targets(build):
    """The names of the fuzz targets that CMake knows."""
    commands = (entry["command"] for entry in json.loads(read(build / "compile_commands.json")))
    return sorted({found[1] for found in map(re.compile(r"fuzz/targets/CMakeFiles/fuzz_(\w+)\.dir/").search, commands)
                   if found})


def pretended_build(names, cmake, scratch):
    """What build.sh leaves in $OUT, what it asked of cmake, and what it says where it fails."""
    for folder in ("bin", "out", "src", "space"):
        (scratch / folder).mkdir()
    (scratch / "src/flowcert").symlink_to(ROOT)
    for name, text in (("cmake", CMAKE), ("compiler", COMPILER)):
        program = scratch / "bin" / name
        program.write_text(text, encoding="utf-8")
        program.chmod(0o755)
    environment = {"PATH": f"{scratch}/bin:{os.environ['PATH']}", "REAL_CMAKE": cmake, "NAMES": " ".join(names),
                   "CC": "compiler", "CXX": "compiler++", "LIB_FUZZING_ENGINE": "the-engine", "LDFLAGS": "a-flag",
                   "SRC": f"{scratch}/src", "OUT": f"{scratch}/out", "WORK": f"{scratch}/space"}  # fmt: skip
    run = subprocess.run(["bash", "-eu", ROOT / "fuzz/oss-fuzz/build.sh"], env=environment, capture_output=True, text=True,
                         check=False)  # fmt: skip
    asked = scratch / "space/asked"
    return scratch / "out", read(asked) if asked.exists() else "", run.stderr if run.returncode else ""


def complaints_about_build(names, cmake):
    with tempfile.TemporaryDirectory() as scratch:
        out, asked, failure = pretended_build(names, cmake, pathlib.Path(scratch))
        if failure:
            yield f"build.sh fails: {failure.strip().splitlines()[-1]}"
            return
        expected = set()
        for name in names:
            files = [f"fuzz_{name}", f"fuzz_{name}.options", f"fuzz_{name}_seed_corpus.zip"]
            files += [f"fuzz_{name}.dict"] if (ROOT / f"fuzz/targets/{name}.dict").exists() else []
            expected.update(files)
            seeds = out / files[2]
            if seeds.exists() and set(zipfile.ZipFile(seeds).namelist()) != set(os.listdir(CORPUS / name)):
                yield f"{files[2]} has other files than fuzz/corpus/{name}"
        for file in sorted(expected ^ set(os.listdir(out))):
            yield f"build.sh leaves {'no ' if file in expected else ''}{file}"
        for words in ("-DFLOWCERT_FUZZING_ENGINE=the-engine", "--target fuzz_targets", " a-flag"):
            if words not in asked:
                yield f"build.sh does not say {words.strip()}"


def complaints(names, cmake):
    if not names:
        yield "CMake knows no fuzz target"
        return
    yield from complaints_about_build(names, cmake)
    owners = {path.name: f"fuzz/corpus/{path.name}" for path in CORPUS.iterdir()}
    owners |= {path.stem: f"fuzz/targets/{path.name}" for path in (ROOT / "fuzz/targets").glob("*.dict")}
    yield from (f"{owners[name]} belongs to no target" for name in sorted(owners.keys() - set(names)))


def package_complaints(project, docker, builder, dev):
    words = first(r"apt-get install((?:.*\\\n)+.*)", docker).replace("\\", "").split()
    installed = {word for word in words if not word.startswith("-")}
    listed = " ".join(first(rf"^{name}=\(([^)]*)\)", dev) for name in ("first_packages", "build_packages"))
    needed = set(listed.split()) - IN_IMAGE - {'"${first_packages[@]}"'}
    yield from (f"Dockerfile installs {name}, and ./dev build does not" for name in sorted(installed - needed))
    yield from (f"Dockerfile does not install {name}" for name in sorted(needed - installed))
    if first(r"^FROM \S+:(\S+)$", docker) != first(r"^base_os_version: (\S+)$", project):
        yield "Dockerfile and project.yaml name other systems"
    sanitizers = re.findall(r"^  - (\w+)$", first(r"^sanitizers:\n((?:  - .*\n)+)", project), re.MULTILINE)
    if sanitizers != re.findall(r"^  \[(\w+)\]=", builder, re.MULTILINE):
        yield "builder.sh and project.yaml name other sanitizers"


def own_texts():
    names = "fuzz/oss-fuzz/project.yaml", "fuzz/oss-fuzz/Dockerfile", "fuzz/oss-fuzz/builder.sh", "dev"
    return [read(ROOT / name) for name in names]


def self_test(cmake):
    names = sorted(os.listdir(CORPUS))
    assert list(complaints(names, cmake)) == []
    assert list(complaints([], cmake)) == ["CMake knows no fuzz target"]
    assert any("fails" in text for text in complaints([*names, "read_nothing"], cmake))
    assert list(complaints(names[1:], cmake))[-1].endswith("belongs to no target")
    project, docker, builder, dev = own_texts()
    assert list(package_complaints(project, docker, builder, dev)) == []
    for changed in ((project.replace("24-04", "20-04"), docker, builder, dev),
                    (project.replace("  - undefined\n", ""), docker, builder, dev),
                    (project, docker.replace("libgmp-dev ", ""), builder, dev),
                    (project, docker, builder, dev.replace("libexpat1-dev", ""))):  # fmt: skip
        assert len(list(package_complaints(*changed))) == 1
    print("ok")
    return 0


def main():
    if sys.argv[1] == "--self-test":
        return self_test(sys.argv[2])
    found = [*complaints(targets(pathlib.Path(sys.argv[1])), sys.argv[2]), *package_complaints(*own_texts())]
    print("\n".join(found) or "ok")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
