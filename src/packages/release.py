#!/usr/bin/env python3
"""The files of a release: whether each is of this version and commit, their checksums, and how two makings differ.

usage: release.py FOLDER VERSION COMMIT        (writes FOLDER/SHA256SUMS; ./dev release calls it; dpkg-deb)
       release.py --compare FOLDER OTHER
       release.py --self-test

Guarantees: no checksums are written where a file's name, metadata or sources are of another version, where sources or
the modules for JavaScript are of another commit, or where one of the kinds is missing that every release has. Two
makings are compared to the byte, and what differs in a file is named, with its times and modes. Exit status: 0; 1 for
complaints, and where a file differs that MAY_DIFFER does not explain; 2 for what cannot be read.
"""
import hashlib
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

# {a pattern of names: why such files may differ}. All can be made to the byte so far.
MAY_DIFFER = {}
CHECKSUMS = "SHA256SUMS"


def tar_members(content):
    """NAME: ((mode, time, link), content)."""
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        return {one.name.removeprefix("./"): ((one.mode, one.mtime, one.linkname),
                                              archive.extractfile(one).read() if one.isfile() else b"")
                for one in archive}


def members(path):
    """Those of any file of a release; of a package of Debian, control/NAME are its control files."""
    if path.suffix == ".whl":
        with zipfile.ZipFile(path) as archive:
            return {one.filename: ((one.external_attr, one.date_time), archive.read(one)) for one in archive.infolist()}
    if path.suffix != ".deb":
        return tar_members(path.read_bytes())
    part = lambda option: tar_members(subprocess.run(["dpkg-deb", option, path], check=True,
                                                     stdout=subprocess.PIPE).stdout)
    return part("--fsys-tarfile") | {f"control/{name}": one for name, one in part("--ctrl-tarfile").items()}


# For each: its name; [(what says a version, its pattern there)]; what has the commit, by a pattern of names. Wheels
# have none. In a package of Debian the program has it in pieces; ./dev package has asked `flowcert --version` there.
PROJECT = ("CMakeLists.txt", r"^project\(flowcert VERSION (\S+)")
KINDS = {
    "source archive": (r"flowcert-{}-source\.tar\.gz", [PROJECT], r"src/io/commit\.txt"),
    "sdist": (r"flowcert-{}\.tar\.gz", [PROJECT, ("PKG-INFO", r"^Version: (.*)")], r"src/io/commit\.txt"),
    "package of Debian": (r"flowcert_{}-1~deb\d+_\w+\.deb",
                          [("control/control", r"^Version: ([^-\n]*)"),
                           ("usr/share/doc/flowcert/flowcert.spdx.json", r'^  "name": "flowcert-(.*)"')],
                          None),
    "wheel": (r"flowcert-{}-cp\d+-cp\d+-manylinux_\d+_\d+_\w+\.whl",
              [("flowcert-{}.dist-info/METADATA", r"^Version: (.*)"),
               ("flowcert-{}.dist-info/sboms/flowcert.spdx.json", r'^  "name": "flowcert-(.*)"')],
              None),
    "npm package": (r"flowcert-{}\.tgz", [("package.json", r'"version": "(.*)"')], r"flowcert_module\.wasm"),
}
OPTIONAL = {"npm package"}


def kind_of(name, version):
    return next((kind for kind, (shape, *_) in KINDS.items() if re.fullmatch(shape.format(re.escape(version)), name)),
                None)


def complaints_of(path, version, commit):
    kind = kind_of(path.name, version)
    if kind is None:
        return [f"{path.name} is no name of a file of version {version}"]
    _, sayings, programs = KINDS[kind]
    content = {name: text for name, (_, text) in members(path).items()}
    if kind in ("source archive", "sdist", "npm package"):  # they have one folder
        content = {name.partition("/")[2]: text for name, text in content.items()}
    found = []
    for name, pattern in ((name.format(version), pattern) for name, pattern in sayings):
        said = re.search(pattern, content.get(name, b"").decode(errors="replace"), re.MULTILINE)
        if not said or said[1] != version:
            found.append(f"{path.name}: {name} says version {said and said[1]}, and not {version}")
    with_commit = [text for name, text in content.items() if programs and re.fullmatch(programs, name)]
    # Programs have twelve digits of it.
    if programs and (len(with_commit) != 1 or commit[:12].encode() not in with_commit[0]):
        found.append(f"{path.name} is not of commit {commit[:12]}")
    return found


def complaints_of_all(folder, version, commit):
    paths = [path for path in sorted(folder.iterdir()) if path.name != CHECKSUMS]
    there = {kind_of(path.name, version) for path in paths}
    return [complaint for path in paths for complaint in complaints_of(path, version, commit)] + [
        f"there is no {kind}" for kind in KINDS if kind not in there | OPTIONAL]


def write_checksums(folder):
    """As `sha256sum --check` reads them."""
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in sorted(folder.iterdir())
             if path.name != CHECKSUMS]
    (folder / CHECKSUMS).write_text("".join(lines))
    return lines


def differences(one, other):
    """[(NAME, what differs)] of files that are not the same in both folders."""
    found = []
    names = {path.name for folder in (one, other) for path in folder.iterdir()} - {CHECKSUMS}
    for name in sorted(names):
        paths = one / name, other / name
        if not all(path.exists() for path in paths):
            found.append((name, "only one making has it"))
        elif paths[0].read_bytes() != paths[1].read_bytes():
            first, second = map(members, paths)
            inside = [part for part in sorted(first.keys() | second.keys()) if first.get(part) != second.get(part)]
            more = f" and {len(inside) - 8} more" if len(inside) > 8 else ""
            found.append((name, (", ".join(inside[:8]) or "nothing that it has, but how that is packed") + more))
    return found


def compare(one, other):
    status = 0
    found = differences(one, other)
    for name, inside in found:
        reason = next((why for pattern, why in MAY_DIFFER.items() if re.fullmatch(pattern, name)), None)
        print(f"{'differs' if reason else 'FAIL'}: {name}: {inside}{f' ({reason})' if reason else ''}")
        status = status if reason else 1
    if not found:
        print(f"two makings are the same to the byte: {len(list(one.iterdir())) - 1} files")
    return status


# ---- The self-test ----

def write_tar(path, files, mtime=0):
    with tarfile.open(path, "w:gz") as archive:
        for name, text in files.items():
            entry = tarfile.TarInfo(name)
            entry.size, entry.mtime = len(text), mtime
            archive.addfile(entry, io.BytesIO(text.encode()))


def write_release(folder, version, commit):
    """A small one of that name, version and commit."""
    folder.mkdir()
    top, bill = "flowcert-1.2.3", f'{{\n  "name": "flowcert-{version}"\n}}'
    sources = {f"{top}/CMakeLists.txt": f"project(flowcert VERSION {version} X)\n", f"{top}/src/io/commit.txt": commit}
    write_tar(folder / f"{top}-source.tar.gz", sources)
    write_tar(folder / f"{top}.tar.gz", sources | {f"{top}/PKG-INFO": f"Name: x\nVersion: {version}\n"})
    write_tar(folder / f"{top}.tgz", {"package/package.json": json.dumps({"version": version}),
                                      "package/flowcert_module.wasm": f"x{commit[:12]}y"})
    with zipfile.ZipFile(folder / f"{top}-cp39-cp39-manylinux_2_34_x86_64.whl", "w") as archive:
        archive.writestr(f"{top}.dist-info/METADATA", f"Version: {version}\n")
        archive.writestr(f"{top}.dist-info/sboms/flowcert.spdx.json", bill)
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch, "root")
        for name, text in {"DEBIAN/control": f"Package: flowcert\nVersion: {version}-1~deb12\nArchitecture: amd64\n"
                                             "Maintainer: x <>\nDescription: x\n",
                           "usr/share/doc/flowcert/flowcert.spdx.json": bill}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        root.chmod(0o755)
        subprocess.run(["dpkg-deb", "--root-owner-group", "--build", root, folder / "flowcert_1.2.3-1~deb12_amd64.deb"],
                       check=True, stdout=subprocess.DEVNULL)


def self_test():
    if not shutil.which("dpkg-deb"):
        print("skipped: packages of Debian need dpkg-deb")
        return 77
    with tempfile.TemporaryDirectory() as scratch:
        folder = lambda name: pathlib.Path(scratch, name)
        commit = "0123456789abcdef0123"
        write_release(folder("right"), "1.2.3", commit)
        assert complaints_of_all(folder("right"), "1.2.3", commit) == []
        assert len(complaints_of_all(folder("right"), "1.2.4", commit)) == 5 + 4, "names, and kinds that are missing"
        assert len(complaints_of_all(folder("right"), "1.2.3", "f" * 20)) == 3
        write_release(folder("wrong"), "1.2.2", commit)
        wrong = complaints_of_all(folder("wrong"), "1.2.3", commit)
        assert len(wrong) == 8 and all("says version 1.2.2, and not 1.2.3" in one for one in wrong), wrong
        lines = write_checksums(folder("right"))
        assert len(lines) == 5
        subprocess.run(["sha256sum", "--check", "--quiet", CHECKSUMS], cwd=folder("right"), check=True)
        assert complaints_of_all(folder("right"), "1.2.3", commit) == []
        (folder("right") / "flowcert-1.2.3.tgz").unlink()
        assert complaints_of_all(folder("right"), "1.2.3", commit) == []
        (folder("right") / "flowcert-1.2.3.tar.gz").unlink()
        assert complaints_of_all(folder("right"), "1.2.3", commit) == ["there is no sdist"]
        self_test_of_differences(folder)
    print("finds wrong versions, commits and kinds, and what differs")
    return 0


def self_test_of_differences(folder):
    for name, text, mtime in (("a", "x", 0), ("b", "y", 0), ("c", "x", 1)):
        folder(name).mkdir()
        write_tar(folder(name) / "one.tar.gz", {"file": text, "other": ""}, mtime)
    (folder("b") / "two").write_bytes(b"")
    assert differences(folder("a"), folder("a")) == []
    assert differences(folder("a"), folder("b")) == [("one.tar.gz", "file"), ("two", "only one making has it")]
    assert differences(folder("a"), folder("c")) == [("one.tar.gz", "file, other")]


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if arguments[:1] == ["--compare"] and len(arguments) == 3:
        return compare(*map(pathlib.Path, arguments[1:]))
    if len(arguments) != 3:
        sys.stderr.write(__doc__)
        return 2
    folder = pathlib.Path(arguments[0])
    complaints = complaints_of_all(folder, *arguments[1:])
    for complaint in complaints:
        print("FAIL:", complaint)
    if complaints:
        return 1
    print("".join(write_checksums(folder)), end="")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (OSError, subprocess.CalledProcessError, tarfile.TarError, zipfile.BadZipFile) as error:
        sys.stderr.write(f"release.py: {error}\n")
        sys.exit(2)
