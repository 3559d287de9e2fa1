"""Compact 3-manifolds with a triangulation: the front door."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tripus import _core, interop
from tripus._core import Manifold as CoreManifold
from tripus._errors import InvalidInput, NoMetric, Undecided, Unsupported
from tripus._limits import NO_LIMITS, Progress, limits
from tripus.answers import CanonicalDecomposition, CensusEntry, Comparison, Orthospectrum
from tripus.groups import AbelianGroup, FundamentalGroup, IsometryGroup
from tripus.metric import Metric
from tripus.sources import load_text, load_thing, surface_of_drawing
from tripus.verdicts import Proof, Verdict, Volume

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
else:
    from tripus._lazy import numpy as np

#: SnapPy's words for what was found.
_SOLUTION_TYPES = {
    "geometric": "all tetrahedra positively oriented",
    "degenerate": "contains flat tetrahedra",
    "infeasible": "no solution found",
    "unresolved": "unrecognized solution type",
}

#: Names of SnapPy and Regina that are called otherwise here.
_ELSEWHERE = {
    "simplify": "manifolds do not change: N = M.simplified()",
    "intelligentSimplify": "manifolds do not change: N = M.simplified()",
    "randomize": "manifolds do not change: N = M.relabelled(seed), or M.simplified(seed=...)",
    "canonize": "manifolds do not change: M.canonical(), M.canonical_retriangulation()",
    "reverse_orientation": "manifolds do not change: N = M.mirrored()",
    "set_name": "manifolds do not change: N = M.renamed(name)",
    "isoSig": "M.triangulation_isosig()",
    "sig": "M.triangulation_isosig()",
    "size": "M.num_tetrahedra()",
    "countTetrahedra": "M.num_tetrahedra()",
    "isOrientable": "M.is_orientable()",
    "fundamentalGroup": "M.fundamental_group()",
    "group": "M.fundamental_group()",
    "isIsomorphicTo": "M.isomorphisms_to(N)",
    "tetrahedra_shapes": "M.metric.edge_lengths, M.metric.dihedral_angles",
    "dehn_fill": "fill with SnapPy: tripus.Manifold(M.to_snappy().filled_triangulation())",
    "browse": "M.view()",
    "inside_view": "M.view()",
    "normal_surfaces": "M.to_regina(), regina.NormalSurfaces",
}


class Manifold:
    """A compact 3-manifold with a triangulation.

    A value: it does not change, can be hashed, compared, pickled, and used from several threads at
    once. Nothing is computed before it is first asked for, and then once.

    source  an isomorphism signature, with or without a sign for the orientation; the name of a
            file (gluing table, Regina, SnapPea, Orb, surface, tetrahedral mesh), FILE#LABEL for one
            of several triangulations in it; a planar diagram ("PD: V[1,3,4] X[5,9,6,10] ..."); a
            name of the tables of knots and graphs or of the census; a gluing table as lists, or as
            arrays (neighbours [T x 4], images [T x 4 x 4]); a triangulation of SnapPy or Regina; a
            mesh of meshio, trimesh or PyVista.
    name    what to call it, instead of the name in the source.

    InvalidInput, a ValueError, for anything else, with the place and the remedy; what of a source
    was mended comes as a warning (InputNote).

    >>> M = Manifold("cPcbbbihq")
    >>> M, M.num_tetrahedra(), M.volume()
    (cPcbbbihq, 2, 6.451990270835)
    >>> Manifold([[[1,"1230"],[1,"3012"],[1,"0321"],[1,"0213"]],
    ...           [[0,"1230"],[0,"3012"],[0,"0321"],[0,"0213"]]]) == M
    True
    >>> Manifold("hello")
    Traceback (most recent call last):
    ...
    tripus.InvalidInput: ...
    """

    __slots__ = ("_core", "__weakref__")
    _core: CoreManifold

    def __init__(
        self,
        source: Any,
        name: str | None = None,
        *,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> None:
        if isinstance(source, Manifold):
            core = source._core
        elif type(source) is str:
            core = load_text(source, time_limit, progress)
        else:
            core = load_thing(source, time_limit, progress)
        self._core = core if name is None else _renamed(core, name)

    @classmethod
    def _wrap(cls, core: CoreManifold) -> Manifold:
        self = object.__new__(cls)
        self._core = core
        return self

    @classmethod
    def from_text(cls, text: str | bytes, name: str | None = None) -> Manifold:
        """What the text of a file says, whatever format it has.

        >>> Manifold.from_text(Manifold("cPcbbbihq").to_text("snappea")) == Manifold("cPcbbbihq")
        True
        """
        given = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else text
        core = _core.from_text(given, True, NO_LIMITS)
        return cls._wrap(core if name is None else _renamed(core, name))

    @classmethod
    def from_mesh(
        cls,
        mesh: Any,
        name: str = "",
        *,
        seed: int = 0,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """The solid that a surface bounds, or that tetrahedra fill.

        mesh  a meshio.Mesh, a trimesh.Trimesh, a pyvista mesh, (points [n x 3], cells [m x 3] or
              [m x 4]), or the name of a file, which meshio reads if tripus does not.

        A boundary component of genus 1 or more becomes an ideal vertex, a sphere is filled in.
        Surfaces are filled with tetrahedra by the program tripus-tetgen.
        """
        if isinstance(mesh, (str, os.PathLike)):
            return cls(mesh, name or None, time_limit=time_limit, progress=progress)
        points, cells = interop.mesh_arrays(mesh)
        core, _ = _core.from_mesh(
            points, cells, os.fsencode(name), seed, limits(time_limit, 0, progress)
        )
        return cls._wrap(core)

    @classmethod
    def from_drawing(
        cls,
        drawing: Any,
        name: str = "",
        *,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """The outside of a knot, link or graph drawn in space with straight pieces.

        drawing  polylines, each [n x 3] points: where three or more ends meet is a vertex, a
                 polyline alone is closed up to a knot; or a dict or file as for `tripus tube`.

        >>> square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        >>> str(Manifold.from_drawing([square]).homology())
        'Z'
        """
        points, triangles = surface_of_drawing(drawing, time_limit=time_limit, progress=progress)
        return cls.from_mesh(
            (points, triangles), name, time_limit=time_limit, progress=progress
        )

    # What it is

    def name(self) -> str:
        """From the file or the caller; may be empty."""
        return os.fsdecode(self._core.name())

    def renamed(self, name: str) -> Manifold:
        """The same by another name."""
        return self._wrap(_renamed(self._core, name))

    def num_tetrahedra(self) -> int:
        """Number of tetrahedra."""
        return self._core.tetrahedron_count()

    def num_edges(self) -> int:
        """Number of edge classes."""
        return self._core.edge_count()

    def num_vertices(self) -> int:
        """Number of vertex classes."""
        return self._core.vertex_count()

    def num_cusps(self) -> int:
        """Number of cusps: vertex links that are tori or Klein bottles."""
        return sum(kind == "cusp" for _, _, kind, _ in self._core.links())

    def num_boundary_components(self) -> int:
        """Number of geodesic boundary components."""
        return sum(kind == "geodesic" for _, _, kind, _ in self._core.links())

    def is_orientable(self) -> bool:
        """Whether the manifold is orientable."""
        return self._core.is_orientable()

    def is_connected(self) -> bool:
        """Whether the triangulation is connected."""
        return self._core.component_count() <= 1

    def is_orientation_known(self) -> bool:
        """False for a signature without a sign, which says nothing about the orientation."""
        return self._core.is_orientation_known()

    def has_finite_vertices(self) -> bool:
        """Whether the link of some vertex is a sphere."""
        return any(kind == "finite" for _, _, kind, _ in self._core.links())

    def links(self) -> list[dict[str, Any]]:
        """[V] kind ("geodesic", "cusp", "finite"), Euler characteristic, orientability and number
        of triangles of the link of each vertex class.

        >>> Manifold("cPcbbbihq").links()[0]["euler_characteristic"]
        -2
        """
        return [
            {"kind": kind, "euler_characteristic": chi, "orientable": orientable, "triangles": n}
            for chi, orientable, kind, n in self._core.links()
        ]

    def edge_valences(self) -> dict[int, int]:
        """{valence: number of edge classes}.

        >>> Manifold("cPcbbbihq").edge_valences()
        {12: 1}
        """
        valences = self._core.valences()
        return {v: valences.count(v) for v in sorted(set(valences))}

    @property
    def valences(self) -> list[int]:
        """[E] the valence of each edge class."""
        return self._core.valences()

    @property
    def edge_classes(self) -> npt.NDArray[np.uint32]:
        """[T x 6] the edge class of the edges 01 02 03 12 13 23. A read-only view."""
        return self._core.edge_classes()

    @property
    def vertex_classes(self) -> npt.NDArray[np.uint32]:
        """[T x 4] the vertex class of each vertex. A read-only view."""
        return self._core.vertex_classes()

    @property
    def gluings(self) -> list[list[list[Any]]]:
        """The gluing table: for the faces 0 to 3 of each tetrahedron [other, permutation].

        >>> Manifold("cPcbbbihq+").gluings[0][0]
        [1, '0132']
        """
        neighbours, images = self._core.arrays()
        return [
            [[other, "".join(map(str, image))] for other, image in zip(row, four)]
            for row, four in zip(neighbours.tolist(), images.tolist())
        ]

    def gluing_arrays(self) -> tuple[npt.NDArray[np.uint32], npt.NDArray[np.uint8]]:
        """neighbours [T x 4] and images [T x 4 x 4]: vertex i of t goes to images[t, f, i]."""
        neighbours, images = self._core.arrays()
        return neighbours, images

    def triangulation_isosig(self, *, oriented: bool = False) -> str:
        """The isomorphism signature, Regina's; oriented=True adds the sign that keeps orientation.

        Undecided where it would take too long, or where the orientation is not known.

        >>> Manifold("cPcbbbihq-").triangulation_isosig(oriented=True)
        'cPcbbbihq-'
        """
        if not oriented:
            signature = self._core.signature()
            if signature is None:
                raise Undecided("the signature would take too long to compute", self)
            return signature
        signature = self._core.oriented_signature()
        if signature is None:
            raise Undecided(
                "there is no signature with a sign: not orientable, not connected, or the "
                "orientation is not known (is_orientation_known)",
                self,
            )
        return signature

    def homology(self) -> AbelianGroup:
        """First homology of the compact manifold.

        >>> Manifold("cPcbbbihq").homology()
        Z + Z
        """
        rank, factors = self._core.homology()
        return AbelianGroup(rank, [int(f) for f in factors])

    def fundamental_group(self, simplify_presentation: bool = True) -> FundamentalGroup:
        """The fundamental group; generators are crossings of faces, with their matrices."""
        return FundamentalGroup(self, simplify_presentation)

    # Other triangulations and manifolds

    def isomorphisms_to(self, other: Manifold) -> list[tuple[list[int], list[list[int]]]]:
        """[an isomorphism] (tetrahedron images, vertex images) of triangulations, or [].

        One is enough to know; the mirror image counts as the same, as in ==.
        """
        found: Any = self._core.isomorphism_to(other._core)
        return [] if found is None else [found]

    def mirrored(self) -> Manifold:
        """The mirror image."""
        return self._wrap(self._core.mirrored())

    def oriented(self) -> Manifold:
        """The same with labels that agree in orientation; unchanged if not orientable."""
        return self._wrap(self._core.oriented())

    def relabelled(self, seed: int = 0) -> Manifold:
        """The same triangulation with random labels."""
        return self._wrap(self._core.relabelled(seed))

    def simplified(
        self,
        *,
        seed: int = 0,
        effort: float = 1.0,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """The same manifold with as few tetrahedra as were found; finite vertices go."""
        return self._wrap(
            self._core.simplified(seed, effort, limits(time_limit, 0, progress))
        )

    def retriangulated(
        self,
        *,
        seed: int = 0,
        budget: int = 500,
        extra: int = 2,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """A triangulation of this manifold that carries the metric: this one, or one nearby.

        Where none is found, verdict() of the result says what was tried.
        """
        core = self._core.retriangulated(seed, budget, extra, limits(time_limit, 0, progress))
        return self._wrap(core)

    def covers(
        self,
        degree: int,
        *,
        cover_type: str = "all",
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> list[Manifold]:
        """The connected covers with so many sheets, one of each isomorphism class.

        cover_type  "all" or "cyclic". Two of them may still be the same manifold.

        Where the time is over, Undecided is raised; its `answer` is the list of those found.

        >>> len(Manifold("cPcbbbihq").covers(2)), len(Manifold("cPcbbbiht").covers(5))
        (3, 4)
        """
        if cover_type not in ("all", "cyclic"):
            raise InvalidInput(f"cover_type is 'all' or 'cyclic', not {cover_type!r}")
        search = self._core.covers if cover_type == "all" else self._core.cyclic_covers
        start = time.monotonic()
        found = search(degree, limits(time_limit, 0, progress))
        is_over = time_limit is not None and time.monotonic() - start >= time_limit
        kind = "cyc" if cover_type == "cyclic" else "cover"
        covers = [
            self._wrap(_renamed(core, f"{self}~{degree}~{kind}~{i}"))
            for i, core in enumerate(found)
        ]
        if is_over:
            raise Undecided(
                f"the time limit of {time_limit} s was over after {len(covers)} covers; there may "
                "be more",
                covers,
            )
        return covers

    def cover(self, permutation_rep: Sequence[Sequence[int]]) -> Manifold:
        """The cover on which the generators of fundamental_group(False) act by permutations.

        InvalidInput if they are no action, or not transitive.
        """
        images = [[int(i) for i in p] for p in permutation_rep]
        degree = len(images[0]) if images else 1
        return self._wrap(_renamed(self._core.cover(images), f"{self}~{degree}"))

    # The metric of this triangulation

    def verdict(self, *, time_limit: float | None = None) -> Verdict:
        """What was found about this triangulation, with the evidence; always an answer."""
        return Verdict(self._core.verdict(limits(time_limit)))

    def solution_type(self, enum: bool = False) -> str:
        """What was found, in SnapPy's words; with enum=True in ours (Verdict.outcome).

        >>> Manifold("cPcbbbihq").solution_type()
        'all tetrahedra positively oriented'
        """
        outcome = self._core.outcome()
        return outcome if enum else _SOLUTION_TYPES[outcome]

    @property
    def metric(self) -> Metric:
        """The metric; NoMetric, with the verdict, if there is none or none was found."""
        core = _core.metric(self._core, NO_LIMITS)
        if core is None:
            raise self._no_metric()
        return Metric(core, self)

    def _no_metric(self) -> NoMetric:
        verdict = self.verdict()
        hint = " retriangulated() looks for one that does." if verdict.advice == "retriangulate" else ""
        return NoMetric(f"{self} has no metric: {verdict.message}{hint}", verdict)

    def volume(self, verified: bool = False) -> Volume:
        """Hyperbolic volume: a float with `error`, a proved bound on what it is off.

        NoMetric, a ValueError that carries the verdict, if there is no metric. With
        verified=True also Undecided, if the bound is not proved.
        """
        volume = self.metric.volume
        if verified:
            volume.interval
        return volume

    def solve(
        self,
        method: str = "auto",
        *,
        initial_length: float | None = None,
        initial_lengths: Sequence[float] | npt.NDArray[np.float64] | None = None,
        tolerance: float | None = None,
        max_iterations: int | None = None,
        cone_orders: Mapping[int, Any] | None = None,
        cone_angles: Mapping[int, float] | None = None,
        angle_structure: bool = False,
        evidence: bool = True,
        history: bool = False,
        time_limit: float | None = None,
    ) -> Verdict:
        """Solves anew: other starts, methods (tripus.methods()), cone angles.

        cone_orders  {edge class: 2, 3, "5/2", ...; 0 for parabolic}; the cone angle is 2 pi / order
        cone_angles  {edge class: radians}
        history      Verdict.history has a row for each iteration

        >>> Manifold("cPcbbbiht").solve(cone_orders={0: 2, 1: 2}).volume.__round__(9)
        6.451990271
        """
        options: dict[str, Any] = {"method": method, "evidence": evidence}
        if angle_structure:
            options["angle_structure"] = True
        for key, value in (
            ("initial_length", initial_length),
            ("tolerance", tolerance),
            ("max_iterations", max_iterations),
        ):
            if value is not None:
                options[key] = value
        if initial_lengths is not None:
            options["initial_lengths"] = [float(x) for x in initial_lengths]
        if cone_orders or cone_angles:
            options["cone_angles"] = self._cone_angles(cone_orders or {}, cone_angles or {})
        if history:
            options["history"] = True
        fields, rows = self._core.solve(options, limits(time_limit))
        if history:
            fields["history"] = _history_columns(rows)
        return Verdict(fields)

    def _cone_angles(
        self, orders: Mapping[int, Any], angles: Mapping[int, float]
    ) -> list[str | float]:
        out: list[str | float] = ["1"] * self.num_edges()
        for edge, given in [*orders.items(), *angles.items()]:
            if not 0 <= edge < len(out):
                raise InvalidInput(f"there is no edge class {edge}: they are 0 to {len(out) - 1}")
        for edge, order in orders.items():
            if edge in angles:
                raise InvalidInput(f"edge class {edge} has an order and an angle; give one")
            out[edge] = str(order)
        for edge, angle in angles.items():
            out[edge] = float(angle)
        return out

    def prove(
        self,
        digits: int = 0,
        *,
        time_limit: float | None = None,
        threads: int = 0,
        progress: Progress = None,
    ) -> Proof:
        """A proof that the metric exists, every rounding accounted for; true if proved.

        digits  0 for doubles, or so many decimal digits of lengths, angles and volume.
        """
        text, message = _core.prove(self._core, digits, limits(time_limit, threads, progress))
        return Proof(text, message, self)

    def verify_hyperbolicity(self) -> Proof:
        """As SnapPy's: (proved, intervals), here of the edge lengths; see prove()."""
        return self.prove()

    def orthospectrum(self, **options: Any) -> Orthospectrum:
        """Arcs orthogonal to the boundary: length=L or count=N; see Metric.orthospectrum."""
        return self.metric.orthospectrum(**options)

    def shortest_return_path(self) -> float:
        """The length of the shortest arc orthogonal to the boundary at both ends.

        >>> Manifold("cPcbbbihq").shortest_return_path().__round__(9)
        0.596133895
        """
        return float(self.metric.orthospectrum(count=1).lengths[0])

    def basmajian_discs(self, **options: Any) -> npt.NDArray[Any]:
        """The discs of the arcs on the boundary, two of each arc, by length: what leaves the
        boundary at right angles within one runs into the same plane as the arc. The discs of all
        arcs fill the boundary, and do not overlap. Options as for orthospectrum().

        A record each: tetrahedron, vertex (of the truncation triangle), x, y (of the centre, in
        the projective disc around the middle of the triangle), radius, length (of the arc).

        >>> discs = Manifold("cPcbbbihq").basmajian_discs(length=6)
        >>> discs.size, float(discs["radius"][0]).__round__(6)
        (1054, 1.239453)
        >>> float((2 * np.pi * (np.cosh(discs["radius"]) - 1)).sum()).__round__(3)  # of 4 pi
        12.353
        """
        return self.metric.orthospectrum(**options).discs

    # The manifold, whatever its triangulation

    def canonical(self, *, time_limit: float | None = None) -> CanonicalDecomposition:
        """The canonical decomposition with isometry group and signature, or why not."""
        return CanonicalDecomposition(
            _core.canonical(self._core, limits(time_limit)), str(self)
        )

    def canonical_retriangulation(self) -> Manifold:
        """A triangulation that subdivides the canonical decomposition and carries the metric."""
        return self.canonical().triangulation.renamed(self.name())

    def isometry_signature(self, ignore_orientation: bool = True) -> str:
        """Equal exactly for isometric manifolds; Undecided if it was not found.

        >>> Manifold("cPcbbbihq").isometry_signature()
        'cPcbbbihq'
        """
        if ignore_orientation:
            signature = _core.isometry_signature(self._core, NO_LIMITS)
            if signature is not None:
                return signature
        found = self.canonical()
        return found.signature if ignore_orientation else found.oriented_signature

    def symmetry_group(self) -> IsometryGroup:
        """The isometry group; Undecided if it was not found."""
        group: Any = _core.isometry_group(self._core, NO_LIMITS)
        return self.canonical().isometry_group if group is None else IsometryGroup(group)

    def compare(self, other: Manifold, *, time_limit: float | None = None) -> Comparison:
        """Whether two manifolds are isometric, and how it was decided."""
        return Comparison(_core.compare(self._core, other._core, limits(time_limit)))

    def is_isometric_to(
        self, other: Manifold, return_isometries: bool = False
    ) -> Comparison | list[Any]:
        """A Comparison, true or false; its bool() raises Undecided where it was not decided.

        With return_isometries a list: one isometry of the canonical cells, or none.
        """
        answer = self.compare(other)
        if not return_isometries:
            return answer
        if not answer:
            return []
        isometry = answer.isometry
        return [] if isometry is None else [isometry]

    def identify(self, *, snappy: bool = False) -> list[CensusEntry]:
        """Its entries in tables, every one; [] if there is none.

        The census that comes with tripus; with snappy=True also all tables of SnapPy that know it.

        >>> [entry.name for entry in Manifold("cPcbbbihq").identify()]
        ['t2g2.8']
        """
        hits = []
        refused = None
        try:
            entry: Any = _core.identify(self._core, NO_LIMITS)
            if entry is not None:
                hits.append(CensusEntry("tripus", entry))
        except Unsupported as error:  # cusps, which the census does not have
            refused = error
        if snappy:
            for found in self.to_snappy().identify():
                fields = {
                    "name": found.name(),
                    "volume": float(found.volume()),
                    "tetrahedra": found.num_tetrahedra(),
                    "homology": format(_group_of_snappy(found.homology()), "regina"),
                    "triangulations": [found.triangulation_isosig(decorated=False)],
                }
                hits.append(CensusEntry("snappy", fields))
        elif refused is not None:
            raise Unsupported(f"{refused}; identify(snappy=True) asks SnapPy's tables") from None
        return hits

    # Results for others

    def to_json(self) -> str:
        """The answer of `tripus solve --json`: one object, without a line end."""
        return self._core.to_json(NO_LIMITS)

    def to_text(self, format: str = "json") -> str:
        """The triangulation as text: "json", "regina", "regina-table", "snappea" or "orb"."""
        return _core.to_text(self._core, format).decode("utf-8", "replace")

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the triangulation: .json, .rga (Regina), .tri (SnapPea), .orb or .sig.

        InvalidInput for another ending, FileError if it cannot be written; whole or not at all.
        """
        name = os.fspath(path)
        formats = {".json": "json", ".rga": "regina", ".tri": "snappea", ".orb": "orb"}
        ending = os.path.splitext(name)[1]
        if ending == ".sig":
            known = self._core.oriented_signature()
            text = ((known or self.triangulation_isosig()) + "\n").encode()
        elif ending in formats:
            text = _core.to_text(self._core, formats[ending])
        else:
            raise InvalidInput(
                f"cannot save to {name!r}: the name must end with .json, .rga, .tri, .orb or .sig"
            )
        write_whole(name, text)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes to_json() to a file whose name ends with .json."""
        self._core.write(os.fsencode(path), NO_LIMITS)

    def to_snappy(self) -> Any:
        """A snappy.Manifold; Unsupported at vertices of genus 2 and more."""
        return interop.to_snappy(self)

    def to_regina(self) -> Any:
        """A regina.Triangulation3 with the same labels."""
        return interop.to_regina(self)

    # Pictures

    def view(
        self,
        cells: int = 20,
        model: str = "ball",
        height: int = 520,
        *,
        discs: bool | float = False,
    ) -> Any:
        """The page that shows the manifold from outside and inside: in a notebook, live; else in
        a browser. NoMetric if there is nothing to show.

        discs  True, or a length: with the discs of arcs on the boundary; see basmajian_discs()
        """
        from tripus.view import view

        return view(self, cells, model, height, discs=discs)

    def page(
        self, cells: int = 20, model: str = "ball", *, discs: bool | float = False
    ) -> str:
        """The HTML of that page: self-contained, nothing from the network.

        >>> '"discs":' in Manifold("cPcbbbihq").page(discs=2.0)
        True
        """
        self.metric
        length = None if isinstance(discs, bool) else float(discs)
        wanted = discs is not False
        page = _core.page(self._core, cells, model, wanted, length, NO_LIMITS)
        return page.decode("utf-8", "replace")

    def picture(self, width: int = 240, height: int = 180) -> npt.NDArray[np.uint8]:
        """[height x width x 4] the manifold from the middle of tetrahedron 0; no display needed.

        >>> Manifold("cPcbbbihq").picture(8, 6).shape
        (6, 8, 4)
        """
        self.metric
        return _core.inside_picture(self._core, width, height, NO_LIMITS)

    # A value

    def copy(self) -> Manifold:
        """The same object: it does not change."""
        return self

    def __copy__(self) -> Manifold:
        return self

    def __deepcopy__(self, memo: Any) -> Manifold:
        return self

    def __eq__(self, other: object) -> bool:
        """The same triangulation up to labels, mirror images included; never an error."""
        if not isinstance(other, Manifold):
            return False  # NotImplemented would let other packages' objects raise
        if self._core.tetrahedron_count() != other._core.tetrahedron_count():
            return False
        mine, theirs = self._core.signature(), other._core.signature()
        if mine is not None and theirs is not None:
            return mine == theirs
        return self._core.isomorphism_to(other._core) is not None

    def __hash__(self) -> int:
        return hash((self._core.tetrahedron_count(), tuple(sorted(self._core.valences()))))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (
            *self._core.arrays(),
            self._core.name(),
            self._core.input(),
            self._core.is_orientation_known(),
        )

    def __str__(self) -> str:
        name = os.fsdecode(self._core.name() or self._core.label())
        return name or f"manifold of {self.num_tetrahedra()} tetrahedra"

    __repr__ = __str__

    def _repr_html_(self) -> str:
        from tripus.view import repr_html

        return repr_html(self)

    def __getattr__(self, name: str) -> Any:
        hint = _ELSEWHERE.get(name)
        raise AttributeError(
            f"a tripus.Manifold has no {name!r}" + (f": {hint}" if hint else "")
        )


def write_whole(path: str, text: bytes) -> None:
    """Writes a file as a whole, or not at all."""
    _core.write_file(os.fsencode(path), text)


def _group_of_snappy(group: Any) -> AbelianGroup:
    divisors = [int(d) for d in group.elementary_divisors()]
    return AbelianGroup(divisors.count(0), [d for d in divisors if d > 1])


def _history_columns(rows: npt.NDArray[np.float64]) -> dict[str, npt.NDArray[Any]]:
    names = (
        "iteration evaluations seconds max_curvature energy volume shortest_edge longest_edge"
    ).split()
    columns: dict[str, npt.NDArray[Any]] = {n: rows[:, i].copy() for i, n in enumerate(names)}
    for name in names[:2]:
        columns[name] = columns[name].astype(np.int64)
    return columns


def _renamed(core: CoreManifold, name: str) -> CoreManifold:
    return _core.renamed(core, os.fsencode(name))


def _restored(
    neighbours: Any, images: Any, name: bytes, given: bytes, orientation_known: bool
) -> Manifold:
    return Manifold._wrap(_core.from_arrays(neighbours, images, name, given, orientation_known))
