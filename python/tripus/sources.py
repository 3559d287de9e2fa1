"""What manifolds are made from."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from tripus import _core, interop
from tripus._core import Manifold as CoreManifold
from tripus._check import as_bytes, real_array, shown, whole_array
from tripus._errors import FileError, InvalidInput
from tripus._limits import Progress, limits
from tripus.diagrams import Diagram

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
else:
    from tripus._lazy import numpy as np


def polylines_of(lines: Any) -> list[npt.NDArray[np.float64]]:
    """The polylines of a drawing, [n x 3] each; TypeError or InvalidInput for what is none."""
    wanted = "a drawing is a list of polylines, each an array [n x 3]"
    if isinstance(lines, bytes) or not isinstance(lines, Iterable):
        raise TypeError(f"{wanted}, not {shown(lines)}")
    polylines = [real_array(f"points of polyline {i}", line) for i, line in enumerate(lines)]
    if not polylines or any(line.ndim != 2 or line.shape[1] != 3 for line in polylines):
        raise InvalidInput(wanted)
    return polylines


def surface_of_drawing(
    drawing: Any, *, time_limit: float | None = None, progress: Progress = None
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
    """Points and triangles of the surface around a drawing; see Manifold.from_drawing."""
    if isinstance(drawing, (str, os.PathLike)):
        text = _core.read_file(as_bytes(drawing))
    elif isinstance(drawing, Mapping):
        try:
            text = json.dumps(dict(drawing)).encode()
        except (TypeError, ValueError) as error:
            raise InvalidInput(f"the drawing is no JSON: {error}") from None
    else:
        text = "\n\n".join(
            "\n".join(" ".join(map(repr, p)) for p in line.tolist())
            for line in polylines_of(drawing)
        ).encode()
    points, triangles = _core.tube_around(text, limits(time_limit, 0, progress))
    return points, triangles


def load_text(source: str, time_limit: float | None, progress: Progress) -> CoreManifold:
    encoded = as_bytes(source)
    if source.lstrip().startswith("PD"):
        source = " ".join(source.split())  # a planar diagram, perhaps on several lines
    if source.startswith(("% Triangulation", "% orb", "<?xml", '{"')) or "\n" in source:
        return _core.from_text(encoded, True, limits(time_limit, 0, progress))
    try:
        return _core.load(os.fsencode(source), limits(time_limit, 0, progress))
    except InvalidInput as error:
        if "is a SnapPy name" in str(error):
            raise InvalidInput(
                f"{shown(source)} is a SnapPy name: tripus.Manifold(snappy.Manifold({source!r}))"
            ) from None
        mesh = interop.read_by_meshio(source) if os.path.isfile(source) else None
        if mesh is None:
            raise
    points, cells = mesh
    core: CoreManifold
    core, _ = _core.from_mesh(
        points, cells, os.fsencode(source), 0, limits(time_limit, 0, progress)
    )
    return core


def load_thing(source: Any, time_limit: float | None, progress: Progress) -> CoreManifold:
    if isinstance(source, os.PathLike) and not os.path.exists(source):
        raise FileError(f"there is no file {shown(os.fspath(source))}")
    if isinstance(source, (str, os.PathLike)):
        return load_text(os.fsdecode(os.fspath(source)), time_limit, progress)
    if isinstance(source, Diagram):
        return source.exterior(time_limit=time_limit, progress=progress)._core
    package = interop.package_of(source)
    if package in ("snappy", "SnapPy", "SnapPyHP", "spherogram"):
        return interop.from_snappy(source)
    if package == "regina":
        return interop.from_regina(source)
    if package in interop.MESH_PACKAGES:
        points, cells = interop.mesh_arrays(source)
        core: CoreManifold
        core, _ = _core.from_mesh(points, cells, b"", 0, limits(time_limit, 0, progress))
        return core
    if isinstance(source, dict) and "gluings" in source:
        return interop.from_table(source["gluings"], str(source.get("name", "")))
    if isinstance(source, tuple) and len(source) == 2:
        neighbours = whole_array("neighbours", source[0], 0xFFFFFFFE, np.uint32)
        images = whole_array("images of vertices", source[1], 3, np.uint8)
        if neighbours.ndim == 2 and images.ndim == 3:
            return _core.from_arrays(neighbours, images, b"", b"", True, [])
    if isinstance(source, list):
        return interop.from_table(source)
    raise InvalidInput(
        f"a manifold cannot be made from a {type(source).__name__}: give a signature, the name of "
        "a file, a gluing table, or a triangulation or mesh of another package"
    )
