#!/usr/bin/env python3
"""Times Tripus and, where they are installed, its peers on the same inputs in one run.

    peers.py PROGRAM FILE      FILE holds a signature a line; a table on standard output

What is compared is what a peer can do with these inputs:
  read    the signature, its H1 and its signature again       Tripus, Regina; SnapPy: H1 only
  metric  the hyperbolic metric with geodesic boundary        Tripus
Regina's angle structures are those of ideal vertices, with vertex sums pi: a manifold whose boundary
has genus 2 or more has none, so there is nothing to compare. Orb finds such metrics, but has no
interface for scripts.
Regina comes with a Python of its own on some systems: then run this script by regina-python.
A peer that is not found is named as such. Answers are compared first. Times are of the processor, the
least of three: other work on the machine counts little.
"""

import importlib
import json
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path


def load(module):
    """The module and its version, or nothing where it is not installed."""
    try:
        found = importlib.import_module(module)
    except Exception:  # whatever keeps it from loading, it cannot be timed
        return None, None
    version = getattr(found, "__version__", None)
    if version is None and hasattr(found, "versionString"):
        version = found.versionString()
    return found, version or "unknown version"


def timed(work, inputs):
    """Seconds an input, the least of three passes, and the answers."""
    seconds = []
    for _ in range(3):
        start = time.process_time()
        answers = [work(text) for text in inputs]
        seconds.append(time.process_time() - start)
    return min(seconds) / len(inputs), answers


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def tripus(program, verb, path, count):
    all_seconds = []
    for _ in range(3):
        start = children_seconds()
        done = subprocess.run([program, verb, "--batch", str(path), "--json", "--threads", "1"],
                              capture_output=True, check=True, text=True)
        all_seconds.append(children_seconds() - start)
    seconds = min(all_seconds)
    answers = [json.loads(line) for line in done.stdout.splitlines()]
    if len(answers) != count:
        raise SystemExit(f"tripus {verb} answered {len(answers)} of {count} inputs")
    return seconds / count, answers


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    program, path = sys.argv[1], Path(sys.argv[2])
    inputs = [line.split("#")[0].strip() for line in path.read_text().splitlines()]
    inputs = [text for text in inputs if text]
    rows, found = [], []

    seconds, info = tripus(program, "info", path, len(inputs))
    rows.append(("read", "Tripus", seconds))
    seconds, solved = tripus(program, "solve", path, len(inputs))
    rows.append(("metric", "Tripus", seconds))

    regina, version = load("regina")
    found.append(("Regina", version))
    if regina:
        def read(text):
            triangulation = regina.Triangulation3.fromIsoSig(text)
            return triangulation.isoSig(), triangulation.homology().str()

        seconds, answers = timed(read, inputs)
        for text, theirs, ours in zip(inputs, answers, info):
            if theirs != (ours["isosig"], ours["H1"]):
                raise SystemExit(f"{text}: Regina says {theirs}, Tripus {ours['isosig'], ours['H1']}")
        rows.append(("read", "Regina", seconds))

    snappy, version = load("snappy")
    found.append(("SnapPy", version))
    if snappy:
        def read_snappy(text):
            try:
                return str(snappy.Triangulation(text).homology())
            except Exception:  # it may refuse boundary of higher genus
                return None

        seconds, answers = timed(read_snappy, inputs)
        if all(answers):
            rows.append(("read", "SnapPy", seconds))
        else:
            found[-1] = ("SnapPy", f"{version}, refuses {answers.count(None)} of the inputs: not timed")

    orb = shutil.which("orb") or shutil.which("Orb")
    found.append(("Orb", "found, but it has no interface for scripts: not timed" if orb else None))

    print(f"{len(inputs)} inputs of {path.name}, one thread; Tripus with its start-up and JSON")
    for name, version in found:
        print(f"  {name}: {version if version else 'not found, not timed'}")
    metrics = sum(answer["outcome"] == "geometric" for answer in solved)
    print(f"  {metrics} of the inputs carry the metric; Tripus decides the others with certificates")
    print(f"\n{'task':<12}{'program':<10}{'us an input':>14}")
    for task, name, seconds in rows:
        print(f"{task:<12}{name:<10}{1e6 * seconds:>14.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
