"""The metric that a triangulation carries, and its cells in hyperbolic space."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._check import checked
from tripus._limits import Progress, limits
from tripus._value import Value
from tripus._errors import InvalidInput
from tripus.arcs import BasmajianDiscs, Orthospectrum, ReturnPath
from tripus.verdicts import Verdict, Volume

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np


@checked
class Metric(Value):
    """The complete hyperbolic metric with totally geodesic boundary (curvature -1).

    Arrays are read-only views into the library's memory: no copies.

    >>> import tripus
    >>> metric = tripus.Manifold("cPcbbbihq").metric
    >>> metric.edge_lengths.round(9).tolist(), metric.dihedral_angles.shape
    ([0.596133895], (2, 6))
    """

    __slots__ = ("_core", "_manifold")

    def __init__(self, core: _core.Metric, manifold: Manifold) -> None:
        self._core = core
        self._manifold = manifold

    def __reduce__(self) -> tuple[Any, ...]:
        return _metric_of, (self._manifold,)

    def _key(self) -> Any:
        return self._manifold, self.edge_lengths

    @property
    def manifold(self) -> Manifold:
        """The manifold whose metric it is."""
        return self._manifold

    @property
    def volume(self) -> Volume:
        """Hyperbolic volume; `volume.error` is a proved bound on what it is off."""
        return Volume(self._core.volume(), self)

    @property
    def edge_lengths(self) -> npt.NDArray[np.float64]:
        """[E] lengths of the edge classes between the truncating planes, > 0; at cusps from the
        horospheres of area sqrt(3)/2."""
        return self._core.edge_lengths()

    @property
    def dihedral_angles(self) -> npt.NDArray[np.float64]:
        """[T x 6] radians, in (0, pi), at the edges 01 02 03 12 13 23."""
        return self._core.dihedral_angles()

    @property
    def max_curvature(self) -> float:
        """max |K|, radians: how far the angles around an edge are from 2 pi at most."""
        return self._core.max_curvature()

    def verdict(self) -> Verdict:
        """How it was found."""
        return Verdict(self._core.report())

    def boundary(self) -> list[dict[str, Any]]:
        """[V] kind, Euler characteristic and area of each boundary component and cusp."""
        return self.verdict().vertices

    def embedding(self) -> dict[str, npt.NDArray[np.float64]]:
        """The tetrahedra in the hyperboloid model, x^2 + y^2 + z^2 - t^2, time last.

        vertices       [T x 4 x 4]     unit spacelike, poles of the truncating planes; null at an ideal
                                       vertex, with the horosphere <x, v> = -1; a point if finite
        faces          [T x 4 x 4]     outward unit normals of the faces
        face_pairings  [T x 4 x 4 x 4] the isometry that carries the neighbour across each face,
                                       from its frame to its place beside the tetrahedron
        """
        vertices, faces, pairings = self._core.embedding()
        return {"vertices": vertices, "faces": faces, "face_pairings": pairings}

    def holonomy(self) -> dict[str, Any]:
        """Generators of the fundamental group as isometries, in the frame of tetrahedron 0.

        The generators are those of `fundamental_group(simplify_presentation=False)`; around singular
        edges relators are powers.

        isometries  [g x 4 x 4]  in O+(3,1)
        moebius     [g x 2 x 2]  complex, determinant 1, up to sign; of the conjugate where
        reverses    [g]          says so
        defect, bound, holds     how far relators are from the identity, and whether double
                                 precision holds the representation
        """
        names = ("isometries", "moebius", "reverses", "rounding", "defect", "bound", "holds")
        return dict(zip(names, self._core.holonomy()))

    def isometry_of_word(
        self, letters: Sequence[int]
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.complex128], bool]:
        """The isometry of a word in the generators of `holonomy()`: 1, 2, ... and negatives.

        A matrix [4 x 4] in O+(3,1), a Moebius map [2 x 2], and whether that is of the conjugate.
        By products in a hundred digits: both are in their groups to rounding of their entries,
        however far the word goes on its way.
        """
        matrices, moebius, reverses = self._core.isometry_of_word(list(letters))
        return matrices[0], moebius, bool(reverses)

    def orthospectrum(
        self,
        *,
        length: float | None = None,
        count: int | None = None,
        most_arcs: float = 1e8,
        prove: bool = False,
        time_limit: float | None = None,
        threads: int = 0,
        progress: Progress = None,
    ) -> Orthospectrum:
        """All arcs orthogonal to the boundary up to a length, or the shortest `count`.

        prove  also intervals in which the lengths are proved to lie: proved_lengths
        """
        if (length is None) == (count is None) or 0 in (length, count):
            raise InvalidInput("give one of length= and count=, more than 0")
        limit = limits(time_limit, threads, progress)
        return Orthospectrum(
            self._core.orthospectrum(length or 0.0, count or 0, most_arcs, prove, limit)
        )

    def shortest_return_path(self) -> ReturnPath:
        """The shortest arc orthogonal to the boundary at both ends (Kojima's and Miyamoto's).

        >>> import tripus
        >>> tripus.Manifold("cPcbbbihq").metric.shortest_return_path()
        <ReturnPath of length 0.596133894891>
        """
        return ReturnPath(self.orthospectrum(count=1))

    def basmajian_discs(
        self,
        length: float = 4.0,
        *,
        most_arcs: float = 1e7,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> BasmajianDiscs:
        """The discs on the boundary around the feet of all arcs up to a length.

        A normal to the boundary that starts in the disc of an arc runs into the plane in which
        the arc ends. The discs of all arcs fill the boundary (Basmajian's identity).

        >>> import tripus
        >>> discs = tripus.Manifold("cPcbbbihq").metric.basmajian_discs(4)
        >>> discs, round(discs.area / discs.boundary_area, 3)
        (<BasmajianDiscs: 58 discs of arcs up to length 4, 94.8 % of the boundary>, 0.948)
        """
        limit = limits(time_limit, 0, progress)
        return BasmajianDiscs(self._core.discs(length, most_arcs, limit), self)

    def universal_cover(
        self,
        cells: int = 20,
        *,
        depth: int | None = None,
        radius: float | None = None,
        root: int = 0,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> CellComplex:
        """The nearest cells of the universal cover, at most so many, so deep, so far away.

        Unsupported where a cone angle is not 2 pi / n.
        """
        core = self._core.universal_cover(
            cells, depth, radius, root, limits(time_limit, 0, progress)
        )
        return CellComplex(core, self, (cells, depth, radius, root))

    def fundamental_domain(self) -> CellComplex:
        """Each tetrahedron once."""
        return CellComplex(self._core.fundamental_domain(), self, None)

    def __repr__(self) -> str:
        return f"<Metric of {self._manifold}: volume {self.volume}, max|K| {self.max_curvature:.2g}>"

    def _rows(self) -> dict[str, str]:
        lengths = self.edge_lengths
        return {
            "metric of": str(self._manifold),
            "volume": f"{float(self.volume):.13g}",
            "edges": f"{len(lengths)}, {lengths.min():.6g} to {lengths.max():.6g} long",
            "max|K|": f"{self.max_curvature:.3g}",
        }

    def _picture(self) -> str:
        return self._manifold._picture()


def _metric_of(manifold: Manifold) -> Metric:
    return manifold.metric


def _cells_of(metric: Metric, asked: Any) -> CellComplex:
    if asked is None:
        return metric.fundamental_domain()
    cells, depth, radius, root = asked
    return metric.universal_cover(cells, depth=depth, radius=radius, root=root)


@checked
class CellComplex(Value):
    """Cells of the universal cover, nearest to the first tetrahedron first.

    >>> import tripus
    >>> cells = tripus.Manifold("cPcbbbihq").metric.universal_cover(10)
    >>> cells, int(cells.depths.max()), cells.isometries.shape
    (<CellComplex: 10 cells>, 2, (10, 4, 4))
    >>> points, triangles = cells.mesh("klein")[:2]
    >>> bool((points**2).sum(axis=1).max() < 1)
    True
    """

    def __init__(self, core: _core.CellComplex, metric: Metric, asked: Any) -> None:
        self._core = core
        self._metric = metric
        self._asked = asked
        self.tetrahedra, self.depths, self.parents, self.isometries, self.end = core.cells()

    def __reduce__(self) -> tuple[Any, ...]:
        return _cells_of, (self._metric, self._asked)

    def _key(self) -> Any:
        return self._metric, self._asked, len(self)

    def _rows(self) -> dict[str, str]:
        return {
            "cells": str(len(self)),
            "of": str(self._metric.manifold),
            "depth": str(int(self.depths.max())),
        }

    def _picture(self) -> str:
        return self._metric._picture()

    def __len__(self) -> int:
        return self._core.size()

    def mesh(
        self, model: str = "ball", error: float = 1e-2, *, time_limit: float | None = None
    ) -> tuple[npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any]]:
        """The cells as closed surfaces: points [P x 3], triangles [F x 3], cell and side [F].

        model is "ball" (Poincare), "klein" or "upper"; error is how far the triangles may lie from
        the surfaces that they stand for. Sides 0 to 3 are faces, 4 to 7 truncations.
        """
        return self._core.mesh(model, error, limits(time_limit))

    def write(
        self, path: str | os.PathLike[str], model: str = "ball", error: float = 1e-2
    ) -> int:
        """Writes .obj, .ply, .vtk, .off, ...; the number of cells written. Whole or not at all."""
        return self._core.write(os.fsencode(path), model, error, limits())

    def to_pyvista(self, model: str = "ball", error: float = 1e-2) -> Any:
        """A pyvista.PolyData with the arrays cell, tetrahedron and side."""
        import pyvista

        points, triangles, cells, sides = self.mesh(model, error)
        surface = pyvista.PolyData.from_regular_faces(points, triangles)
        surface.cell_data["cell"] = cells
        surface.cell_data["tetrahedron"] = self.tetrahedra[cells]
        surface.cell_data["side"] = sides
        return surface

    def to_trimesh(self, model: str = "ball", error: float = 1e-2) -> Any:
        """A trimesh.Trimesh, with nothing merged."""
        import trimesh

        points, triangles, _, _ = self.mesh(model, error)
        return trimesh.Trimesh(points, triangles, process=False)

    def to_meshio(self, model: str = "ball", error: float = 1e-2) -> Any:
        """A meshio.Mesh with cell data."""
        import meshio

        points, triangles, cells, sides = self.mesh(model, error)
        data = {"cell": [cells], "tetrahedron": [self.tetrahedra[cells]], "side": [sides]}
        return meshio.Mesh(points, [("triangle", triangles)], cell_data=data)

    def __repr__(self) -> str:
        return f"<CellComplex: {len(self)} cells>"
