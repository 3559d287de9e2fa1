"""There and back: SnapPy, Regina, meshio, trimesh, PyVista.

None of them is imported before it is needed, and none is needed: objects are recognised by the
name of the package that their class comes from.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._check import real_array, whole_array
from tripus._errors import InvalidInput, Unsupported
from tripus._limits import NO_LIMITS

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold

    Points = npt.NDArray[np.float64]
    Cells = npt.NDArray[np.uint32]
else:
    from tripus._lazy import numpy as np

MESH_PACKAGES = ("meshio", "trimesh", "pyvista", "vtkmodules", "vtk")


def package_of(thing: object) -> str:
    """The package of the first base class that is one of those known here; or ""."""
    known = ("snappy", "SnapPy", "SnapPyHP", "spherogram", "regina", *MESH_PACKAGES)
    for base in type(thing).__mro__:
        package = (base.__module__ or "").partition(".")[0]
        if package in known:
            return package
    return ""


def from_snappy(triangulation: Any) -> _core.Manifold:
    """A snappy.Triangulation, Manifold or ManifoldHP, with its name.

    Unsupported for Dehn fillings: M.filled_triangulation() makes a triangulation of them. The
    orientation is SnapPy's.
    """
    if hasattr(triangulation, "exterior"):  # a link
        triangulation = triangulation.exterior()
    fillings = [info for info in triangulation.cusp_info() if not info["complete?"]]
    if fillings:
        raise Unsupported(
            f"{triangulation} has Dehn fillings; give its filled_triangulation()"
        )
    text = triangulation._to_string()
    core = _core.from_text(text.encode("utf-8", "replace"), False, NO_LIMITS)
    return core


def require_plain(manifold: Manifold, package: str) -> None:
    """Unsupported for cone angles, which no triangulation of another package has."""
    if manifold._core.is_labelled():
        raise Unsupported(
            f"{manifold} has cone angles other than 2 pi, which {package} does not know at edges; "
            "with_cone_angles() is the manifold without them"
        )


def to_snappy(manifold: Manifold) -> Any:
    """A snappy.Manifold; where there are finite vertices, a snappy.Triangulation that keeps them.

    Unsupported where a vertex link is neither a torus, a Klein bottle nor a sphere: SnapPea's
    kernel accepts some of those and is not safe afterwards.
    """
    import snappy

    require_plain(manifold, "SnapPy")
    for vertex, (chi, orientable, kind, *_) in enumerate(manifold._core.links()):
        if kind == "geodesic" or (chi > 0 and chi != 2):
            raise Unsupported(
                f"vertex class {vertex} has a link of Euler characteristic {chi}: SnapPy knows "
                "cusps and finite vertices only. Regina knows such manifolds: to_regina()"
            )
    if not manifold.is_connected():
        raise Unsupported("SnapPy knows connected triangulations only; see components()")
    text = _core.to_text(manifold._core, "snappea").decode("utf-8", "replace")
    if any(chi == 2 for chi, *_ in manifold._core.links()):
        made = snappy.Triangulation(text, remove_finite_vertices=False)
    else:
        made = snappy.Manifold(text)
    made.set_name(str(manifold))
    return made


def from_regina(triangulation: Any) -> _core.Manifold:
    """A regina.Triangulation3 or SnapPeaTriangulation; open faces are coned off.

    Unsupported for Dehn fillings.
    """
    if hasattr(triangulation, "countCompleteCusps"):
        if triangulation.isNull():
            raise InvalidInput("the SnapPeaTriangulation is null")
        if triangulation.countFilledCusps() > 0:
            raise Unsupported(
                "the SnapPeaTriangulation has Dehn fillings; give its filledAll()"
            )
    if not hasattr(triangulation, "tetrahedra"):
        raise InvalidInput(f"a regina {type(triangulation).__name__} is no triangulation")
    table = []
    for tetrahedron in triangulation.tetrahedra():
        row: list[Any] = []
        for face in range(4):
            other = tetrahedron.adjacentTetrahedron(face)
            if other is None:
                row.append(None)
            else:
                row.append([other.index(), str(tetrahedron.adjacentGluing(face))])
        table.append(row)
    label = getattr(triangulation, "label", None)
    return from_table(table, str(label()) if callable(label) else "")


def from_table(table: Any, name: str = "") -> _core.Manifold:
    """A gluing table: for the faces 0 to 3 of each tetrahedron [other, "1230"], None where open."""
    import json

    try:
        text = json.dumps({"name": name, "gluings": table}, default=_plain)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"this is no gluing table: {error}") from None
    return _core.from_text(text.encode("utf-8", "backslashreplace"), True, NO_LIMITS)


def _plain(thing: Any) -> Any:
    if isinstance(thing, np.integer):
        return int(thing)
    if isinstance(thing, np.ndarray):
        return thing.tolist()
    raise TypeError(f"{thing!r} is neither a number nor a permutation such as '1230'")


def to_regina(manifold: Manifold) -> Any:
    """A regina.Triangulation3 with the same labels."""
    import regina

    require_plain(manifold, "Regina")

    neighbours, images = manifold._core.arrays()
    made = regina.Triangulation3()
    tetrahedra = made.newTetrahedra(len(neighbours)) if len(neighbours) else []
    back = 0
    for t, (row, four) in enumerate(zip(neighbours.tolist(), images.tolist())):
        for face in range(4):
            other, image = row[face], four[face]
            back = image[face]
            if (other, back) > (t, face):
                tetrahedra[t].join(face, tetrahedra[other], regina.Perm4(*image))
    return made


def mesh_arrays(mesh: Any) -> tuple[Points, Cells]:
    """Points and triangles, or tetrahedra where there are any, of a mesh of another package."""
    package = package_of(mesh)
    if package == "meshio":
        return _from_meshio(mesh)
    if package == "trimesh":
        if not hasattr(mesh, "faces"):
            mesh = mesh.to_geometry() if hasattr(mesh, "to_geometry") else mesh.dump(True)
        return _arrays(mesh.vertices, mesh.faces)
    if package in ("pyvista", "vtkmodules", "vtk"):
        return _from_pyvista(mesh)
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return _arrays(*mesh)
    raise InvalidInput(
        f"{type(mesh).__name__} is no mesh that is known here: give a meshio.Mesh, a "
        "trimesh.Trimesh, a pyvista mesh, (points, cells) or the name of a file"
    )


def _arrays(points: Any, cells: Any) -> tuple[Points, Cells]:
    places = real_array("points", points)
    numbers = whole_array("points of cells", cells, max(len(np.atleast_1d(places)) - 1, 0), np.uint32)
    if places.ndim != 2 or numbers.ndim != 2:
        raise InvalidInput("points are an array [n x 3], cells one [m x 3] or [m x 4]")
    return places, numbers


def _from_meshio(mesh: Any) -> tuple[Points, Cells]:
    kinds = {"tetra": [], "triangle": [], "quad": [], "polygon": []}  # type: dict[str, list[Any]]
    for block in mesh.cells:
        kind = "polygon" if block.type.startswith("polygon") else block.type
        if kind in kinds:
            kinds[kind].append(np.asarray(block.data))
        elif kind not in ("vertex", "line"):
            raise Unsupported(f"meshio's cells of type {block.type} are no triangles or tetrahedra")
    points = np.asarray(mesh.points)
    if points.ndim == 2 and points.shape[1] > 3:
        points = points[:, :3]  # meshio 5.3 takes the colours of .obj vertices for coordinates
    if kinds["tetra"]:
        return _arrays(points, np.concatenate(kinds["tetra"]))
    triangles = [t for t in kinds["triangle"]]
    for block in kinds["quad"] + kinds["polygon"]:
        triangles += [_fan(np.asarray(polygon)) for polygon in block]
    if not triangles:
        raise InvalidInput("the mesh has neither triangles nor tetrahedra")
    return _arrays(points, np.concatenate(triangles))


def _fan(polygon: Any) -> Any:
    return np.array([[polygon[0], polygon[i], polygon[i + 1]] for i in range(1, len(polygon) - 1)])


def _from_pyvista(mesh: Any) -> tuple[Points, Cells]:
    import pyvista

    mesh = pyvista.wrap(mesh)
    if isinstance(mesh, pyvista.PolyData):
        surface = mesh.triangulate()
        return _arrays(surface.points, surface.regular_faces)
    if isinstance(mesh, pyvista.UnstructuredGrid):
        cells: dict[Any, Any] = dict(mesh.cells_dict)
        if pyvista.CellType.TETRA in cells:
            return _arrays(mesh.points, cells[pyvista.CellType.TETRA])
        return _from_pyvista(mesh.extract_surface(algorithm="dataset_surface"))
    raise InvalidInput(f"a pyvista {type(mesh).__name__} is no surface and no tetrahedral mesh")


def read_by_meshio(path: str) -> tuple[Points, Cells] | None:
    """A mesh file that tripus does not read itself; None without meshio or if it cannot either.

    meshio ends the process on some files, which is caught here.
    """
    try:
        import meshio
    except ImportError:
        return None
    try:
        return _from_meshio(meshio.read(path))
    except (Exception, SystemExit):
        return None
