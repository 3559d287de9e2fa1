"""Regina's and SnapPy's answers, on random triangulations and SnapPy's census; a sample."""

import pytest

pytest.importorskip("regina", exc_type=ImportError)
snappy = pytest.importorskip("snappy", exc_type=ImportError)

from oracles import check_one, check_volume, random_triangulations  # noqa: E402

SEED = 20261130


def test_random_triangulations():
    cusped = sum(check_one(R, 3) for R in random_triangulations(40, SEED))
    assert cusped >= 5


def test_covers_of_degree_four():
    for R in random_triangulations(6, SEED + 1):
        check_one(R)


def test_volumes_of_the_cusped_census():
    for census in (snappy.OrientableCuspedCensus, snappy.NonorientableCuspedCensus):
        for theirs in list(census(num_tets=6))[::30] + list(census(num_tets=7))[::200]:
            assert check_volume(theirs) is not None, theirs
