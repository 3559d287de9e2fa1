"""What was found about a manifold, whatever its triangulation. All of it pickles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tripus._errors import Undecided
from tripus._value import Value, frozen
from tripus.groups import AbelianGroup, IsometryGroup
from tripus.verdicts import Verdict

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold


class Isometry(Value):
    """An isometry between two manifolds, by what it does to their canonical decompositions.

    Cells, and the vertices of a cell, are numbered as in `canonical()`; boundary components (vertex
    classes) as in `canonical().triangulation`.

    >>> import tripus
    >>> M = tripus.Manifold("cPcbbbihq")
    >>> isometries = M.is_isometric_to(M, return_isometries=True)
    >>> len(isometries), isometries[0]
    (6, <Isometry 0 -> 0; cell 0 to 0 by 0123>)
    """

    def __init__(
        self,
        cell_images: list[int],
        vertex_images: list[list[int]],
        boundary_images: list[int],
        keeps_orientation: bool | None,
    ) -> None:
        self._cells = cell_images
        self._vertices = vertex_images
        self._boundary = boundary_images
        self._keeps = keeps_orientation

    def _key(self) -> Any:
        return self._cells, self._vertices, self._boundary, self._keeps

    def _rows(self) -> dict[str, str]:
        return {
            "boundary": self._arrows(),
            "cells": ", ".join(f"{i} -> {image}" for i, image in enumerate(self._cells)),
            "keeps orientation": {True: "yes", False: "no", None: "not known"}[self._keeps],
        }

    @property
    def cell_images(self) -> list[int]:
        """[cells] where each cell goes."""
        return list(self._cells)

    @property
    def vertex_images(self) -> list[list[int]]:
        """[cells][vertices] where the vertices of each cell go."""
        return [list(images) for images in self._vertices]

    def boundary_images(self) -> list[int]:
        """[V] where each boundary component or cusp goes."""
        return list(self._boundary)

    def cusp_images(self) -> list[int]:
        """SnapPy's name of boundary_images()."""
        return self.boundary_images()

    @property
    def keeps_orientation(self) -> bool | None:
        """Whether it keeps the orientations; None if they are not known, or there is none."""
        return self._keeps

    def _arrows(self) -> str:
        return ", ".join(f"{i} -> {image}" for i, image in enumerate(self._boundary))

    def __repr__(self) -> str:
        vertices = "".join(map(str, self._vertices[0]))
        return f"<Isometry {self._arrows()}; cell 0 to {self._cells[0]} by {vertices}>"


class Comparison(Value):
    """Whether two manifolds are isometric, and how it was decided.

    True or False; where it was not decided, bool() raises Undecided, for False would be wrong.

    >>> import tripus
    >>> answer = tripus.Manifold("cPcbbbihq").is_isometric_to(tripus.Manifold("cPcbbbdhq"))
    >>> bool(answer), answer.decided_by
    (False, 'decomposition')
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    def _key(self) -> Any:
        return self._fields

    def _rows(self) -> dict[str, str]:
        return {
            "isometric": {"homeomorphic": "yes", "different": "no"}.get(self.verdict, "not decided"),
            "decided by": self.decided_by,
            "": self.message,
        }

    def __eq__(self, other: object) -> bool:
        """With True or False: whether that was decided; with another Comparison, all fields."""
        if isinstance(other, bool):
            return self._decided() is other
        return super().__eq__(other)

    def __hash__(self) -> int:
        decided = self._decided()
        return hash(frozen(self._fields) if decided is None else decided)

    def _decided(self) -> bool | None:
        return {"homeomorphic": True, "different": False}.get(self.verdict)

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
        decided = self._decided()
        if decided is None:
            raise Undecided(self.message, self)
        return decided

    def __repr__(self) -> str:
        return f"<Comparison {self.verdict}: {self.message}>"


class CanonicalDecomposition(Value):
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

    def _key(self) -> Any:
        # The triangulation up to labels is not enough: cells are numbered by its tetrahedra.
        exact = {"gluings": self.triangulation.gluings} if self else {}
        return {**self._fields, **exact}, self._name

    def _rows(self) -> dict[str, str]:
        if not self:
            return {"canonical decomposition": self._name, "": self.message}
        return {
            "canonical decomposition": self._name,
            "cells": self.cells,
            "volume": f"{self.volume:.12g}",
            "isometries": f"{self.isometry_group} (order {self.isometry_group.order()})",
            "signature": self.signature if len(self.signature) <= 80 else "",
        }

    def _picture(self) -> str:
        return self.triangulation._picture() if self else ""

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


class CensusEntry(Value):
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

    def _key(self) -> Any:
        return self._table, self.name

    def _rows(self) -> dict[str, str]:
        return {
            "name": f"{self.name} ({self.table})",
            "volume": f"{self.volume:.12g}",
            "H1": str(self.homology()),
            "tetrahedra": str(self.tetrahedra),
            "boundary": self.boundary,
            "cells": self.cells,
        }

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
