"""Arcs orthogonal to the boundary: the orthospectrum, the shortest return path, Basmajian's discs."""

from __future__ import annotations

import base64
import math
from typing import TYPE_CHECKING, Any

from tripus._check import checked
from tripus._lazy import load
from tripus._limits import limits
from tripus._value import Value

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.metric import Metric
else:
    from tripus._lazy import numpy as np


class Orthospectrum(Value):
    """Lengths of the geodesic arcs orthogonal to the boundary at both ends, with multiplicities.

    >>> import tripus
    >>> arcs = tripus.Manifold("cPcbbbihq").orthospectrum(length=2)
    >>> float(arcs.lengths[0]).__round__(9), int(arcs.multiplicities[0]), arcs.complete
    (0.596133895, 1, True)
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    def _key(self) -> Any:
        return self._fields

    def _rows(self) -> dict[str, str]:
        rows = {"arcs": f"{self.arc_count} up to length {self.length:.6g}"}
        for length, n in list(zip(self.lengths, self.multiplicities))[:8]:
            rows[f"{length:.12g}"] = str(n)
        if len(self.lengths) > 8:
            rows["..."] = f"{len(self.lengths) - 8} more lengths"
        return rows

    def _picture(self) -> str:
        return stems(self.lengths.tolist(), self.multiplicities.tolist())

    @property
    def complete(self) -> bool:
        """False if a stop or a time limit ended the search; all up to `length` are there."""
        return bool(self._fields["complete"])

    @property
    def length(self) -> float:
        """All arcs up to this length are there."""
        return float(self._fields["length"])

    @property
    def arc_count(self) -> int:
        """Number of arcs."""
        return int(self._fields["arc_count"])

    @property
    def lengths(self) -> npt.NDArray[np.float64]:
        """[n] lengths, ascending."""
        return self._fields["lengths"]  # type: ignore[no-any-return]

    @property
    def multiplicities(self) -> npt.NDArray[np.uint64]:
        """[n] how many arcs have this length between these boundary components."""
        return self._fields["multiplicities"]  # type: ignore[no-any-return]

    @property
    def ends(self) -> npt.NDArray[np.uint32]:
        """[n x 2] the boundary components."""
        return self._fields["ends"]  # type: ignore[no-any-return]

    @property
    def edges(self) -> list[list[int]]:
        """[n] the edge classes among them."""
        return [list(e) for e in self._fields["edges"]]

    @property
    def area(self) -> dict[str, Any]:
        """Basmajian's identity: counted, exact, tail (value, uncertainty)."""
        return dict(self._fields["area"])

    @property
    def volume(self) -> dict[str, Any]:
        """Bridgeman and Kahn's identity: counted, exact, tail (value, uncertainty)."""
        return dict(self._fields["volume"])

    @property
    def volume_from_area(self) -> tuple[float, float] | None:
        """The volume by the arcs and the area of the boundary alone, with its uncertainty."""
        return self._fields["volume_from_area"]  # type: ignore[no-any-return]

    @property
    def return_time(self) -> tuple[Any, Any]:
        """Mean over the boundary of the time that the normal flow takes to come back, and of its
        square (Vlamis): (value, uncertainty) each, or None."""
        return self._fields["return_time"]  # type: ignore[no-any-return]

    @property
    def proved_lengths(self) -> list[tuple[float, float] | None] | None:
        """[n] intervals of the lengths, of orthospectrum(prove=True); None where not proved."""
        return self._fields.get("proved_lengths")

    @property
    def dimension(self) -> tuple[float, float] | None:
        """Hausdorff dimension of the limit set, with its uncertainty; None for few arcs."""
        return self._fields["dimension"]  # type: ignore[no-any-return]

    def to_frame(self) -> Any:
        """A pandas data frame: length, multiplicity, from, to."""
        return load("pandas").DataFrame(
            {
                "length": self.lengths,
                "multiplicity": self.multiplicities,
                "from": self.ends[:, 0],
                "to": self.ends[:, 1],
            }
        )

    def __repr__(self) -> str:
        return f"<Orthospectrum: {self.arc_count} arcs up to length {self.length:.6g}>"


class ReturnPath(Value):
    """The shortest arcs orthogonal to the boundary at both ends; float() is their length.

    >>> import tripus
    >>> path = tripus.Manifold("cPcbbbihq").shortest_return_path()
    >>> path.length.__round__(9), path.multiplicity, path.ends, path.edges
    (0.596133895, 1, (0, 0), [0])
    """

    def __init__(self, shortest: Orthospectrum) -> None:
        self._length = float(shortest.lengths[0])
        first, second = shortest.ends[0].tolist()
        # Arcs of one length may join other components: all of them are shortest.
        same = np.flatnonzero(np.abs(shortest.lengths - self._length) < 1e-9).tolist()
        self._multiplicity = int(sum(shortest.multiplicities[same].tolist()))
        self._ends = (first, second)
        self._edges = sorted(e for i in same for e in shortest.edges[i])

    def _key(self) -> Any:
        return self._length, self._multiplicity, self._ends, self._edges

    def _rows(self) -> dict[str, str]:
        return {
            "shortest return path": f"{self._length:.12g}",
            "arcs": str(self._multiplicity),
            "ends": f"components {self._ends[0]} and {self._ends[1]}",
            "edge classes": ", ".join(map(str, self._edges)),
        }

    @property
    def length(self) -> float:
        """Its length; half of it is the height of the widest collar of the boundary, if the two
        ends are on one component or the boundary has but one."""
        return self._length

    @property
    def multiplicity(self) -> int:
        """How many arcs have this length."""
        return self._multiplicity

    @property
    def ends(self) -> tuple[int, int]:
        """The boundary components (vertex classes) at the ends of the first."""
        return self._ends

    @property
    def edges(self) -> list[int]:
        """The edge classes of the triangulation among them."""
        return list(self._edges)

    def __float__(self) -> float:
        return self._length

    def __repr__(self) -> str:
        return f"<ReturnPath of length {self._length:.12g}>"


@checked
class BasmajianDiscs(Value):
    """Discs on the boundary around the feet of arcs, two for each arc: Calegari's leopard spots.

    tiles    [n x 2] tetrahedron and vertex of the truncation triangle where the foot lies
    feet     [n x 2] the foot in the projective model of that triangle's plane, its middle at 0
    lengths  [n] of the arcs
    radii    [n] log coth(length / 2)
    """

    def __init__(self, found: tuple[Any, ...], metric: Metric) -> None:
        self._found = found
        self._metric = metric
        self.tiles, self.feet, self.lengths, self.radii, self.length = found

    def __reduce__(self) -> tuple[Any, ...]:
        return BasmajianDiscs, (self._found, self._metric)

    def _key(self) -> Any:
        return self._found, self._metric

    def __len__(self) -> int:
        return len(self.lengths)

    @property
    def areas(self) -> npt.NDArray[np.float64]:
        """[n] areas of the discs, 2 pi (cosh radius - 1)."""
        areas: npt.NDArray[np.float64] = 4 * math.pi * np.sinh(self.radii / 2) ** 2
        return areas

    @property
    def area(self) -> float:
        """Of all discs together."""
        return float(self.areas.sum())

    @property
    def boundary_area(self) -> float:
        """Of the boundary, -2 pi times its Euler characteristic."""
        boundary = self._metric.boundary()
        return float(sum(v["area"] for v in boundary if v["kind"] == "geodesic"))

    def svg(self, *, time_limit: float | None = None) -> str:
        """The picture: each component of the boundary in the Poincare disc, covered by the discs."""
        return self._metric._core.spots_svg(self.length, limits(time_limit))

    def _rows(self) -> dict[str, str]:
        return {
            "discs": f"{len(self)}, of arcs up to length {self.length:.6g}",
            "area": f"{self.area:.9g} of {self.boundary_area:.9g}",
        }

    def _picture(self) -> str:
        svg = self.svg()
        if len(svg) > 2_000_000:
            return ""
        data = base64.b64encode(svg.encode()).decode()
        return f'<img alt="discs" width="320" src="data:image/svg+xml;base64,{data}">'

    def __repr__(self) -> str:
        share = self.area / self.boundary_area
        return (
            f"<BasmajianDiscs: {len(self)} discs of arcs up to length {self.length:.6g}, "
            f"{100 * share:.3g} % of the boundary>"
        )


def stems(lengths: list[float], counts: list[int], width: int = 240, height: int = 120) -> str:
    """A small picture of a spectrum: a line for each length, its height by the multiplicity."""
    if not lengths:
        return ""
    top = math.log(max(counts) + 1)
    lines = []
    for length, count in list(zip(lengths, counts))[:2000]:
        x = 5 + (width - 10) * length / lengths[-1]
        y = height - 18 - (height - 24) * math.log(count + 1) / top
        lines.append(f"M{x:.1f} {height - 18}V{y:.1f}")
    return (
        f'<svg width="{width}" height="{height}" viewBox="0 0 {width} {height}">'
        f'<path d="{"".join(lines)}" stroke="#0072B2" fill="none"></path>'
        f'<path d="M5 {height - 18}H{width - 5}" stroke="#888888" fill="none"></path>'
        f'<text x="5" y="{height - 4}" font-size="11">0</text>'
        f'<text x="{width - 5}" y="{height - 4}" font-size="11" text-anchor="end">'
        f"length {lengths[-1]:.3g}</text></svg>"
    )
