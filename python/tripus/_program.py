"""The program `tripus`, which comes with the package."""

from __future__ import annotations

import os
import sys


def main() -> None:
    """Becomes the program."""
    folder = os.path.join(os.path.dirname(__file__), "bin")
    program = os.path.join(folder, "tripus")
    if not os.path.exists(program):
        sys.exit(f"tripus: the program is not in {folder}; build it with scripts/build")
    os.execv(program, ["tripus", *sys.argv[1:]])
