"""Builds wheels and the sdist of flowcert with CMake and git, as PEP 517 says. pip calls this; it needs no package of
PyPI. src/packages/wheel.py makes wheels for other machines of it.

What is built where: with FLOWCERT_BUILD, the package is built in that folder, which may be one that is there already,
as build/ after ./dev build; then nothing is compiled twice. A relative name is below the repository. Without it, the
folder is build-pip/, which stays, so that the next time is quick. `--config-settings build=FOLDER` is the same.

Guarantees: the wheel has what CMake leaves in FOLDER/python/flowcert/, and is the same to the byte for the same files.
The metadata say what pyproject.toml says. The sdist is what git archives of HEAD, with two more files at the top, and
is the same to the byte for the same commit and zlib.
"""

import base64
import gzip
import hashlib
import io
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent.parent
ROOT = HERE.parent.parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = ROOT / ((config_settings or {}).get("build") or os.environ.get("FLOWCERT_BUILD") or "build-pip")
    _build(folder)
    return write_wheel(wheel_directory, package_files(folder / "python") | information(), _platform())


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    for name, content in information().items():
        path = pathlib.Path(metadata_directory) / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
    return information_folder()


def build_sdist(sdist_directory, config_settings=None):
    if not (ROOT / ".git").exists():
        raise SystemExit("the sdist of flowcert is made from a clone of its repository")
    git = lambda *words: subprocess.run(["git", "-C", str(ROOT), *words], check=True, stdout=subprocess.PIPE).stdout
    top = f"flowcert-{version()}"
    # The modes of files are git's, whatever this machine's settings are.
    content = io.BytesIO(git("-c", "tar.umask=0002", "archive", f"--prefix={top}/", "HEAD"))
    settings = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    # This file stays where it is, so its place is another one seen from the top.
    settings = settings.replace('["build_backend"]', '["src/python/build_backend"]')
    with tarfile.open(fileobj=content, mode="a", format=tarfile.PAX_FORMAT) as archive:
        for name, text in (("PKG-INFO", _metadata()), ("pyproject.toml", settings.encode())):
            entry = tarfile.TarInfo(f"{top}/{name}")
            entry.size, entry.mtime = len(text), int(git("log", "-1", "--format=%ct"))
            archive.addfile(entry, io.BytesIO(text))
    path = pathlib.Path(sdist_directory) / f"{top}.tar.gz"
    path.write_bytes(gzip.compress(content.getvalue(), 6, mtime=0))
    return path.name


def _build(folder):
    # A folder that is configured for more stays so. NumPy need not be there yet, hence ON, not AUTO. A virtual
    # environment may be gone the next time, but the Python behind it is there.
    options = [f"-DPython_EXECUTABLE={os.path.realpath(sys.executable)}", "-DFLOWCERT_PYTHON=ON", "-DFLOWCERT_JUDGE=ON"]
    if not (folder / "CMakeCache.txt").exists():
        options += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DFLOWCERT_TESTS=OFF"]
    elif _builds_for_this_python(folder):
        options = []
    _run("cmake", "-S", ROOT, "-B", folder, *options)
    _run("cmake", "--build", folder, "--parallel", str(os.cpu_count()), "--target", "flowcert_python")


def _builds_for_this_python(folder):
    """Whether the folder has a package already that this Python can import."""
    return (folder / "python" / "flowcert" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}").exists()


def _run(*command):
    # pip hides the packages of Python from this program. CMake looks for them.
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    try:
        subprocess.run([str(word) for word in command], check=True, env=environment)
    except FileNotFoundError:
        raise SystemExit("flowcert is built with CMake and Ninja: ./dev build installs what is needed") from None


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(flowcert VERSION ([0-9.]+)", text)[1]


def information_folder():
    return f"flowcert-{version()}.dist-info"


def _platform():
    return sysconfig.get_platform().replace("-", "_").replace(".", "_")


def package_files(folder):
    """NAME: content, of the package in the folder, with the extension of this Python."""
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    paths = [path for path in sorted((folder / "flowcert").iterdir()) if path.is_file()]
    paths = [path for path in paths if not path.name.startswith("_core.c") or path.name == f"_core{suffix}"]
    return {f"flowcert/{path.name}": path.read_bytes() for path in paths}


def _metadata():
    # Python reads TOML from 3.11 on only, and few lines are asked.
    settings = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    setting = lambda name: re.search(rf'^{name} = "(.*)"$', settings, re.MULTILINE)[1]
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {setting('name')}",
        f"Version: {version()}",
        f"Summary: {setting('description')}",
        "License: GPL-3.0-or-later",
        f"Requires-Python: {setting('requires-python')}",
        "Requires-Dist: numpy",
    ]
    return ("\n".join(lines) + "\n").encode()


def information():
    """The files of flowcert-VERSION.dist-info that are the same on every machine."""
    folder = information_folder()
    return {f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes(), f"{folder}/METADATA": _metadata()}


def write_wheel(directory, files, platform):
    """Writes the wheel of these files, with WHEEL and RECORD, and returns its name."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag, folder = f"{python}-{python}-{platform}", information_folder()
    wheel = ["Wheel-Version: 1.0", "Generator: flowcert", "Root-Is-Purelib: false", f"Tag: {tag}"]
    files = {**files, f"{folder}/WHEEL": ("\n".join(wheel) + "\n").encode()}
    name = f"flowcert-{version()}-{tag}.whl"
    lines = []
    with zipfile.ZipFile(pathlib.Path(directory) / name, "w", zipfile.ZIP_DEFLATED) as archive:
        for file, content in files.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
            lines.append(f"{file},sha256={digest},{len(content)}\n")
            archive.writestr(_entry(file), content)
        archive.writestr(_entry(f"{folder}/RECORD"), "".join([*lines, f"{folder}/RECORD,,\n"]))
    return name


def _entry(name):
    """With a date that is always the same."""
    entry = zipfile.ZipInfo(name)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = 0o644 << 16
    return entry
