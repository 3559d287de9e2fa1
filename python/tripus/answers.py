"""What was found about a manifold, whatever its triangulation. All of it pickles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tripus._errors import Undecided
from tripus.groups import AbelianGroup, IsometryGroup
from tripus.verdicts import Verdict

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np


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

    def __eq__(self, other: object) -> bool:
        """With True or False: bool(self), which may raise Undecided; with another, all fields."""
        if isinstance(other, bool):
            return bool(self) is other
        return isinstance(other, Comparison) and self._fields == other._fields

    __hash__ = None  # type: ignore[assignment]

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
    def discs(self) -> npt.NDArray[Any]:
        """[2 arc_count] the discs of the arcs; see Manifold.basmajian_discs."""
        tiles, feet, radii, lengths = self._fields["discs"]
        names = ("tetrahedron", "vertex", "x", "y", "radius", "length")
        kinds = ("u4", "u4", "f8", "f8", "f8", "f8")
        discs = np.empty(len(radii), dtype=list(zip(names, kinds)))
        columns = (tiles[:, 0], tiles[:, 1], feet[:, 0], feet[:, 1], radii, lengths)
        for name, column in zip(names, columns):
            discs[name] = column
        return discs

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
