#!/usr/bin/env python3
"""Runs tests of the page for browsers, which scripts/page makes.

    run.py PROGRAM              every test
    run.py PROGRAM page.Links   one class of page.py

Where the page has not been made the tests are skipped (exit status 77), unless TRIPUS_NEED_PAGE is set.
"""

import os
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
SKIPPED = 77


def main():
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        print(__doc__, file=sys.stderr)
        return 2
    sys.dont_write_bytecode = True
    sys.path[:0] = [str(HERE), str(HERE.parent / "program")]
    os.environ["TRIPUS_PROGRAM"] = str(Path(sys.argv[1]).resolve())
    from page_browser import page_path

    if not page_path().is_file():
        print(f"skipped: {page_path()} has not been made (scripts/page)")
        return 1 if os.environ.get("TRIPUS_NEED_PAGE") else SKIPPED
    suite = unittest.defaultTestLoader.loadTestsFromNames(sys.argv[2:] or ["page"])
    result = unittest.TextTestRunner(verbosity=1).run(suite)
    return 0 if result.wasSuccessful() and result.testsRun > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
