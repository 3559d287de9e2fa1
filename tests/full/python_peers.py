#!/usr/bin/env python3
"""The Python package beside Regina and SnapPy, in full: minutes.

    PYTHONPATH=build/release/python build/venv/bin/python tests/full/python_peers.py [COUNT [SEED]]

COUNT random triangulations (500): homology, signatures, all covers with up to four sheets by all
three. Then the volumes of SnapPy's cusped census with up to seven tetrahedra.
"""

import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))

import snappy
from oracles import check_one, check_volume, random_triangulations

count = int(sys.argv[1]) if len(sys.argv) > 1 else 500
seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
begin = time.process_time()
cusped = sum(check_one(R) for R in random_triangulations(count, seed))
print(f"{count} random triangulations, {cusped} of them with SnapPy, seed {seed}: all agree "
      f"({time.process_time() - begin:.0f} s)")

begin = time.process_time()
for census in (snappy.OrientableCuspedCensus, snappy.NonorientableCuspedCensus):
    found, missed, largest = 0, [], 0.0
    for tetrahedra in range(1, 8):
        for theirs in census(num_tets=tetrahedra):
            difference = check_volume(theirs)
            if difference is None:
                missed.append(theirs.name())
            else:
                found, largest = found + 1, max(largest, difference)
    print(f"{census.__class__.__name__}: {found} volumes agree within {largest:.1e}; no metric found "
          f"for {missed} ({time.process_time() - begin:.0f} s)")
