"""Random triangulations, and what Regina and SnapPy say about them.

test_oracles.py takes a sample; tests/full/python_peers.py takes 500, and SnapPy's whole census of up
to seven tetrahedra.
"""

import random

import regina
import snappy
from conftest import column, signatures

import tripus


def random_triangulations(count, seed):
    """So many regina triangulations: random moves from random entries of the lists in data/."""
    chance = random.Random(seed)
    starts = (
        signatures("triangulations-2.txt") + signatures("triangulations-3.txt", 3)
        + signatures("triangulations-4.txt", 300) + signatures("triangulations-cusped.txt")
        + column("cusped-census-5.tsv", 1)[1:300:3]
    )
    for _ in range(count):
        R = regina.Triangulation3.fromIsoSig(chance.choice(starts))
        for _ in range(chance.randrange(4)):
            # A move of another kind may be refused; 2-3 moves of different tetrahedra are not.
            if chance.random() < 0.7:
                R.pachner(R.triangle(chance.randrange(R.countTriangles())))
            else:
                R.pachner(R.edge(chance.randrange(R.countEdges())))
        yield R


def regina_covers(R, degree):
    """Homology of each connected cover with so many sheets, up to isomorphism; sorted."""
    found = []
    group = regina.GroupPresentation(R.group())
    group.enumerateCovers(degree, lambda cover: found.append(str(cover.abelianisation())))
    return sorted(found)


def check_one(R, most_degree=4):
    """Homology, signature and covers by all; a difference is an assertion."""
    M = tripus.Manifold(R)
    where = R.isoSig()
    assert M.triangulation_isosig() == where
    assert format(M.homology(), "regina") == str(R.homology()), where
    assert M.num_edges() == R.countEdges() and M.num_vertices() == R.countVertices()
    assert M.is_orientable() == R.isOrientable()
    degrees = range(2, most_degree + 1)
    for degree in degrees:
        ours = sorted(format(C.homology(), "regina") for C in M.covers(degree))
        assert ours == regina_covers(R, degree), (where, degree)
    if M.num_boundary_components() or M.has_finite_vertices():
        return 0
    S = snappy.Triangulation(where)
    assert str(S.homology()) == str(M.homology()), where
    assert S.triangulation_isosig(decorated=False) == where
    for degree in degrees:
        assert len(S.covers(degree)) == len(M.covers(degree)), (where, degree)
    return 1


def check_volume(theirs, tolerance=1e-9):
    """A census manifold's volume by both; the difference, or None where the metric is not found."""
    ours = tripus.Manifold(theirs)
    if not ours.verdict():
        ours = ours.retriangulated()
    if not ours.verdict():
        return None
    difference = abs(float(theirs.volume()) - ours.volume())
    assert difference < tolerance, theirs
    return difference
