"""Where memory or threads end, there is a MemoryError or the usual result, and asking again gives the usual result."""

import os
import subprocess
import sys

import pytest

SCRIPT = """
import hashlib
import resource
import sys

import flowcert
import numpy as np

megabytes, threads = int(sys.argv[1]), int(sys.argv[2])
points = np.random.default_rng(41).random((1500, 3))


def digest(fc):
    fc.stationary_points, fc.unstable_lines(), fc.volumes, fc.persistence(), fc.pockets()
    fc.unstable_surface(2000, exact=True)
    parts = [fc.stationary_points["center"].tobytes(), fc.volumes.tobytes(), repr(fc.persistence()).encode()]
    return hashlib.sha256(b"".join(parts)).hexdigest()


usual = digest(flowcert.FlowComplex(points, threads=1))
fc = flowcert.FlowComplex(points, threads=threads)
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
hard = resource.getrlimit(resource.RLIMIT_AS)[1]
resource.setrlimit(resource.RLIMIT_AS, (used + megabytes * 2**20, hard))
try:
    found = digest(fc)
except MemoryError:
    found = "MemoryError"
resource.setrlimit(resource.RLIMIT_AS, (hard, hard))
print("usual" if found == usual else found)
print("usual" if digest(fc) == usual else "another result afterwards")
"""


@pytest.mark.parametrize("megabytes, threads", [(0, 1), (2, 1), (0, 64), (2, 64), (5, 64), (200, 64)])
def test_of_a_limit(megabytes, threads):
    words = [sys.executable, "-c", SCRIPT, str(megabytes), str(threads)]
    # Its threads' memory is what glibc takes for them alone.
    finished = subprocess.run(words, capture_output=True, text=True, env={**os.environ, "MALLOC_ARENA_MAX": "1"})
    assert finished.returncode == 0, finished.stderr[-500:]
    first, afterwards = finished.stdout.split()
    assert first in ("usual", "MemoryError")
    assert afterwards == "usual"
