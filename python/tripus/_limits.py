"""Time limits, threads and progress: the last, keyword-only arguments of everything long."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Union

from tripus import _core
from tripus._errors import InvalidInput

#: A function of (activity, count), or True for a bar on standard error, by tqdm if that is there.
Progress = Union[Callable[[str, int], Any], bool, None]

NO_LIMITS = _core.Limits()


def _bar() -> Callable[[str, int], Any]:
    """A progress bar by tqdm; nothing where tqdm is not installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return lambda activity, count: None
    bar = tqdm(desc="tripus", unit="", leave=False)

    def show(activity: str, count: int) -> None:
        bar.set_description(activity, refresh=False)
        bar.n = count
        bar.refresh()

    return show


def limits(
    time_limit: float | None = None, threads: int = 0, progress: Progress = None
) -> _core.Limits:
    if time_limit is None and threads == 0 and not progress:
        return NO_LIMITS
    if time_limit is not None and not (time_limit > 0 and math.isfinite(time_limit)):
        raise InvalidInput(f"time_limit is a number of seconds > 0, not {time_limit!r}")
    if threads > 1024:
        raise InvalidInput(f"threads is from 0 (all cores) to 1024, not {threads!r}")
    if progress is True:
        progress = _bar()
    return _core.Limits(time_limit, threads, progress or None)
