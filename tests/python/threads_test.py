"""Other threads run while the library computes, Ctrl-C stops it, and no memory is lost."""

import os
import pickle
import subprocess
import sys
import threading
import time

import flowcert
import numpy as np
import pytest
from conftest import sphere_sample

POINTS = np.random.default_rng(1).uniform(size=(20_000, 3))


def ticks_during(work):
    """How often another thread runs meanwhile, and how many seconds the work takes."""
    done = threading.Event()
    ticks = []
    ticking = threading.Thread(target=lambda: [ticks.append(time.perf_counter()) for _ in iter(done.is_set, True)
                                               if not time.sleep(0.001)])  # fmt: skip
    ticking.start()
    start = time.perf_counter()
    work()
    end = time.perf_counter()
    done.set()
    ticking.join()
    return sum(start < tick < end for tick in ticks), end - start


@pytest.mark.parametrize(
    "ask",
    [
        lambda fc: fc.persistence(),
        lambda fc: fc.surface(),
        lambda fc: fc.unstable_lines(),
        lambda fc: fc.counts,
        lambda fc: fc.check([], highest_level=2),
        lambda fc: fc.orbit([0.5, 0.5, 0.5]),
        lambda fc: fc.volumes,
        lambda fc: fc.connections,
        lambda fc: fc.is_morse_smale,
        lambda _: flowcert.pores(POINTS[:500], 0.01).points,
        lambda _: flowcert.cavities(POINTS, 0.01, 0),
    ],
    ids=["persistence", "surface", "lines", "counts", "check", "orbit", "volumes", "connections", "is_morse_smale",
         "pores", "cavities"],
)
def test_other_threads_run_meanwhile(ask):
    fc = flowcert.FlowComplex(POINTS)
    ticks, seconds = ticks_during(lambda: ask(fc))
    assert seconds > 0.02  # or it says nothing
    assert ticks >= 5


def test_several_threads_may_ask_one_complex():
    fc = flowcert.FlowComplex(sphere_sample(2000))
    expected = flowcert.FlowComplex(sphere_sample(2000), threads=1)
    answers = []

    def ask(k):
        answers.append(fc.persistence() if k % 2 else fc.stationary_points.tobytes())

    threads = [threading.Thread(target=ask, args=(k,)) for k in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(answers) == 8
    for answer in answers:
        assert answer in (expected.persistence(), expected.stationary_points.tobytes())


INTERRUPTED = """
import _thread, os, signal, sys, threading, time
import flowcert, numpy
signal.signal(signal.SIGINT, signal.default_int_handler)  # a background job's shell has it ignored
points = numpy.random.default_rng(1).uniform(size=(100_000, 3))
fc = flowcert.FlowComplex(points, threads=int(sys.argv[1]))
if sys.argv[2] != "persistence":
    fc.counts
ask = (lambda: fc.volumes) if sys.argv[2] == "volumes" else getattr(fc, sys.argv[2])
start = time.perf_counter()  # before the timer, which may fire while this thread waits for a processor
threading.Timer(float(sys.argv[3]), os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    ask()
except KeyboardInterrupt:
    interrupted = time.perf_counter() - start
    start = time.perf_counter()
    ask()  # it can be asked again
    print(interrupted, time.perf_counter() - start)
"""


@pytest.mark.parametrize("threads, ask, after", [(1, "persistence", 0.3), (2, "persistence", 0.3),
                                                 (2, "surface", 0.3), (2, "volumes", 0.3)])  # fmt: skip
def test_an_interrupt_stops_it_and_it_can_be_asked_again(threads, ask, after):
    words = [sys.executable, "-c", INTERRUPTED, str(threads), ask, str(after)]
    finished = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, text=True)
    assert finished.returncode == 0, finished.stderr
    interrupted, uninterrupted = map(float, finished.stdout.split())  # nothing if it was not interrupted
    # It stops soon after the signal, and not because it was done.
    assert after <= interrupted < after + 2
    assert interrupted - after < uninterrupted / 4


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * 4096


def use_everything(points):
    fc = flowcert.FlowComplex(points, threads=2)
    fc.persistence()
    fc.persistence_pairs(zero=True)
    fc.exact(len(fc.stationary_points) - 1)
    fc.surface(select="largest-gaps=10")
    fc.stable_surfaces()
    fc.unstable_lines()
    fc.orbit([0.1, 0.2, 0.3])
    place = int(fc.volumes.argmax())
    fc.volume(place)
    fc.hull_volume
    for exact in (False, True):
        fc.shares(place, exact=exact)
        fc.lambda_list(fc.counts[0], exact=exact)
        fc.unstable_surface(fc.counts[0], exact=exact)
    fc.connections
    fc.is_morse_smale
    fc.check(fc.critical_points)
    fc._repr_html_()
    flowcert.generate("lattice-3", 5)
    made = flowcert.pores(points[:30], [0.01] * 30, depth=0)
    made.points, made.exact(0), made.cavity_steps(), made.hidden
    flowcert.cavities(points[:30], 0.01, 0.01)
    for wrong in (np.zeros((2, 2)), [[np.nan, 0, 0]]):
        with pytest.raises(ValueError):
            flowcert.FlowComplex(wrong)
    with pytest.raises(ValueError):
        fc.surface(select="colour=red")


def test_no_memory_is_lost():
    points = sphere_sample(500)
    for _ in range(10):
        use_everything(points)
    before = resident_bytes()
    rounds = 30
    for _ in range(rounds):
        use_everything(points)
    lost = (resident_bytes() - before) / rounds
    one = flowcert.FlowComplex(points)
    least = one.stationary_points.nbytes + len(one.persistence()) * 160  # what one round hands out is more than this
    assert lost < least / 8, (lost, least)


def test_references_are_counted():
    fc = flowcert.FlowComplex(sphere_sample(50))
    first = fc.persistence()
    inf_before = sys.getrefcount(first)
    zero = first[0][1][0]
    count = sys.getrefcount(zero)
    again = fc.persistence()
    assert sys.getrefcount(zero) == count and sys.getrefcount(first) == inf_before
    del again
    births = sum(birth is zero for _, (birth, _) in first)
    assert births == fc.counts[0] and sys.getrefcount(zero) >= births


def test_a_complex_is_pickled_by_its_points():
    fc = flowcert.FlowComplex(sphere_sample(30), threads=2)
    other = pickle.loads(pickle.dumps(fc))
    assert other.threads == 2 and other.persistence() == fc.persistence()


READING = """
import os
import signal
import sys
import threading
import time

import flowcert

path, waits = sys.argv[1], sys.argv[2] == "waits"


def interrupt(*_):
    raise KeyboardInterrupt


signal.signal(signal.SIGALRM, interrupt)
signal.setitimer(signal.ITIMER_REAL, 0.2 if waits else 0.05)
start = time.perf_counter()
try:
    flowcert.read_points(path)
    print("read")
except KeyboardInterrupt:
    print("interrupted")
assert time.perf_counter() - start < 5
if not waits:
    print(len(flowcert.read_points(path)))
"""


def test_reading_is_interrupted(tmp_path):
    """A file takes a while; nobody writes into a pipe."""
    table, pipe = tmp_path / "points.xyz", tmp_path / "pipe"
    table.write_text("0.123456 1.234567 2.345678\n" * 2_000_000)
    os.mkfifo(pipe)
    for path, how, expected in ((table, "reads", ["interrupted", "2000000"]), (pipe, "waits", ["interrupted"])):
        words = [sys.executable, "-c", READING, str(path), how]
        finished = subprocess.run(words, capture_output=True, text=True, timeout=60)
        assert finished.stdout.split() == expected, finished.stderr
