#!/usr/bin/env python3
"""The wheel of the Python package for other machines: what the build has, with the libraries that it is linked with.

usage: wheel.py BUILD_DIR OUT_DIR      (the package is built there, on Debian; binutils, patchelf)
       wheel.py --self-test

Guarantees: libraries that not every system has lie beside the extension, named by a hash of their content, and are
found there alone. The tag is the C library that the newest symbol of all these files asks for, or, where it is newer,
the first one that comes with a libstdc++ that has their symbols. It is never newer than this system's own. Debian's
notices and the bill of materials are in the metadata. The wheel is the same to the byte for the same files. Prints its
name and its size.
"""
import hashlib
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "python" / "build_backend"))
import flowcert_build  # noqa: E402

# What each system has that a wheel for manylinux may ask for.
EVERYWHERE = re.compile(r"ld-linux.*|linux-vdso.*|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)\.so\.\d+")
# {N: M}: systems with the C library 2.M have a libstdc++ with symbols up to GLIBCXX_3.4.N, as auditwheel's policies for
# manylinux_2_M say. Debian 12 has 2.36 and 3.4.30, Debian 13 2.41 and 3.4.33.
GLIBC_OF_GLIBCXX = {19: 17, 22: 24, 24: 27, 28: 31, 29: 34, 30: 35, 33: 39}
LICENCES = "Apache-2.0", "LGPL-3", "MPL-2.0"  # those that the notices refer to, by a path of Debian's


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True).stdout


def least_glibc(symbols, own):
    """M of the C library 2.M that these versions of symbols ask for. The system has 2.OWN, and symbols of a libstdc++
    that no policy knows are said to need it."""
    newest = {name: max((int(number) for number in re.findall(rf"\b{name}_{major}\.(\d+)", symbols)), default=0)
              for name, major in (("GLIBC", "2"), ("GLIBCXX", r"3\.4"))}
    of_cxx = next((glibc for cxx, glibc in GLIBC_OF_GLIBCXX.items() if newest["GLIBCXX"] <= cxx), own)
    if max(newest["GLIBC"], of_cxx) > own:
        raise SystemExit(f"wheel.py: this system has the C library 2.{own}, and {newest} are said to need a newer one")
    return max(newest["GLIBC"], of_cxx)


def needed(file):
    return [name for name in run("patchelf", "--print-needed", file).split() if not EVERYWHERE.fullmatch(name)]


def libraries(extension):
    """NAME: file, of all that it needs and not every system has."""
    found = dict(re.findall(r"(\S+) => (/\S+) \(0x", run("ldd", extension)))
    return {name: pathlib.Path(path) for name, path in sorted(found.items()) if not EVERYWHERE.fullmatch(name)}


def hashed_name(name, content):
    """libgmp.so.10: libgmp-0123abcd.so.10"""
    stem, rest = name.split(".so", 1)
    return f"{stem}-{hashlib.sha256(content).hexdigest()[:8]}.so{rest}"


def gathered(extension, folder):
    """Copies the libraries into the folder of the extension, and makes all of them find each other there."""
    names = {}
    for name, path in libraries(extension).items():
        names[name] = hashed_name(name, path.read_bytes())
        (folder / names[name]).write_bytes(path.read_bytes())
    for file in [extension, *(folder / name for name in names.values())]:
        run("strip", "--strip-unneeded", file)
        # patchelf 0.14 does one kind of thing at a time.
        words = [word for name in needed(file) for word in ("--replace-needed", name, names[name])]
        if words:
            run("patchelf", *words, file)
        if file != extension:
            run("patchelf", "--set-soname", file.name, file)
        run("patchelf", "--set-rpath", "$ORIGIN", file)
    return sorted(names.values())


def check(extension, names):
    """That the files need each other, and otherwise what is everywhere."""
    for file in [extension, *(extension.parent / name for name in names)]:
        missing = set(needed(file)) - set(names)
        if missing or run("patchelf", "--print-rpath", file).strip() != "$ORIGIN":
            raise SystemExit(f"wheel.py: {file.name} needs {missing or 'another path'}")
    outside = [line for line in run("ldd", extension).splitlines() if any(name in line for name in names)
               and f"=> {extension.parent}/" not in line]
    if outside:
        raise SystemExit(f"wheel.py: found elsewhere:{outside}")


def information(build, folder):
    """Files of the metadata: the bill, the notices, and what these refer to."""
    bill, notices = folder / "flowcert.spdx.json", folder / "notices"
    run(HERE / "bill_of_materials.py", build, "-o", bill, "--notices", notices, "--of", "python/flowcert/_core*.so")
    files = {"sboms/flowcert.spdx.json": bill.read_bytes()}
    for path in [*sorted(notices.iterdir()), *(pathlib.Path("/usr/share/common-licenses", name) for name in LICENCES)]:
        files[f"licenses/{path.name}"] = path.read_bytes()
    return {f"{flowcert_build.information_folder()}/{name}": content for name, content in files.items()}


def made(build, out):
    files = flowcert_build.package_files(build / "python")
    (core,) = (name for name in files if name.startswith("flowcert/_core.c"))
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch).resolve() / "flowcert"
        folder.mkdir()
        extension = folder / pathlib.Path(core).name
        extension.write_bytes(files[core])
        names = gathered(extension, folder)
        check(extension, names)
        files |= {f"flowcert/{path.name}": path.read_bytes() for path in sorted(folder.iterdir())}
        symbols = "".join(run("objdump", "-T", path) for path in folder.iterdir())
        files |= flowcert_build.information() | information(build, pathlib.Path(scratch))
    least = least_glibc(symbols, int(platform.libc_ver()[1].split(".")[1]))
    return flowcert_build.write_wheel(out, files, f"manylinux_2_{least}_{platform.machine()}")


def self_test():
    assert least_glibc("(GLIBC_2.2.5) (GLIBC_2.36) (GLIBC_2.4) (GLIBCXX_3.4.29) (GLIBCXX_3.4)", 41) == 36
    assert least_glibc("(GLIBC_2.34) (GLIBCXX_3.4.30) (GLIBCXX_3.4.9)", 36) == 35
    assert least_glibc("(GLIBC_2.34) (GLIBCXX_3.4.31)", 41) == 39
    assert least_glibc("(GLIBC_2.2.5) (GLIBCXX_3.4)", 41) == 17
    assert least_glibc("(GLIBC_2.17) (GLIBCXX_3.4.99)", 43) == 43, "a libstdc++ that no policy knows"
    try:
        least_glibc("(GLIBC_2.34) (GLIBCXX_3.4.33)", 36)
        raise AssertionError("a wheel may ask for a newer C library than the system has that made it")
    except SystemExit:
        pass
    assert hashed_name("libgmp.so.10", b"") == "libgmp-e3b0c442.so.10"
    assert EVERYWHERE.fullmatch("libstdc++.so.6") and not EVERYWHERE.fullmatch("libmpfr.so.6")
    print("finds the newest symbol, and knows what is everywhere")


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) != 2:
        sys.exit(__doc__)
    build, out = (pathlib.Path(name).resolve() for name in arguments)
    name = made(build, out)
    print(f"{name}: {(out / name).stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main(sys.argv[1:])
