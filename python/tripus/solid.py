"""Harmonic maps of solids in space onto their hyperbolic manifolds."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

from tripus import _core, interop
from tripus._check import as_bytes, checked, one_of, real_array, whole_array
from tripus._errors import InvalidInput
from tripus._limits import Progress, limits
from tripus._value import Value

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
else:
    from tripus._lazy import numpy as np


class Parameterisation(Value):
    """The harmonic map of a solid; `parameterise` makes it, and pickles make it again.

    Every point of the mesh has a point of hyperbolic space, in a frame of its own. In a tetrahedron
    `t` of the mesh the four images are `deck_matrices[deck[t, i]] @ points_h3[cells[t, i]]`.
    """

    def __init__(self, core: _core.Parameterisation, asked: tuple[Any, ...]) -> None:
        self._core = core
        self._asked = asked
        self._facts: dict[str, Any] = json.loads(core.to_json())

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, self._asked

    def _key(self) -> Any:
        return self.points_h3, self.deck, self.cells

    def _rows(self) -> dict[str, str]:
        facts = self._facts
        return {
            "tetrahedra": str(facts["tetrahedra"]),
            "energy": f"{facts['energy']:.6g}",
            "volume": f"{facts['manifold_volume']:.12g}",
        }

    def _picture(self) -> str:
        return self.to_svg()

    @property
    def points_h3(self) -> npt.NDArray[np.float64]:
        """[V x 4] on the hyperboloid x^2 + y^2 + z^2 - t^2 = -1, t last."""
        return self._core.points_h3()

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """[V x 3] of the mesh, in space."""
        return self._core.points()

    @property
    def cells(self) -> npt.NDArray[np.uint32]:
        """[T x 4] corners of its tetrahedra."""
        return self._core.cells()

    @property
    def deck(self) -> npt.NDArray[np.uint32]:
        """[T x 4] rows of `deck_matrices`."""
        return self._core.deck()

    @property
    def deck_matrices(self) -> npt.NDArray[np.float64]:
        """[n x 4 x 4] deck transformations as Lorentz matrices; the first is the identity."""
        return self._core.deck_matrices()

    @property
    def energy(self) -> float:
        """Half the sum over the edges of weight times squared distance."""
        return float(self._facts["energy"])

    @property
    def max_gradient(self) -> float:
        """Largest entry of the gradient of the energy, 0 at the minimum."""
        return float(self._facts["max_gradient"])

    @property
    def converged(self) -> bool:
        """Whether the gradient is below the tolerance."""
        return bool(self._core.converged())

    @property
    def image_volume(self) -> float:
        """Sum of the signed volumes of the images: the manifold's volume."""
        return float(self._facts["image_volume"])

    def info(self) -> dict[str, Any]:
        """All numbers that `tripus parameterise --json` prints."""
        return dict(self._facts)

    def distortion(self) -> dict[str, npt.NDArray[Any]]:
        """For each tetrahedron of the mesh [T]: `anisotropy`, the largest by the smallest stretch;
        `volume_ratio`, hyperbolic by Euclidean volume in units of the mean; `orientation`, -1 where
        it is turned over, exactly."""
        return {
            "anisotropy": self._core.anisotropy(),
            "volume_ratio": self._core.volume_ratio(),
            "orientation": self._core.orientation(),
        }

    @checked
    def to_svg(self, cut_away: float = 0.5) -> str:
        """The solid in the colours of the manifold's tetrahedra; the part `cut_away` of it, 0 to 1, is
        cut away on the viewer's side."""
        if not 0 <= cut_away <= 1:
            raise InvalidInput(f"to_svg(): cut_away is from 0 to 1, not {cut_away}")
        return self._core.to_svg(cut_away).decode()

    @checked
    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes x.vtu (VTK), x.html (a page with pictures) or x.svg."""
        name = os.fspath(path)
        for ending, text in (
            (".vtu", self._core.to_vtu),
            (".html", self._core.to_page),
            (".svg", lambda: self._core.to_svg(0.5)),
        ):
            if name.endswith(ending):
                _core.write_file(as_bytes(name), text())
                return
        raise InvalidInput(f"{name!r}: the name must end with .vtu, .html or .svg")

    def __repr__(self) -> str:
        facts = self._facts
        return (
            f"<Parameterisation of {facts['tetrahedra']} tetrahedra onto volume "
            f"{facts['manifold_volume']:.6g}, energy {facts['energy']:.6g}>"
        )


@checked
def parameterise(
    mesh: Any,
    *,
    weights: str = "finite-elements",
    method: str = "newton",
    tolerance: float = 1e-11,
    tetrahedra: int = 0,
    refine: int = 0,
    seed: int = 0,
    time_limit: float | None = None,
    progress: Progress = None,
) -> Parameterisation:
    """The harmonic map of a solid onto its hyperbolic manifold.

    mesh        a file (surface or tetrahedral mesh), a mesh of meshio, trimesh or PyVista, or
                points [n x 3] with triangles [m x 3] or tetrahedra [m x 4]
    weights     of the edges: "finite-elements", "cotangent" (the same, raised where they are not
                positive), or "uniform"
    method      "newton", "ceres", or "descent" for comparison
    tolerance   on the largest entry of the gradient
    tetrahedra  fill a surface with about so many; 0: with few, or a quarter of `refine`
    refine      then bisect edges that the map makes long, until there are so many

    Raises InvalidInput for a ball, Unsupported for a torus in the boundary and where no metric is
    found.
    """
    one_of("parameterise", "weights", weights, ("finite-elements", "cotangent", "uniform"))
    one_of("parameterise", "method", method, ("newton", "ceres", "descent"))
    if not tolerance > 0 or tetrahedra < 0 or refine < 0:
        raise InvalidInput("tolerance is > 0, and tetrahedra and refine are >= 0")
    options = (weights, method, tolerance, tetrahedra, refine, seed)
    limit = limits(time_limit, 0, progress)
    if isinstance(mesh, (str, os.PathLike)):
        return _made((as_bytes(os.fspath(mesh)),), options, limit)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        points = real_array("points", mesh[0])
        cells = whole_array("cells", mesh[1], 0xFFFFFFFE, np.uint32)
    elif interop.package_of(mesh) in interop.MESH_PACKAGES:
        points, cells = interop.mesh_arrays(mesh)
    else:
        raise InvalidInput(
            f"a solid cannot be made from a {type(mesh).__name__}: give the name of a file, a mesh "
            "of another package, or points and cells"
        )
    if points.ndim != 2 or cells.ndim != 2:
        raise InvalidInput("points are an array [n x 3], cells [m x 3] or [m x 4]")
    return _made((points, cells), options, limit)


def _made(mesh: tuple[Any, ...], options: tuple[Any, ...], limit: Any = None) -> Parameterisation:
    """Of a file, or of points and cells."""
    limit = limits(None, 0, None) if limit is None else limit
    make: Any = _core.parameterise_file if len(mesh) == 1 else _core.parameterise_mesh
    return Parameterisation(make(*mesh, *options, limit), (mesh, options))
