"""Builds a wheel of flowcert with CMake, as PEP 517 says. pip calls this; it needs no package of PyPI.

What is built where: with FLOWCERT_BUILD, the package is built in that folder, which may be one that is there already,
as build/ after ./dev build; then nothing is compiled twice. A relative name is below the repository. Without it, the
folder is build-pip/, which stays, so that the next time is quick. `--config-settings build=FOLDER` is the same.

Guarantees: the wheel has what CMake leaves in FOLDER/python/flowcert/, and is the same to the byte for the same files.
The metadata say what pyproject.toml says.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).resolve().parent.parent
ROOT = HERE.parent.parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder = ROOT / ((config_settings or {}).get("build") or os.environ.get("FLOWCERT_BUILD") or "build-pip")
    _build(folder)
    files = _package_files(folder / "python") | _information()
    name = f"flowcert-{_version()}-{_tag()}.whl"
    _write(pathlib.Path(wheel_directory) / name, files)
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    for name, content in _information().items():
        path = pathlib.Path(metadata_directory) / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
    return f"flowcert-{_version()}.dist-info"


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("there is no sdist of flowcert: it is built from its repository, by pip install ./src/python")


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


def _version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(flowcert VERSION ([0-9.]+)", text)[1]


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _package_files(folder):
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    paths = [path for path in sorted((folder / "flowcert").iterdir()) if path.is_file()]
    paths = [path for path in paths if not path.name.startswith("_core.c") or path.name == f"_core{suffix}"]
    return {f"flowcert/{path.name}": path.read_bytes() for path in paths}


def _information():
    """The files of flowcert-VERSION.dist-info but RECORD."""
    # Python reads TOML from 3.11 on only, and few lines are asked.
    settings = (HERE / "pyproject.toml").read_text(encoding="utf-8")
    setting = lambda name: re.search(rf'^{name} = "(.*)"$', settings, re.MULTILINE)[1]
    metadata = [
        "Metadata-Version: 2.1",
        f"Name: {setting('name')}",
        f"Version: {_version()}",
        f"Summary: {setting('description')}",
        "License: GPL-3.0-or-later",
        f"Requires-Python: {setting('requires-python')}",
        "Requires-Dist: numpy",
    ]
    wheel = ["Wheel-Version: 1.0", "Generator: flowcert", "Root-Is-Purelib: false", f"Tag: {_tag()}"]
    folder = f"flowcert-{_version()}.dist-info"
    return {
        f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes(),
        f"{folder}/METADATA": ("\n".join(metadata) + "\n").encode(),
        f"{folder}/WHEEL": ("\n".join(wheel) + "\n").encode(),
    }


def _write(path, files):
    record = f"flowcert-{_version()}.dist-info/RECORD"
    lines = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
            lines.append(f"{name},sha256={digest},{len(content)}\n")
            archive.writestr(_entry(name), content)
        archive.writestr(_entry(record), "".join([*lines, f"{record},,\n"]))


def _entry(name):
    """With a date that is always the same."""
    entry = zipfile.ZipInfo(name)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = 0o644 << 16
    return entry
