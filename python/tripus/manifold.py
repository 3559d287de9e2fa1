"""Compact 3-manifolds with a triangulation: the front door."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tripus import _core, interop
from tripus._check import as_bytes, checked, one_of, shown
from tripus._core import Manifold as CoreManifold
from tripus._errors import InvalidInput, NoMetric, Undecided, Unsupported
from tripus._limits import NO_LIMITS, Progress, limits
from tripus._value import Value
from tripus.answers import (
    CanonicalDecomposition,
    CensusEntry,
    Comparison,
    Isometry,
)
from tripus.arcs import BasmajianDiscs, Orthospectrum, ReturnPath
from tripus.diagrams import Diagram, is_diagram
from tripus.groups import AbelianGroup, FundamentalGroup, IsometryGroup
from tripus.metric import Metric
from tripus.sources import load_text, load_thing, surface_of_drawing
from tripus.verdicts import Proof, Verdict, Volume

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.hyperbolic.decide import Hyperbolicity
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
    "normal_surfaces": "M.to_regina(), regina.NormalSurfaces",
    "cusp_info": "M.links()",
    "drill": "M.drilled(edges)",
    "high_precision": "M.prove(digits=60)",
    "filled_triangulation": "M.to_snappy().filled_triangulation()",
    "link": "M.diagram()",
    "plink": "M.diagram()",
    "orientation_cover": "M.covers(2), those that are is_orientable()",
    "boundaryComponents": "M.links()",
    "countEdges": "M.num_edges()",
    "edge": "M.valences, M.edge_classes",
}

#: What SnapPy alone has.
_OF_SNAPPY = (
    "alexander_polynomial chern_simons complex_volume cusp_areas cusp_neighborhood dirichlet_domain "
    "exterior_to_link gluing_equations length_spectrum polished_holonomy short_slopes "
    "splitting_surfaces tetrahedra_field_gens trace_field_gens"
).split()


@checked
class Manifold(Value):
    """A compact 3-manifold with a triangulation.

    A value: it does not change, can be hashed, compared, pickled, and used from several threads at
    once. Nothing is computed before it is first asked for, and then once.

    source  an isomorphism signature, with or without a sign for the orientation; the name of a
            file (gluing table, Regina, SnapPea, Orb, surface, tetrahedral mesh), FILE#LABEL for one
            of several triangulations in it; a planar diagram ("PD: V[1,3,4] X[5,9,6,10] ..."); a
            name of the tables of knots and graphs or of the census; a gluing table as lists, or as
            arrays (neighbours [T x 4], images [T x 4 x 4]); a tripus.Diagram; a triangulation of
            SnapPy or Regina; a mesh of meshio, trimesh or PyVista.
    name    what to call it, instead of the name in the source.
    cone_orders, cone_angles
            as for solve(): cone angles around edge classes, on top of those in the source (a file,
            or a text such as "cPcbbbiht 0=2,1=2"). Volume, canonical decomposition, isometries and
            == are then those of the cone manifold; homology(), fundamental_group() and covers()
            are of the space without its labels, which covers keep.

    InvalidInput, a ValueError, for anything else, with the place and the remedy; what of a source
    was mended comes as a warning (InputNote).

    >>> M = Manifold("cPcbbbihq")
    >>> M, M.num_tetrahedra(), M.volume()
    (cPcbbbihq, 2, 6.451990270835)
    >>> Manifold("cPcbbbiht", cone_orders={0: 2, 1: 2}).volume()
    6.451990270835
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
        cone_orders: Mapping[int, Any] | None = None,
        cone_angles: Mapping[int, float] | None = None,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> None:
        if isinstance(source, Manifold):
            core = source._core
        elif type(source) is str:
            core = load_text(source, time_limit, progress)
        else:
            core = load_thing(source, time_limit, progress)
        if cone_orders or cone_angles:
            core = core.with_cone_angles(
                _on_top(_labels(core), cone_orders or {}, cone_angles or {})
            )
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
        if not isinstance(text, (str, bytes)):
            raise TypeError(f"Manifold.from_text(): text is a str or bytes, not {shown(text)}")
        given = as_bytes(text) if isinstance(text, str) else text
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
        return self._kinds().count("cusp")

    def num_boundary_components(self) -> int:
        """Number of geodesic boundary components."""
        return self._kinds().count("geodesic")

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
        return "finite" in self._kinds()

    def _kinds(self) -> list[str]:
        return [kind for _, _, kind, *_ in self._core.links()]

    @property
    def cone_angles(self) -> npt.NDArray[np.float64]:
        """[E] the cone angle around each edge class in radians; 2 pi but for labelled ones."""
        angles = np.full(self.num_edges(), 2 * np.pi)
        for edge, (_, _, radians) in enumerate(self._core.cone_angles()):
            angles[edge] = radians
        return angles

    @property
    def cone_orders(self) -> dict[int, Any]:
        """{edge class: 2 pi / its cone angle} where that is not 2 pi: an int, a Fraction or, where
        the angle is no rational multiple of pi, a float; 0 for parabolic. {} for a manifold.

        >>> Manifold("cPcbbbiht", cone_orders={0: 2, 1: "5/2"}).cone_orders
        {0: 2, 1: Fraction(5, 2)}
        """
        orders = {e: _order(*angle) for e, angle in enumerate(self._core.cone_angles())}
        return {e: order for e, order in orders.items() if order != 1}

    def with_cone_angles(
        self,
        cone_orders: Mapping[int, Any] | None = None,
        cone_angles: Mapping[int, float] | None = None,
    ) -> Manifold:
        """The same triangulation with these cone angles and no others; none for the manifold."""
        labels = _on_top(["1"] * self.num_edges(), cone_orders or {}, cone_angles or {})
        given = labels if cone_orders or cone_angles else []
        return self._wrap(self._core.with_cone_angles(given))

    def links(self) -> list[dict[str, Any]]:
        """[V] kind ("geodesic", "cusp", "finite"), Euler characteristic, orientability, number of
        triangles and of cone points of the link of each vertex class.

        >>> Manifold("cPcbbbihq").links()[0]["euler_characteristic"]
        -2
        """
        return [
            {
                "kind": kind,
                "euler_characteristic": chi,
                "orientable": orientable,
                "triangles": n,
                "cone_points": cone_points,
            }
            for chi, orientable, kind, n, cone_points in self._core.links()
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

    def triangulation_isosig(self, *, oriented: bool = False, decorated: bool = False) -> str:
        """The isomorphism signature, Regina's; oriented=True adds the sign that keeps orientation.

        decorated is for SnapPy's users: there are no curves to add, so True is Unsupported.
        Undecided where it would take too long, or where the orientation is not known.

        >>> Manifold("cPcbbbihq-").triangulation_isosig(oriented=True)
        'cPcbbbihq-'
        """
        if decorated:
            raise Unsupported("no peripheral curves are known to decorate the signature with")
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

    def isomorphisms_to(
        self, other: Manifold, *, time_limit: float | None = None
    ) -> list[tuple[npt.NDArray[np.uint32], npt.NDArray[np.uint8]]]:
        """All isomorphisms of triangulations, as (images of tetrahedra [T], images of their vertices
        [T x 4]); [] if there is none.

        Those that reverse the orientation count too, as in ==; cone angles are kept.

        >>> M = Manifold("cPcbbbihq")
        >>> len(M.isomorphisms_to(M))
        6
        """
        if not (self.is_connected() and other.is_connected()):
            raise Unsupported("isomorphisms are listed for connected triangulations only")
        tetrahedra, vertices = self._core.isomorphisms_to(other._core, limits(time_limit))
        return list(zip(tetrahedra, vertices))

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

    def drilled(
        self,
        edges: Sequence[int],
        *,
        seed: int = 0,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """What is left without neighbourhoods of these edge classes, simplified.

        An edge between two components of the boundary joins them, one back to the same component
        raises its genus.

        >>> Manifold("cPcbbbihq").drilled([0]).links()[0]["euler_characteristic"]
        -4
        """
        core = self._core.drilled(edges, seed, limits(time_limit, 0, progress))
        return self._wrap(core)

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
        one_of("Manifold.covers", "cover_type", cover_type, ("all", "cyclic"))
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

    def cover(
        self, permutation_rep: Sequence[Sequence[int]], *, time_limit: float | None = None
    ) -> Manifold:
        """The cover on which the generators of fundamental_group() act by permutations; or those
        of fundamental_group(False), if there are so many permutations.

        InvalidInput if they are no action, or not transitive.
        """
        degree = len(permutation_rep[0]) if permutation_rep else 1
        permutation_rep = self.fundamental_group()._extended(permutation_rep)
        core = self._core.cover(permutation_rep, limits(time_limit))
        return self._wrap(_renamed(core, f"{self}~{degree}"))

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
        cone_angles  {edge class: radians}. Both on top of those that the manifold has.
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
            options["initial_lengths"] = list(initial_lengths)
        if cone_orders or cone_angles:
            options["cone_angles"] = _on_top(
                _labels(self._core), cone_orders or {}, cone_angles or {}
            )
        if history:
            options["history"] = True
        fields, rows = self._core.solve(options, limits(time_limit))
        if history:
            fields["history"] = _history_columns(rows)
        return Verdict(fields)

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

    def shortest_return_path(self) -> ReturnPath:
        """The shortest arc orthogonal to the boundary at both ends; see Metric."""
        return self.metric.shortest_return_path()

    def basmajian_discs(self, length: float = 4.0, **options: Any) -> BasmajianDiscs:
        """The discs on the boundary around the feet of arcs; see Metric.basmajian_discs."""
        return self.metric.basmajian_discs(length, **options)

    # The manifold, whatever its triangulation

    def hyperbolicity(
        self, *, time_limit: float | None = None, surfaces: bool = True
    ) -> Hyperbolicity:
        """Whether the manifold is hyperbolic: True, False or not decided, with a certificate.

        time_limit  seconds in all, 60 if not given.
        surfaces    whether to search with Regina (tripus[regina]) for essential surfaces, in a
                    process of its own, if the quick tests do not decide.

        >>> answer = Manifold("dLQbcbcmebs").hyperbolicity()
        >>> answer.hyperbolic, answer.name, answer.certificate.check()
        (False, 'handlebody of genus 2', True)
        """
        from tripus.hyperbolic.decide import hyperbolicity

        return hyperbolicity(self, time_limit, surfaces)

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
    ) -> Comparison | list[Isometry]:
        """A Comparison, true or false; its bool() raises Undecided where it was not decided.

        With return_isometries a list of all isometries, [] if there is none; Undecided if they
        were not found.
        """
        if not return_isometries:
            return self.compare(other)
        fields, found = _core.isometries(self._core, other._core, NO_LIMITS)
        answer = Comparison(fields)
        if not answer:
            return []
        if found is None:
            raise Undecided(
                f"{answer.message} But the isometries were not found: there is no canonical "
                "decomposition of both.",
                answer,
            )
        return [Isometry(*each) for each in found]

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
        """The triangulation as text: "json", "regina", "regina-table", "snappea" or "orb".

        Unsupported for cone angles but in JSON and Orb's format.
        """
        if format in ("regina", "regina-table", "snappea"):
            interop.require_plain(self, "that format")
        return _core.to_text(self._core, format).decode("utf-8", "replace")

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the triangulation: .json, .rga (Regina), .tri (SnapPea), .orb or .sig.

        InvalidInput for another ending, FileError if it cannot be written; whole or not at all.
        """
        name = os.fsdecode(path)
        formats = {".json": "json", ".rga": "regina", ".tri": "snappea", ".orb": "orb"}
        ending = os.path.splitext(name)[1]
        if ending == ".sig":
            interop.require_plain(self, "a .sig file")
            known = self._core.oriented_signature()
            text = ((known or self.triangulation_isosig()) + "\n").encode()
        elif ending in formats:
            if ending in (".rga", ".tri"):
                interop.require_plain(self, f"a {ending} file")
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

    def diagram(self) -> Diagram:
        """The diagram that it was made from; Unsupported if it was made from something else.

        >>> Manifold("5_1 theta").diagram()
        <Diagram 5_1 theta: 5 crossings, 2 vertices, 3 strands>
        """
        given = os.fsdecode(self._core.input())
        if not is_diagram(given) and not is_diagram(self.name()):
            raise Unsupported(f"{self} was not made from a diagram")
        return Diagram(given if is_diagram(given) else self.name(), name=self.name() or None)

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

    def inside_view(self, height: int = 520, *, discs: bool | float = False) -> Any:
        """The same page, which begins inside: what one sees along geodesics. SnapPy's name."""
        from tripus.view import view

        return view(self, height=height, discs=discs, inside=True)

    def page(
        self,
        cells: int = 20,
        model: str = "ball",
        *,
        discs: bool | float = False,
        inside: bool = False,
    ) -> str:
        """The HTML of that page: self-contained, nothing from the network. It begins outside, or
        inside.

        >>> '"discs":' in Manifold("cPcbbbihq").page(discs=2.0)
        True
        """
        self.metric
        length = None if isinstance(discs, bool) else float(discs)
        wanted = discs is not False
        page = _core.page(self._core, cells, model, inside, wanted, length, NO_LIMITS)
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
        mine, theirs = self._core, other._core
        if mine.tetrahedron_count() != theirs.tetrahedron_count():
            return False
        if not (mine.is_labelled() or theirs.is_labelled()):
            signatures = mine.signature(), theirs.signature()
            if None not in signatures:
                return signatures[0] == signatures[1]
        return mine.is_isomorphic_to(theirs)

    def __hash__(self) -> int:
        edges: list[Any] = list(self._core.valences())
        if self._core.is_labelled():
            edges = list(zip(edges, map(tuple, self._core.cone_angles())))
        return hash((self._core.tetrahedron_count(), tuple(sorted(edges))))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (
            *self._core.arrays(),
            self._core.name(),
            self._core.input(),
            self._core.is_orientation_known(),
            _labels(self._core) if self._core.cone_angles() else [],
        )

    def __str__(self) -> str:
        """The name, or what it was made from, or the signature; with the labels behind."""
        name = os.fsdecode(self._core.name() or self._core.label())
        return name or f"manifold of {self.num_tetrahedra()} tetrahedra"

    __repr__ = __str__

    def _rows(self) -> dict[str, str]:
        from tripus.view import rows_of

        return rows_of(self)

    def _picture(self) -> str:
        from tripus.view import picture_of

        return picture_of(self)

    def __getattr__(self, name: str) -> Any:
        hint = f"M.to_snappy().{name}()" if name in _OF_SNAPPY else _ELSEWHERE.get(name)
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
    neighbours: Any,
    images: Any,
    name: bytes,
    given: bytes,
    orientation_known: bool,
    cone_angles: list[Any],
) -> Manifold:
    core = _core.from_arrays(neighbours, images, name, given, orientation_known, cone_angles)
    return Manifold._wrap(core)


def _labels(core: CoreManifold) -> list[Any]:
    """[E] cone angles for the extension: exact ones as (p, q) for p/q pi, others in radians."""
    angles: list[Any] = [(p, q) if q else radians for p, q, radians in core.cone_angles()]
    return angles or ["1"] * core.edge_count()


def _order(numerator: int, denominator: int, radians: float) -> Any:
    """2 pi / a cone angle: an int where it is one; 0 for parabolic."""
    from fractions import Fraction

    if radians == 0:
        return 0
    if denominator == 0:
        return 2 * np.pi / radians
    order = Fraction(2 * denominator, numerator)
    return order.numerator if order.denominator == 1 else order


def _on_top(labels: list[Any], orders: Mapping[int, Any], angles: Mapping[int, Any]) -> list[Any]:
    """Labels [E] with these in their place."""
    out = list(labels)
    for edge in (*orders, *angles):
        if edge >= len(out):
            raise InvalidInput(f"there is no edge class {edge}: they are 0 to {len(out) - 1}")
    for edge, order in orders.items():
        if edge in angles:
            raise InvalidInput(f"edge class {edge} has an order and an angle; give one")
        if isinstance(order, bool) or not hasattr(order, "__float__") and type(order) is not str:
            raise TypeError(
                f"the cone order of edge class {edge} is a number or a text such as '5/2', not "
                f"{shown(order)}"
            )
        out[edge] = str(order)
    for edge, angle in angles.items():
        if isinstance(angle, (bool, str)) or not hasattr(angle, "__float__"):
            raise TypeError(
                f"the cone angle of edge class {edge} is a number of radians, not {shown(angle)}"
            )
        out[edge] = float(angle)
    return out
