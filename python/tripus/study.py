"""The studies of `tripus study` as data frames and matplotlib figures.

The rows, the findings and what the figures show come from the same code as the program's; only the
drawing is matplotlib's. `tripus study` itself needs no Python.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from tripus import _core
from tripus._check import checked, shown
from tripus._errors import InvalidInput, Stopped
from tripus._lazy import load
from tripus._limits import Progress, limits
from tripus.manifold import Manifold
from tripus.many import read_batch
from tripus._value import Value


class Study(Value):
    """What a study found.

    tables     {name: pandas data frame}
    columns    {name: {column: (unit, description)}}
    paragraph  the findings in words
    facts      {name: number}
    """

    def __init__(self, name: str, fields: dict[str, Any]) -> None:
        pandas = load("pandas")
        self.name = name
        self._fields = fields
        self.paragraph = str(fields["paragraph"])
        self.facts = {key: value for key, value, _ in fields["facts"]}
        self.tables: dict[str, Any] = {}
        self.columns: dict[str, dict[str, tuple[str, str]]] = {}
        self._figures = fields["figures"]
        for table in fields["tables"]:
            columns = table["columns"]
            self.tables[table["name"]] = pandas.DataFrame(
                {c["name"]: _typed(c["cells"]) for c in columns}
            )
            self.columns[table["name"]] = {
                c["name"]: (c["unit"], c["description"]) for c in columns
            }

    def figures(self) -> dict[str, Any]:
        """{name: matplotlib figure}, with the caption as its `caption`."""
        from tripus.plot import draw

        return {f["name"]: draw(f) for f in self._figures}

    def captions(self) -> dict[str, str]:
        """{figure: what there is to see}."""
        return {f["name"]: f["caption"] for f in self._figures}

    def __repr__(self) -> str:
        sizes = ", ".join(f"{name} [{len(t)}]" for name, t in self.tables.items())
        return f"<Study {self.name}: {sizes}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Study, (self.name, self._fields)

    def _key(self) -> Any:
        return self.name, self._fields

    def _rows(self) -> dict[str, str]:
        return {"": self.paragraph, **{k: f"{v:.6g}" for k, v in self.facts.items()}}


def _typed(cells: Sequence[str]) -> Any:
    """Numbers where all are numbers (empty: NaN), yes and no as bool, else texts."""
    filled = [c for c in cells if c != ""]
    if filled and all(c in ("yes", "no") for c in filled) and len(filled) == len(cells):
        return np.array([c == "yes" for c in cells])
    try:
        numbers = np.array([float(c) if c != "" else np.nan for c in cells])
    except ValueError:
        return list(cells)
    if filled and len(filled) == len(cells) and all(c.lstrip("-").isdigit() for c in cells):
        return np.array([int(c) for c in cells])
    return numbers


def names() -> list[str]:
    """The studies there are.

    >>> names()
    ['convergence', 'stability', 'paper', 'triangulations', 'valence']
    """
    return [name for name, *_ in _core.study_names()]


@checked
def run(
    name: str,
    inputs: Iterable[Any] | str | os.PathLike[str] = (),
    *,
    samples: int = 0,
    seed: int = 1,
    methods: Sequence[str] = (),
    covers: Sequence[int] = (),
    folder: str | os.PathLike[str] | None = None,
    threads: int = 0,
    time_limit: float | None = None,
    progress: Progress = None,
) -> Study:
    """Runs a study; docs/studies.md says what each does.

    inputs   manifolds, or whatever Manifold takes; the name of a file with one a line
    samples  how much of it; 0: the study's default
    covers   degrees of cyclic covers to add, where the study does that
    folder   keeps what is done, so that a run that was stopped goes on from there

    Stopped, if the time limit ended it: what is done is in the folder.
    """
    if name not in names():
        raise InvalidInput(f"there is no study {shown(name)}: {', '.join(names())}")
    if isinstance(inputs, (str, os.PathLike)):
        inputs = read_batch(inputs)
    if isinstance(inputs, (bytes, Manifold)) or not isinstance(inputs, Iterable):
        raise TypeError(
            f"run(): inputs is a list of what Manifold takes, or the name of a file with one a "
            f"line, not {shown(inputs)}"
        )
    cores = [(m if isinstance(m, Manifold) else Manifold(m))._core for m in inputs]
    with tempfile.TemporaryDirectory(prefix="tripus-") as temporary:
        fields = _core.run_study(
            name,
            cores,
            seed,
            samples,
            list(methods),
            list(covers),
            os.fsencode(folder) if folder is not None else os.fsencode(temporary),
            limits(time_limit, threads or os.cpu_count() or 1, progress),
        )
    if fields["done"] < fields["total"] or fields["total"] == 0:
        raise Stopped(f"{fields['done']} of {fields['total']} items are done")
    return Study(name, fields)


def convergence(inputs: Iterable[Any] | str | os.PathLike[str], **options: Any) -> Study:
    """How the methods converge; options as those of run().

    >>> study = convergence(["cPcbbbihq"], methods=["newton"], samples=1)
    >>> study, len(study.figures()) > 0
    (<Study convergence: ...>, True)
    """
    return run("convergence", inputs, **options)


def triangulations(inputs: Iterable[Any] | str | os.PathLike[str], **options: Any) -> Study:
    """What triangulations carry; options as those of run()."""
    return run("triangulations", inputs, **options)


def stability(inputs: Iterable[Any] | str | os.PathLike[str], **options: Any) -> Study:
    """How stable the flows are; options as those of run()."""
    return run("stability", inputs, **options)
