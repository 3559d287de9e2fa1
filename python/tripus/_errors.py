"""What tripus raises, and what it warns of.

Four kinds of failure are kept apart: input that cannot be used (`InvalidInput`, a ValueError), the
system (`FileError`, an OSError), a bug of ours (`InternalError`), and mathematics. A mathematical
"no" is a value, with its evidence; only where a number or an object is asked for that does not
exist, it comes as an exception (`NoMetric`, `Undecided`), which carries that value.
"""

from __future__ import annotations

from typing import Any


class TripusError(Exception):
    """Root of everything that tripus raises."""


class InvalidInput(TripusError, ValueError):
    """The input cannot be used; the message names the place, the value and the remedy."""


class Unsupported(InvalidInput):
    """The input is well formed, but outside what tripus knows so far."""


class FileError(TripusError, OSError):
    """The system failed: a full disk, a file that cannot be written, a helper program."""


class InternalError(TripusError, RuntimeError):
    """A promise of ours was broken: please report it."""


class Stopped(TripusError, RuntimeError):
    """The work ended before there was anything to return."""


class _WithAnswer:
    """Shows the message alone: what an error carries may be long."""

    def __str__(self) -> str:
        return str(self.args[0])  # type: ignore[attr-defined]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({str(self)!r})"


class NoMetric(_WithAnswer, TripusError, ValueError):
    """The triangulation carries no metric, or none was found; `verdict` has the evidence."""

    def __init__(self, message: str, verdict: Any = None) -> None:
        super().__init__(message, verdict)
        self.verdict = verdict


class Undecided(_WithAnswer, TripusError, RuntimeError):
    """A question about the manifold was not decided; `answer` says what is known."""

    def __init__(self, message: str, answer: Any = None) -> None:
        super().__init__(message, answer)
        self.answer = answer


class InputNote(UserWarning):
    """What of an input was mended, changed or not read."""
