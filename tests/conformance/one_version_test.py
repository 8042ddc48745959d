#!/usr/bin/env python3
"""The version of the programs is named once, in CMakeLists.txt, and all else that says it says the same.

usage: one_version_test.py BUILD_DIR

Looked at: what cites, the npm package, the change log; in the build, the program, its manual pages and the package for
CMake; and the metadata of wheel and sdist. python/pip_test compares these with the module's, and ./dev package looks at
what it makes. Exit status: 0; 1 where one is another.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "src/python/build_backend"))
import flowcert_build  # noqa: E402


def first(pattern, text):
    found = re.search(pattern, text, re.MULTILINE)
    return found and found[1]


def read(path):
    return path.read_text(encoding="utf-8")


def versions(build):
    """WHO: what it says."""
    program = build / "flowcert"
    said = {
        "CMakeCache.txt": first(r"^CMAKE_PROJECT_VERSION:\w+=(.*)$", read(build / "CMakeCache.txt")),
        "CITATION.cff": first(r"^version: (.*)$", read(ROOT / "CITATION.cff")),
        "package.json": json.loads(read(ROOT / "src/web/package/package.json"))["version"],
        "spec/CHANGELOG.md": first(r"^## Programs (\d+\.\d+\.\d+)", read(ROOT / "spec/CHANGELOG.md")),
        "flowcert --version": first(r"^flowcert (\S+) \(", subprocess.run([program, "--version"], check=True, text=True,
                                                                        stdout=subprocess.PIPE).stdout),
        "flowcertConfigVersion.cmake": first(r'^set\(PACKAGE_VERSION "(.*)"\)',
                                             read(build / "src/flowcertConfigVersion.cmake")),
        "METADATA": first(r"^Version: (.*)$", flowcert_build.information()[
            f"{flowcert_build.information_folder()}/METADATA"].decode()),
    }
    for page in [*sorted((build / "share/man/man1").glob("*.1")), build / "oracle/proof/flowcert-proof.1"]:
        said[page.name] = first(r'^\.TH \S+ 1 "" "flowcert (.*?)"', read(page))
    return said


def main():
    build = pathlib.Path(sys.argv[1])
    version = first(r"^project\(flowcert VERSION (\S+)", read(ROOT / "CMakeLists.txt"))
    said = versions(build)
    for who, what in said.items():
        if what != version:
            print(f"FAIL: {who} says version {what}, and CMakeLists.txt {version}")
    print(f"{len(said)} places say version {version}")
    return 0 if version and set(said.values()) == {version} else 1


if __name__ == "__main__":
    sys.exit(main())
