"""Many at once: lists of triangulations, and the census."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import Any

from tripus import _core
from tripus._check import checked, shown
from tripus._errors import InvalidInput, TripusError
from tripus._limits import Progress, limits
from tripus.answers import CensusEntry
from tripus.frames import frame, structured
from tripus.manifold import Manifold


def load(source: Any, **options: Any) -> Manifold:
    """The same as Manifold(source)."""
    return Manifold(source, **options)


def methods() -> list[str]:
    """Every name that Manifold.solve takes as its method.

    >>> import tripus
    >>> "newton" in tripus.methods()
    True
    """
    return _core.methods()


@checked
def read_batch(path: str | os.PathLike[str]) -> list[str]:
    """The inputs in a file with one a line (# begins a comment), or in a Regina data file."""
    return [os.fsdecode(line) for line in _core.read_batch_file(os.fsencode(path))]


@checked
def solve_many(
    inputs: Iterable[Any] | str | os.PathLike[str],
    *,
    threads: int = 0,
    prove: bool = False,
    as_array: bool = False,
    time_limit: float | None = None,
    progress: Progress = None,
) -> Any:
    """Solves many triangulations on all cores, without the interpreter's lock.

    inputs      anything that Manifold takes, or texts as lines of a batch, with labels behind
                ("eLAkbbcddpuchf 0=7,1=2"); or the name of a file of such lines
    prove       also bounds of the volume that are proved
    as_array    a structured array instead of a pandas data frame
    progress    a function of ("solve", number done), or True for a bar

    Columns: input, outcome ("error" for an input that is refused: it never stops the rest), volume
    (NaN where there is no metric), tetrahedra, max_curvature, iterations, seconds, volume_lower
    and volume_upper if proved, message.

    >>> solve_many(["cPcbbbihq", "cPcbbbiht", "hello"], threads=2)["volume"].round(9).tolist()
    [6.451990271, 2.029883213, nan]
    """
    if isinstance(inputs, (str, os.PathLike)):
        inputs = read_batch(inputs)
    questions: list[Any] = []
    names: list[str] = []
    refused: dict[int, str] = {}
    if isinstance(inputs, (bytes, Manifold)) or not isinstance(inputs, Iterable):
        raise TypeError(
            f"solve_many(): inputs is a list of what Manifold takes, or the name of a file with one "
            f"a line, not {shown(inputs)}"
        )
    for each in inputs:
        try:
            if type(each) is str:
                questions.append(each.encode("utf-8", "surrogateescape"))
                names.append(each)
                continue
            manifold = each if isinstance(each, Manifold) else Manifold(each)
        except (TripusError, TypeError, UnicodeEncodeError) as error:
            refused[len(names)] = str(error)
            questions.append(b"")
            names.append(str(each))
            continue
        questions.append(manifold._core)
        names.append(str(manifold))
    found = _core.solve_many(questions, prove, limits(time_limit, threads, progress))
    found["message"] = [
        refused.get(i, os.fsdecode(m)) for i, m in enumerate(found["message"])
    ]
    columns = {"input": names, **found}
    return structured(columns) if as_array else frame(columns)


@checked
def census(
    *,
    tetrahedra: int | None = None,
    volume: tuple[float, float] | None = None,
    boundary: str = "",
    homology: str = "",
    cells: str = "",
    **unknown: Any,
) -> list[CensusEntry]:
    """Manifolds of the census that comes with tripus: all that are compact, with up to four
    tetrahedra, and those of up to four with cusps that docs/canonical.md names.

    volume    (least, greatest)
    boundary  "g2+g3"
    homology  "2 Z + Z_3", "Z^2 + Z/3"
    cells     "2 tetrahedra + 1 pyramid"

    An unknown filter is an error (in SnapPy it gives the whole census).

    >>> import tripus
    >>> len(tripus.census(tetrahedra=2)), len(tripus.census(tetrahedra=3))
    (12, 167)
    >>> tripus.census(num_tetrahedra=2)
    Traceback (most recent call last):
    ...
    TypeError: there is no filter 'num_tetrahedra': tetrahedra, volume, boundary, homology, cells
    """
    if unknown:
        raise TypeError(
            f"there is no filter {next(iter(unknown))!r}: "
            "tetrahedra, volume, boundary, homology, cells"
        )
    query: dict[str, Any] = {"boundary": boundary, "homology": homology, "cells": cells}
    if tetrahedra is not None:
        query["tetrahedra"] = tetrahedra
    if volume is not None:
        if len(volume) != 2:
            raise InvalidInput(f"volume is a pair (least, greatest), not {volume!r}")
        query["least_volume"], query["greatest_volume"] = volume
    return [CensusEntry("tripus", fields) for fields in _core.census(query)]
