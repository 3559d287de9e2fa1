"""Gluing tables of compact 3-manifolds, with open faces or without, and their cells.

Plain Python: what a certificate claims is checked with this and with nothing of the library's.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from functools import cached_property
from typing import Any, Generic, TypeVar

from tripus._errors import InvalidInput

EDGES = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
Key = TypeVar("Key", bound=Hashable)


class Classes(Generic[Key]):
    """Union-find over anything that can be hashed."""

    def __init__(self) -> None:
        self._up: dict[Key, Key] = {}

    def find(self, key: Key) -> Key:
        up = self._up
        root = up.setdefault(key, key)
        while up[root] != root:
            root = up[root]
        while up[key] != root:
            up[key], key = root, up[key]
        return root

    def join(self, a: Key, b: Key) -> None:
        self._up[self.find(a)] = self.find(b)

    def groups(self) -> dict[Key, list[Key]]:
        out: dict[Key, list[Key]] = {}
        for key in list(self._up):
            out.setdefault(self.find(key), []).append(key)
        return out


class EdgeClass:
    """`corners`: (t, from, to, front, back) around the edge, in order: through face `front`, which
    is opposite vertex `front`, to the next. A boundary edge begins and ends at open faces."""

    def __init__(self, corners: list[tuple[int, int, int, int, int]], boundary: bool) -> None:
        self.corners = corners
        self.is_boundary = boundary


class Table:
    """A gluing table: for the faces 0 to 3 of each tetrahedron (other, permutation), None if open.

    InvalidInput if the table is inconsistent or an edge is glued to its own reverse.
    """

    def __init__(self, rows: Iterable[Iterable[Any]]) -> None:
        self.glue: list[list[tuple[int, tuple[int, ...]] | None]] = [
            [
                None if entry is None else (int(entry[0]), tuple(int(c) for c in entry[1]))
                for entry in row
            ]
            for row in rows
        ]
        for t, row in enumerate(self.glue):
            if len(row) != 4:
                raise InvalidInput(f"tetrahedron {t} has {len(row)} faces")
            for f, entry in enumerate(row):
                if entry is not None and not self._is_undone(t, f, *entry):
                    raise InvalidInput(f"face {f} of tetrahedron {t} is not glued back")

    def _is_undone(self, t: int, f: int, other: int, p: tuple[int, ...]) -> bool:
        if not 0 <= other < len(self.glue) or sorted(p) != [0, 1, 2, 3]:
            return False
        back = self.glue[other][p[f]]
        if back is None or (other, p[f]) == (t, f):
            return False
        return back[0] == t and all(back[1][p[i]] == i for i in range(4))

    def rows(self) -> list[list[Any]]:
        """As in JSON: [other, "1230"] or None."""
        return [
            [None if e is None else [e[0], "".join(map(str, e[1]))] for e in row]
            for row in self.glue
        ]

    @property
    def size(self) -> int:
        return len(self.glue)

    @cached_property
    def faces(self) -> list[tuple[int, int]]:
        """(t, f), the first of each pair, open faces included."""
        out = []
        for t, row in enumerate(self.glue):
            for f, entry in enumerate(row):
                if entry is None or (t, f) < (entry[0], entry[1][f]):
                    out.append((t, f))
        return out

    @cached_property
    def gluings(self) -> list[tuple[int, int, int, tuple[int, ...]]]:
        """(t, f, other, p) of the faces that are not open, from the first of each pair."""
        return [(t, f, *entry) for t, f in self.faces if (entry := self.glue[t][f])]

    def first(self, t: int, f: int) -> tuple[int, int, tuple[int, ...]]:
        """The representative of a face, with where the vertices go."""
        entry = self.glue[t][f]
        if entry is None or (t, f) < (entry[0], entry[1][f]):
            return t, f, (0, 1, 2, 3)
        return entry[0], entry[1][f], entry[1]

    @cached_property
    def edges(self) -> list[EdgeClass]:
        out = []
        seen: set[tuple[int, int, int]] = set()
        for t in range(self.size):
            for a, b in EDGES:
                if (t, a, b) not in seen:
                    out.append(self._walk(t, a, b, seen))
        return out

    def _walk(self, t: int, a: int, b: int, seen: set[tuple[int, int, int]]) -> EdgeClass:
        back, front = (v for v in range(4) if v not in (a, b))
        start = (t, a, b, front, back)
        ahead, open_ahead = self._run(start)
        behind: list[tuple[int, int, int, int, int]] = []
        if open_ahead:
            behind, _ = self._run((t, a, b, back, front))
            behind = [(s, u, w, g, h) for s, u, w, h, g in reversed(behind[1:])]
        corners = behind + ahead
        for s, u, w, _, _ in corners:
            if (s, w, u) in seen:
                raise InvalidInput(f"an edge of tetrahedron {s} is glued to its own reverse")
            seen.add((s, u, w))
        for s, u, w, _, _ in corners:
            seen.add((s, w, u))
        return EdgeClass(corners, open_ahead)

    def _run(
        self, start: tuple[int, int, int, int, int]
    ) -> tuple[list[tuple[int, int, int, int, int]], bool]:
        corners = [start]
        while True:
            t, a, b, front, back = corners[-1]
            entry = self.glue[t][front]
            if entry is None:
                return corners, True
            p = entry[1]
            # The face left is opposite p[front]; the next one is opposite the image of `back`.
            following = (entry[0], p[a], p[b], p[back], p[front])
            if following == start:
                return corners, False
            corners.append(following)
            if len(corners) > 6 * self.size:
                raise InvalidInput("an edge is glued to its own reverse")

    @cached_property
    def edge_of(self) -> dict[tuple[int, int, int], int]:
        """(t, from, to) in the direction of the class -> its number."""
        return {
            (t, a, b): e for e, edge in enumerate(self.edges) for t, a, b, _, _ in edge.corners
        }

    @cached_property
    def vertices(self) -> Classes[tuple[int, int]]:
        classes: Classes[tuple[int, int]] = Classes()
        for t, row in enumerate(self.glue):
            for v in range(4):
                classes.find((t, v))
            for f, entry in enumerate(row):
                if entry is not None:
                    for v in range(4):
                        if v != f:
                            classes.join((t, v), (entry[0], entry[1][v]))
        return classes

    def is_connected(self) -> bool:
        classes: Classes[int] = Classes()
        for t, row in enumerate(self.glue):
            classes.find(t)
            for entry in row:
                if entry is not None:
                    classes.join(t, entry[0])
        return len(classes.groups()) == 1

    def is_orientable(self) -> bool:
        classes: Classes[tuple[int, int]] = Classes()
        for t, row in enumerate(self.glue):
            for entry in row:
                if entry is not None:
                    flip = 1 - sign(entry[1])  # an odd gluing keeps the orientation
                    classes.join((t, 0), (entry[0], flip))
                    classes.join((t, 1), (entry[0], 1 - flip))
        return all(classes.find((t, 0)) != classes.find((t, 1)) for t in range(self.size))

    @cached_property
    def link_characteristics(self) -> dict[tuple[int, int], int]:
        """Euler characteristic of the link of each vertex class: 1 for one in the boundary."""
        chi: dict[tuple[int, int], int] = {}
        for key, members in self.vertices.groups().items():
            chi[key] = len(members)
        for t, f in self.faces:
            for v in range(4):
                if v != f:
                    chi[self.vertices.find((t, v))] -= 1
        for edge in self.edges:
            t, a, b, _, _ = edge.corners[0]
            chi[self.vertices.find((t, a))] += 1
            chi[self.vertices.find((t, b))] += 1
        return chi

    def boundary_characteristics(self) -> list[int]:
        """Euler characteristics of the boundary components that open faces form."""
        classes: Classes[tuple[int, int]] = Classes()
        for t, f in self.faces:
            if self.glue[t][f] is None:
                classes.find((t, f))
        rims = [edge for edge in self.edges if edge.is_boundary]
        for edge in rims:
            classes.join(*_rim(edge))
        chi = {key: len(members) for key, members in classes.groups().items()}
        points: dict[tuple[int, int], tuple[int, int]] = {}
        for edge in rims:
            chi[classes.find(_rim(edge)[0])] -= 1
            t, a, b, _, _ = edge.corners[0]
            for v in (a, b):
                points[self.vertices.find((t, v))] = _rim(edge)[0]
        for face in points.values():
            chi[classes.find(face)] += 1
        return sorted(chi.values())


def _rim(edge: EdgeClass) -> tuple[tuple[int, int], tuple[int, int]]:
    """The two open faces at a boundary edge."""
    first, last = edge.corners[0], edge.corners[-1]
    return (first[0], first[4]), (last[0], last[3])


def sign(p: tuple[int, ...]) -> int:
    """0 if even, 1 if odd."""
    return sum(p[i] > p[j] for i in range(4) for j in range(i + 1, 4)) % 2
