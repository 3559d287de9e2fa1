"""Which manifolds double cover the tripus, and are any two of them the same?

    build/venv/bin/python examples/python/census_of_covers.py [SIGNATURE [DEGREE]]
"""

import collections
import sys

import tripus

M = tripus.Manifold(sys.argv[1] if len(sys.argv) > 1 else "cPcbbbihq")
degree = int(sys.argv[2]) if len(sys.argv) > 2 else 2
print(f"{M}: volume {M.volume()}, H1 = {M.homology()}")

by_manifold = collections.defaultdict(list)
for cover in M.covers(degree):
    cover = cover.retriangulated(budget=50)
    if cover.verdict():
        by_manifold[cover.isometry_signature()].append(cover)
    else:
        print(f"  {cover}: {cover.verdict().message}")

for signature, covers in sorted(by_manifold.items()):
    first = covers[0]
    print(f"  {len(covers)} x volume {first.volume()}, H1 = {first.homology()}, "
          f"isometries {first.symmetry_group()}, {signature}")
    assert abs(first.volume() - degree * M.volume()) < 1e-9
