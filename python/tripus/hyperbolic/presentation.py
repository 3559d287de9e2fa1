"""Finitely presented groups: moves that keep the group, free splittings.

Words are tuples of integers other than 0: generator i is i + 1, its inverse -(i + 1).
"""

from __future__ import annotations

import collections
import itertools
import math
import time
from collections.abc import Iterator, Sequence
from typing import Any

from tripus._errors import InvalidInput
from tripus.hyperbolic.integers import Matrix, torsion_and_rank
from tripus.hyperbolic.tables import Classes, Table

Word = tuple[int, ...]


def reduced(word: Sequence[int]) -> Word:
    """Freely reduced."""
    out: list[int] = []
    for letter in word:
        if out and out[-1] == -letter:
            out.pop()
        else:
            out.append(letter)
    return tuple(out)


def cyclically_reduced(word: Sequence[int]) -> Word:
    out = reduced(word)
    begin, end = 0, len(out)
    while end - begin > 1 and out[begin] == -out[end - 1]:
        begin, end = begin + 1, end - 1
    return out[begin:end]


def inverse(word: Sequence[int]) -> Word:
    return tuple(-letter for letter in reversed(word))


def substituted(word: Sequence[int], images: dict[int, Word]) -> Word:
    """Each generator number in `images` replaced by a word."""
    out: list[int] = []
    for letter in word:
        image = images.get(abs(letter) - 1)
        if image is None:
            out.append(letter)
        else:
            out.extend(image if letter > 0 else inverse(image))
    return reduced(out)


def _whitehead_images(letter: int, before: Sequence[int], after: Sequence[int]) -> dict[int, Word]:
    return {
        g: (*((-letter,) if g in before else ()), g + 1, *((letter,) if g in after else ()))
        for g in {*before, *after}
    }


class Presentation:
    """Generators (their numbers never change, they only disappear) and relators."""

    def __init__(
        self,
        generators: Sequence[int],
        relators: Sequence[Sequence[int]],
        deadline: float = math.inf,
    ) -> None:
        self._deadline = deadline  # of time.monotonic()
        self.generators = list(generators)
        self.relators = [w for w in map(cyclically_reduced, relators) if w]
        #: What became of eliminated generators: words in those that are left.
        self.images: dict[int, Word] = {}
        self.moves: list[list[Any]] = []

    def eliminate(self, generator: int, relator: int) -> None:
        """A generator that occurs once in a relator goes, and the relator with it."""
        word = self.relators[relator]
        letter = generator + 1
        if [abs(x) for x in word].count(letter) != 1:
            raise InvalidInput(f"generator {generator} does not occur once in relator {relator}")
        at = next(i for i, x in enumerate(word) if abs(x) == letter)
        rest = inverse(word[at + 1 :] + word[:at])
        image = rest if word[at] > 0 else inverse(rest)
        del self.relators[relator]
        self._apply({generator: image})
        self.generators.remove(generator)
        self.moves.append(["eliminate", generator, relator])

    def whitehead(self, letter: int, before: Sequence[int], after: Sequence[int]) -> None:
        """Every generator x in `after` becomes x a, every one in `before` a^-1 x; a = letter."""
        moved = set(before) | set(after)
        if abs(letter) - 1 in moved or not moved <= set(self.generators):
            raise InvalidInput("this is no Whitehead automorphism")
        self._apply(_whitehead_images(letter, before, after))
        self.moves.append(["whitehead", letter, sorted(before), sorted(after)])

    def _apply(self, images: dict[int, Word]) -> None:
        words = (cyclically_reduced(substituted(w, images)) for w in self.relators)
        self.relators = [w for w in words if w]
        for g, word in self.images.items():
            self.images[g] = substituted(word, images)
        for g, word in images.items():
            self.images.setdefault(g, word)

    def image_of(self, word: Sequence[int]) -> Word:
        """A word in the first generators, in those that are left."""
        return substituted(word, self.images)

    def replay(self, moves: Sequence[Sequence[Any]]) -> None:
        for kind, *what in moves:
            if kind == "eliminate":
                self.eliminate(int(what[0]), int(what[1]))
            elif kind == "whitehead":
                self.whitehead(int(what[0]), list(what[1]), list(what[2]))
            else:
                raise InvalidInput(f"no move of presentations is called {kind!r}")

    @property
    def length(self) -> int:
        return sum(map(len, self.relators))

    def simplify(self, longest: int = 2000) -> None:
        """Eliminates as long as the relators stay short."""
        while time.monotonic() < self._deadline:
            best: tuple[int, int, int] | None = None
            in_all = collections.Counter(abs(x) for word in self.relators for x in word)
            for r, word in enumerate(self.relators):
                for x, n in collections.Counter(map(abs, word)).items():
                    if n != 1:
                        continue
                    cost = (in_all[x] - 1) * (len(word) - 2) - len(word)
                    if best is None or cost < best[0]:
                        best = cost, x - 1, r
            if best is None or self.length + best[0] > longest:
                return
            self.eliminate(best[1], best[2])

    def shorten(self, most_generators: int = 6) -> None:
        """Whitehead automorphisms while they shorten the relators, then eliminations again."""
        while self.relators and 1 < len(self.generators) <= most_generators:
            if not self._shorten_once():
                return
            self.simplify()

    def _shorten_once(self) -> bool:
        for letter, before, after in self._automorphisms():
            if time.monotonic() >= self._deadline:
                return False
            images = _whitehead_images(letter, before, after)
            length = sum(len(cyclically_reduced(substituted(w, images))) for w in self.relators)
            if length < self.length:
                self.whitehead(letter, before, after)
                return True
        return False

    def _automorphisms(self) -> Iterator[tuple[int, list[int], list[int]]]:
        """Those with few generators moved first."""
        for multiplier in self.generators:
            others = [g for g in self.generators if g != multiplier]
            kinds = sorted(
                itertools.product(range(4), repeat=len(others)), key=lambda k: sum(map(bool, k))
            )
            for letter in (multiplier + 1, -multiplier - 1):
                for kind in kinds[1:]:
                    before = [g for g, k in zip(others, kind) if k & 1]
                    after = [g for g, k in zip(others, kind) if k & 2]
                    yield letter, before, after

    def splitting(self) -> tuple[list[int], list[int]] | None:
        """The generators in two parts such that each relator is in one of them, and both factors
        are seen not to be trivial; the first part is one generator without relators if possible."""
        classes: Classes[int] = Classes()
        for g in self.generators:
            classes.find(g)
        for word in self.relators:
            for x in word:
                classes.join(abs(word[0]) - 1, abs(x) - 1)
        parts = list(classes.groups().values())
        if len(parts) < 2:
            return None
        free = [p for p in parts if not self.part(p).relators]
        good = free or [p for p in parts if self.part(p).homology() != ([], 0)]
        for part in good:
            rest = [g for g in self.generators if g not in part]
            if self.part(rest).homology() != ([], 0):
                return part, rest
        return None

    def part(self, generators: Sequence[int]) -> Presentation:
        """These generators and the relators in them."""
        chosen = {g + 1 for g in generators}
        return Presentation(
            generators, [w for w in self.relators if abs(w[0]) in chosen]
        )

    def homology(self, *words: Word) -> tuple[list[int], int]:
        """Torsion coefficients and rank of the abelian group; `words` count as relators as well."""
        place = {g: i for i, g in enumerate(self.generators)}
        rows: Matrix = []
        for word in (*self.relators, *words):
            row = [0] * len(place)
            for x in word:
                row[place[abs(x) - 1]] += 1 if x > 0 else -1
            rows.append(row)
        return torsion_and_rank(rows, len(place))


def of_table(table: Table, deadline: float = math.inf) -> Presentation:
    """The fundamental group: crossings of faces off a tree, relators around the edges inside.

    Every edge class must be a circle of tetrahedra or lie in the boundary.
    """
    tree = spanning_tree(
        range(table.size), [(t, e[0]) for t, f in table.faces if (e := table.glue[t][f])]
    )
    inside = [face for face in table.faces if table.glue[face[0]][face[1]] is not None]
    number = {face: i for i, face in enumerate(inside)}
    generators = [i for i in range(len(inside)) if i not in tree]
    relators = []
    for edge in table.edges:
        if edge.is_boundary:
            continue
        word = []
        for t, _, _, front, _ in edge.corners:
            first = table.first(t, front)
            i = number[first[:2]]
            if i not in tree:
                word.append(i + 1 if first[:2] == (t, front) else -(i + 1))
        relators.append(word)
    return Presentation(generators, relators, deadline)


def spanning_tree(nodes: Any, links: Sequence[tuple[Any, Any]]) -> set[int]:
    """Numbers of links that form a forest."""
    classes: Classes[Any] = Classes()
    chosen = set()
    for i, (a, b) in enumerate(links):
        if classes.find(a) != classes.find(b):
            classes.join(a, b)
            chosen.add(i)
    return chosen
