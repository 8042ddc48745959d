"""`pip install ./src/python` in a virtual environment, without a network, from the build folder of the tests.

Environment: FLOWCERT_BUILD is that folder. Nothing is compiled.
"""

import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

import flowcert
import pytest

ROOT = pathlib.Path(__file__).parents[2]
FILES = {path.name for path in pathlib.Path(flowcert.__file__).parent.iterdir() if path.is_file()}


def run(*words, **environment):
    # No package index answers, and nothing of this test's Python is seen.
    settings = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "PYTHONHOME")}
    settings.update(PIP_NO_INDEX="1", PIP_DISABLE_PIP_VERSION_CHECK="1", PIP_CONFIG_FILE=os.devnull, **environment)
    finished = subprocess.run(
        [str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, text=True,
        env=settings, cwd=ROOT,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stdout
    return finished.stdout


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """The Python of an environment that sees Debian's NumPy."""
    folder = tmp_path_factory.mktemp("environment")
    run(sys.executable, "-m", "venv", "--system-site-packages", folder)
    return folder / "bin" / "python"


def test_pip_installs_it_without_a_network(python, tmp_path):
    run(python, "-m", "pip", "install", "./src/python")
    program = "import flowcert; print(flowcert.__file__); print(flowcert.FlowComplex([[0, 0, 0], [2, 0, 0]]).counts)"
    file, counts = run(python, "-c", program).splitlines()
    assert pathlib.Path(file).is_relative_to(python.parents[1]) and counts == "(2, 1, 0, 0)"
    lines = run(python, "-m", "pip", "show", "flowcert").splitlines()
    said = dict(line.split(": ", 1) for line in lines if ": " in line)
    assert said["Version"] == flowcert.__version__ and said["License"] == "GPL-3.0-or-later"
    run(python, "-m", "pip", "uninstall", "--yes", "flowcert")
    assert not pathlib.Path(file).exists()


def test_the_wheel_has_the_package_and_is_always_the_same(python, tmp_path):
    wheels = []
    for name in ("one", "two"):
        run(python, "-m", "pip", "wheel", "--no-deps", "-w", tmp_path / name, "./src/python")
        (wheel,) = (tmp_path / name).iterdir()
        wheels.append(wheel)
    assert wheels[0].read_bytes() == wheels[1].read_bytes()
    with zipfile.ZipFile(wheels[0]) as archive:
        names = archive.namelist()
        assert archive.testzip() is None
    package = {name.split("/")[1] for name in names if name.startswith("flowcert/")}
    assert package == FILES and f"_core{sysconfig.get_config_var('EXT_SUFFIX')}" in package
    folder = f"flowcert-{flowcert.__version__}.dist-info"
    assert {f"{folder}/{name}" for name in ("METADATA", "WHEEL", "RECORD", "LICENSE")} == set(names) - {
        f"flowcert/{name}" for name in package
    }


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="an sdist is made from a clone")
def test_the_sdist_has_all_that_pip_reads(python, tmp_path):
    program = f"import flowcert_build; print(flowcert_build.build_sdist({str(tmp_path)!r}))"
    name = run(python, "-B", "-c", program, PYTHONPATH="src/python/build_backend").strip()
    top = f"flowcert-{flowcert.__version__}"
    assert name == f"{top}.tar.gz"
    with tarfile.open(tmp_path / name) as archive:
        content = lambda file: archive.extractfile(f"{top}/{file}").read().decode()
        assert f"Version: {flowcert.__version__}\n" in content("PKG-INFO")
        path = re.search(r'^backend-path = \["(.*)"\]$', content("pyproject.toml"), re.MULTILINE)[1]
        assert "def build_wheel" in content(f"{path}/flowcert_build.py")
        # The commit, for builds that have no git.
        assert content("src/io/commit.txt") == run("git", "rev-parse", "HEAD")


def test_cmake_installs_it_where_python_looks(tmp_path):
    build = os.environ["FLOWCERT_BUILD"]
    run("cmake", f"-DCMAKE_INSTALL_PREFIX={tmp_path}", "-P", f"{build}/src/python/cmake_install.cmake")
    (installed,) = tmp_path.glob("lib*/python3*/*-packages/flowcert")
    assert {path.name for path in installed.iterdir()} == FILES
    program = "import flowcert; print(flowcert.__file__)"
    assert run(sys.executable, "-c", program, PYTHONPATH=str(installed.parent)).startswith(str(tmp_path))
