#!/usr/bin/env bash
# meshio 5.3.5 neither writes nor reads XDMF whose numbers are all in the XML file (Format="XML")
# unless h5py is installed. One expects h5py to be needed for numbers in HDF5 files alone.
#
# Seen on 2026-11-30: Mesh.write("a.xdmf", data_format="XML") raises ModuleNotFoundError: No module
# named 'h5py', data_format="Binary" as well, and so does reading a file with Format="XML". Exits
# with 1 if that changes.
set -euo pipefail
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install meshio==5.3.5 numpy==2.4.6
"$folder/venv/bin/python" - "$folder" <<'PYTHON'
import sys
from pathlib import Path

import meshio
import numpy as np

folder = Path(sys.argv[1])
mesh = meshio.Mesh(np.eye(3), [("triangle", [[0, 1, 2]])])
refused = 0
for data_format in ("XML", "Binary"):
    try:
        mesh.write(folder / "a.xdmf", data_format=data_format)
        print(f"{data_format}: written without h5py")
    except ModuleNotFoundError as error:
        print(f"{data_format}: {error}")
        refused += 1
(folder / "b.xdmf").write_text("""<Xdmf Version="3.0"><Domain><Grid>
<Geometry GeometryType="XYZ"><DataItem DataType="Float" Dimensions="3 3" Format="XML" Precision="8">
1 0 0 0 1 0 0 0 1</DataItem></Geometry>
<Topology TopologyType="Triangle" NumberOfElements="1"><DataItem DataType="Int" Dimensions="1 3"
Format="XML" Precision="8">0 1 2</DataItem></Topology></Grid></Domain></Xdmf>""")
try:
    print(f"read without h5py: {len(meshio.read(folder / 'b.xdmf').points)} points")
except ModuleNotFoundError as error:
    print(f"reading: {error}")
    refused += 1
sys.exit(0 if refused == 3 else 1)
PYTHON
