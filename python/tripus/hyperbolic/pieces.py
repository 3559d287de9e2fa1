"""What a manifold is: names read off the fundamental group, pieces along a disc or a sphere."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from tripus.hyperbolic.presentation import Presentation, of_table
from tripus.hyperbolic.tables import Classes


def surface_group(group: Presentation) -> tuple[int, bool] | None:
    """(Euler characteristic, orientable) of the closed surface whose group this is seen to be: one
    relator, in which each generator occurs twice, as the word around a polygon with one vertex."""
    if len(group.relators) != 1 or not group.generators:
        return None
    word = group.relators[0]
    if sorted(abs(x) for x in word) != sorted(2 * [g + 1 for g in group.generators]):
        return None
    corners: Classes[int] = Classes()  # before each letter
    ends: dict[int, tuple[int, int]] = {}
    orientable = True
    for i, x in enumerate(word):
        start, end = (i, (i + 1) % len(word)) if x > 0 else ((i + 1) % len(word), i)
        if abs(x) in ends:
            corners.join(start, ends[abs(x)][0])
            corners.join(end, ends[abs(x)][1])
            orientable &= word.count(x) == 1
        else:
            ends[abs(x)] = (start, end)
            corners.find(start)
            corners.find(end)
    if len(corners.groups()) != 1:
        return None
    return 2 - len(group.generators), orientable


def group_name(group: Presentation, boundary: Iterable[int]) -> str | None:
    """Of an irreducible orientable manifold with these boundary characteristics, or one without
    closed pieces; None if the group says nothing."""
    genera = sorted((2 - chi) // 2 for chi in boundary)
    rank = len(group.generators)
    if not group.relators:
        if len(genera) == 1 and genera[0] == rank:
            return "solid torus" if rank == 1 else f"handlebody of genus {rank}"
        if sum(genera) == rank and len(genera) > 1:
            return "connected sum of handlebodies of genus " + ", ".join(map(str, genera))
        if sum(genera) < rank:
            parts = "handlebodies" if len(genera) > 1 else "a handlebody"
            return (
                f"connected sum of {parts} of genus {', '.join(map(str, genera))} and "
                f"{rank - sum(genera)} S2 x S1"
            )
        return None
    surface = surface_group(group)
    if surface is None:
        return None
    chi, orientable = surface
    if orientable and genera == 2 * [(2 - chi) // 2]:
        return f"product of a surface of genus {(2 - chi) // 2} and an interval"
    if not orientable and [2 - 2 * g for g in genera] == [2 * chi]:
        return f"twisted I-bundle over the non-orientable surface of Euler characteristic {chi}"
    return None


def cut_pieces(triangulation: Any, vector: list[int]) -> list[dict[str, Any]]:
    """The pieces along a disc or a sphere, by Regina; spheres in their boundary are filled."""
    import regina

    from tripus.hyperbolic.search import from_regina

    surface = regina.NormalSurface(triangulation, regina.NS_STANDARD, vector)
    whole = surface.cutAlong()
    whole.simplify()
    out = []
    for piece in whole.triangulateComponents():
        piece.finiteToIdeal()
        piece.simplify()
        table = from_regina(piece)
        genera = sorted((2 - chi) // 2 for chi in table.link_characteristics.values() if chi < 2)
        group = of_table(table)
        group.simplify()
        group.shorten()
        name = group_name(group, [2 - 2 * g for g in genera])
        if name is None and not group.generators and not genera:
            name = "ball"  # or a sphere, if it has been filled
        out.append({"signature": piece.isoSig(), "name": name, "boundary": genera})
    return out
