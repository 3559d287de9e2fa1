"""`python -m tripus.hyperbolic INPUT`, which is also what `tripus hyperbolic INPUT` runs.

Exit status: 0 decided (for --batch: the run finished), 1 not decided, 2 bad usage or bad input, 3 a
failure of the program or the system.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
from collections.abc import Sequence
from typing import Any, NamedTuple

import tripus
from tripus import _core
from tripus._errors import FileError, InvalidInput, TripusError
from tripus.hyperbolic.decide import TIME_LIMIT, Hyperbolicity

USAGE = """usage: tripus hyperbolic INPUT [--time-limit S] [--json] [--no-surfaces]
       tripus hyperbolic --batch FILE [--time-limit S] [--json] [--no-surfaces] [--resume FILE]
       tripus hyperbolic --check FILE [INPUT]"""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        "tripus hyperbolic",
        usage=USAGE[7:],
        description="hyperbolic or not, about the manifold, with a certificate",
    )
    parser.add_argument("input", nargs="?", metavar="INPUT", help="as for every verb of tripus")
    parser.add_argument("--batch", metavar="FILE", help="one INPUT a line")
    parser.add_argument(
        "--resume",
        metavar="FILE",
        help="with --batch and --json: write to this file, after the answers that are there",
    )
    parser.add_argument("--check", metavar="FILE", help="check the certificate in an answer of --json")
    parser.add_argument(
        "--time-limit", type=float, metavar="S", help=f"seconds for one INPUT ({TIME_LIMIT:.0f})"
    )
    parser.add_argument("--json", action="store_true", help="one JSON object an INPUT")
    parser.add_argument(
        "--no-surfaces", action="store_true", help="the quick tests only, without Regina"
    )
    return parser


def _json_line(source: str, body: dict[str, Any]) -> str:
    """As the program writes it: other letters than ASCII as they are."""
    shown = source.encode("utf-8", "surrogateescape").decode("utf-8", "replace")
    head = {"tripus": tripus.__version__, "input": shown}
    return json.dumps({**head, **body}, ensure_ascii=False)


#: What may decide it, in words for people.
_ADVICE = {
    "more time": "  More time may decide it: --time-limit.",
    "surfaces": "  A search for surfaces may decide it: without --no-surfaces.",
}


def _as_text(source: str, answer: Hyperbolicity) -> str:
    lines = [f"{source}: {answer.message}"]
    for piece in answer.pieces:
        lines.append(f"  piece           {piece['name'] or piece['signature']}")
    if answer.hyperbolic is None:
        lines = [f"{source}: not decided", *(f"  tried           {words}" for words in answer.tried)]
        if answer.advice is not None:
            lines.append(_ADVICE[answer.advice])
    return "\n".join(lines)


class _Answer(NamedTuple):
    text: str  # for standard output, without the line end; may be empty
    message: str  # for standard error; may be empty
    status: int


def _failure(source: str, error: Exception, as_json: bool) -> _Answer:
    # Files are only read here: one that cannot be is an input that is not good.
    is_input = isinstance(error, (InvalidInput, FileError, FileNotFoundError, IsADirectoryError))
    body = {"kind": "invalid-input" if is_input else "system", "message": str(error)}
    text = _json_line(source, {"error": body}) if as_json else ""
    return _Answer(text, str(error), 2 if is_input else 3)


def _answer(source: str, arguments: argparse.Namespace, is_line: bool) -> _Answer:
    try:
        if source == "-" and is_line:
            raise InvalidInput(
                "a line of a batch cannot be standard input; give a signature or a file"
            )
        manifold = tripus.Manifold(sys.stdin.read() if source == "-" else source)
        answer = manifold.hyperbolicity(
            time_limit=arguments.time_limit, surfaces=not arguments.no_surfaces
        )
    except (TripusError, OSError) as error:
        return _failure(source, error, arguments.json)
    if arguments.json:
        text = _json_line(source, json.loads(answer.to_json()))
    else:
        text = _as_text(source, answer)
    return _Answer(text, "", 1 if answer.hyperbolic is None else 0)


def _say(answer: _Answer, place: str = "") -> int:
    """Writes it; returns the status that it deserves."""
    if answer.message:
        sys.stderr.write(f"tripus: {place}{answer.message}\n")
    if answer.text:
        print(answer.text, flush=True)
    return answer.status


def _batch(arguments: argparse.Namespace) -> int:
    """Answers line by line, after those that an earlier run has left in the file of --resume."""
    asked = "hyperbolic --no-surfaces\n" if arguments.no_surfaces else "hyperbolic\n"
    resume = arguments.resume or ""
    try:
        batch = _core.ResumedBatch(*map(os.fsencode, (arguments.batch, resume, asked)))
    except (TripusError, OSError) as error:
        return _say(_failure(arguments.batch, error, arguments.json))
    lines = batch.lines()
    answered, status = batch.answered(), 0
    try:
        for number, line in lines[answered:]:
            answer = _answer(os.fsdecode(line), arguments, is_line=True)
            if resume:
                batch.write((answer.text + "\n").encode("utf-8"))
                answer = answer._replace(text="")
            _say(answer, f"line {number}: ")
            status = 3 if answer.status == 3 else status
            answered += 1
    except KeyboardInterrupt:
        rest = "the same command goes on from there" if resume else (
            "--json --resume FILE, with these answers in FILE, goes on from there"
        )
        sys.stderr.write(
            f"tripus: interrupted: {answered} of {len(lines)} inputs answered, none after these; {rest}\n"
        )
        return 1
    except (TripusError, OSError) as error:
        if isinstance(error, BrokenPipeError):
            raise
        return _say(_failure(resume or arguments.batch, error, as_json=False))
    return status


def _check(arguments: argparse.Namespace) -> int:
    from tripus.hyperbolic.certificate import HyperbolicityCertificate

    try:
        with open(arguments.check, encoding="utf-8") as file:
            data = json.load(file)
        if not isinstance(data, dict):
            raise InvalidInput("it holds no JSON object")
        data = data.get("certificate", data)
        if data is None:
            raise InvalidInput("the answer has no certificate: it was not decided")
        manifold = None if arguments.input is None else tripus.Manifold(arguments.input)
        objection = HyperbolicityCertificate(data).objection(manifold)
    except ValueError as error:
        named = InvalidInput(f"{arguments.check}: {error}")
        return _say(_failure(arguments.check, named, arguments.json))
    except (TripusError, OSError) as error:
        return _say(_failure(arguments.check, error, arguments.json))
    valid = not objection
    if arguments.json:
        print(json.dumps({"valid": valid, "by": data.get("by"), "reason": objection}))
    else:
        print(f"valid, by {data.get('by')}" if valid else f"not valid: {objection}")
    return 0 if valid else 1


def main(given: Sequence[str] | None = None) -> int:
    """The status with which the program ends."""
    parser = _parser()
    arguments = parser.parse_args(given)
    if arguments.check is not None:
        return _check(arguments)
    if (arguments.input is None) == (arguments.batch is None):
        parser.error("give one INPUT, or --batch FILE")
    if arguments.resume and not (arguments.batch and arguments.json):
        parser.error("--resume needs --batch, and --json, whose lines can be told apart")
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        if arguments.batch is None:
            return _say(_answer(arguments.input, arguments, is_line=False))
        return _batch(arguments)
    except KeyboardInterrupt:
        sys.stderr.write("tripus: interrupted\n")
        return 1
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 3
    except ModuleNotFoundError as error:
        sys.stderr.write(f"tripus: {sys.executable} has no {error.name}: pip install 'tripus[regina]'\n")
        return 3


if __name__ == "__main__":
    sys.exit(main())
