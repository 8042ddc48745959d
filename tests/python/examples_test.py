"""The four scripts beside this file run, and do what they say."""

import pathlib
import re
import subprocess
import sys

import flowcert
import numpy as np
from conftest import sphere_sample, write_xyz

FOLDER = pathlib.Path(__file__).parent


def run(script, *words):
    finished = subprocess.run(
        [sys.executable, FOLDER / script, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        check=False, text=True,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stderr
    return finished.stdout


def test_reconstruct_a_scan(tmp_path):
    scan = sphere_sample(1000)
    shape = tmp_path / "shape.off"
    printed = run("reconstruct_a_scan.py", write_xyz(tmp_path / "scan.xyz", scan), shape)
    vertices, faces = map(int, re.findall(r"\d+", printed.replace(",", ""))[:2])
    lines = shape.read_text().splitlines()
    assert lines[1] == f"{vertices} {faces} 0" and len(lines) == 2 + vertices + faces
    # All of it is near the sphere that the scan is of, and it is closed: no edge has one triangle.
    assert faces > 4 * len(scan)
    positions = flowcert.read_points(shape)
    assert (abs(np.linalg.norm(positions, axis=1) - 1) < 0.05).all()
    corners = np.array([line.split()[1:] for line in lines[2 + vertices :]], dtype=int)
    edges = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    assert np.unique(edges, axis=0, return_counts=True)[1].min() >= 2


def test_tunnels_of_a_scan(tmp_path):
    # A torus has two tunnels, one through its hole and one inside.
    turn, around = np.meshgrid(np.arange(40) * np.pi / 20, np.arange(16) * np.pi / 8)
    radius = 3 + np.cos(around)
    torus = np.stack([radius * np.cos(turn), radius * np.sin(turn), np.sin(around)], axis=-1).reshape(-1, 3)
    picture = tmp_path / "tunnels.svg"
    printed = run("tunnels_of_a_scan.py", write_xyz(tmp_path / "scan.xyz", torus), picture, "5%").splitlines()
    assert len(printed) == 10
    lengths = [float(line.split()[5].rstrip(",")) for line in printed[:2]]
    assert max(lengths) > 2 * np.pi * 1.8 and 5 < min(lengths) < 8
    drawn = picture.read_text()
    assert drawn.count("<polygon") >= 10
    assert drawn.count("h0") == len(torus)


def test_persistence_against_gudhi(tmp_path):
    printed = run("persistence_against_gudhi.py", write_xyz(tmp_path / "scan.xyz", sphere_sample(500)))
    lines = printed.splitlines()
    assert [line.split(":")[0] for line in lines] == ["components", "tunnels", "voids"]
    for line in lines:
        assert float(line.rsplit(" ", 1)[1]) < 1e-12


def test_certify_your_critical_points(tmp_path):
    script = "certify_your_critical_points.py"
    source = (FOLDER / script).read_text()
    assert len(re.findall(r"^ *[^ #\n\"]", source, re.MULTILINE)) <= 10  # it promises ten lines
    printed = run(script).splitlines()
    # Its rule takes right angles for acute ones, and points with further contacts.
    assert printed[0].startswith("claim[") and "truth: " in printed[0]
    assert printed[-1] in ("perturbed (approximate)", "fails (approximate)")
    # The rule that it should be has no finding.
    old = "if squared_distances.min() >= squared_distances[i]:"
    new = "if (np.delete(squared_distances, [i, j]) > squared_distances[i]).all():"
    assert old in source
    right = tmp_path / script
    right.write_text("import numpy as np\n" + source.replace(old, new))
    assert run(right).splitlines()[-1] == "conforms (approximate)"
