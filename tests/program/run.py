#!/usr/bin/env python3
"""Runs tests of the program.

    run.py PROGRAM              every test
    run.py PROGRAM errors       the tests of errors.py
    run.py PROGRAM errors.Signatures
"""

import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main():
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        print(__doc__, file=sys.stderr)
        return 2
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(HERE))
    os.environ["TRIPUS_PROGRAM"] = str(Path(sys.argv[1]).resolve())
    modules = [p.stem for p in sorted(HERE.glob("*.py")) if p.stem != "run"]
    suite = unittest.defaultTestLoader.loadTestsFromNames(sys.argv[2:] or modules)
    result = unittest.TextTestRunner(verbosity=1).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
