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

import tripus
from tripus._errors import FileError, InvalidInput, TripusError
from tripus.hyperbolic.decide import TIME_LIMIT, Hyperbolicity

USAGE = """usage: tripus hyperbolic INPUT [--time-limit S] [--json] [--no-surfaces]
       tripus hyperbolic --batch FILE [--time-limit S] [--json] [--no-surfaces]
       tripus hyperbolic --check FILE [INPUT]"""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        "tripus hyperbolic",
        usage=USAGE[7:],
        description="hyperbolic or not, about the manifold, with a certificate",
    )
    parser.add_argument("input", nargs="?", metavar="INPUT", help="as for every verb of tripus")
    parser.add_argument("--batch", metavar="FILE", help="one INPUT a line")
    parser.add_argument("--check", metavar="FILE", help="check the certificate in an answer of --json")
    parser.add_argument(
        "--time-limit", type=float, metavar="S", help=f"seconds for one INPUT ({TIME_LIMIT:.0f})"
    )
    parser.add_argument("--json", action="store_true", help="one JSON object an INPUT")
    parser.add_argument(
        "--no-surfaces", action="store_true", help="the quick tests only, without Regina"
    )
    return parser


def _as_json(source: str, answer: Hyperbolicity) -> str:
    head = {"tripus": tripus.__version__, "input": source}
    return json.dumps({**head, **json.loads(answer.to_json())})


def _as_text(source: str, answer: Hyperbolicity) -> str:
    lines = [f"{source}: {answer.message}"]
    for piece in answer.pieces:
        lines.append(f"  piece           {piece['name'] or piece['signature']}")
    if answer.hyperbolic is None:
        lines = [f"{source}: not decided", *(f"  tried           {words}" for words in answer.tried)]
        lines.append("  More time may decide it: --time-limit.")
    return "\n".join(lines)


def _failure(source: str, error: Exception, as_json: bool) -> int:
    # Files are only read here: one that cannot be is an input that is not good.
    is_input = isinstance(error, (InvalidInput, FileError, FileNotFoundError, IsADirectoryError))
    sys.stderr.write(f"tripus: {error}\n")
    if as_json:
        kind = "invalid-input" if is_input else "system"
        body = {"kind": kind, "message": str(error)}
        print(json.dumps({"tripus": tripus.__version__, "input": source, "error": body}), flush=True)
    return 2 if is_input else 3


def _one(source: str, arguments: argparse.Namespace) -> int:
    try:
        manifold = tripus.Manifold(sys.stdin.read() if source == "-" else source)
        answer = manifold.hyperbolicity(
            time_limit=arguments.time_limit, surfaces=not arguments.no_surfaces
        )
    except (TripusError, OSError) as error:
        return _failure(source, error, arguments.json)
    print((_as_json if arguments.json else _as_text)(source, answer), flush=True)
    return 1 if answer.hyperbolic is None else 0


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
        return _failure(
            arguments.check, InvalidInput(f"{arguments.check}: {error}"), arguments.json
        )
    except (TripusError, OSError) as error:
        return _failure(arguments.check, error, arguments.json)
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
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    lines, answered = None, 0
    try:
        if arguments.batch is None:
            return _one(arguments.input, arguments)
        lines = tripus.read_batch(arguments.batch)
        for line in lines:
            _one(line, arguments)
            answered += 1
    except KeyboardInterrupt:
        rest = "" if lines is None else f" after {answered} of {len(lines)} inputs"
        sys.stderr.write(f"tripus: interrupted{rest}\n")
        return 1
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 3
    except (TripusError, OSError) as error:
        return _failure(str(arguments.batch), error, arguments.json)
    return 0


if __name__ == "__main__":
    sys.exit(main())
