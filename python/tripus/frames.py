"""Tables: data frames, structured arrays, HTML."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tripus._lazy import load

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
else:
    from tripus._lazy import numpy as np


def frame(columns: dict[str, Any]) -> Any:
    """A pandas data frame, or a structured array where pandas is not installed."""
    try:
        pandas = load("pandas")
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
