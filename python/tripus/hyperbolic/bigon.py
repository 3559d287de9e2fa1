"""The check of a closed bigon (docs/theory.md section 5.1), by other code than finds it.

The vertex links are a surface of triangles. Each triangle through which a curve passes is split from
the curve's corner to the middle of the side that it crosses; what is not glued along the curve is
cut. Pieces are closed surfaces with boundary, and their vertices, sides and triangles are counted.
"""

from __future__ import annotations

from tripus.hyperbolic.tables import Classes, Table

Triangle = tuple[int, int, str]  # tetrahedron, vertex, "" or "x" or "y": which half
Corner = tuple[Triangle, object]


class ClosedBigon:
    """Of an edge class; `error` says why it is none."""

    def __init__(self, table: Table, edge: int) -> None:
        self.table = table
        self.error = ""
        self.is_moebius = False
        if not 0 <= edge < len(table.edges):
            self.error = f"there is no edge class {edge}"
            return
        corners = table.edges[edge].corners
        if table.edges[edge].is_boundary or len(corners) != 2 or corners[0][0] == corners[1][0]:
            self.error = f"edge class {edge} is not one of valence 2 between two tetrahedra"
            return
        # (t, x, y, front, back): the next corner's `back` is the image of this one's `front`.
        (a, x, y, q, p), (b, _, _, pp, qq) = corners
        entry = table.glue[a][q]
        if entry is None or entry[0] != b:
            self.error = "the edge is not surrounded as it should be"
            return
        g = entry[1]
        #: (t, x, y, p, q) of both tetrahedra.
        self.sides = ((a, x, y, p, q), (b, g[x], g[y], g[p], g[q]))
        direct = table.edge_of
        one, two = (a, p, q), (b, g[p], g[q])
        ends = [direct.get(one, -1), direct.get(two, -1)]
        back = [direct.get((t, w, v), -1) for t, v, w in (one, two)]
        if max(ends[0], back[0]) != max(ends[1], back[1]):
            self.error = "the opposite edges are two edge classes"
            return
        self.is_moebius = (ends[0] >= 0) != (ends[1] >= 0)
        assert {pp, qq} == {g[p], g[q]}

    def consequence(self) -> str:
        """ "moebius band", "disc", "essential annulus" or "none", as the library says it."""
        if self.is_moebius:
            return "moebius band"
        discs = [self._has_disc(end) for end in (0, 1)]
        if discs[0] != discs[1]:
            return "disc"
        return "none" if discs[0] or self._has_annulus_with_one_end() else "essential annulus"

    def _curve(self, t: int, v: int, cut: tuple[int, ...]) -> tuple[int, ...] | None:
        """(x, y, tip) if a curve passes through the triangle of vertex v of tetrahedron t."""
        for s, x, y, p, q in self.sides:
            if s == t and v == p and 0 in cut:
                return x, y, q
            if s == t and v == q and 1 in cut:
                return x, y, p
        return None

    def _triangle(self, t: int, v: int, u: int, cut: tuple[int, ...]) -> Triangle:
        """The triangle, or half of it, that has the corner on edge v u, which is no tip."""
        curve = self._curve(t, v, cut)
        return (t, v, "" if curve is None else "x" if u == curve[0] else "y")

    def _cut(self, cut: tuple[int, ...]) -> tuple[Classes[Triangle], dict[Triangle, int]]:
        """The pieces, and the Euler characteristic of each."""
        pieces: Classes[Triangle] = Classes()
        points: Classes[Corner] = Classes()
        sides: list[Triangle] = []
        for t in range(self.table.size):
            for v in range(4):
                for u in range(4):
                    curve = self._curve(t, v, cut)
                    if u == v or (curve and u == curve[2]):
                        continue
                    one = self._triangle(t, v, u, cut)
                    pieces.find(one)
                    points.find((one, u))
                    if curve:
                        points.find((one, curve[2]))
                        points.find((one, "middle"))
                        sides.append(one)  # along the curve
        for t, f, other, g in self.table.gluings:
            for v in range(4):
                if v == f:
                    continue
                curve, far = self._curve(t, v, cut), self._curve(other, g[v], cut)
                ends = [u for u in range(4) if u not in (f, v)]
                if curve and f == curve[2]:
                    for u in ends:
                        one, two = self._triangle(t, v, u, cut), self._triangle(other, g[v], g[u], cut)
                        pieces.join(one, two)
                        points.join((one, u), (two, g[u]))
                        points.join((one, "middle"), (two, "middle"))
                        sides.append(one)
                    continue
                # A side between the corners of two curves belongs to the half at its other end.
                one = self._triangle(t, v, _other_than(curve, ends), cut)
                two = self._triangle(other, g[v], _other_than(far, [g[u] for u in ends]), cut)
                pieces.join(one, two)
                for u in ends:
                    points.join((one, u), (two, g[u]))
                sides.append(one)
        chi = {key: len(members) for key, members in pieces.groups().items()}
        for key in points.groups():
            chi[pieces.find(key[0])] += 1
        for one in sides:
            chi[pieces.find(one)] -= 1
        return pieces, chi

    def _along(self, end: int, cut: tuple[int, ...]) -> list[Triangle]:
        return [
            self._triangle(t, (p, q)[end], u, cut) for t, x, y, p, q in self.sides for u in (x, y)
        ]

    def _has_disc(self, end: int) -> bool:
        pieces, chi = self._cut((end,))
        return any(chi[pieces.find(one)] == 1 for one in self._along(end, (end,)))

    def _has_annulus_with_one_end(self) -> bool:
        pieces, chi = self._cut((0, 1))
        both = {pieces.find(a) for a in self._along(0, (0, 1))}
        both &= {pieces.find(a) for a in self._along(1, (0, 1))}
        t, x, y, _, _ = self.sides[0]
        ends = [pieces.find((t, x, "")), pieces.find((t, y, ""))]
        return any(chi[piece] == 0 and ends.count(piece) == 1 for piece in both)


def _other_than(curve: tuple[int, ...] | None, ends: list[int]) -> int:
    """An end of a side that is not the curve's corner."""
    return next(u for u in ends if curve is None or u != curve[2])
