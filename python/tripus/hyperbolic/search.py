"""The search for a surface, by Regina. Runs in a process of its own, as no call of Regina's can be
interrupted: see worker.py.

Triangulations with real boundary are made from the ideal one by Regina's moves, each *round* from
other labels; round n of a table is the same in every process, so that a certificate can be checked.
"""

from __future__ import annotations

import random
import time
from collections.abc import Callable, Iterator
from typing import Any

from tripus.hyperbolic import essential
from tripus.hyperbolic.normal import NormalSurface
from tripus.hyperbolic.pieces import cut_pieces
from tripus.hyperbolic.tables import Table

#: Simplifications in a round, of which the smallest triangulation is taken.
ATTEMPTS = 6
#: Seconds of the first search; all vertex surfaces first, then those that miss one edge.
FIRST_STEP = 0.5
#: Regina's test for compressing discs takes seconds beyond so many tetrahedra.
SMALL = 16
#: A surface of more discs is not examined: a simpler one comes along.
MOST_DISCS = 3000


def to_regina(table: Table) -> Any:
    import regina

    made = regina.Triangulation3()
    tetrahedra = made.newTetrahedra(table.size)
    for t, f, other, p in table.gluings:
        tetrahedra[t].join(f, tetrahedra[other], regina.Perm4(*p))
    return made


def from_regina(triangulation: Any) -> Table:
    rows = []
    for tetrahedron in triangulation.tetrahedra():
        row: list[Any] = []
        for face in range(4):
            other = tetrahedron.adjacentTetrahedron(face)
            row.append(
                None
                if other is None
                else [other.index(), str(tetrahedron.adjacentGluing(face))]
            )
        rows.append(row)
    return Table(rows)


def relabelled(table: Table, seed: int) -> Table:
    """The same with labels drawn by chance; seed 0 leaves them."""
    if seed == 0:
        return table
    drawn = random.Random(seed)
    order = list(range(table.size))
    drawn.shuffle(order)
    perms = [drawn.sample(range(4), 4) for _ in order]
    rows: list[list[Any]] = [[None] * 4 for _ in order]
    for t, row in enumerate(table.glue):
        for f, entry in enumerate(row):
            if entry is None:
                continue
            image = [0] * 4
            for v in range(4):
                image[perms[t][v]] = perms[entry[0]][entry[1][v]]
            rows[order[t]][perms[t][f]] = (order[entry[0]], image)
    return Table(rows)


def truncated(table: Table, round_number: int) -> Any:
    """A small triangulation with real boundary, as Regina makes it."""
    import regina

    regina.RandomEngine.reseedWithDefault()
    whole = to_regina(relabelled(table, round_number))
    whole.truncateIdeal()
    best = None
    for _ in range(ATTEMPTS):
        made = regina.Triangulation3(whole)
        made.simplify()
        made.simplify()
        if best is None or _size(made) < _size(best):
            best = made
    return best


def _size(triangulation: Any) -> tuple[int, int]:
    return triangulation.countBoundaryTriangles(), triangulation.size()


def vector_of(surface: Any, size: int) -> list[int]:
    """Seven numbers a tetrahedron."""
    out: list[int] = []
    for t in range(size):
        out += [surface.triangles(t, v).longValue() for v in range(4)]
        out += [surface.quads(t, k).longValue() for k in range(3)]
    return out


def trees(triangulation: Any) -> Iterator[tuple[str, Any]]:
    """Searches of vertex surfaces, with a name each: inner edges banned first, as the surfaces that
    miss one lie on a smaller face of the solution space."""
    import regina

    yield "all", regina.TreeEnumeration(triangulation, regina.NS_QUAD)
    edges = sorted(triangulation.edges(), key=lambda e: (not e.isBoundary(), -e.degree()))
    for edge in edges:
        yield (
            f"edge {edge.index()} banned",
            regina.TreeEnumeration_BanEdge(triangulation, regina.NS_QUAD, edge),
        )


class Search:
    """Looks for a surface; `tell` hears of what is being done, by name and number."""

    def __init__(
        self,
        table: Table,
        tell: Callable[[str, Any], None],
        deadline: float,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """`deadline` is one of `clock`, in seconds: time.process_time counts processor time."""
        self.table = table
        self.tell = tell
        self.deadline = deadline
        self.clock = clock
        self.surfaces = 0
        self.searches = 0

    def run(self) -> dict[str, Any] | None:
        """The certificate's own part: triangulation, vector, kind and reason; None if the time is
        over."""
        step, round_number = FIRST_STEP, 0
        best: int | None = None
        while self.clock() < self.deadline:
            triangulation = truncated(self.table, round_number)
            size = triangulation.size()
            if best is not None and size > best + 1:
                round_number += 1
                continue
            best = size if best is None else min(best, size)
            found = self._round(triangulation, round_number, step)
            if found is not None:
                return found
            if round_number == 0 and size <= SMALL and self._compresses(triangulation):
                return {"because": "compressing disc", "round": 0}
            round_number += 1
            step *= 1.5
        return None

    def _compresses(self, triangulation: Any) -> bool:
        import regina

        self.tell("test", "hasCompressingDisc")
        return bool(regina.Triangulation3(triangulation).hasCompressingDisc())

    def _round(self, triangulation: Any, round_number: int, step: float) -> dict[str, Any] | None:
        table = from_regina(triangulation)
        self.tell("round", [round_number, table.size, table.boundary_characteristics()])
        for name, tree in trees(triangulation):
            limit = step if name == "all" else step / 4
            end = min(self.deadline, self.clock() + limit)
            self.searches += 1
            seen_all = False
            while self.clock() < end:
                if not tree.next():
                    seen_all = name == "all"
                    break
                self.surfaces += 1
                found = self._examine(table, tree.buildSurface())
                if found is not None:
                    return {
                        **found,
                        "round": round_number,
                        "pieces": self._pieces(triangulation, found["surface"]),
                    }
            self.tell("searched", [self.searches, self.surfaces])
            # With an edge banned there are no others than these.
            if seen_all or self.clock() >= self.deadline:
                break
        return None

    def _pieces(self, triangulation: Any, surface: dict[str, Any]) -> list[dict[str, Any]]:
        if surface["kind"] not in ("disc", "sphere"):
            return []
        return cut_pieces(triangulation, surface["vector"])

    def _examine(self, table: Table, surface: Any) -> dict[str, Any] | None:
        if surface.eulerChar() < 0:
            return None
        if surface.hasRealBoundary() and any(
            edge and edge.isBoundary() for edge in surface.isThinEdgeLink()
        ):
            return None  # parallel to the boundary
        vector = vector_of(surface, table.size)
        if sum(vector) > MOST_DISCS:
            return None
        normal = NormalSurface(table, vector)
        kind = essential.kind_of(normal)
        reason = None if kind is None else essential.find_reason(normal, kind)
        if reason is None:
            return None
        return {
            "triangulation": table.rows(),
            "surface": {
                "kind": kind,
                "coordinates": "standard",
                "vector": vector,
                "euler_characteristic": normal.euler_characteristic,
                "boundary_curves": len(normal.boundary.curves),
                "why_essential": reason,
            },
        }
