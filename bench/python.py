#!/usr/bin/env python3
"""The speed of the Python package: a Markdown table for docs/python.md and bench/README.md.

    PYTHONPATH=build/release/python build/venv/bin/python bench/python.py

Each row has its baseline in the same run; times are those of the processor (user), the least of
several, as other work may run.
"""

import os
import pathlib
import resource
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]


def least(work, times, rounds=7):
    best = float("inf")
    for _ in range(rounds):
        begin = time.process_time()
        for _ in range(times):
            work()
        best = min(best, (time.process_time() - begin) / times)
    return best


def import_time(module):
    """User and system seconds of a process that imports it, less those of one that does not."""

    def cost(code):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([sys.executable, "-c", code], check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    return min(cost(f"import {module}") for _ in range(7)) - min(cost("pass") for _ in range(7))


def rate_of_program(path):
    program = os.environ.get("TRIPUS_PROGRAM", str(ROOT / "build/release/bin/tripus"))
    best = float("inf")
    for _ in range(5):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([program, "solve", "--batch", path, "--json", "--threads", "2"],
                       stdout=subprocess.DEVNULL, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return best


def main():
    import snappy

    import tripus

    path = str(ROOT / "data/triangulations-4.txt")
    tripus.Manifold("cPcbbbihq").volume()
    ours = least(lambda: tripus.Manifold("cPcbbbihq").volume(), 2000)
    cusped = least(lambda: tripus.Manifold("cPcbbbiht").volume(), 2000)
    theirs = least(lambda: snappy.Manifold("cPcbbbiht").volume(), 200)
    texts = tripus.read_batch(path)
    many = least(lambda: tripus.solve_many(texts, threads=2, as_array=True), 1, 5)
    batch = rate_of_program(path)
    rows = [
        ("`import tripus`", f"{1e3 * import_time('tripus'):.0f} ms",
         f"`import snappy`: {1e3 * import_time('snappy'):.0f} ms"),
        ('`Manifold("cPcbbbihq").volume()`', f"{1e6 * ours:.0f} us", ""),
        ('`Manifold("cPcbbbiht").volume()`', f"{1e6 * cusped:.0f} us",
         f"SnapPy: {1e6 * theirs:.0f} us, {theirs / cusped:.0f} times as long"),
        ("`solve_many(triangulations-4.txt)`", f"{len(texts) / many:.0f} a second",
         f"`tripus solve --batch`: {len(texts) / batch:.0f} a second; ratio {batch / many:.2f}"),
    ]
    print("| | here | baseline |\n|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    main()
