"""What was found about one triangulation, with the evidence. All of it pickles."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._errors import Undecided
from tripus._check import checked
from tripus._limits import NO_LIMITS
from tripus._value import Value
from tripus.frames import frame, html_table

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
    from tripus.metric import Metric
else:
    from tripus._lazy import numpy as np


class Volume(float):
    """A hyperbolic volume: a float, which knows what it may be off.

    >>> import tripus
    >>> v = tripus.Manifold("cPcbbbihq").volume()
    >>> v
    6.451990270835
    >>> f"{v:.12f}", v + 1 == float(v) + 1
    ('6.451990270835', True)
    >>> v.error < 1e-11, v.interval[0] <= v <= v.interval[1]
    (True, True)
    """

    __slots__ = ("_metric", "_bounds")
    _metric: Metric
    _bounds: tuple[float, float] | str | None

    def __new__(cls, value: float, metric: Metric, bounds: Any = None) -> Volume:
        self = super().__new__(cls, value)
        self._metric = metric
        self._bounds = bounds
        return self

    def _proved(self) -> tuple[float, float] | str:
        bounds: Any = self._bounds
        if bounds is None:
            bounds = self._bounds = _core.volume_bounds(self._metric._core)  # type: ignore[assignment]
        return bounds  # type: ignore[no-any-return]

    @property
    def is_proved(self) -> bool:
        """Whether `interval` and `error` are proved, every rounding accounted for."""
        return not isinstance(self._proved(), str)

    @property
    def interval(self) -> tuple[float, float]:
        """Lower and upper bound, proved; Undecided, with the reason, where the proof fails."""
        bounds = self._proved()
        if isinstance(bounds, str):
            raise Undecided(f"the volume is not proved: {bounds}", bounds)
        return bounds

    @property
    def error(self) -> float:
        """How far the true volume is from this number at most: proved, computed when asked for.

        Undecided where the proof does not go through.
        """
        lower, upper = self.interval
        return float(np.nextafter(max(float(self) - lower, upper - float(self)), np.inf))

    def __repr__(self) -> str:
        return f"{float(self):.13g}"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        return html_table({"volume": repr(self)})

    def __reduce__(self) -> tuple[Any, ...]:
        return Volume, (float(self), self._metric, self._bounds)


class Verdict(Value):
    """What was found about a triangulation, with the evidence. True if there is a metric.

    The numbers are those of the last iterate, also where there is no metric; always finite.

    >>> import tripus
    >>> verdict = tripus.Manifold("cPcbbbihq").verdict()
    >>> verdict.outcome, bool(verdict)
    ('geometric', True)
    """

    def __init__(self, fields: dict[str, Any], signature: str = "") -> None:
        self._fields = fields
        self._label = signature
        for name in ("edge_lengths", "dihedral_angles"):
            fields[name].flags.writeable = False

    def _key(self) -> Any:
        return {
            key: value
            for key, value in self._fields.items()
            if key not in ("seconds", "history")  # which no two runs have in common
        }

    def _rows(self) -> dict[str, str]:
        return {
            "outcome": self.outcome,
            "volume": f"{self.volume:.12g}" if self else "",
            "max|K|": f"{self.max_curvature:.3g}",
            "method": f"{self.method}, {self.iterations} iteration{'s'[: self.iterations != 1]}",
            "": self.message,
        }

    def __bool__(self) -> bool:
        return self.outcome == "geometric"

    @property
    def outcome(self) -> str:
        """ "geometric", "degenerate" (flat tetrahedra), "infeasible" (proved) or "unresolved"."""
        return str(self._fields["outcome"])

    @property
    def message(self) -> str:
        """One sentence for a person."""
        return str(self._fields["message"])

    @property
    def advice(self) -> str:
        """What to do where nothing was found: "retriangulate", "more time", ...; or "none"."""
        return str(self._fields["advice"])

    @property
    def termination(self) -> str:
        """Why the iteration ended."""
        return str(self._fields["termination"])

    @property
    def method(self) -> str:
        """Name of the method, as in `tripus.methods()`."""
        return str(self._fields["method"])

    @property
    def iterations(self) -> int:
        """Steps of the method."""
        return int(self._fields["iterations"])

    @property
    def evaluations(self) -> int:
        """Evaluations of the energy."""
        return int(self._fields["evaluations"])

    @property
    def seconds(self) -> float:
        """Time it took."""
        return float(self._fields["seconds"])

    @property
    def max_curvature(self) -> float:
        """max |K|, radians: how far the angles around an edge are from the cone angle at most."""
        return float(self._fields["max_curvature"])

    @property
    def volume(self) -> float:
        """Hyperbolic volume of the tetrahedra of the last iterate."""
        return float(self._fields["volume"])

    @property
    def edge_lengths(self) -> npt.NDArray[np.float64]:
        """[E] lengths of the edge classes."""
        return self._fields["edge_lengths"]  # type: ignore[no-any-return]

    @property
    def dihedral_angles(self) -> npt.NDArray[np.float64]:
        """[T x 6] radians at the edges 01 02 03 12 13 23."""
        return self._fields["dihedral_angles"]  # type: ignore[no-any-return]

    @property
    def vertices(self) -> list[dict[str, Any]]:
        """[V] kind, Euler characteristic, cone points and area of each vertex class."""
        return [dict(v) for v in self._fields["vertices"]]

    @property
    def flat_tetrahedra(self) -> list[int]:
        """Numbers of the flat tetrahedra of a degenerate outcome."""
        return list(self._fields["flat_tetrahedra"])

    @property
    def certificate(self) -> Certificate | None:
        """The exact proof that there is no strict angle structure, where there is one."""
        text = self._fields.get("certificate")
        return Certificate(text) if text else None

    @property
    def angle_structure(self) -> AngleStructure | None:
        """An exact strict angle structure, where one was decided to exist, or asked for."""
        text = self._fields.get("angle_structure")
        return AngleStructure(text) if text else None

    @property
    def closed_bigon(self) -> dict[str, Any] | None:
        """Of a triangulation without a metric: a surface at an edge of valence 2 which proves
        that the manifold is not hyperbolic ("decides"), or hints at it; docs/verdicts.md."""
        found = self._fields.get("closed_bigon")
        return None if found is None else dict(found)

    @property
    def history(self) -> Any:
        """Of solve(history=True): a data frame with a row an iteration (or a structured array)."""
        rows = self._fields.get("history")
        return None if rows is None else frame(rows)

    def __repr__(self) -> str:
        bigon = self.closed_bigon
        if bigon is not None and bigon["decides"]:
            return f"<Verdict {self.outcome}; not hyperbolic: {bigon['consequence']}>"
        return f"<Verdict {self.outcome}: {self.message}>"


@checked
class Certificate(Value):
    """An exact proof, in integers, that a triangulation has no strict angle structure.

    >>> import tripus
    >>> M = tripus.Manifold("dLQbcbcaekw")
    >>> certificate = M.verdict().certificate
    >>> certificate, certificate.check(M)
    (<Certificate of kind semi, 2 edge classes>, True)
    """

    def __init__(self, text: str) -> None:
        self._text = text

    def _data(self) -> dict[str, Any]:
        return json.loads(self._text)  # type: ignore[no-any-return]

    @property
    def kind(self) -> str:
        """ "none": no angle structure at all; "semi": none without zero angles."""
        return str(self._data()["kind"])

    @property
    def edge(self) -> list[int]:
        """[E] integer multipliers."""
        return list(self._data()["edge"])

    @property
    def vertex(self) -> list[list[int]]:
        """[T][4] integer multipliers."""
        return list(self._data()["vertex"])

    def check(self, manifold: Manifold) -> bool:
        """Checks it by integer arithmetic, with code that shares nothing with its maker."""
        return bool(_core.check_certificate(manifold._core, self._text)[0])

    def to_json(self) -> str:
        """The certificate as `tripus check` reads it."""
        return self._text

    def _key(self) -> Any:
        return self._text

    def _rows(self) -> dict[str, str]:
        return {
            "certificate": self.kind,
            "says": "no angle structure" if self.kind == "none" else "no strict angle structure",
            "edge classes": f"{sum(x != 0 for x in self.edge)} of {len(self.edge)} have multipliers",
        }

    def __repr__(self) -> str:
        return f"<Certificate of kind {self.kind}, {len(self.edge)} edge classes>"


class AngleStructure(Value):
    """An exact strict angle structure: rational angles, in units of pi."""

    def __init__(self, text: str) -> None:
        self._text = text

    def _key(self) -> Any:
        return self._text

    def _rows(self) -> dict[str, str]:
        rows = {
            f"tetrahedron {t}": ", ".join(map(str, six)) + " (times pi)"
            for t, six in enumerate(self.angles[:6])
        }
        if len(self.angles) > 6:
            rows["..."] = f"{len(self.angles) - 6} more tetrahedra"
        return rows

    @property
    def angles(self) -> list[list[Fraction]]:
        """[T][6] in units of pi, at the edges 01 02 03 12 13 23."""
        data = json.loads(self._text)
        return [[Fraction(n, data["denominator"]) for n in six] for six in data["numerators"]]

    def to_json(self) -> str:
        """{"denominator": d, "numerators": [[6 integers], ...]}"""
        return self._text

    def __repr__(self) -> str:
        return f"<AngleStructure of {len(self.angles)} tetrahedra>"


class Proof(Value):
    """A proof that the metric exists, with every rounding accounted for. True if proved.

    Unpacks into (proved, intervals of the edge lengths), as SnapPy's verify_hyperbolicity does.

    >>> import tripus
    >>> M = tripus.Manifold("cPcbbbihq")
    >>> proved, lengths = M.verify_hyperbolicity()
    >>> proved, len(lengths)
    (True, 1)
    >>> M.prove(digits=30).volume[0][:32]
    '6.451990270835032865298234421060'
    """

    def __init__(self, text: str, message: str, manifold: Manifold) -> None:
        self._text = text
        self._manifold = manifold
        self.message = message

    def _key(self) -> Any:
        return self._text, self._manifold

    def _rows(self) -> dict[str, str]:
        volume = self.volume
        return {
            "proved": "yes" if self else "no",
            "volume": "" if volume is None else f"[{volume[0]}, {volume[1]}]",
            "": self.message,
        }

    def __bool__(self) -> bool:
        return bool(self._data()["proved"])

    def __iter__(self) -> Iterator[Any]:
        yield bool(self)
        yield self.length_intervals()

    def _data(self) -> dict[str, Any]:
        return json.loads(self._text)  # type: ignore[no-any-return]

    @property
    def reason(self) -> str:
        """Why not, in a sentence; empty if proved."""
        return str(self._data().get("reason", ""))

    @property
    def lengths(self) -> list[str]:
        """[E] centres of the lengths, exact numbers as text."""
        return list(self._data().get("lengths", []))

    @property
    def radii(self) -> list[str]:
        """[E] how far the true lengths are from these at most."""
        return list(self._data().get("radii", []))

    @property
    def volume(self) -> tuple[str, str] | None:
        """Lower and upper bound of the volume, decimal numbers as text."""
        pair = self._data().get("volume")
        return None if pair is None else (pair[0], pair[1])

    def length_intervals(self) -> list[tuple[float, float]]:
        """[E] doubles around which the true lengths are proved to be."""
        out = []
        for centre, radius in zip(self.lengths, self.radii):
            c, r = _exact(centre), _exact(radius)
            low, high = float(c - r), float(c + r)
            out.append(
                (
                    low if Fraction(low) <= c - r else float(np.nextafter(low, -np.inf)),
                    high if Fraction(high) >= c + r else float(np.nextafter(high, np.inf)),
                )
            )
        return out

    def check(self) -> bool:
        """Checks it by code that shares nothing with its maker but the theory."""
        return bool(_core.check_proof(self._manifold._core, self._text, NO_LIMITS)[0])

    def to_json(self) -> str:
        """The proof as `tripus check` reads it."""
        return self._text

    def __repr__(self) -> str:
        return f"<Proof: {self.message}>"


def _exact(text: str) -> Fraction:
    """Decimal, or binary such as 0x1.3p-1."""
    return Fraction(float.fromhex(text)) if "x" in text else Fraction(text)
