#!/usr/bin/env python3
"""The bill of materials: the software of others in the programs and the Python package, with versions and licences.

usage: bill_of_materials.py BUILD_DIR -o FILE [--notices FOLDER] [--of PROGRAM]      (a Ninja build, on Debian)
       bill_of_materials.py BUILD_DIR --check
       bill_of_materials.py --self-test

Guarantees: SPDX 2.3 as JSON, the same to the byte for the same build. Its time is SOURCE_DATE_EPOCH, or that of the
commit. Nothing is written where the check complains. It complains of each library that ldd names, and of each archive
and header that Ninja recorded, which belongs to nothing in PARTS; of what is in PARTS and not in the build; where
Debian's copyright file has no such licence; and where the viewer's page has another module than three.js.
--of: the bill of this program alone. FOLDER gets Debian's copyright files of what is compiled in and linked, PART.txt.
Exit status: 0; 1 where the check complains; 2 for what cannot be read; 77 where dpkg or Ninja's record is missing.
"""
import argparse
import collections
import json
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import time
import urllib.parse
import uuid

PROGRAMS = "flowcert", "flowcert-oracle", "flowcert-proof", "python/flowcert/_core*.so"  # those that are built
DEVELOPERS = "Organization: The Flowcert developers"

# source: a pattern of Debian's source packages. licence: what the parts that we use are under. says: what Debian's
# copyright file has of it, but for blanks. optional: not in every build, as what judges is not.
Part = collections.namedtuple("Part", "name source licence says optional", defaults=(False,))
PARTS = [
    Part("Boost", r"boost[\d.]+", "BSL-1.0", "License: BSL-1.0"),
    Part("CGAL", r"cgal", "GPL-3.0-or-later AND LGPL-3.0-or-later AND BSL-1.0",
         "GNU General Public License or the GNU Lesser General Public License (as published by the Free Software "
         "Foundation; either version 3"),
    Part("CLI11", r"cli11", "BSD-3-Clause", "License: BSD-3-clause"),
    Part("Eigen", r"eigen3", "MPL-2.0 AND Apache-2.0 AND BSD-3-Clause", "License: MPL-2"),
    Part("Expat", r"expat", "MIT", "License: MIT", optional=True),
    Part("GCC-runtime", r"gcc-\d+", "GPL-3.0-or-later WITH GCC-exception-3.1", "GCC Runtime Library Exception"),
    Part("GMP", r"gmp", "LGPL-3.0-or-later OR GPL-2.0-or-later", "License: GPL-2+ or LGPL-3+"),
    Part("Linux-headers", r"linux", "GPL-2.0-only WITH Linux-syscall-note", "License: GPL-2"),
    Part("MPFR", r"mpfr4", "LGPL-3.0-or-later", "GNU Lesser General Public License (either version 3"),
    Part("RapidCheck", r"rapidcheck", "BSD-2-Clause", "License: BSD-2", optional=True),
    Part("fmt", r"fmtlib", "MIT", "License: Expat with embedded exception"),
    Part("glibc", r"glibc", "LGPL-2.1-or-later", "GNU Lesser General Public License"),
    Part("nlohmann-json", r"nlohmann-json3", "MIT", "License: Expat"),
    Part("zlib", r"zlib", "Zlib", "License: Zlib"),
    Part("Python", r"python3\.\d+", "PSF-2.0", "PYTHON SOFTWARE FOUNDATION LICENSE VERSION 2", optional=True),
    Part("pybind11", r"pybind11", "BSD-3-Clause", "License: BSD-3-Clause", optional=True),
    # Where clang compiles, and where its libc++ reads no doubles.
    Part("LLVM-runtime", r"llvm-toolchain-\d+", "Apache-2.0 WITH LLVM-exception",
         "License: APACHE-2-LLVM-EXCEPTIONS", optional=True),
    Part("fast_float", r"fast-float", "MIT", "License: Expat", optional=True),
]


def output_of(*command, check=True):
    environment = {**os.environ, "LC_ALL": "C"}
    return subprocess.run(command, check=check, stdout=subprocess.PIPE, env=environment, text=True,
                          stderr=None if check else subprocess.DEVNULL).stdout


def cached(build, name):
    return re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)[1]


def used_files(build, patterns):
    """RELATIONSHIP: the files of others that the programs have it to."""
    programs = [str(path.relative_to(build)) for pattern in patterns for path in build.glob(pattern)]
    inputs = set(output_of("ninja", "-C", str(build), "-t", "inputs", *programs).splitlines())
    found = {"STATIC_LINK": {file for file in inputs if file.startswith("/") and file.endswith(".a")},
             "DYNAMIC_LINK": set(re.findall(r"(/\S+) \(0x", output_of("ldd", *(str(build / one) for one in programs)))),
             "CONTAINS": set()}
    for block in output_of("ninja", "-C", str(build), "-t", "deps").split("\n\n"):
        head, *lines = block.splitlines() or [""]
        if head.split(":")[0] in inputs and "STALE" not in head:
            found["CONTAINS"] |= {os.path.normpath(build / line.strip()) for line in lines}
    own = tuple(f"{folder}/" for folder in (build, cached(build, "CMAKE_HOME_DIRECTORY")))
    return {kind: {file for file in files if not file.startswith(own)} for kind, files in found.items()}


def owners(files):
    """FILE: Debian's package. /lib may stand for /usr/lib; which of them a package has depends on its age."""
    other = {file: file.removeprefix("/usr") if file.startswith("/usr/lib") else "/usr" + file for file in files}
    answers = output_of("dpkg-query", "-S", *sorted({*other, *other.values()}), check=False).splitlines()
    known = {path: names.split(", ")[0] for names, path in (line.split(": ", 1) for line in answers if ": " in line)
             if not names.startswith("diversion ")}
    return {file: known.get(file) or known.get(other[file]) for file in files}


def packages_of_debian(names):
    """NAME: its source, the version of that, its own version, architecture and copyright file."""
    shape = "${source:Package} ${source:Version} ${Version} ${Architecture} ${Package}\n"
    lines = output_of("dpkg-query", "-W", "-f", "${binary:Package} " + shape, *sorted(names)).splitlines()
    found = {}
    for name, *fields, plain in map(str.split, lines):
        copyright_file = pathlib.Path("/usr/share/doc", plain, "copyright")
        found[name] = found[name.split(":")[0]] = (*fields, copyright_file)
    return found


def sorted_out(used, owner, packages, text_of, parts, whole=True):
    """({PART: [(its packages, its relationships)]}, complaints). `whole` where all of the parts have to be there."""
    found, complaints = {part: (set(), set()) for part in parts}, []
    for kind, files in used.items():
        for file in sorted(files):
            package = owner[file]
            part = next((one for one in parts if package and re.fullmatch(one.source, packages[package][0])), None)
            if part:
                found[part][0].add(package)
                found[part][1].add(kind)
            else:
                complaints.append(f"{file} ({package or 'of no package'}) is in the programs and not in the bill")
    for part, (names, _) in found.items():
        if whole and not names and not part.optional:
            complaints.append(f"{part.name} is in the bill, and the programs have nothing of it")
        for name in sorted(names):
            if part.says not in " ".join(text_of(packages[name][4]).split()):
                complaints.append(f"{packages[name][4]} does not say {part.says!r}, so {part.licence} may be wrong")
    return {part: uses for part, uses in found.items() if uses[0]}, complaints


def three_js(page, lock):
    """(the versions of the page and of three.js, the licence of that, complaints)."""
    modules = json.loads(lock)["packages"]
    three = modules.get("node_modules/three", {})
    made_with = re.search(r"with three\.js ([\d.]+)\. ", page)
    complaints = [f"{name} is in the viewer's page and not in the bill" for name in modules
                  if name not in ("", "node_modules/three")]
    if not made_with or made_with[1] != three.get("version"):
        complaints.append("page.html does not say the version of three.js that package-lock.json has")
    return (modules[""].get("version"), three.get("version"), three.get("license")), complaints


def notice(copyright_file):
    text = copyright_file.read_text(errors="replace")
    # The two megabytes of Boost's are mostly of parts that are not used.
    boost = re.search(r"^ Boost Software License - .*?\n\n", text, re.MULTILINE | re.DOTALL)
    return boost[0] if len(text) > 1e6 and boost else text


def quote(text):
    return urllib.parse.quote(text, safe=":~")


def document(version, created, found, packages, three, distribution):
    def package(name, version, licence, supplier, purls=(), comment=""):
        return {"SPDXID": f"SPDXRef-{name.replace('_', '-')}", "name": name, "versionInfo": version,
                "supplier": supplier, "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
                "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION",
                **({"licenseComments": comment} if comment else {}),
                **({"externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                      "referenceLocator": purl} for purl in purls]} if purls else {})}

    def relationship(one, kind, other):
        return {"spdxElementId": f"SPDXRef-{one}", "relationshipType": kind,
                "relatedSpdxElement": f"SPDXRef-{other.replace('_', '-')}"}

    made = [package("flowcert", version, "GPL-3.0-or-later", DEVELOPERS),
            package("flowcert-viewer", three[0], "MIT", DEVELOPERS, comment="The page that is in the programs."),
            package("three.js", three[1], three[2], "Organization: three.js authors", [f"pkg:npm/three@{three[1]}"])]
    relations = [relationship("DOCUMENT", "DESCRIBES", "flowcert"),
                 relationship("flowcert", "CONTAINS", "flowcert-viewer"),
                 relationship("flowcert-viewer", "CONTAINS", "three.js")]
    for part, (names, kinds) in found.items():
        of = [packages[name] for name in sorted(names)]
        purls = [f"pkg:deb/{distribution[0]}/{quote(name.split(':')[0])}@{quote(one[2])}?arch={one[3]}"
                 for name, one in zip(sorted(names), of)]
        made.append(package(part.name, of[0][1], part.licence, f"Organization: {distribution[1]}", purls,
                            f"{of[0][4]} has the holders and the whole text."))
        relations += [relationship("flowcert", kind, part.name) for kind in sorted(kinds)]
    body = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
            "name": f"flowcert-{version}",
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(created)),
                             "creators": [DEVELOPERS, "Tool: bill_of_materials.py"]},
            "packages": made, "relationships": relations}
    # A name that is no address, and another one for each content.
    namespace = uuid.uuid5(uuid.NAMESPACE_OID, json.dumps(body)).urn
    return json.dumps({**body, "documentNamespace": namespace}, indent=2) + "\n"


def self_test():
    parts = [Part("A", r"a\d", "MIT", "License: Expat"), Part("B_c", "b", "Zlib", "License: Zlib", optional=True)]
    packages = {"liba-dev": ("a1", "2:1.0+x-1", "2:1.0+x-1", "amd64", "A"), "libb": ("b", "1", "1", "all", "B"),
                "libc": ("c", "1", "1", "all", "C")}
    owner = {"/a.h": "liba-dev", "/b.so": "libb", "/c.h": "libc", "/d.h": None}

    def judged(used, text="License:  Expat License: Zlib"):
        return sorted_out(used, owner, packages, lambda path: text, parts)

    right = {"CONTAINS": {"/a.h"}, "DYNAMIC_LINK": {"/b.so"}}
    found, complaints = judged(right)
    assert complaints == [] and found[parts[1]] == ({"libb"}, {"DYNAMIC_LINK"}), (found, complaints)
    assert judged({"CONTAINS": {"/a.h"}})[1] == []
    assert judged({"CONTAINS": {"/a.h", "/c.h"}})[1] == ["/c.h (libc) is in the programs and not in the bill"]
    assert judged({"STATIC_LINK": {"/d.h"}, **right})[1] == ["/d.h (of no package) is in the programs and not in the "
                                                             "bill"]
    assert judged({"DYNAMIC_LINK": {"/b.so"}})[1] == ["A is in the bill, and the programs have nothing of it"]
    assert sorted_out({"CONTAINS": {"/c.h"}}, owner, packages, str, [], False)[1] != []
    assert sorted_out({}, owner, packages, str, parts, False) == ({}, [])
    assert judged(right, "License: Zlib")[1] == ["A does not say 'License: Expat', so MIT may be wrong"]
    page = "with three.js 1.2. Made"
    lock = {"": {"version": "3"}, "node_modules/three": {"version": "1.2", "license": "MIT"}}
    assert three_js(page, json.dumps({"packages": lock})) == (("3", "1.2", "MIT"), [])
    assert len(three_js("", json.dumps({"packages": {**lock, "node_modules/x": {}}}))[1]) == 2
    text = document("1.0", 86400, found, packages, ("3", "1.2", "MIT"), ("debian", "Debian"))
    assert text == document("1.0", 86400, found, packages, ("3", "1.2", "MIT"), ("debian", "Debian"))
    spdx = json.loads(text)
    ids = [one["SPDXID"] for one in spdx["packages"]]
    named = {end for one in spdx["relationships"] for end in (one["spdxElementId"], one["relatedSpdxElement"])}
    assert len(ids) == len(set(ids)) and named == {"SPDXRef-DOCUMENT", *ids}, (ids, named)
    assert spdx["creationInfo"]["created"] == "1970-01-02T00:00:00Z"
    assert "pkg:deb/debian/liba-dev@2:1.0%2Bx-1?arch=amd64" in text
    print("finds what is not in the bill, what is there for nothing, and licences that are not said")
    return 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n\n")[0])
    parser.add_argument("build", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("-o", dest="bill", type=pathlib.Path)
    parser.add_argument("--notices", type=pathlib.Path)
    parser.add_argument("--of")
    parser.add_argument("--check", action="store_true")
    given = parser.parse_args(arguments)
    build = given.build
    if given.check == bool(given.bill):
        parser.error("either -o FILE or --check")
    if not shutil.which("dpkg-query") or not (build / ".ninja_deps").exists():
        print("skipped: the bill of materials needs Debian's dpkg and a Ninja build")
        return 77
    source = pathlib.Path(cached(build, "CMAKE_HOME_DIRECTORY"))
    used = used_files(build, [given.of] if given.of else PROGRAMS)
    owner = owners(set().union(*used.values()))
    packages = packages_of_debian({name for name in owner.values() if name})
    found, complaints = sorted_out(used, owner, packages, lambda path: path.read_text(errors="replace"), PARTS,
                                   whole=not given.of)
    viewer = source / "src" / "viewer"
    three, more = three_js((viewer / "page.html").read_text(), (viewer / "package-lock.json").read_text())
    for complaint in complaints + more:
        print("FAIL:", complaint)
    if complaints + more:
        return 1
    print(f"{sum(map(len, used.values()))} files of others are of {len(found) + 1} parts, which the bill has")
    if given.bill:
        created = os.environ.get("SOURCE_DATE_EPOCH") or output_of("git", "-C", str(source), "log", "-1",
                                                                  "--format=%ct", check=False)
        if not created.strip():
            sys.stderr.write("bill_of_materials.py: SOURCE_DATE_EPOCH is not set, and there is no commit\n")
            return 2
        system = platform.freedesktop_os_release()
        given.bill.write_text(document(cached(build, "CMAKE_PROJECT_VERSION"), int(created), found, packages, three,
                                       (system["ID"], system["NAME"])))
    if given.notices:
        given.notices.mkdir(parents=True, exist_ok=True)
        for part, (names, _) in found.items():
            (given.notices / f"{part.name}.txt").write_text(notice(packages[min(names)][4]))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (OSError, subprocess.CalledProcessError) as error:
        sys.stderr.write(f"bill_of_materials.py: {error}\n")
        sys.exit(2)
