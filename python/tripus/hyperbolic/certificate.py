"""Certificates of "hyperbolic" and "not hyperbolic", and their check."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tripus._errors import InvalidInput, Unsupported
from tripus._value import Value
from tripus.hyperbolic import essential, presentation
from tripus.hyperbolic.bigon import ClosedBigon
from tripus.hyperbolic.normal import NormalSurface
from tripus.hyperbolic.tables import Table

if TYPE_CHECKING:
    from tripus.manifold import Manifold

#: How many rounds of retriangulation are repeated to find the triangulation of a certificate: its
#: own first, then the others, should another version of Regina make them in another order.
ROUNDS = 30


class HyperbolicityCertificate(Value):
    """Why a manifold is hyperbolic, or is not: JSON, with everything that its check needs.

    >>> import tripus
    >>> certificate = tripus.Manifold("dLQbcbcmebs").hyperbolicity().certificate
    >>> certificate.by, certificate.check()
    ('free group', True)
    """

    def __init__(self, data: dict[str, Any] | str) -> None:
        self._data: dict[str, Any] = json.loads(data) if isinstance(data, str) else data

    @property
    def by(self) -> str:
        """ "free group", "free product", "closed bigon", "surface", "compressing disc", "metric"."""
        return str(self._data["by"])

    @property
    def data(self) -> dict[str, Any]:
        """All of it."""
        return self._data

    def check(self, manifold: Manifold | None = None) -> bool:
        """Whether it proves what it says, of this manifold if one is given; `objection` says why not.

        No search is made again: groups are made from the gluing table and moved as written, surfaces
        are counted anew, by the code that found them; metrics and bigons are checked by other code. A
        surface needs Regina, to make its triangulation anew from the manifold's.
        """
        return not self.objection(manifold)

    def objection(self, manifold: Manifold | None = None) -> str:
        """The first thing that is wrong; empty if nothing is."""
        try:
            table = Table(self._data["gluings"])
            if manifold is not None and not _same(table, manifold):
                return "it is about another triangulation"
            test = _TESTS.get(self.by)
            if test is None:
                return f"no certificate is called {self.by!r}"
            return test(self._data, table) if self.by == "metric" else (
                _outside(table) or test(self._data, table)
            )
        except KeyError as error:
            return f"it is no certificate: {error} is missing"
        except InvalidInput as error:
            return f"it is not written as it should be: {error}"
        except (IndexError, TypeError, AttributeError):
            return "it is not written as it should be: something in it is of another kind, or too short"

    def to_json(self) -> str:
        """One object, without a line end."""
        return json.dumps(self._data)

    def _key(self) -> Any:
        return self._data

    def _rows(self) -> dict[str, str]:
        return {"certificate by": self.by}

    def __repr__(self) -> str:
        return f"<HyperbolicityCertificate by {self.by}>"


def _same(table: Table, manifold: Manifold) -> bool:
    """Whether the table is that of the manifold, or what Tripus's moves make of one that has many
    tetrahedra or finite vertices."""
    from tripus.hyperbolic.decide import LARGE, needs_simplifying
    from tripus.manifold import Manifold as Made

    made = Made(table.rows())
    if made == manifold:
        return True
    if manifold.num_tetrahedra() <= LARGE and not needs_simplifying(manifold):
        return False
    return made == manifold.simplified()


def _outside(table: Table) -> str:
    """Why nothing is claimed about such a manifold; empty if it is one that the theory is about."""
    links = table.link_characteristics.values()
    if any(entry is None for row in table.glue for entry in row):
        return "the triangulation has open faces"
    if not table.is_connected() or not table.is_orientable():
        return "the triangulation is not connected and orientable"
    if any(chi > 0 for chi in links) or all(chi == 0 for chi in links):
        return "the boundary has a sphere, or no component of genus 2 or more"
    return ""


def _check_group(data: dict[str, Any], table: Table) -> str:
    group = presentation.of_table(table)
    given = data["group"]
    if [given["generators"], given["relators"]] != [
        group.generators,
        [list(word) for word in group.relators],
    ]:
        return "the presentation is not that of the triangulation"
    group.replay(given["moves"])
    parts = [list(part) for part in given["factors"]]
    if sorted(g for part in parts for g in part) != sorted(group.generators):
        return "the factors are not made of the generators that the moves leave"
    for word in group.relators:
        if not any({abs(x) - 1 for x in word} <= set(part) for part in parts):
            return f"the relator {list(word)} is in no factor"
    if data["by"] == "free group":
        return "" if not group.relators and len(group.generators) > 1 else "relators are left"
    if len(parts) != 2 or any(group.part(part).homology() == ([], 0) for part in parts):
        return "the factors are not two that are seen not to be trivial"
    return ""


def _check_bigon(data: dict[str, Any], table: Table) -> str:
    bigon = ClosedBigon(table, int(data["bigon"]["edge"]))
    if bigon.error:
        return bigon.error
    consequence = bigon.consequence()
    if consequence == "none" or consequence != data["bigon"]["consequence"]:
        return f"what follows from the bigon is: {consequence}"
    return ""


def _check_surface(data: dict[str, Any], table: Table) -> str:
    solid = Table(data["triangulation"])
    given = data["surface"]
    return (
        _other_manifold(solid, table)
        or _not_made_by_regina(solid, table, int(data["round"]))
        or essential.check_reason(
            NormalSurface(solid, given["vector"]), given["kind"], given["why_essential"]
        )
    )


def _check_disc(data: dict[str, Any], table: Table) -> str:
    _need_regina()
    import regina

    from tripus.hyperbolic.search import truncated

    solid = truncated(table, int(data["round"]))
    return "" if regina.Triangulation3(solid).hasCompressingDisc() else "Regina finds no disc"


def _check_metric(data: dict[str, Any], table: Table) -> str:
    from tripus import _core
    from tripus._limits import NO_LIMITS
    from tripus.manifold import Manifold as Made

    if data["proof"] is None:
        return "there is no proof, only floating point: " + str(data["reason"])
    metric = Made(data["triangulation"])
    other = Table(data["triangulation"])
    if other.rows() != table.rows() and _homology(other) != _homology(table):
        return "the metric is on a triangulation of another manifold"
    answer = _core.check_proof(metric._core, json.dumps(data["proof"]), NO_LIMITS)
    return "" if answer[0] else str(answer[1])


def _homology(table: Table) -> tuple[list[int], int]:
    return presentation.of_table(table).homology()


def _other_manifold(solid: Table, table: Table) -> str:
    """Cheap signs that a triangulation is one of another manifold."""
    if not solid.is_connected() or not solid.is_orientable():
        return "the triangulation of the surface is not connected and orientable"
    boundary = sorted(chi for chi in table.link_characteristics.values())
    if solid.boundary_characteristics() != boundary or _homology(solid) != _homology(table):
        return "the triangulation of the surface is one of another manifold"
    if any(chi not in (1, 2) for chi in solid.link_characteristics.values()):
        return "the triangulation of the surface has ideal vertices"
    return ""


def _need_regina() -> None:
    try:
        import regina  # noqa: F401
    except ImportError:
        raise Unsupported(
            "this check needs Regina, to make the surface's triangulation from the manifold's: "
            "pip install 'tripus[regina]'"
        ) from None


def _not_made_by_regina(solid: Table, table: Table, first: int) -> str:
    """Makes the triangulation anew: truncation and moves, which keep the manifold."""
    _need_regina()
    from tripus.hyperbolic.search import to_regina, truncated

    wanted = to_regina(solid).isoSig()
    for number in (first, *(n for n in range(ROUNDS) if n != first)):
        if truncated(table, number).isoSig() == wanted:
            return ""
    return "Regina's moves did not lead to the triangulation of the surface again"


_TESTS: dict[str, Callable[[dict[str, Any], Table], str]] = {
    "free group": _check_group,
    "free product": _check_group,
    "closed bigon": _check_bigon,
    "surface": _check_surface,
    "compressing disc": _check_disc,
    "metric": _check_metric,
}

