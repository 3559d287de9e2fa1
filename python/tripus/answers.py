"""Answers: values that say what was found, with the evidence. All of them pickle."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._errors import Undecided
from tripus._limits import Progress, limits
from tripus.groups import AbelianGroup, IsometryGroup

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

    def __reduce__(self) -> tuple[Any, ...]:
        return Volume, (float(self), self._metric, self._bounds)


class Verdict:
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
    def history(self) -> Any:
        """Of solve(history=True): a data frame with a row an iteration (or a structured array)."""
        rows = self._fields.get("history")
        return None if rows is None else frame(rows)

    def __repr__(self) -> str:
        return f"<Verdict {self.outcome}: {self.message}>"

    def _repr_html_(self) -> str:
        rows = {
            "outcome": self.outcome,
            "volume": f"{self.volume:.12g}" if self else "",
            "max|K|": f"{self.max_curvature:.3g}",
            "method": f"{self.method}, {self.iterations} iterations",
            "": self.message,
        }
        return html_table(rows)


class Certificate:
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

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Certificate) and self._text == other._text

    def __hash__(self) -> int:
        return hash(self._text)

    def __repr__(self) -> str:
        return f"<Certificate of kind {self.kind}, {len(self.edge)} edge classes>"


class AngleStructure:
    """An exact strict angle structure: rational angles, in units of pi."""

    def __init__(self, text: str) -> None:
        self._text = text

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


class Proof:
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
        return bool(_core.check_proof(self._manifold._core, self._text, limits())[0])

    def to_json(self) -> str:
        """The proof as `tripus check` reads it."""
        return self._text

    def __repr__(self) -> str:
        return f"<Proof: {self.message}>"


def _exact(text: str) -> Fraction:
    """Decimal, or binary such as 0x1.3p-1."""
    return Fraction(float.fromhex(text)) if "x" in text else Fraction(text)


class Comparison:
    """Whether two manifolds are isometric, and how it was decided.

    True or False; where it was not decided, bool() raises Undecided, for False would be wrong.

    >>> import tripus
    >>> answer = tripus.Manifold("cPcbbbihq").is_isometric_to(tripus.Manifold("cPcbbbdhq"))
    >>> bool(answer), answer.decided_by
    (False, 'decomposition')
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    @property
    def verdict(self) -> str:
        """ "homeomorphic", "different" or "unresolved"."""
        return str(self._fields["verdict"])

    @property
    def decided_by(self) -> str:
        """What decided: "boundary", "homology", "volume", "decomposition", ..."""
        return str(self._fields["decided_by"])

    @property
    def message(self) -> str:
        """One sentence for a person."""
        return str(self._fields["message"])

    @property
    def advice(self) -> str:
        """What to do where it was not decided."""
        return str(self._fields["advice"])

    @property
    def keeps_orientation(self) -> bool:
        """Whether an isometry keeps the orientations of the two triangulations."""
        return bool(self._fields["keeps_orientation"])

    @property
    def reverses_orientation(self) -> bool:
        """Whether an isometry reverses them."""
        return bool(self._fields["reverses_orientation"])

    @property
    def orientations_known(self) -> bool:
        """False where a signature without a sign left an orientation open."""
        return bool(self._fields["orientations_known"])

    @property
    def isometry(self) -> tuple[list[int], list[list[int]]] | None:
        """(images of the canonical cells, images of their vertices), where one was found."""
        return self._fields.get("isometry")

    def __bool__(self) -> bool:
        if self.verdict == "unresolved":
            raise Undecided(self.message, self)
        return self.verdict == "homeomorphic"

    def __repr__(self) -> str:
        return f"<Comparison {self.verdict}: {self.message}>"


class CanonicalDecomposition:
    """The canonical (Kojima) decomposition of a manifold, or why it was not found.

    >>> import tripus
    >>> found = tripus.Manifold("cPcbbbihq").canonical()
    >>> found.cells, found.signature, bool(found)
    ('2 tetrahedra', 'cPcbbbihq', True)
    """

    def __init__(self, fields: dict[str, Any], name: str) -> None:
        self._fields = dict(fields)
        self._name = name
        self._fields["verdict"] = Verdict(self._fields["verdict"])
        if "triangulation" in self._fields:
            from tripus.manifold import Manifold

            self._fields["triangulation"] = Manifold._wrap(self._fields["triangulation"])

    def __bool__(self) -> bool:
        return bool(self._fields["found"])

    def __getstate__(self) -> dict[str, Any]:
        return dict(self.__dict__)

    def _get(self, key: str) -> Any:
        if not self:
            raise Undecided(self.message, self)
        return self._fields[key]

    @property
    def message(self) -> str:
        """One sentence for a person."""
        return str(self._fields["message"])

    @property
    def advice(self) -> str:
        """What to do where it was not found."""
        return str(self._fields["advice"])

    @property
    def verdict(self) -> Verdict:
        """Of the triangulation that it was found from."""
        return self._fields["verdict"]  # type: ignore[no-any-return]

    @property
    def triangulation(self) -> Manifold:
        """A triangulation that subdivides the decomposition and carries the metric."""
        return self._get("triangulation")  # type: ignore[no-any-return]

    @property
    def cells(self) -> str:
        """ "4 tetrahedra", "1 octahedron", "2 tetrahedra + 1 pyramid"."""
        return str(self._get("cells"))

    @property
    def cell_types(self) -> list[str]:
        """The type of each cell."""
        return list(self._get("cell_types"))

    @property
    def edge_lengths(self) -> npt.NDArray[np.float64]:
        """Lengths of its edges, ascending."""
        return self._get("edge_lengths")  # type: ignore[no-any-return]

    @property
    def signature(self) -> str:
        """Equal exactly for isometric manifolds, mirror images included."""
        return str(self._get("signature"))

    @property
    def oriented_signature(self) -> str:
        """The same with a sign that tells a chiral manifold from its mirror image."""
        return str(self._get("oriented_signature"))

    @property
    def isometry_group(self) -> IsometryGroup:
        """The isometry group."""
        return IsometryGroup(self._get("isometries"))

    @property
    def volume(self) -> float:
        """The volume, from this triangulation."""
        return float(self._get("volume"))

    @property
    def volume_error(self) -> float:
        """An estimate, not proved, of what it may be off."""
        return float(self._get("volume_error"))

    @property
    def margin(self) -> float:
        """How far from 0 the nearest tilt sum of a true face was."""
        return float(self._get("margin"))

    @property
    def path(self) -> list[str]:
        """The moves from the triangulation given, or a simplification of it, to this one."""
        return list(self._get("path"))

    def __repr__(self) -> str:
        return f"<CanonicalDecomposition: {self._fields['cells'] if self else self.message}>"


class CensusEntry:
    """A manifold in a table.

    >>> import tripus
    >>> tripus.Manifold("cPcbbbihq").identify()
    [<CensusEntry t2g2.8 of tripus, volume 6.45199027084>]
    """

    def __init__(self, table: str, fields: dict[str, Any]) -> None:
        self._table = table
        self._fields = fields

    @property
    def table(self) -> str:
        """ "tripus" for the census that comes with it, "snappy" for SnapPy's tables."""
        return self._table

    @property
    def name(self) -> str:
        """ "t3g2.17", "m015"."""
        return str(self._fields["name"])

    @property
    def volume(self) -> float:
        """As the table has it."""
        return float(self._fields["volume"])

    def homology(self) -> AbelianGroup:
        """First homology."""
        return parse_group(self._fields["homology"])

    @property
    def tetrahedra(self) -> int:
        """Least number of tetrahedra known."""
        return int(self._fields["tetrahedra"])

    @property
    def boundary(self) -> str:
        """ "g2", "g2+g3": genera of the boundary components."""
        return str(self._fields.get("boundary", ""))

    @property
    def cells(self) -> str:
        """Of the canonical decomposition."""
        return str(self._fields.get("cells", ""))

    @property
    def signature(self) -> str:
        """Isometry signature."""
        return str(self._fields.get("signature", ""))

    @property
    def triangulations(self) -> list[str]:
        """Isomorphism signatures."""
        return list(self._fields.get("triangulations", []))

    def as_dict(self) -> dict[str, Any]:
        """All there is, for a data frame."""
        return {"table": self._table, **self._fields}

    def manifold(self) -> Manifold:
        """The manifold, by its first triangulation."""
        from tripus.manifold import Manifold

        return Manifold(self.triangulations[0], name=self.name)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CensusEntry) and (self._table, self.name) == (
            other._table,
            other.name,
        )

    def __hash__(self) -> int:
        return hash((self._table, self.name))

    def __repr__(self) -> str:
        return f"<CensusEntry {self.name} of {self._table}, volume {self.volume:.12g}>"


def parse_group(text: str) -> AbelianGroup:
    """The group that "2 Z + Z_3" means.

    >>> parse_group("2 Z + Z_3 + 2 Z_6")
    Z/3 + Z/6 + Z/6 + Z + Z
    """
    rank, factors = 0, []
    for part in text.split(" + ") if text != "0" else []:
        count, _, kind = part.rpartition(" ")
        if kind == "Z":
            rank += int(count or 1)
        else:
            factors += [int(kind[2:])] * int(count or 1)
    return AbelianGroup(rank, factors)


class Orthospectrum:
    """Lengths of the geodesic arcs orthogonal to the boundary at both ends, with multiplicities.

    >>> import tripus
    >>> arcs = tripus.Manifold("cPcbbbihq").orthospectrum(length=2)
    >>> float(arcs.lengths[0]).__round__(9), int(arcs.multiplicities[0]), arcs.complete
    (0.596133895, 1, True)
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    @property
    def complete(self) -> bool:
        """False if a stop or a time limit ended the search; all up to `length` are there."""
        return bool(self._fields["complete"])

    @property
    def length(self) -> float:
        """All arcs up to this length are there."""
        return float(self._fields["length"])

    @property
    def arc_count(self) -> int:
        """Number of arcs."""
        return int(self._fields["arc_count"])

    @property
    def lengths(self) -> npt.NDArray[np.float64]:
        """[n] lengths, ascending."""
        return self._fields["lengths"]  # type: ignore[no-any-return]

    @property
    def multiplicities(self) -> npt.NDArray[np.uint64]:
        """[n] how many arcs have this length between these boundary components."""
        return self._fields["multiplicities"]  # type: ignore[no-any-return]

    @property
    def ends(self) -> npt.NDArray[np.uint32]:
        """[n x 2] the boundary components."""
        return self._fields["ends"]  # type: ignore[no-any-return]

    @property
    def edges(self) -> list[list[int]]:
        """[n] the edge classes among them."""
        return [list(e) for e in self._fields["edges"]]

    @property
    def area(self) -> dict[str, Any]:
        """Basmajian's identity: counted, exact, tail (value, uncertainty)."""
        return dict(self._fields["area"])

    @property
    def volume(self) -> dict[str, Any]:
        """Bridgeman and Kahn's identity: counted, exact, tail (value, uncertainty)."""
        return dict(self._fields["volume"])

    @property
    def dimension(self) -> tuple[float, float] | None:
        """Hausdorff dimension of the limit set, with its uncertainty; None for few arcs."""
        return self._fields["dimension"]  # type: ignore[no-any-return]

    def to_frame(self) -> Any:
        """A pandas data frame: length, multiplicity, from, to."""
        import pandas

        return pandas.DataFrame(
            {
                "length": self.lengths,
                "multiplicity": self.multiplicities,
                "from": self.ends[:, 0],
                "to": self.ends[:, 1],
            }
        )

    def __repr__(self) -> str:
        return f"<Orthospectrum: {self.arc_count} arcs up to length {self.length:.6g}>"


def frame(columns: dict[str, Any]) -> Any:
    """A pandas data frame, or a structured array where pandas is not installed."""
    try:
        import pandas
    except ImportError:
        return structured(columns)
    return pandas.DataFrame(columns, copy=False)


def structured(columns: dict[str, Any]) -> npt.NDArray[np.void]:
    """A structured array: numbers as they are, texts as objects."""
    arrays = {
        name: np.asarray(c) if isinstance(c, np.ndarray) else np.array(list(c), dtype=object)
        for name, c in columns.items()
    }
    size = len(next(iter(arrays.values()), ()))
    out = np.empty(size, dtype=[(name, a.dtype) for name, a in arrays.items()])
    for name, a in arrays.items():
        out[name] = a
    return out


def html_table(rows: dict[str, str], caption: str = "") -> str:
    """A small table for notebooks."""
    from html import escape

    body = "".join(
        f"<tr><th style='text-align:left'>{escape(k)}</th>"
        f"<td style='text-align:left'>{escape(v)}</td></tr>"
        for k, v in rows.items()
        if v
    )
    head = f"<caption>{escape(caption)}</caption>" if caption else ""
    return f"<table>{head}{body}</table>"


__all__ = [
    "AngleStructure",
    "CanonicalDecomposition",
    "CensusEntry",
    "Certificate",
    "Comparison",
    "Orthospectrum",
    "Progress",
    "Proof",
    "Verdict",
    "Volume",
]
