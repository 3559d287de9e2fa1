"""What the objects of the package have in common: they are values, and tables in notebooks."""

from __future__ import annotations

from typing import Any

from tripus.frames import html_table


def frozen(thing: Any) -> Any:
    """The same as tuples, so that it can be compared and hashed; arrays by shape and content."""
    if isinstance(thing, dict):
        return tuple((key, frozen(value)) for key, value in sorted(thing.items()))
    if isinstance(thing, (list, tuple)):
        return tuple(frozen(each) for each in thing)
    if type(thing).__module__ == "numpy" and hasattr(thing, "tobytes"):
        return thing.shape, str(thing.dtype), thing.tobytes()
    if isinstance(thing, float) and thing != thing:
        return "nan"
    return thing


class Value:
    """Equal where the content is: so also after pickling. `==` never raises, and fits hash()."""

    __slots__ = ()

    def _key(self) -> Any:
        """All that makes it what it is, in things that can be compared."""
        raise NotImplementedError

    def _rows(self) -> dict[str, str]:
        """What a notebook shows of it: {name: text}."""
        return {type(self).__name__: repr(self)}

    def _picture(self) -> str:
        """HTML of a picture beside the table; empty for none."""
        return ""

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return False
        return self is other or bool(frozen(self._key()) == frozen(other._key()))

    def __hash__(self) -> int:
        return hash((type(self).__name__, frozen(self._key())))

    def _repr_html_(self) -> str:
        table = html_table(self._rows())
        picture = self._picture()
        if not picture:
            return table
        return f'<div style="display:flex;gap:1em;align-items:center">{picture}{table}</div>'
