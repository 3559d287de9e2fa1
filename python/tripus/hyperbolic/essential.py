"""Why a normal surface shows that a manifold is not hyperbolic, and the check of such a reason.

M is compact and orientable, its boundary has no spheres and some component of genus 2 or more. If it
is hyperbolic, it is irreducible, its boundary is incompressible, and every incompressible annulus
or torus is parallel into the boundary; it has no projective planes, Klein bottles and Moebius bands
(docs/theory.md section 5.1). Each reason contradicts one of these.
"""

from __future__ import annotations

from math import gcd
from typing import Any

from tripus.hyperbolic import quotients
from tripus.hyperbolic.integers import diagonal, kernel
from tripus.hyperbolic.normal import Group, NormalSurface
from tripus.hyperbolic.presentation import Word, inverse, reduced

#: (Euler characteristic, number of boundary curves, two-sided) -> kind
KINDS = {
    (2, 0, True): "sphere",
    (1, 0, False): "projective plane",
    (1, 1, True): "disc",
    (0, 0, True): "torus",
    (0, 0, False): "klein bottle",
    (0, 2, True): "annulus",
    (0, 1, False): "moebius band",
}

Reason = dict[str, Any]


def kind_of(surface: NormalSurface) -> str | None:
    """Of a surface of Euler characteristic 0 or more; None if it is none or not connected."""
    chi = surface.euler_characteristic
    if chi < 0 or not surface.is_connected():
        return None
    return KINDS.get((chi, len(surface.boundary.curves), surface.is_two_sided()))


def find_reason(surface: NormalSurface, kind: str) -> Reason | None:
    """Why a surface of this kind contradicts that the manifold is hyperbolic; None if it may not."""
    if kind in ("projective plane", "klein bottle", "moebius band"):
        return {"because": "one-sided"}
    if kind == "disc":
        return None if surface.boundary.bounds_disc(0) else {"because": "its curve bounds no disc"}
    if kind == "annulus":
        return _annulus(surface)
    if not surface.is_separating():
        return {"because": "does not separate"}
    find = _not_a_ball if kind == "sphere" else _incompressible
    sides = [find(surface, side, None) for side in (0, 1)]
    if None in sides:
        return None
    return {"because": f"essential {kind}", "sides": sides}


def _annulus(surface: NormalSurface) -> Reason | None:
    boundary = surface.boundary
    discs = [boundary.bounds_disc(curve) for curve in (0, 1)]
    if discs[0] != discs[1]:
        return {"because": "just one of its curves bounds a disc"}
    if not surface.is_separating():
        return {"because": "does not separate"}
    if discs[0]:
        return None
    if not boundary.annuli():
        return {"because": "its curves are not parallel in the boundary"}
    sides = [_not_a_product(surface, annulus, None) for annulus in boundary.annuli()]
    return None if None in sides else {"because": "not parallel to the boundary", "sides": sides}


def _not_a_product(surface: NormalSurface, annulus: Any, given: Reason | None) -> Reason | None:
    """Why the piece at an annulus of the boundary is no product between it and the surface."""
    piece = surface.boundary.piece_of_manifold(annulus)
    if len(surface.boundary.in_piece(piece)) > 1:
        return {"because": "the piece has more boundary"}
    group = surface.group(piece)
    torsion, rank = group.presentation.homology(*_words(group))
    if (torsion, rank) != ([], 0):
        return {"because": "the core does not generate H1", "quotient": {"torsion": torsion, "rank": rank}}
    generators = group.presentation.generators
    return _quotient(
        group,
        "the piece is no solid torus",
        lambda images, n: not quotients.is_abelian(generators, images, n),
        given,
    )


def _not_a_ball(surface: NormalSurface, side: int, given: Reason | None) -> Reason | None:
    piece = surface.piece_at(side)
    if surface.boundary.in_piece(piece):
        return {"because": "the piece has more boundary"}
    group = surface.group(piece)
    torsion, rank = group.presentation.homology()
    if (torsion, rank) != ([], 0):
        return {"because": "the piece has homology", "homology": {"torsion": torsion, "rank": rank}}
    return _quotient(
        group,
        "the piece has a fundamental group",
        lambda images, n: any(p != tuple(range(n)) for p in images.values()),
        given,
    )


def _incompressible(surface: NormalSurface, side: int, given: Reason | None) -> Reason | None:
    """Why a torus bounds neither a solid torus on this side nor a collar of the boundary, nor
    compresses there in another way.

    A disc on this side has a curve that is trivial in rational homology. If only multiples of one
    curve are, the disc would have that one.
    """
    piece = surface.piece_at(side)
    inside = surface.boundary.in_piece(piece)
    if inside and all(surface.boundary.chi[p] == 0 for p in inside):
        return None  # tori alone: perhaps a collar
    group = surface.group(piece)
    one, other = _directions(group)
    bounding = _bounding(group, one, other)
    if bounding is None:
        return {"because": "no direction bounds in homology"}
    if bounding == (0, 0):
        return None
    curve = reduced(_power(one, bounding[0]) + _power(other, bounding[1]))
    if _is_not_zero(group, curve):
        return {"because": "the direction that bounds is torsion in homology"}
    return _quotient(
        group,
        "the direction that bounds in homology is not trivial",
        lambda images, n: quotients.moves_word(curve, images, n),
        given,
    )


def _quotient(group: Group, because: str, wanted: Any, given: Reason | None) -> Reason | None:
    """A homomorphism to permutations: one that is found, or the given one if it is as wanted."""
    presentation = group.presentation
    if given is None:
        images = quotients.search(presentation, wanted)
        if images is None:
            return None
        return {"because": because, "permutations": {str(g): list(p) for g, p in images.items()}}
    images = {int(g): tuple(p) for g, p in given["permutations"].items()}
    degree = len(next(iter(images.values()), ()))
    if not quotients.is_homomorphism(presentation, images, degree) or not wanted(images, degree):
        return None
    return {"because": because, "permutations": given["permutations"]}


def _words(group: Group) -> list[Word]:
    return [tuple(word) for word, _ in group.loops()]


def _vector(word: Word, group: Group) -> list[int]:
    return [
        sum((x > 0) - (x < 0) for x in word if abs(x) == g + 1)
        for g in group.presentation.generators
    ]


def _power(word: Word, n: int) -> Word:
    return word * n if n >= 0 else inverse(word) * -n


def _directions(group: Group) -> tuple[Word, Word]:
    """Words of two loops that generate the group of a torus."""
    loops = group.loops()
    relations = group.surface_relations()
    steps = len(group.surface.steps)
    divisors, turned = diagonal(relations, steps)
    free = range(len(divisors), steps)
    coordinates = [
        [sum(v * turned[s][j] for s, v in enumerate(vector)) for _, vector in loops] for j in free
    ]
    _, chosen = diagonal(coordinates, len(loops))
    words = []
    for j in (0, 1):
        word: Word = ()
        for (loop, _), row in zip(loops, chosen):
            word += _power(tuple(loop), row[j])
        words.append(reduced(word))
    return words[0], words[1]


def _bounding(group: Group, one: Word, other: Word) -> tuple[int, int] | None:
    """The primitive (a, b) such that a one + b other is 0 in rational homology: None if there is
    none, (0, 0) if all are."""
    relators = [_vector(word, group) for word in group.presentation.relators]
    columns = [_vector(one, group), _vector(other, group), *relators]
    rows = [list(row) for row in zip(*columns)]
    pairs = [(x[0], x[1]) for x in kernel(rows, len(columns)) if (x[0], x[1]) != (0, 0)]
    if not pairs:
        return None
    a, b = pairs[0]
    if any(a * d - b * c for c, d in pairs):
        return 0, 0
    return a // gcd(a, b), b // gcd(a, b)


def _is_not_zero(group: Group, word: Word) -> bool:
    """In integral homology."""
    return group.presentation.homology() != group.presentation.homology(word)


def check_reason(surface: NormalSurface, kind: str, reason: Reason) -> str:
    """Why the reason does not hold for the surface; empty if it does."""
    if kind_of(surface) != kind:
        return f"the surface is no {kind}, but: {kind_of(surface)}"
    if "sides" not in reason:
        found = find_reason(surface, kind)
        return "" if found == reason else f"the reason does not hold: {reason['because']}"
    if not surface.is_separating():
        return "the surface does not separate"
    if kind == "annulus":
        boundary = surface.boundary
        if any(boundary.bounds_disc(curve) for curve in (0, 1)):
            return "a curve bounds a disc in the boundary"
        places: list[Any] = boundary.annuli()
        test: Any = _not_a_product
    else:
        places = [0, 1]
        test = _not_a_ball if kind == "sphere" else _incompressible
    if len(places) != len(reason["sides"]):
        return "the reason does not speak of every side"
    for place, given in zip(places, reason["sides"]):
        if test(surface, place, given) != given:
            return f"a side is not as claimed: {given['because']}"
    return ""
