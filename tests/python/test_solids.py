"""tripus.parameterise: solids mapped onto their hyperbolic manifolds."""

from pathlib import Path

import numpy as np
import pytest

import tripus

SURFACE = Path(__file__).resolve().parents[2] / "examples" / "surfaces" / "knotted-y.off"


@pytest.fixture(scope="module")
def found() -> tripus.Parameterisation:
    return tripus.parameterise(SURFACE)


def test_points_lie_on_the_hyperboloid_and_edges_agree(found: tripus.Parameterisation) -> None:
    x = found.points_h3
    form = np.diag([1.0, 1, 1, -1])
    assert found.converged and found.max_gradient < 1e-10
    assert np.allclose(np.einsum("vi,ij,vj->v", x, form, x), -1, atol=1e-9)
    images = np.einsum("tcij,tcj->tci", found.deck_matrices[found.deck], x[found.cells])
    lengths: dict[tuple[int, int], float] = {}
    for i, j in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)):
        cosh = -np.einsum("ti,ij,tj->t", images[:, i], form, images[:, j])
        for t, d in enumerate(np.arccosh(np.maximum(cosh, 1))):
            a, b = sorted((int(found.cells[t, i]), int(found.cells[t, j])))
            assert abs(lengths.setdefault((a, b), d) - d) < 1e-6


def test_distortion_and_volume(found: tripus.Parameterisation) -> None:
    distortion = found.distortion()
    assert {len(v) for v in distortion.values()} == {len(found.cells)}
    assert (distortion["anisotropy"] >= 1 - 1e-9).all()
    assert found.image_volume == pytest.approx(6.451990270835033, abs=1e-8)
    assert found.info()["inverted"] == (distortion["orientation"] < 0).sum()


def test_writes_and_shows(found: tripus.Parameterisation, tmp_path: Path) -> None:
    for name, end in (("y.vtu", "</VTKFile>\n"), ("y.html", "</html>\n"), ("y.svg", "</svg>\n")):
        found.write(tmp_path / name)
        assert (tmp_path / name).read_text().endswith(end)
    assert found.to_svg(0.2).startswith("<svg")
    with pytest.raises(tripus.InvalidInput):
        found.write(tmp_path / "y.png")
    with pytest.raises(tripus.InvalidInput, match="cut_away"):
        found.to_svg(7)


def test_is_refined(found: tripus.Parameterisation) -> None:
    fine = tripus.parameterise(SURFACE, refine=8000)
    assert fine.converged and 8000 <= len(fine.cells) < 8100
    assert (fine.points[: len(found.points)] == found.points).all()
    assert fine.energy < found.energy
    with pytest.raises(tripus.InvalidInput, match="10000000"):
        tripus.parameterise(SURFACE, refine=10**9)


def test_takes_arrays_and_refuses_balls() -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    with pytest.raises(tripus.InvalidInput, match="trivial"):
        tripus.parameterise((points, np.array([[0, 1, 2, 3]])))
    with pytest.raises(tripus.InvalidInput):
        tripus.parameterise((points, np.array([0, 1, 2])))
    with pytest.raises(tripus.InvalidInput):
        tripus.parameterise(SURFACE, weights="best")
    with pytest.raises(tripus.InvalidInput):
        tripus.parameterise(7)
