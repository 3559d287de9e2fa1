"""Threads, processes, signals, memory."""

import concurrent.futures
import gc
import multiprocessing
import os
import resource
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import tripus


def large(n):
    """A cover of the tripus with n^2 sheets, on which CHOLMOD works supernodally."""
    shifts = ((1, 0), (1, 1), (2, -1))  # the relator bAcBAbcAC needs b + c = 3 a
    images = [
        [((i // n + p) % n) * n + (i % n + q) % n for i in range(n * n)] for p, q in shifts
    ]
    return tripus.Manifold("cPcbbbihq").cover(images)


def start_of(M):
    return np.random.default_rng(1).uniform(0.3, 1.2, M.num_edges())


def solve_large(n=20):
    M = large(n)
    return M.solve("newton", initial_lengths=start_of(M)).volume


def threads_now():
    return len(os.listdir("/proc/self/task"))


def test_a_fork_after_a_solve_does_not_hang():
    before = threads_now()
    expected = solve_large()
    assert threads_now() > before, "OpenMP has threads now, which a child does not have"
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.write(writing, repr(solve_large()).encode())
        os._exit(0)
    os.close(writing)
    end = time.monotonic() + 120
    while time.monotonic() < end:
        if os.waitpid(child, os.WNOHANG)[0] == child:
            break
        time.sleep(0.05)
    else:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        pytest.fail("the child hangs")
    assert float(os.read(reading, 100)) == pytest.approx(expected, rel=1e-12)
    os.close(reading)


@pytest.mark.parametrize("start", ["fork", "spawn", "forkserver"])
def test_process_pools(start):
    context = multiprocessing.get_context(start)
    manifolds = [tripus.Manifold(t) for t in ("cPcbbbihq", "cPcbbbdhq", "cPcbbbiht")]
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as pool:
        volumes = list(pool.map(tripus.Manifold.volume, manifolds))
        with pytest.raises(tripus.NoMetric) as caught:
            pool.submit(tripus.Manifold.volume, tripus.Manifold("dLQbcbcaekw")).result()
    assert volumes == [M.volume() for M in manifolds]
    assert caught.value.verdict.certificate is not None


def test_threads_at_one_manifold_and_at_many():
    shared = large(6)
    texts = ["cPcbbbihq", "cPcbbbdhq", "dLQbcccdinf", "eLAkabcddjjgaf"] * 25

    def ask(text):
        return (shared.volume() - 36 * 6.45199027083503287, tripus.Manifold(text).verdict().volume,
                shared.verdict().max_curvature)

    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(ask, texts))
    assert max(abs(a[0]) for a in answers) < 1e-9
    for text, answer in zip(texts, answers):
        assert answer[1] == tripus.Manifold(text).verdict().volume


def test_other_threads_run_while_one_solves():
    """A call that held the interpreter's lock would let no tick fall inside it, however often it is
    made; one that gives it up has many inside it, unless the machine is busy elsewhere."""
    M = large(64)
    lengths = start_of(M)
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.001):
            ticks.append(time.monotonic())

    def most_ticks_inside(solve, times=200, wanted=6):
        most = 0
        for _ in range(times):
            start = time.monotonic()
            solve()
            end = time.monotonic()
            most = max(most, sum(start < t < end for t in reversed(ticks)))
            if most >= wanted:
                break
        return most

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        by_cg = most_ticks_inside(
            lambda: M.solve("newton-cg", initial_lengths=lengths, max_iterations=20))
        by_newton = most_ticks_inside(lambda: M.solve("newton", initial_lengths=lengths))
    finally:
        done.set()
        thread.join()
    assert by_cg >= 6
    assert by_newton >= 6


INTERRUPTED = """
import os, signal, sys, threading, time
sys.path.insert(0, {tests!r})
import tripus
from test_processes import large, start_of

def works():
    {work}

threading.Timer(0.7, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    while True:
        works()
except KeyboardInterrupt:
    print("interrupted", flush=True)
assert abs(tripus.Manifold("cPcbbbihq").volume() - 6.45199027083503287) < 1e-12
try:
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(5)
except KeyboardInterrupt:
    print("and again", flush=True)
"""


@pytest.mark.parametrize("work", [
    "tripus.Manifold('cPcbbbihq').metric.orthospectrum(length=14)",
    "tripus.Manifold('cPcbbbihq').covers(9)",
    "tripus.solve_many(['cPcbbbihq'] * 10**6, threads=2, as_array=True)",
    "tripus.Manifold('cPcbbbihq').metric.universal_cover(2 * 10**6)",
    "large(60).simplified()",
    "M = large(30); M.solve('flow:curvature/euler', initial_lengths=start_of(M))",
    "tripus.study.convergence([large(6)], threads=2)",
    # 3042 tetrahedra
    "large(39).homology()",
    "large(39).canonical()",
    "large(39).isometry_signature()",
    "large(39).compare(large(39).relabelled(1))",
    "large(39).isomorphisms_to(large(39))",
    "large(39).simplified(effort=100.0)",
    "large(200)",
    "large(60).prove(digits=50)",
    "large(60).page(cells=10000)",
    "tripus.Manifold('cPcbbbihq').basmajian_discs(8).svg()",
    "tripus.Diagram('Braid: ' + '1 -2 3 ' * 300).svg()",
    "tripus.Diagram('Braid: ' + '1 -2 3 ' * 400).exterior()",
    "tripus.Manifold.from_text(large(60).to_text('snappea'))",
])
def test_control_c_ends_the_work_and_not_the_process(work):
    text = INTERRUPTED.format(tests=os.path.dirname(__file__), work=work)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=120)
    assert done.stdout.split("\n")[:2] == ["interrupted", "and again"], done.stderr[-2000:]
    assert done.returncode == 0, done.stderr[-2000:]


def test_a_signal_whose_handler_goes_on_costs_no_answer():
    seen = []
    previous = signal.signal(signal.SIGINT, lambda *_: seen.append(1))
    try:
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        arcs = tripus.Manifold("cPcbbbihq").orthospectrum(length=11.5)
        timer.join()
    finally:
        signal.signal(signal.SIGINT, previous)
    assert arcs.complete
    assert signal.getsignal(signal.SIGINT) is previous


def test_time_limits_give_what_is_done():
    arcs = tripus.Manifold("cPcbbbihq").orthospectrum(length=14, time_limit=0.2)
    assert not arcs.complete and arcs.length < 14
    with pytest.raises(tripus.Stopped):
        tripus.study.convergence([large(5)], time_limit=0.01)


def test_progress():
    seen = []
    rows = tripus.solve_many(["cPcbbbihq"] * 500, threads=2, progress=lambda *a: seen.append(a),
                             as_array=True)
    assert len(rows) == 500 and seen[-1] == ("solve", 500)
    tripus.solve_many(["cPcbbbihq"] * 10, progress=True)

    class Enough(Exception):
        pass

    def stop(activity, count):
        raise Enough

    with pytest.raises(Enough):
        tripus.solve_many(["cPcbbbihq"] * 10**5, threads=2, progress=stop)
    with pytest.raises(Enough):
        large(10).simplified(progress=stop)


def bytes_held():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def test_a_hundred_thousand_objects_leave_nothing():
    def make(count):
        for _ in range(count // 10):
            M = tripus.Manifold("cPcbbbihq")
            metric = M.metric
            things = [M, metric, M.volume(), metric.edge_lengths, metric.dihedral_angles, M.homology(),
                      M.edge_classes, M.verdict(), M.renamed("x"), hash(M)]
            assert len(things) == 10
            try:
                tripus.Manifold("hello")
            except tripus.InvalidInput:
                pass
        gc.collect()

    make(20_000)
    before = bytes_held()
    make(100_000)
    assert bytes_held() - before < 2_000_000


IMPORTED = """
import os, signal, sys
import tripus
assert "numpy" not in sys.modules

class Interrupts:
    # Stands before all finders: Ctrl-C comes amid the import of numpy.
    def find_spec(self, name, path=None, target=None):
        if name == "numpy._core.numeric":
            os.kill(os.getpid(), signal.SIGINT)
        return None

sys.meta_path.insert(0, Interrupts())
try:
    tripus.Manifold("cPcbbbihq").metric.edge_lengths
except KeyboardInterrupt:
    print("interrupted")
assert abs(tripus.Manifold("cPcbbbihq").metric.edge_lengths[0] - 0.596133894890837) < 1e-12
import numpy
print(signal.getsignal(signal.SIGINT) is signal.default_int_handler)
"""


def test_control_c_while_numpy_is_imported_leaves_it_whole():
    done = subprocess.run([sys.executable, "-c", IMPORTED], capture_output=True, text=True,
                          timeout=60)
    assert done.stdout.split() == ["interrupted", "True"], done.stderr[-2000:]

