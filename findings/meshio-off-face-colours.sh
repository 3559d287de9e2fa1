#!/usr/bin/env bash
# meshio 5.3.5 does not read OFF faces with colours ("3 0 1 2 255 0 0"), which Geomview's definition
# of OFF allows and many programs write. One expects the colours to be skipped, or an exception.
#
# Seen on 2026-11-29: the file without colours gives 4 triangles; for the same file with colours
# meshio prints "Can only read triangular faces", though all faces are triangles, and raises
# SystemExit, which `except Exception` does not catch. Exits with 1 if that changes.
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install meshio==5.3.5 numpy==1.26.4
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import sys
from pathlib import Path

import meshio

folder = Path(sys.argv[1])
points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
faces = ["3 0 2 1", "3 0 1 3", "3 0 3 2", "3 1 2 3"]
plain, coloured = folder / "plain.off", folder / "coloured.off"
plain.write_text("OFF\n4 4 0\n" + points + "\n".join(faces) + "\n")
coloured.write_text("OFF\n4 4 0\n" + points + "\n".join(f + " 255 0 0" for f in faces) + "\n")

read = len(meshio.read(plain).cells_dict["triangle"])
print(f"without colours: {read} triangles")
try:
    cells = meshio.read(coloured).cells_dict.get("triangle", [])
    print(f"with colours: {len(cells)} triangles")
    refused = False
except SystemExit as error:
    print(f"with colours: {type(error).__name__} {error}")
    refused = True
sys.exit(0 if read == 4 and refused else 1)
PYTHON
