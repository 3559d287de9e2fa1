"""Plots by matplotlib. Each returns a figure, and draws into `ax` if that is given.

    tripus.plot.drawing(lines)         a knot, link or graph in space
    tripus.plot.valences(M)            edge classes by valence
    tripus.plot.spectrum(M, length=4)  the orthospectrum
    tripus.plot.convergence(M)         max|K| by iteration, for several methods
    tripus.plot.volumes(many)          the volumes of a list
"""

from __future__ import annotations

import functools
import io
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._check import as_bytes, checked, shown
from tripus._errors import InvalidInput
from tripus.arcs import Orthospectrum
from tripus.sources import polylines_of

if TYPE_CHECKING:
    import numpy as np

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np

#: Okabe and Ito's palette, as in the C++ figures and the viewer.
PALETTE = ("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#000000", "#F0E442")
_MARKERS = "osD^vPX*"
_DASHES = ("-", "--", "-.", ":")


@functools.cache
def _figure_class() -> Any:
    # Not pyplot: it keeps every figure, and picks a window system. But notebooks show pyplot's
    # figures only, so these say by themselves how.
    from matplotlib.figure import Figure

    class Plot(Figure):
        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            self.savefig(buffer, format="png", dpi=100)
            return buffer.getvalue()

    return Plot


def _axes(ax: Any, size: tuple[float, float] = (6, 3.6), **options: Any) -> Any:
    if ax is not None:
        return ax
    return _figure_class()(figsize=size, layout="constrained").add_subplot(**options)


def drawing(lines: Any, ax: Any = None) -> Any:
    """A knot, link or graph in space, as Manifold.from_drawing takes it.

    >>> figure = drawing([[(0, 0, 0), (1, 0, 0), (1, 1, 0)]])
    >>> len(figure.axes[0].lines)
    1
    """
    polylines = _polylines(lines)
    ax = _axes(ax, (4, 3.2), projection="3d")
    for i, line in enumerate(polylines):
        ax.plot(*line.T, color=PALETTE[i % len(PALETTE)], lw=2)
    ax.set_axis_off()
    ax.set_aspect("equal")
    return ax.figure


def _polylines(lines: Any) -> list[Any]:
    """The polylines of a drawing as Manifold.from_drawing takes it, each [n x 3]."""
    if isinstance(lines, (str, os.PathLike)):
        try:
            lines = json.loads(_core.read_file(as_bytes(lines)))
        except ValueError as error:
            raise InvalidInput(f"{shown(lines)} is no drawing in JSON: {error}") from None
    if isinstance(lines, Mapping):
        if "edges" not in lines:
            raise InvalidInput('a drawing as a dict has its polylines under "edges"')
        lines = lines["edges"]
    return polylines_of(lines)


@checked
def valences(manifold: Manifold, ax: Any = None) -> Any:
    """Edge classes by valence.

    >>> import tripus
    >>> figure = valences(tripus.Manifold("cPcbbbihq"))
    >>> [int(p.get_height()) for p in figure.axes[0].patches]
    [1]
    """
    ax = _axes(ax)
    counts = manifold.edge_valences()
    ax.bar(list(counts), list(counts.values()), color=PALETTE[0])
    ax.set(xlabel="valence", ylabel="edge classes", title=str(manifold))
    ax.yaxis.get_major_locator().set_params(integer=True)
    return ax.figure


@checked
def spectrum(arcs: Manifold | Orthospectrum, ax: Any = None, *, length: float = 4.0) -> Any:
    """Lengths of the arcs orthogonal to the boundary, with multiplicities; log scale."""
    if not isinstance(arcs, Orthospectrum):
        if not hasattr(arcs, "orthospectrum"):
            raise TypeError(f"spectrum(): arcs is a Manifold or an Orthospectrum, not {shown(arcs)}")
        arcs = arcs.orthospectrum(length=length)
    ax = _axes(ax)
    ax.vlines(arcs.lengths, 0.5, arcs.multiplicities.astype(float), color=PALETTE[0])
    ax.plot(arcs.lengths, arcs.multiplicities.astype(float), "o", color=PALETTE[0], ms=3)
    ax.set(xlabel="length", ylabel="arcs", yscale="log", title=repr(arcs).strip("<>"))
    return ax.figure


@checked
def convergence(
    manifold: Manifold, methods: str | Sequence[str] = ("newton",), ax: Any = None
) -> Any:
    """max|K| after each iteration of solving anew by each method, or by one; log scale."""
    methods = [methods] if isinstance(methods, str) else methods
    ax = _axes(ax)
    for i, method in enumerate(methods):
        history = manifold.solve(method, history=True).history
        ax.plot(
            history["iteration"],
            history["max_curvature"],
            marker=_MARKERS[i % len(_MARKERS)],
            ls=_DASHES[i % len(_DASHES)],
            ms=3,
            color=PALETTE[i % len(PALETTE)],
            label=method,
        )
    ax.set(xlabel="iteration", ylabel="max|K|", yscale="log", title=str(manifold))
    if methods:
        ax.legend(frameon=False)
    return ax.figure


@checked
def volumes(many: Any, ax: Any = None, *, bins: int = 60) -> Any:
    """The volumes of a list of manifolds, or of the frame that solve_many returns."""
    if hasattr(many, "columns") or getattr(many, "dtype", None) is not None:
        try:
            numbers = np.asarray(many["volume"] if _has_volume(many) else many, dtype=float)
        except (TypeError, ValueError):
            raise TypeError(f"volumes(): many has other things than numbers: {shown(many)}") from None
    else:
        from tripus.many import solve_many

        if isinstance(many, bytes) or not isinstance(many, (str, os.PathLike, Iterable)):
            raise TypeError(f"volumes(): many is a list of manifolds, not {shown(many)}")
        numbers = np.asarray(solve_many(many, as_array=True)["volume"])
    numbers = numbers[np.isfinite(numbers)]
    ax = _axes(ax)
    if len(numbers) == 0 or np.ptp(numbers) < 1e-9:
        bins = 1
    ax.hist(numbers, bins=bins, color=PALETTE[0])
    ax.set(xlabel="volume", ylabel="manifolds", title=f"{len(numbers)} volumes")
    return ax.figure


def _has_volume(many: Any) -> bool:
    names = getattr(getattr(many, "dtype", None), "names", None)
    return "volume" in (names if names is not None else list(getattr(many, "columns", ())))


def draw(figure: dict[str, Any], ax: Any = None) -> Any:
    """A figure of a study, from the description that the program draws as SVG."""
    ax = _axes(ax, (7, 4.2))
    for which in ("x", "y"):
        _set_axis(ax, which, figure[which])
    for i, series in enumerate(figure["series"]):
        _draw_series(ax, series, i)
    for vertical, at, label in figure["guides"]:
        (ax.axvline if vertical else ax.axhline)(at, color="#777777", ls="--", lw=1)
        if label:
            where = (at, 1) if vertical else (1, at)
            how = ax.get_xaxis_transform() if vertical else ax.get_yaxis_transform()
            ax.text(*where, f" {label}", transform=how, color="#555555", fontsize=8, va="top")
    if any(series["label"] for series in figure["series"]):
        ax.legend(frameon=False, fontsize=8)
    ax.set_title(figure["title"], fontsize=10)
    ax.figure.caption = figure["caption"]
    return ax.figure


def _set_axis(ax: Any, which: str, axis: dict[str, Any]) -> None:
    getattr(ax, f"set_{which}label")(axis["label"])
    if axis["log"]:
        getattr(ax, f"set_{which}scale")("log")
    if axis["categories"]:
        getattr(ax, f"set_{which}ticks")(range(len(axis["categories"])), axis["categories"])
    if axis["lower"] is not None or axis["upper"] is not None:
        getattr(ax, f"set_{which}lim")(axis["lower"], axis["upper"])


def _draw_series(ax: Any, series: dict[str, Any], number: int) -> None:
    colour_number = series["colour"] if series["colour"] >= 0 else number
    colour = PALETTE[colour_number % len(PALETTE)]
    points = np.array(series["points"], dtype=float).reshape(-1, 2)
    x, y = points[:, 0], points[:, 1]
    label = series["label"] or None
    if series["mark"] == "bar":
        base = np.array(series["base"] or [0.0] * len(x))
        steps = np.diff(np.unique(x))
        width = 0.8 * (steps.min() if len(steps) else 1.0)
        ax.bar(x, y - base, width, bottom=base, color=colour, label=label)
        return
    line = _DASHES[colour_number % len(_DASHES)] if "line" in series["mark"] else ""
    marker = _MARKERS[colour_number % len(_MARKERS)] if "point" in series["mark"] else ""
    ax.plot(x, y, ls=line or "none", marker=marker, ms=3, color=colour, label=label)
