"""Hyperbolic or not: the tests in order, the cheapest first, and the answer.

1.  a metric on the triangulation, or on one a few moves away: hyperbolic;
2.  a fundamental group that is free or splits freely: a disc or a sphere (a hyperbolic manifold with
    boundary is irreducible, its boundary incompressible, and its group splits in no such way);
3.  a closed bigon: a disc, an annulus or a Moebius band;
4.  a normal surface found by Regina, in a process of its own, while this one goes on looking for a
    metric.
"""

from __future__ import annotations

import functools
import json
import math
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from tripus._errors import InvalidInput, Undecided, Unsupported
from tripus._value import Value
from tripus.hyperbolic import presentation
from tripus.hyperbolic.certificate import HyperbolicityCertificate
from tripus.hyperbolic.pieces import group_name
from tripus.hyperbolic.tables import Table

if TYPE_CHECKING:
    from tripus.manifold import Manifold

#: Seconds in all where no limit is given.
TIME_LIMIT = 60.0
#: Triangulations tried for a metric before surfaces are looked for: those that have one nearby
#: were all a single move away in the lists of up to four tetrahedra.
NEAR = 40
#: And while they are looked for, so many in so many seconds, after a wait.
FAR = 5000
FAR_SECONDS = 3.0
WAIT = 3.0
#: More tetrahedra than that are made fewer before anything but a metric is looked for.
LARGE = 50
#: Seconds a tetrahedron that the cells and the group take in Python, with room to spare.
READING = 3e-4

_ARTICLES = {"annulus": "an essential annulus", "disc": "an essential disc"}


class Hyperbolicity(Value):
    """Whether a manifold is hyperbolic: True, False, or None where it was not decided.

    bool() raises Undecided where it was not decided, for False would be wrong.

    >>> import tripus
    >>> answer = tripus.Manifold("cPcbbbihq").hyperbolicity()
    >>> answer.hyperbolic, answer.proved, answer.by
    (True, True, 'metric')
    >>> tripus.Manifold("dLQbcbcaekw").hyperbolicity()
    not hyperbolic: an essential annulus, certificate attached
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    def _key(self) -> Any:
        return {name: value for name, value in self._fields.items() if name != "seconds"}

    def _rows(self) -> dict[str, str]:
        words = {True: "yes", False: "no", None: "not decided"}
        rows = {"hyperbolic": words[self.hyperbolic], "by": self.by or "", "why": self.message}
        return {name: text for name, text in rows.items() if text}

    @property
    def hyperbolic(self) -> bool | None:
        """True, False or None."""
        return self._fields["hyperbolic"]  # type: ignore[no-any-return]

    def __bool__(self) -> bool:
        if self.hyperbolic is None:
            raise Undecided(f"it was not decided: {self.message}", self)
        return self.hyperbolic

    @property
    def proved(self) -> bool:
        """Whether the certificate is a proof: all of those for "not hyperbolic" are."""
        return bool(self._fields["proved"])

    @property
    def by(self) -> str | None:
        """What decided: "metric", "free group", "free product", "closed bigon", "surface",
        "compressing disc"; None where nothing did."""
        return self._fields["by"]  # type: ignore[no-any-return]

    @property
    def kind(self) -> str | None:
        """The kind of the surface, where there is one: "disc", "annulus", "moebius band", ..."""
        return self._fields["kind"]  # type: ignore[no-any-return]

    @property
    def certificate(self) -> HyperbolicityCertificate | None:
        """The evidence; its check() searches for nothing."""
        data = self._fields["certificate"]
        return None if data is None else HyperbolicityCertificate(data)

    @property
    def pieces(self) -> list[dict[str, Any]]:
        """Where a disc or a sphere was found, what it cuts the manifold into: "signature" of an ideal
        triangulation (None for balls and handlebodies), "name" if it is known."""
        return list(self._fields["pieces"])

    @property
    def name(self) -> str | None:
        """What the manifold is, if it was recognised: "handlebody of genus 2", ..."""
        return self._fields["name"]  # type: ignore[no-any-return]

    @property
    def tried(self) -> list[str]:
        """The tests that were made, with what came out, in words."""
        return list(self._fields["tried"])

    @property
    def advice(self) -> str | None:
        """What may decide it, where it was not decided: "more time", "surfaces" (a search for them);
        None where neither does."""
        return self._fields["advice"]  # type: ignore[no-any-return]

    @property
    def seconds(self) -> float:
        """Time it took."""
        return float(self._fields["seconds"])

    @property
    def message(self) -> str:
        """One sentence for a person."""
        return str(self._fields["message"])

    def to_json(self) -> str:
        """One object, without a line end; docs/verdicts.md has its keys."""
        return json.dumps(self._fields)

    def __repr__(self) -> str:
        return self.message


class _Decision:
    def __init__(self, manifold: Manifold, time_limit: float, surfaces: bool) -> None:
        self.began = time.monotonic()
        self.deadline = self.began + time_limit
        self.surfaces = surfaces
        self.advice: str | None = None
        self.tried: list[str] = []
        self.given = manifold
        self.manifold = manifold  # the same with fewer tetrahedra, where that is needed

    def left(self) -> float:
        return max(1e-3, self.deadline - time.monotonic())

    def is_over(self) -> bool:
        return time.monotonic() >= self.deadline

    @functools.cached_property
    def table(self) -> Table:
        """Of self.manifold, when that is settled."""
        return Table(self.manifold.gluings)

    def run(self, metric: bool = True) -> Hyperbolicity:
        self.metric = metric
        is_large = self.given.num_tetrahedra() > LARGE
        if needs_simplifying(self.given):
            self._simplify()
        else:
            # Of a large one that has no metric the moves and the group need the time.
            share = self.left() / (3 if is_large else 1)
            answer = self._by_metric(self.given, share)
            if answer is not None:
                return answer
            if is_large:
                self._simplify()
        objection = _objection(self.manifold)
        tests: list[Callable[[], Hyperbolicity | None]] = []
        if self.manifold is not self.given:
            tests.append(functools.partial(self._by_metric, self.manifold))
        if objection:
            tests.append(functools.partial(self._by_other_metric, FAR))
        else:
            tests += [self._by_group, self._by_bigon]
            tests.append(functools.partial(self._by_other_metric, NEAR))
            if self.surfaces:
                tests.append(self._by_surface)
        for test in tests:
            if self.is_over():
                break
            answer = test()
            if answer is not None:  # an answer of "no" is one, too
                return answer
        if objection:
            self.tried.append(objection)
        return self._not_decided(surfaces_help=not objection and not self.surfaces)

    def _simplify(self) -> None:
        """What a search that was cut short leaves could not be made anew by a check."""
        before = self.given.num_tetrahedra()
        seconds = self.left() / 2
        begin = time.monotonic()
        small = self.given.simplified(time_limit=seconds)
        if time.monotonic() - begin < seconds:
            self.manifold = small
            return
        self.tried.append(f"fewer tetrahedra than {before}: not done after {seconds:.2g} s")

    # Yes

    def _by_metric(self, manifold: Manifold, limit: float = math.inf) -> Hyperbolicity | None:
        if not self.metric:
            return None
        if manifold.verdict(time_limit=min(limit, self.left())).outcome != "geometric":
            return None
        found = manifold.prove(time_limit=self.left())
        proof, reason = (json.loads(found.to_json()), "") if found else (None, found.reason)
        certificate = {
            "by": "metric",
            "gluings": self.given.gluings,
            "triangulation": manifold.gluings,
            "proof": proof,
            "reason": reason,
        }
        volume = f"volume {manifold.volume():.12g}"
        message = f"hyperbolic: a metric of {volume}, " + (
            "proved" if proof else "in floating point, not proved"
        )
        return self._answer(True, "metric", message, certificate, proved=proof is not None)

    def _by_other_metric(self, budget: int) -> Hyperbolicity | None:
        if not self.metric:
            return None
        seconds = self.left() if budget == NEAR else min(self.left(), FAR_SECONDS)
        other = self.manifold.retriangulated(budget=budget, time_limit=seconds)
        answer = self._by_metric(other)
        if answer is None:
            self.tried.append(
                f"a metric on other triangulations: none on {budget}, or as many as were reached in "
                f"{seconds:.2g} s"
            )
        return answer

    # No

    def _by_group(self) -> Hyperbolicity | None:
        size = self.manifold.num_tetrahedra()
        if READING * size > self.left():
            self.tried.append(
                f"the fundamental group: not read, as {size} tetrahedra are too many for "
                f"{self.left():.2g} s"
            )
            return None
        group = presentation.of_table(self.table, self.deadline)
        start = [list(group.generators), [list(word) for word in group.relators]]
        group.simplify()
        group.shorten()
        if self.is_over():
            self.tried.append("the fundamental group: the time was over while it was made simpler")
            return None
        parts: list[list[int]] | None
        if not group.relators and len(group.generators) > 1:
            by, parts = "free group", [group.generators]
        else:
            by, split = "free product", group.splitting()
            parts = None if split is None else list(split)
        if parts is None:
            number = len(group.relators)
            count = f"{len(group.generators)} generators, {number} relator{'s' * (number != 1)}"
            self.tried.append(f"the fundamental group: {count}, seen neither free nor a free product")
            return None
        certificate = {
            "by": by,
            "gluings": self.table.rows(),
            "group": {
                "generators": start[0],
                "relators": start[1],
                "moves": group.moves,
                "factors": parts,
            },
        }
        name = group_name(group, self.table.link_characteristics.values())
        message = "not hyperbolic: an essential disc, as the fundamental group is free"
        if by == "free product":
            message = "not hyperbolic: an essential disc or sphere, as the fundamental group is a free product"
        if name:
            message += f" ({name})"
        return self._answer(False, by, message + ", certificate attached", certificate, name=name)

    def _by_bigon(self) -> Hyperbolicity | None:
        bigon = self.manifold._core.closed_bigon()
        if bigon is None or not bigon["decides"]:
            hint = "none" if bigon is None else "an annulus, which may be trivial"
            self.tried.append(f"closed bigons: {hint}")
            return None
        certificate = {"by": "closed bigon", "gluings": self.table.rows(), "bigon": bigon}
        kind = str(bigon["surface"])
        what = {
            "moebius band": "a Moebius band",
            "disc": "an essential disc",
            "essential annulus": "an essential annulus",
        }[bigon["consequence"]]
        message = f"not hyperbolic: {what}, certificate attached"
        return self._answer(False, "closed bigon", message, certificate, kind=kind)

    def _by_surface(self) -> Hyperbolicity | None:
        from tripus.hyperbolic.worker import worker

        try:
            searcher = worker()
        except Unsupported as error:
            self.tried.append(str(error))
            return self._by_other_metric(FAR)
        searcher.start(self.table.rows(), self.left())
        try:
            found, told = searcher.wait(min(self.deadline, time.monotonic() + WAIT))
            if found is None and not told.get("over"):
                answer = self._by_other_metric(FAR)
                if answer is not None:
                    searcher.end()
                    return answer
                found, told = searcher.wait(self.deadline)
        except BaseException:
            searcher.end()
            raise
        if found is None:
            searcher.end()
            self.tried.append(surfaces_tried(told))
            return None
        return self._surface_answer(found)

    def _surface_answer(self, found: dict[str, Any]) -> Hyperbolicity:
        pieces = found.pop("pieces", [])
        if "surface" not in found:
            certificate = {"by": "compressing disc", "gluings": self.table.rows(), **found}
            message = "not hyperbolic: an essential disc, by Regina's hasCompressingDisc"
            return self._answer(False, "compressing disc", message, certificate, kind="disc")
        certificate = {"by": "surface", "gluings": self.table.rows(), **found}
        kind = str(found["surface"]["kind"])
        what = _ARTICLES.get(kind, f"a {kind.replace('moebius', 'Moebius').replace('klein', 'Klein')}")
        chi = found["surface"]["euler_characteristic"]
        message = f"not hyperbolic: {what}, Euler characteristic {chi}, certificate attached"
        return self._answer(False, "surface", message, certificate, kind=kind, pieces=pieces)

    # The answer

    def _not_decided(self, surfaces_help: bool) -> Hyperbolicity:
        if self.is_over():
            self.advice = "more time"
        elif surfaces_help:
            self.advice = "surfaces"
        message = "not decided; tried: " + "; ".join(self.tried or ["nothing, for want of time"])
        return self._answer(None, None, message, None, proved=False)

    def _answer(
        self,
        hyperbolic: bool | None,
        by: str | None,
        message: str,
        certificate: dict[str, Any] | None,
        *,
        proved: bool = True,
        kind: str | None = None,
        pieces: list[dict[str, Any]] | None = None,
        name: str | None = None,
    ) -> Hyperbolicity:
        return Hyperbolicity(
            {
                "hyperbolic": hyperbolic,
                "proved": proved,
                "by": by,
                "kind": kind,
                "certificate": certificate,
                "pieces": pieces or [],
                "name": name,
                "tried": self.tried,
                "advice": self.advice,
                "seconds": round(time.monotonic() - self.began, 6),
                "message": message,
            }
        )


def needs_simplifying(manifold: Manifold) -> bool:
    """Whether there are finite vertices beside the boundary, which the tests do not know."""
    spheres = sum(link["euler_characteristic"] > 0 for link in manifold.links())
    return manifold.has_finite_vertices() and spheres < len(manifold.links())


def _objection(manifold: Manifold) -> str:
    """Why only a metric is looked for; empty if the other tests know such manifolds."""
    links = [link["euler_characteristic"] for link in manifold.links()]
    if not manifold.is_connected():
        return "only connected manifolds are decided"
    if not manifold.is_orientable():
        return "surfaces and groups: not tried, as the manifold is not orientable; its orientable double cover may be"
    if any(chi > 0 for chi in links) or all(chi == 0 for chi in links):
        return "surfaces and groups: not tried, as no boundary component has genus 2 or more"
    return ""


def surfaces_tried(told: dict[str, Any]) -> str:
    """In words, from what a search has told."""
    searches, surfaces = told.get("searched", [0, 0])
    number = told.get("round", [0])[0] + 1
    return f"normal surfaces: {surfaces} in {searches} searches of {number} triangulations"


def hyperbolicity(
    manifold: Manifold, time_limit: float | None = None, surfaces: bool = True
) -> Hyperbolicity:
    """See Manifold.hyperbolicity."""
    seconds = TIME_LIMIT if time_limit is None else time_limit
    if not (seconds > 0 and math.isfinite(seconds)):
        raise InvalidInput(f"time_limit is a number of seconds > 0, not {time_limit!r}")
    if manifold._core.is_labelled():
        raise Unsupported(
            f"{manifold} has cone angles other than 2 pi: whether an orbifold is hyperbolic is not decided "
            "so far; with_cone_angles() is the manifold without them"
        )
    return _Decision(manifold, seconds, surfaces).run()


def without_metric(
    manifold: Manifold, time_limit: float, surfaces: bool = True
) -> Hyperbolicity:
    """All the tests but the metric: for hyperbolic manifolds, where none may say "no"."""
    return _Decision(manifold, time_limit, surfaces).run(metric=False)
