"""The program `tripus`, which comes with the package: `tripus ...` or `python -m tripus ...`."""

from __future__ import annotations

import os
import sys

from tripus import _core


def main() -> None:
    """Runs the program in this process; exits with its status."""
    if sys.argv[1:2] == ["hyperbolic"] and not {"-h", "--help"} & set(sys.argv):
        from tripus.hyperbolic.__main__ import main as hyperbolic

        sys.exit(hyperbolic(sys.argv[2:]))
    sys.exit(_core.run_program([os.fsencode(argument) for argument in sys.argv[1:]]))


if __name__ == "__main__":
    main()
