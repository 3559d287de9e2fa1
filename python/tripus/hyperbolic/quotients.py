"""Homomorphisms to permutations, which show that a group or an element of it is not trivial."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence

from tripus.hyperbolic.presentation import Presentation, Word

Perm = tuple[int, ...]

#: Degrees that are tried, and how many choices of images at most in each.
DEGREES = (3, 4, 5)
MOST = 100_000


def value(word: Sequence[int], images: dict[int, Perm], degree: int) -> Perm:
    """The permutation of a word, read from left to right."""
    out = tuple(range(degree))
    for letter in word:
        p = images[abs(letter) - 1]
        if letter > 0:
            out = tuple(p[i] for i in out)
        else:
            back = inverse(p)
            out = tuple(back[i] for i in out)
    return out


def inverse(p: Perm) -> Perm:
    out = [0] * len(p)
    for i, j in enumerate(p):
        out[j] = i
    return tuple(out)


def is_homomorphism(presentation: Presentation, images: dict[int, Perm], degree: int) -> bool:
    identity = tuple(range(degree))
    return (
        all(sorted(images.get(g, ())) == list(identity) for g in presentation.generators)
        and all(value(word, images, degree) == identity for word in presentation.relators)
    )


def is_abelian(generators: Sequence[int], images: dict[int, Perm], degree: int) -> bool:
    return all(
        value((a + 1, b + 1), images, degree) == value((b + 1, a + 1), images, degree)
        for a in generators
        for b in generators
    )


def search(
    presentation: Presentation, wanted: Callable[[dict[int, Perm], int], bool]
) -> dict[int, Perm] | None:
    """Images of all generators for which `wanted`; None if none was found."""
    small = Presentation(presentation.generators, presentation.relators)
    small.simplify()
    if not small.generators:
        return None
    for degree in DEGREES:
        perms = list(itertools.permutations(range(degree)))
        if len(perms) ** len(small.generators) > MOST:
            return None
        first = _one_of_each_type(perms)
        rest = [perms] * (len(small.generators) - 1)
        for choice in itertools.product(first, *rest):
            images = dict(zip(small.generators, choice))
            if not is_homomorphism(small, images, degree):
                continue
            whole = {
                g: value(small.image_of((g + 1,)), images, degree) for g in presentation.generators
            }
            if wanted(whole, degree):
                return whole
    return None


def _one_of_each_type(perms: Sequence[Perm]) -> list[Perm]:
    found: dict[tuple[int, ...], Perm] = {}
    for p in perms:
        lengths, seen = [], set()
        for i in range(len(p)):
            n = 0
            while i not in seen:
                seen.add(i)
                i = p[i]
                n += 1
            if n:
                lengths.append(n)
        found.setdefault(tuple(sorted(lengths)), p)
    return list(found.values())


def moves_word(word: Word, images: dict[int, Perm], degree: int) -> bool:
    return value(word, images, degree) != tuple(range(degree))
