"""What the tests of the Python package share: the programs to compare with, and point files.

The environment says where the programs are: FLOWCERT_PROGRAM and FLOWCERT_ORACLE. ctest sets both, and PYTHONPATH.
"""

import doctest
import inspect
import json
import os
import pathlib
import subprocess

import hypothesis
import numpy as np
import pytest

# The same examples each time, and no limit of time: the machine may be busy.
hypothesis.settings.register_profile("same", derandomize=True, deadline=None, max_examples=60, print_blob=True)
hypothesis.settings.load_profile("same")


def run(program, *words):
    """What the program prints. Exit statuses 0 and 1 are answers."""
    finished = subprocess.run(
        [os.environ[program], *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, text=True
    )
    assert finished.returncode in (0, 1), finished.stderr
    return finished.stdout


def flowcert_says(*words):
    return run("FLOWCERT_PROGRAM", *words)


def oracle_says(*words):
    return run("FLOWCERT_ORACLE", *words)


def json_lines(text):
    return [json.loads(line) for line in text.splitlines()]


def write_xyz(path, points):
    """Hexadecimal floats, which are exact."""
    rows = np.asarray(points, dtype=float).reshape(-1, 3)
    pathlib.Path(path).write_text("".join(" ".join(x.hex() for x in row) + "\n" for row in rows.tolist()))
    return path


@pytest.fixture
def examples_hold(tmp_path, monkeypatch):
    """Runs the examples of a docstring, also those that need a library, in a folder of their own."""
    import flowcert

    def run_examples(function):
        text = inspect.getdoc(function).replace("# doctest: +SKIP", "")
        monkeypatch.chdir(tmp_path)
        test = doctest.DocTestParser().get_doctest(text, dict(vars(flowcert)), function.__name__, None, 0)
        done = doctest.DocTestRunner().run(test)
        return done.attempted > 0 and done.failed == 0

    return run_examples


@pytest.fixture
def xyz(tmp_path):
    """Writes points to a file, and gives its path."""
    return lambda points: write_xyz(tmp_path / "points.xyz", points)


def sphere_sample(count, seed=1):
    """Points of the unit sphere, up to rounding, far enough apart."""
    golden_angle = np.pi * (3 - np.sqrt(5))
    k = np.arange(count)
    z = 1 - (2 * k + 1) / count
    radius = np.sqrt(1 - z * z)
    rows = np.column_stack([radius * np.cos(golden_angle * k), radius * np.sin(golden_angle * k), z])
    return rows + np.random.default_rng(seed).uniform(-0.01, 0.01, rows.shape)


CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
