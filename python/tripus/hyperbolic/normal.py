"""Normal surfaces in a triangulation with real boundary, cell by cell.

A vector has seven numbers a tetrahedron: triangles at the vertices 0 to 3, quadrilaterals that
separate the edges 01|23, 02|13, 03|12. The surface cuts tetrahedra, faces and edges into *regions*;
regions of tetrahedra, joined across regions of faces, are what is left of the manifold. The side of
a disc of the surface that faces vertex 0 (for a triangle: its own vertex) is side 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

from tripus._errors import InvalidInput
from tripus.hyperbolic.presentation import Presentation, spanning_tree
from tripus.hyperbolic.tables import Classes, Table

#: PARTNER[k][v]: the vertex on the same side of quadrilaterals of type k as v.
PARTNER = ((1, 0, 3, 2), (2, 3, 0, 1), (3, 2, 1, 0))

Region = tuple[int, int, int]  # (t, v, i): number i from vertex v; (t, 4, i): between quadrilaterals
Disc = tuple[int, int, int]  # the same numbers: just behind region (t, v, i)
Arc = tuple[int, int, int, int]  # (t, f, v, i): in face f, number i from vertex v
FaceRegion = tuple[int, int, int, int]  # the same; (t, f, f, 0) in the middle


class Step(NamedTuple):
    """From disc to disc across an arc, which begins in the sides of discs as they are."""

    arc: Arc
    discs: tuple[Disc, Disc]
    #: Whether side 0 of the first is side 0 of the second.
    agree: bool


class NormalSurface:
    """InvalidInput if the vector is not that of an embedded normal surface in the table."""

    def __init__(self, table: Table, vector: Sequence[int]) -> None:
        if len(vector) != 7 * table.size or any(int(x) != x or x < 0 for x in vector):
            raise InvalidInput("the vector is not one of 7 integers >= 0 a tetrahedron")
        self.table = table
        self.triangles = [[int(x) for x in vector[7 * t : 7 * t + 4]] for t in range(table.size)]
        self.quads: list[tuple[int, int]] = []
        for t in range(table.size):
            kinds = [(k, int(x)) for k, x in enumerate(vector[7 * t + 4 : 7 * t + 7]) if x]
            if len(kinds) > 1:
                raise InvalidInput(f"two kinds of quadrilaterals in tetrahedron {t}")
            self.quads.append(kinds[0] if kinds else (0, 0))
        for t, f, other, p in table.gluings:
            for v in range(4):
                if v != f and self.arcs(t, f, v) != self.arcs(other, p[f], p[v]):
                    raise InvalidInput(f"the matching equations fail at face {f} of tetrahedron {t}")
        if not any(self.discs):
            raise InvalidInput("the surface is empty")

    def arcs(self, t: int, f: int, v: int) -> int:
        """How many arcs surround vertex v in face f."""
        kind, count = self.quads[t]
        return self.triangles[t][v] + (count if PARTNER[kind][f] == v else 0)

    @cached_property
    def discs(self) -> list[Disc]:
        out: list[Disc] = []
        for t in range(self.table.size):
            out += [(t, v, i) for v in range(4) for i in range(self.triangles[t][v])]
            out += [(t, 4, j) for j in range(self.quads[t][1])]
        return out

    def _middle(self, t: int, v: int) -> Region:
        """The region that vertex v reaches behind its triangles."""
        kind, count = self.quads[t]
        return (t, 4, 0 if v in (0, PARTNER[kind][0]) else count)

    def disc_region(self, disc: Disc, side: int) -> Region:
        """The region on a side of a disc."""
        t, v, i = disc
        if v == 4:
            return (t, 4, i + side)
        if side == 0:
            return (t, v, i)
        return (t, v, i + 1) if i + 1 < self.triangles[t][v] else self._middle(t, v)

    def arc_disc(self, t: int, f: int, v: int, i: int) -> tuple[Disc, int]:
        """The disc in t at an arc of face f, and its side that faces v."""
        here = self.triangles[t][v]
        if i < here:
            return (t, v, i), 0
        kind, count = self.quads[t]
        if v in (0, PARTNER[kind][0]):
            return (t, 4, i - here), 0
        return (t, 4, count - 1 - (i - here)), 1

    def face_region(self, t: int, f: int, v: int, i: int) -> Region:
        """The region of t at a region of face f: number i from v, or the middle if v is f."""
        if v == f:
            v = next(u for u in range(4) if u not in (f, PARTNER[self.quads[t][0]][f]))
            return self._middle(t, v)
        if i < self.triangles[t][v]:
            return (t, v, i)
        disc, side = self.arc_disc(t, f, v, i)
        return self.disc_region(disc, side)

    # The surface

    @cached_property
    def steps(self) -> list[Step]:
        out = []
        for t, f, other, p in self.table.gluings:
            for v in range(4):
                for i in range(self.arcs(t, f, v) if v != f else 0):
                    here, mine = self.arc_disc(t, f, v, i)
                    there, theirs = self.arc_disc(other, p[f], p[v], i)
                    out.append(Step((t, f, v, i), (here, there), mine == theirs))
        return out

    @cached_property
    def boundary_arcs(self) -> list[Arc]:
        return [
            (t, f, v, i)
            for t, f in self.table.faces
            if self.table.glue[t][f] is None
            for v in range(4)
            if v != f
            for i in range(self.arcs(t, f, v))
        ]

    def weight(self, e: int) -> int:
        """How often the surface meets an edge class."""
        t, a, b, front, _ = self.table.edges[e].corners[0]
        return self.arcs(t, front, a) + self.arcs(t, front, b)

    @property
    def euler_characteristic(self) -> int:
        points = sum(self.weight(e) for e in range(len(self.table.edges)))
        return len(self.discs) - len(self.steps) - len(self.boundary_arcs) + points

    def is_connected(self) -> bool:
        classes: Classes[Disc] = Classes()
        for disc in self.discs:
            classes.find(disc)
        for step in self.steps:
            classes.join(*step.discs)
        return len(classes.groups()) == 1

    @cached_property
    def sides(self) -> Classes[tuple[Disc, int]]:
        classes: Classes[tuple[Disc, int]] = Classes()
        for disc in self.discs:
            classes.find((disc, 0))
            classes.find((disc, 1))
        for _, (a, b), agree in self.steps:
            classes.join((a, 0), (b, 0 if agree else 1))
            classes.join((a, 1), (b, 1 if agree else 0))
        return classes

    def is_two_sided(self) -> bool:
        """Of a connected surface."""
        disc = self.discs[0]
        return self.sides.find((disc, 0)) != self.sides.find((disc, 1))

    # What the surface leaves of the manifold

    @cached_property
    def _links(self) -> list[tuple[FaceRegion, Region, Region]]:
        """Regions of faces inside the manifold, with the regions on both sides."""
        out = []
        for t, f, other, p in self.table.gluings:
            for v in range(4):
                for i in range(self.arcs(t, f, v) if v != f else 1):
                    out.append(
                        (
                            (t, f, v, i),
                            self.face_region(t, f, v, i),
                            self.face_region(other, p[f], p[v], i),
                        )
                    )
        return out

    @cached_property
    def pieces(self) -> Classes[Region]:
        classes: Classes[Region] = Classes()
        for disc in self.discs:
            classes.find(self.disc_region(disc, 0))
            classes.find(self.disc_region(disc, 1))
        for t in range(self.table.size):
            classes.find((t, 4, 0))
        for _, a, b in self._links:
            classes.join(a, b)
        return classes

    def piece_at(self, side: int) -> Region:
        """The piece of the manifold on a side of the first disc, of a two-sided surface."""
        return self.pieces.find(self.disc_region(self.discs[0], side))

    def is_separating(self) -> bool:
        return self.piece_at(0) != self.piece_at(1)

    def beyond(self, t: int, f: int, v: int, i: int) -> FaceRegion:
        """The region of face f behind its arc i from v."""
        return (t, f, v, i + 1) if i + 1 < self.arcs(t, f, v) else (t, f, f, 0)

    def point(self, t: int, f: int, a: int, b: int, k: int) -> Arc:
        """The arc of face f at point k of its edge from a to b."""
        at_a = self.arcs(t, f, a)
        return (t, f, a, k) if k < at_a else (t, f, b, at_a + self.arcs(t, f, b) - 1 - k)

    def segment(self, t: int, f: int, a: int, b: int, k: int) -> FaceRegion:
        """The region of face f at segment k of its edge from a to b."""
        at_a = self.arcs(t, f, a)
        if k < at_a:
            return (t, f, a, k)
        if k == at_a:
            return (t, f, f, 0)
        return (t, f, b, at_a + self.arcs(t, f, b) - k)

    def group(self, piece: Region) -> Group:
        """The fundamental group of a piece."""
        return Group(self, piece)

    # The boundary

    @cached_property
    def boundary(self) -> BoundaryPieces:
        return BoundaryPieces(self)


class Group:
    """The fundamental group of a piece of the manifold, and words of loops on the surface in it."""

    def __init__(self, surface: NormalSurface, piece: Region) -> None:
        self.surface = surface
        self.piece = piece
        table = surface.table
        links = [
            (key, a, b) for key, a, b in surface._links if surface.pieces.find(a) == piece
        ]
        self.number = {key: i for i, (key, _, _) in enumerate(links)}
        nodes = {r for _, a, b in links for r in (a, b)}
        self.tree = spanning_tree(nodes, [(a, b) for _, a, b in links])
        relators = []
        for e, edge in enumerate(table.edges):
            if edge.is_boundary:
                continue
            for k in range(surface.weight(e) + 1):
                t, a, b, front, _ = edge.corners[0]
                region = surface.face_region(*surface.segment(t, front, a, b, k))
                if surface.pieces.find(region) == piece:
                    relators.append(self._around(e, k))
        self.presentation = Presentation(
            [i for i in range(len(links)) if i not in self.tree], relators
        )

    def _around(self, e: int, k: int) -> list[int]:
        word = []
        for t, a, b, front, _ in self.surface.table.edges[e].corners:
            word += self.crossing(*self.surface.segment(t, front, a, b, k))
        return word

    def crossing(self, t: int, f: int, v: int, i: int) -> list[int]:
        """From the region of t at a region of its face f to the other side."""
        s, g, p = self.surface.table.first(t, f)
        number = self.number[s, g, p[v], i]
        if number in self.tree:
            return []
        return [number + 1 if (s, g) == (t, f) else -(number + 1)]

    def loops(self) -> list[tuple[list[int], list[int]]]:
        """Loops on the surface, pushed into the piece, which generate the surface's group: the
        word in the group, and the loop's steps as a vector [steps] for homology.

        The surface is two-sided; the words are up to one conjugation (a path to a base point).
        """
        surface = self.surface
        start = surface.discs[0]
        side = 0 if surface.piece_at(0) == self.piece else 1
        steps = surface.steps
        tree = spanning_tree(surface.discs, [step.discs for step in steps])
        neighbours: dict[Disc, list[tuple[int, Disc]]] = {}
        for i in tree:
            a, b = steps[i].discs
            neighbours.setdefault(a, []).append((i, b))
            neighbours.setdefault(b, []).append((i, a))
        paths: dict[Disc, tuple[int, list[tuple[int, int]]]] = {start: (side, [])}
        stack = [start]
        while stack:
            disc = stack.pop()
            at, path = paths[disc]
            for i, other in neighbours.get(disc, []):
                if other not in paths:
                    forward = 1 if steps[i].discs == (disc, other) else -1
                    there = at if steps[i].agree else 1 - at
                    paths[other] = there, [*path, (i, forward)]
                    stack.append(other)
        out = []
        for i, step in enumerate(steps):
            if i in tree:
                continue
            a, b = step.discs
            path = [*paths[a][1], (i, 1), *((j, -d) for j, d in reversed(paths[b][1]))]
            vector = [0] * len(steps)
            for j, d in path:
                vector[j] += d
            out.append((self._word(side, path), vector))
        return out

    def _word(self, side: int, path: list[tuple[int, int]]) -> list[int]:
        """Of a path of steps along the surface, on a side of its first disc."""
        surface, word = self.surface, []
        for i, direction in path:
            (t, f, v, n), _, agree = surface.steps[i]
            _, facing = surface.arc_disc(t, f, v, n)
            if direction < 0 and not agree:
                side = 1 - side  # now as seen from the first disc of the step
            key = (t, f, v, n) if side == facing else self.surface.beyond(t, f, v, n)
            crossing = self.crossing(*key)
            word += crossing if direction > 0 else [-x for x in reversed(crossing)]
            if direction > 0 and not agree:
                side = 1 - side
        return word

    def surface_relations(self) -> list[list[int]]:
        """[points inside][steps]: what is 0 in the first homology of the surface."""
        surface = self.surface
        number = {step.arc: i for i, step in enumerate(surface.steps)}
        rows = []
        for e, edge in enumerate(surface.table.edges):
            if edge.is_boundary:
                continue
            for k in range(surface.weight(e)):
                row = [0] * len(number)
                for t, a, b, front, _ in edge.corners:
                    _, _, v, i = surface.point(t, front, a, b, k)
                    s, g, p = surface.table.first(t, front)
                    row[number[s, g, p[v], i]] += 1 if (s, g) == (t, front) else -1
                rows.append(row)
        return rows


class BoundaryPieces:
    """The boundary of the manifold cut along the boundary of the surface."""

    def __init__(self, surface: NormalSurface) -> None:
        table = surface.table
        pieces: Classes[FaceRegion] = Classes()
        curves: Classes[Arc] = Classes()
        for t, f in table.faces:
            if table.glue[t][f] is None:
                pieces.find((t, f, f, 0))
                for v in range(4):
                    for i in range(surface.arcs(t, f, v) if v != f else 0):
                        pieces.find((t, f, v, i))
                        curves.find((t, f, v, i))
        segments = []
        corners: dict[tuple[int, int], FaceRegion] = {}
        for e, edge in enumerate(table.edges):
            if not edge.is_boundary:
                continue
            (t, a, b, _, f), (s, c, d, g, _) = edge.corners[0], edge.corners[-1]
            weight = surface.weight(e)
            for k in range(weight + 1):
                one = surface.segment(t, f, a, b, k)
                pieces.join(one, surface.segment(s, g, c, d, k))
                segments.append(one)
                if k < weight:
                    curves.join(surface.point(t, f, a, b, k), surface.point(s, g, c, d, k))
            corners[table.vertices.find((t, a))] = surface.segment(t, f, a, b, 0)
            corners[table.vertices.find((t, b))] = surface.segment(t, f, a, b, weight)
        #: Euler characteristic of each open piece.
        self.chi = {key: len(members) for key, members in pieces.groups().items()}
        for region in segments:
            self.chi[pieces.find(region)] -= 1
        for region in corners.values():
            self.chi[pieces.find(region)] += 1
        #: The two pieces along each curve.
        self.curves: list[tuple[FaceRegion, FaceRegion]] = []
        for arc in curves.groups():
            self.curves.append((pieces.find(arc), pieces.find(surface.beyond(*arc))))
        self._surface = surface
        self._pieces = pieces

    def curves_along(self, piece: FaceRegion) -> list[int]:
        """Numbers of the curves along a piece, one twice if the piece is on both sides of it."""
        return [n for n, sides in enumerate(self.curves) for side in sides if side == piece]

    def bounds_disc(self, curve: int) -> bool:
        """Whether a curve bounds a disc, which may hold other curves."""
        return any(self._is_disc(side, curve) for side in self.curves[curve])

    def _is_disc(self, piece: FaceRegion, curve: int, depth: int = 0) -> bool:
        """Whether what lies on this side of the curve is a disc."""
        others = self.curves_along(piece)
        others.remove(curve)
        if curve in others or depth > len(self.curves):
            return False
        for other in others:
            far = [side for side in self.curves[other] if side != piece]
            if len(far) != 1 or not self._is_disc(far[0], other, depth + 1):
                return False
        return self.chi[piece] + len(others) == 1

    def annuli(self) -> list[FaceRegion]:
        """Pieces that are annuli between two different curves."""
        return [
            piece
            for piece, chi in self.chi.items()
            if chi == 0 and len(set(self.curves_along(piece))) == 2 == len(self.curves_along(piece))
        ]

    def piece_of_manifold(self, piece: FaceRegion) -> Region:
        return self._surface.pieces.find(self._surface.face_region(*piece))

    def in_piece(self, piece: Region) -> list[FaceRegion]:
        """Boundary pieces of a piece of the manifold."""
        return [p for p in self.chi if self.piece_of_manifold(p) == piece]
