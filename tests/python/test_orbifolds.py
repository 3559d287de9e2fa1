"""Cone angles: through the constructor, files, pickles, covers, isometries."""

import json
import math
import pickle
from fractions import Fraction

import pytest

import tripus

TRIPUS_VOLUME = 6.45199027083503287  # docs/theory.md (28)


@pytest.fixture
def M():
    return tripus.Manifold("cPcbbbiht", cone_orders={0: 2, 1: 2})


def test_the_ways_to_say_them(M):
    assert M.volume() == pytest.approx(TRIPUS_VOLUME, abs=1e-12)
    assert M.cone_orders == {0: 2, 1: 2}
    assert M.cone_angles.tolist() == [math.pi, math.pi]
    plain = tripus.Manifold("cPcbbbiht")
    assert plain.cone_orders == {} and plain.cone_angles.tolist() == [2 * math.pi] * 2
    for same in (
        tripus.Manifold("cPcbbbiht 0=2,1=2"),
        tripus.Manifold(plain, cone_angles={0: math.pi, 1: math.pi}),
        tripus.Manifold(tripus.Manifold(plain, cone_orders={1: 2}), cone_orders={0: 2}),
        plain.with_cone_angles({0: 2}, {1: math.pi}),
        tripus.Manifold.from_text(M.to_text("json")),
        tripus.Manifold.from_text(M.to_text("orb")),
        M.relabelled(4), M.mirrored(), M.oriented(), M.renamed("x"),
        pickle.loads(pickle.dumps(M)),
    ):
        assert same == M and hash(same) == hash(M)
        assert same.volume() == pytest.approx(TRIPUS_VOLUME, abs=1e-12)
    assert M.with_cone_angles() == plain != M
    assert str(M) == "cPcbbbiht 0=2,1=2"


def test_they_are_exact():
    for orders in ({0: 3}, {0: "5/2"}, {0: Fraction(7, 3), 1: 4}, {1: 0}):
        M = tripus.Manifold("cPcbbbiht", cone_orders=orders)
        again = pickle.loads(pickle.dumps(M))
        assert M.cone_orders == again.cone_orders == {e: Fraction(k) for e, k in orders.items()}
        assert again == M and str(again) == str(M) and again.to_text() == M.to_text()
    odd = tripus.Manifold("cPcbbbiht", cone_angles={0: 1.2345})
    assert odd.cone_angles[0] == 1.2345 and pickle.loads(pickle.dumps(odd)).cone_angles[0] == 1.2345
    assert odd.cone_orders[0] == 2 * math.pi / 1.2345


def test_answers_are_those_of_the_orbifold(M, program):
    plain = tripus.Manifold("cPcbbbiht")
    assert M.is_isometric_to(tripus.Manifold("cPcbbbiht 0=2,1=2"))
    other = tripus.Manifold("cPcbbbiht 0=2,1=3")
    assert not M.is_isometric_to(other) and M != other
    assert M.isometry_signature() != plain.isometry_signature()
    assert len(M.is_isometric_to(M, return_isometries=True)) == M.symmetry_group().order()
    one = tripus.Manifold("cPcbbbiht", cone_orders={0: 2})
    assert len(one.isomorphisms_to(one)) * 2 == len(M.isomorphisms_to(M)), "edges 0, 1 change places"
    assert M.links()[0]["kind"] == "geodesic" and M.links()[0]["cone_points"] == 4
    line = program("solve", "--batch", "-", "--json", "--quiet", input="cPcbbbiht 0=2,1=2\n")
    found, expected = json.loads(M.to_json()), json.loads(line)
    for key in ("input", "cone_orders", "volume", "edge_lengths", "outcome"):
        assert found[key] == expected[key], key
    assert M.solve(cone_orders={0: 1, 1: 1}).volume == pytest.approx(plain.volume(), abs=1e-12)


def test_covers_keep_them():
    M = tripus.Manifold("cPcbbbiht", cone_orders={0: 3})
    for N in M.covers(3):
        assert sorted(N.cone_orders.values()) == [3, 3, 3]
        assert N.volume() == pytest.approx(3 * M.volume(), abs=1e-10)


def test_they_are_proved(M):
    assert M.prove() and M.prove().check() and 0 < M.volume().error < 1e-12
    irrational = tripus.Manifold("cPcbbbiht", cone_angles={0: 1.25, 1: 1.5})
    assert irrational.volume() > 0 and irrational.prove().message


def test_retriangulation_keeps_them():
    M = tripus.Manifold("dLQbcbcaekw", cone_orders={0: 3})
    N = M.retriangulated(budget=200)
    assert N.verdict().outcome == "unresolved" and "200 other" in N.verdict().message
    assert sorted(N.cone_orders.values()) == [3]


def test_places_in_space(M):
    holonomy = M.metric.holonomy()
    assert holonomy["holds"] and holonomy["defect"] < 1e-11 and not any(holonomy["reverses"])
    vertices = M.metric.embedding()["vertices"]
    assert vertices.shape == (2, 4, 4)
    assert len(M.metric.universal_cover(30)) == 30
    eight = tripus.Manifold("4_1").metric
    v = eight.embedding()["vertices"]
    assert abs(v[..., 0]**2 + v[..., 1]**2 + v[..., 2]**2 - v[..., 3]**2).max() < 1e-12
    assert any(tripus.Manifold("bkaaid").metric.holonomy()["reverses"])
    with pytest.raises(tripus.Unsupported, match="2 pi / n"):
        tripus.Manifold("cPcbbbihq", cone_orders={0: Fraction(5, 2)}).metric.universal_cover(30)


def test_what_does_not_know_them_says_so(M, tmp_path):
    for work in (M.simplified, M.to_snappy, M.to_regina, M.page, M.picture):
        with pytest.raises(tripus.Unsupported, match="cone angles"):
            work()
    assert "img" not in M._repr_html_() and "edge 0: 2" in M._repr_html_()
    for ending in ("rga", "tri", "sig"):
        with pytest.raises(tripus.Unsupported, match="cone angles"):
            M.save(tmp_path / f"m.{ending}")
    assert list(tmp_path.iterdir()) == []
    M.save(tmp_path / "m.json")
    assert tripus.Manifold(tmp_path / "m.json") == M


@pytest.mark.parametrize("wrong", [{7: 2}, {-1: 2}, {0: 1.5}, {0: -2}, {0: "x"}, {0: float("nan")}])
def test_wrong_orders(wrong):
    with pytest.raises(tripus.InvalidInput):
        tripus.Manifold("cPcbbbiht", cone_orders=wrong)
    with pytest.raises(tripus.InvalidInput):
        tripus.Manifold("cPcbbbiht").solve(cone_orders=wrong)


@pytest.mark.parametrize("wrong", [{0: None}, {0: [2]}, {"0": 2}, [2, 2], 2, {0: True}])
def test_orders_of_the_wrong_type(wrong):
    with pytest.raises(TypeError, match="cone"):
        tripus.Manifold("cPcbbbiht", cone_orders=wrong)
