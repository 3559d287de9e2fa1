"""Volumes of SnapPy's census of knots by both programs, and the knots' canonical triangulations.

    build/venv/bin/python examples/python/compare_with_snappy.py [HOW_MANY]
"""

import sys

import snappy

import tripus

how_many = int(sys.argv[1]) if len(sys.argv) > 1 else 20
largest = 0.0
for theirs in snappy.CensusKnots[:how_many]:
    ours = tripus.Manifold(theirs)
    assert tripus.Manifold(ours.to_snappy()) == ours
    assert str(ours.homology()) == str(theirs.homology())
    largest = max(largest, abs(ours.volume() - float(theirs.volume())))
    print(f"{theirs.name():8} {ours.volume():.12f} {ours.num_tetrahedra()} tetrahedra")
print(f"largest difference of {how_many} volumes: {largest:.1e}")
assert largest < 1e-9
