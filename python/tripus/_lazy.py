"""Packages that are imported when they are first used.

numpy would take most of the time of `import tripus`. A Ctrl-C while it is imported would leave it
broken for the rest of the process, as its compiled parts cannot be loaded twice: so the signal
waits until the import is done.
"""

from __future__ import annotations

import importlib
from typing import Any

_loaded: dict[str, Any] = {}


def load(name: str) -> Any:
    """The module, imported as a whole or not at all."""
    module = _loaded.get(name)
    if module is None:
        module = _loaded[name] = _import_in_peace(name)
    return module


def _import_in_peace(name: str) -> Any:
    import signal
    import threading

    previous = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(previous):
        return importlib.import_module(name)
    seen: list[Any] = []
    signal.signal(signal.SIGINT, lambda *event: seen.append(event))
    try:
        return importlib.import_module(name)
    finally:
        signal.signal(signal.SIGINT, previous)
        if seen:
            previous(*seen[-1])


class LazyModule:
    """Stands for a module until something of it is asked for."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        return getattr(_loaded.get(self._name) or load(self._name), attribute)


numpy = LazyModule("numpy")
