"""A census of hyperbolic 3-manifolds with geodesic boundary, made by Tripus, as a data package.

    >>> import tripus_census_5 as census                               # doctest: +SKIP
    >>> len(census.manifolds(boundary="g2", volume=(7.5, 7.6)))          # doctest: +SKIP
    >>> census.find("fLAMcbcbdeedhjhhs").volume                        # doctest: +SKIP

`manifolds` gives the entries in the order of the table: by tetrahedra, boundary, volume, signature. A
signature is an INPUT of Tripus: `tripus.Manifold(entry.signature)`. Needs nothing but Python.
"""

from __future__ import annotations

import sqlite3
from functools import cache
from pathlib import Path
from typing import NamedTuple

__all__ = ["Entry", "connect", "find", "manifolds", "path", "triangulations"]


class Entry(NamedTuple):
    """A manifold of the census."""
    name: str
    tetrahedra: int  #: least number of them among its triangulations in the list
    boundary: str  #: "g2+g3": genera of the geodesic boundary components
    volume: float
    homology: str  #: first homology, "2 Z + Z_3"
    cells: str  #: of the canonical decomposition
    keeping: int  #: isometries that keep the orientation
    reversing: int  #: and that reverse it
    signature: str  #: isometry signature


def path() -> Path:
    """The SQLite database."""
    return Path(__file__).with_name("census.sqlite")


@cache
def connect() -> sqlite3.Connection:
    """The database, opened for reading: tables `manifold`, `triangulation`, `unresolved`, `about`."""
    return sqlite3.connect(f"{path().as_uri()}?immutable=1", uri=True, check_same_thread=False)


_COLUMNS = ", ".join(f"manifold.{name}" for name in Entry._fields)


def manifolds(*, boundary: str | None = None, homology: str | None = None, cells: str | None = None,
              tetrahedra: int | None = None,
              volume: tuple[float, float] | None = None) -> list[Entry]:
    """The manifolds that have all of what is given; `volume` is a range, ends included."""
    given = {"boundary": boundary, "homology": homology, "cells": cells, "tetrahedra": tetrahedra}
    conditions = [f"{name} = ?" for name, value in given.items() if value is not None]
    values: list[object] = [value for value in given.values() if value is not None]
    if volume is not None:
        low, high = volume
        conditions.append("volume BETWEEN ? AND ?")
        values += [float(low), float(high)]
    where = " WHERE " + " AND ".join(conditions) if conditions else ""
    rows = connect().execute(f"SELECT {_COLUMNS} FROM manifold{where} ORDER BY rowid", values)
    return [Entry(*row) for row in rows]


def find(text: str) -> Entry | None:
    """The manifold of a name, an isometry signature or the signature of a listed triangulation."""
    row = connect().execute(
        f"SELECT {_COLUMNS} FROM manifold WHERE name = ?1 OR signature = ?1 OR name = "
        "(SELECT manifold FROM triangulation WHERE isosig = ?1)", (text.rstrip("+-"),)).fetchone()
    return Entry(*row) if row else None


def triangulations(entry: Entry | str) -> list[str]:
    """The listed triangulations of a manifold, smallest first."""
    name = entry.name if isinstance(entry, Entry) else entry
    return [row[0] for row in connect().execute(
        "SELECT isosig FROM triangulation WHERE manifold = ? ORDER BY rowid", (name,))]
