#!/usr/bin/env bash
# numpy 2.4.6: a histogram with so many bins works for equal values and for values that are far
# apart, but raises ValueError for values a few units in the last place apart, as the same quantity
# computed twice is. matplotlib's hist and pandas' plot.hist inherit it.
#
# Seen on 2026-11-30: np.histogram([x, x], bins=60) gives 60 bins of width 1/60 around x;
# np.histogram([x, np.nextafter(x, 9)], bins=60) raises "Too many bins for data range. Cannot create
# 60 finite-sized bins." Exits with 1 if that changes.
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install numpy==2.4.6
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np

x = 6.451990270835033
counts, edges = np.histogram([x, x], bins=60)
print(f"equal: {counts.sum()} values in {len(counts)} bins of width {edges[1] - edges[0]:.4f}")
try:
    np.histogram([x, np.nextafter(x, 9)], bins=60)
    print("nearly equal: a histogram")
    refused = False
except ValueError as error:
    print(f"nearly equal: {error}")
    refused = True
sys.exit(0 if counts.sum() == 2 and refused else 1)
PYTHON
