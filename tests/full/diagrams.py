#!/usr/bin/env python3
"""Two routes from every hyperbolic graph of the tables to its manifold.

    diagrams.py TRIPUS [NAME ...]

For each (by default all theta curves, handcuff graphs and handlebody-knots with a volume): the
diagram's octahedral triangulation, and the drawing in space, the tube around it, its mesh. Both are
compared by `tripus compare`. Exit status 1 if any two differ or were not decided. Some minutes.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def main(program, names):
    tables = ("theta-curves", "handlebody-knots")
    rows = [row for table in tables
            for row in json.loads(run(program, "table", table, "--json").stdout)["rows"]]
    failures, seconds = [], {"octahedra": 0.0, "space": 0.0}
    with tempfile.TemporaryDirectory() as folder:
        space, surface = str(Path(folder) / "space.json"), str(Path(folder) / "space.off")
        for row in rows:
            name = row["name"]
            if (names and name not in names) or (not names and row["volume"] is None):
                continue
            start = time.perf_counter()
            info = json.loads(run(program, "info", name, "--json").stdout)
            seconds["octahedra"] += time.perf_counter() - start
            start = time.perf_counter()
            made = run(program, "draw", name, "--polylines", "-o", space)
            made = run(program, "tube", space, "-o", surface, "--quiet") if made.returncode == 0 else made
            mesh = run(program, "info", surface, "--json") if made.returncode == 0 else made
            seconds["space"] += time.perf_counter() - start
            if mesh.returncode != 0:
                failures.append(name)
                print(f"{name}: {(made.stderr or mesh.stderr).strip()}", flush=True)
                continue
            other = json.loads(mesh.stdout)
            answer = json.loads(run(program, "compare", info["oriented_isosig"],
                                    other["oriented_isosig"], "--json").stdout)
            print(f"{name}: {answer['verdict']} by {answer['decided_by']}, "
                  f"{info['tetrahedron_count']} and {other['tetrahedron_count']} tetrahedra", flush=True)
            if answer["verdict"] != "homeomorphic":
                failures.append(name)
    print(f"{seconds['octahedra']:.1f} s by octahedra, {seconds['space']:.1f} s through space; "
          f"failures: {', '.join(failures) or 'none'}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
