#!/usr/bin/env python3
"""Solids by boolean operations, turned off the axes: TRIPUS must take every one of them.

    turned_solids.py make FOLDER [--count N] [--seed S]     writes N surfaces in OFF
    turned_solids.py run FOLDER TRIPUS                      exit status 1 if one is refused or wrong

Not a test of the suite: making the solids needs the package manifold3d. What lies inside such a
surface has for its first homology Z to the power of the sum of its genera (Alexander duality);
that and the genera, counted here, are compared with the answer of `tripus mesh` and `tripus info`.
"""

import argparse
import json
import random
import subprocess
import sys
from pathlib import Path


def aligned(m3d, rng):
    """Boxes and drills along the axes, many faces in one plane."""
    if rng.random() < 0.4:
        solid = m3d.Manifold.cube([rng.choice([0.5, 1.0, 1.5, 2.5]) for _ in range(3)], True)
    else:
        solid = m3d.Manifold.cylinder(3, rng.choice([0.2, 0.3, 0.45]), -1.0, rng.randint(6, 40),
                                      True)
        solid = solid.rotate(rng.choice([[0, 0, 0], [90, 0, 0], [0, 90, 0]]))
    return solid.translate([rng.choice([-0.75, -0.5, -0.25, 0, 0.25, 0.5, 0.75]) for _ in range(3)])


def primitive(m3d, rng):
    kind = rng.choice(["box", "box", "cylinder", "cylinder", "sphere", "tube"])
    if kind == "box":
        solid = m3d.Manifold.cube([rng.uniform(0.3, 2) for _ in range(3)], True)
    elif kind == "cylinder":
        solid = m3d.Manifold.cylinder(rng.uniform(0.5, 3), rng.uniform(0.15, 0.8), -1.0,
                                      rng.randint(5, 32), True)
    elif kind == "sphere":
        solid = m3d.Manifold.sphere(rng.uniform(0.3, 1), 4 * rng.randint(1, 6))
    else:
        radius, n = rng.uniform(0.4, 0.8), rng.randint(5, 24)
        solid = (m3d.Manifold.cylinder(2, radius, -1.0, n, True) -
                 m3d.Manifold.cylinder(3, rng.uniform(0.5, 0.9) * radius, -1.0, n, True))
    if rng.random() < 0.6:
        solid = solid.rotate([rng.uniform(0, 360) for _ in range(3)])
    elif rng.random() < 0.5:
        solid = solid.rotate([90 * rng.randint(0, 3) for _ in range(3)])
    return solid.translate([rng.uniform(-0.9, 0.9) for _ in range(3)])


def solid_of(m3d, rng):
    make_one = rng.choice([primitive, aligned])
    while True:
        solid = m3d.Manifold.cube([2.0, 2.0, 2.0], True)
        for _ in range(rng.randint(2, 9)):
            other = make_one(m3d, rng)
            solid = solid - other if rng.random() < 0.6 else solid + other
        pieces = solid.decompose()
        if not pieces:
            continue
        solid = max(pieces, key=lambda piece: piece.volume())
        if rng.random() < 0.9:
            solid = solid.rotate([rng.uniform(0, 360) for _ in range(3)])
        mesh = solid.to_mesh64()
        return mesh.vert_properties[:, :3], mesh.tri_verts


def make(folder, count, seed):
    import manifold3d
    folder.mkdir(parents=True, exist_ok=True)
    for number in range(count):
        rng = random.Random(f"{seed}:{number}")
        points, triangles = solid_of(manifold3d, rng)
        digits = rng.choice([6, 9, 17, 17])
        lines = ["OFF", f"{len(points)} {len(triangles)} 0"]
        lines += [" ".join(f"{x:.{digits}g}" for x in p) for p in points]
        lines += ["3 " + " ".join(str(v) for v in t) for t in triangles]
        (folder / f"solid-{seed}-{number:03}.off").write_text("\n".join(lines) + "\n")


def genera(path):
    """Of the components, by counting."""
    words = path.read_text().split()
    points, count = int(words[1]), int(words[2])
    rest = words[4 + 3 * points:]
    triangles = [tuple(map(int, rest[4 * t + 1:4 * t + 4])) for t in range(count)]
    root = list(range(points))

    def find(v):
        while root[v] != v:
            root[v] = root[root[v]]
            v = root[v]
        return v

    for a, b, c in triangles:
        root[find(a)] = find(b)
        root[find(b)] = find(c)
    chi = {}
    for v in range(points):
        chi[find(v)] = chi.get(find(v), 0) + 2
    for a, _, _ in triangles:
        chi[find(a)] -= 1
    return sorted((4 - twice) // 4 for twice in chi.values())


def run(folder, program):
    refused, wrong, invalid, total = [], [], [], 0
    for path in sorted(folder.glob("*.off")):
        answer = subprocess.run([program, "mesh", str(path), "--json"], capture_output=True,
                                text=True)
        try:
            report = json.loads(answer.stdout)
        except json.JSONDecodeError:
            report = {"error": {"message": answer.stderr}}
        total += 1
        if "error" in report:
            message = report["error"]["message"]
            # Rounded to few digits, some are no surfaces any more.
            kind = invalid if any(text in message for text in (
                "intersects itself", "lie on a line", "are equal", "twice")) else refused
            kind.append(f"{path.name}: {message}")
            continue
        if report["boundary_genera"] != genera(path):
            wrong.append(f"{path.name}: genera {report['boundary_genera']}, not {genera(path)}")
        if not report["ball"]:
            info = subprocess.run([program, "info", str(path), "--json"], capture_output=True,
                                  text=True)
            rank = sum(genera(path))
            found, wanted = json.loads(info.stdout)["H1"], "Z" if rank == 1 else f"{rank} Z"
            if found != wanted:
                wrong.append(f"{path.name}: H1 is {found}, not {wanted}")
    for line in refused + wrong:
        print(line)
    print(f"{total} solids: {len(refused)} refused, {len(wrong)} wrong, "
          f"{len(invalid)} no surfaces after rounding")
    return 1 if refused or wrong or total == 0 else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    verbs = parser.add_subparsers(dest="verb", required=True)
    maker = verbs.add_parser("make")
    maker.add_argument("folder", type=Path)
    maker.add_argument("--count", type=int, default=200)
    maker.add_argument("--seed", type=int, default=1)
    runner = verbs.add_parser("run")
    runner.add_argument("folder", type=Path)
    runner.add_argument("program")
    options = parser.parse_args()
    if options.verb == "make":
        return make(options.folder, options.count, options.seed)
    return run(options.folder, options.program)


if __name__ == "__main__":
    sys.exit(main())
