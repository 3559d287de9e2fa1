"""A process that searches with Regina, and the handle on it.

No call of Regina's can be interrupted, so the process is ended when the time is over; it tells by
lines of JSON what it does, so that a "not decided" says what was tried.
"""

from __future__ import annotations

import atexit
import json
import os
import selectors
import subprocess
import sys
import time
from typing import Any

from tripus._errors import InternalError, Unsupported

#: Seconds beyond its limit after which a process is ended that should have answered.
GRACE = 0.3
#: Seconds that starting one may take; they do not count as time of the search.
START = 60.0


class Worker:
    """A process, kept for the next manifold. One search at a time."""

    def __init__(self) -> None:
        self._owner = os.getpid()
        self._unread = b""  # not the pipe's own buffer, of which a selector knows nothing
        self._told: dict[str, Any] = {}
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join(
            [_package_root(), *filter(None, [environment.get("PYTHONPATH")])]
        )
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tripus.hyperbolic.worker"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            bufsize=0,
            env=environment,
            start_new_session=True,  # Ctrl-C is for the parent, which ends this one
        )
        ready = self._read(time.monotonic() + START)
        if ready is None or "missing" in ready:
            self.end()
            raise Unsupported(
                "the search for surfaces needs Regina: pip install 'tripus[regina]'"
            )

    def is_usable(self) -> bool:
        return self._owner == os.getpid() and self._process.poll() is None

    def start(self, rows: Any, seconds: float) -> None:
        """Begins to search a gluing table."""
        self._told = {}
        self._write({"gluings": rows, "seconds": seconds})

    def wait(self, deadline: float) -> tuple[dict[str, Any] | None, dict[str, Any]]:
        """What was found, and what was tried: the last of each thing that the process told. "over"
        says that it gave up, or ended; until then it may be waited for again."""
        while (line := self._read(deadline + GRACE)) is not None:
            if "answer" in line:
                self._told["over"] = True
                return line["answer"], self._told
            if "failed" in line:
                raise InternalError(f"the search for surfaces failed: {line['failed']}")
            self._told.update(line)
        if self._process.poll() is not None:
            self._told["over"] = True
        return None, self._told

    def _write(self, thing: Any) -> None:
        assert self._process.stdin is not None
        self._process.stdin.write((json.dumps(thing) + "\n").encode())
        self._process.stdin.flush()

    def _read(self, deadline: float) -> dict[str, Any] | None:
        """The next line; None if the time is over or the process has ended."""
        pipe = self._process.stdout
        assert pipe is not None
        with selectors.DefaultSelector() as selector:
            selector.register(pipe, selectors.EVENT_READ)
            while b"\n" not in self._unread:
                if not selector.select(max(0.0, deadline - time.monotonic())):
                    return None
                some = os.read(pipe.fileno(), 1 << 16)
                if not some:
                    return None
                self._unread += some
        line, _, self._unread = self._unread.partition(b"\n")
        return json.loads(line)  # type: ignore[no-any-return]

    def end(self) -> None:
        if self._owner != os.getpid():
            return  # a forked child must not end its parent's worker
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()


_worker: Worker | None = None


def worker() -> Worker:
    """The one of this process, started when first needed."""
    global _worker
    if _worker is None or not _worker.is_usable():
        _worker = Worker()
    return _worker


@atexit.register
def _end() -> None:
    if _worker is not None:
        _worker.end()


def _package_root() -> str:
    """Where the running package is imported from: the extension's folder, links not followed."""
    import tripus

    return os.path.dirname(os.path.dirname(os.path.abspath(tripus.__file__)))


def _main() -> None:
    """The process itself: a line of JSON in, lines of JSON out."""
    out = sys.stdout.buffer

    def tell(thing: Any) -> None:
        out.write((json.dumps(thing) + "\n").encode())
        out.flush()

    try:
        import regina  # noqa: F401
    except ImportError:
        tell({"missing": "regina"})
        return
    from tripus.hyperbolic.search import Search
    from tripus.hyperbolic.tables import Table

    tell({"ready": True})
    for line in sys.stdin.buffer:
        task = json.loads(line)
        deadline = time.monotonic() + task["seconds"]
        try:
            search = Search(Table(task["gluings"]), lambda k, v: tell({k: v}), deadline)
            tell({"answer": search.run()})
        except Exception as error:
            tell({"failed": repr(error)})


if __name__ == "__main__":
    _main()
