"""Tripus: hyperbolic metrics with totally geodesic boundary on compact 3-manifolds.

>>> import tripus
>>> M = tripus.Manifold("cPcbbbihq")
>>> M.volume(), M.homology(), M.symmetry_group()
(6.451990270835, Z + Z, D3)
>>> M.metric.edge_lengths
array([0.59613389])
"""

from __future__ import annotations

import os as _os

_tetgen = _os.path.join(_os.path.dirname(__file__), "bin", "tripus-tetgen")
if _os.path.exists(_tetgen):
    _os.environ.setdefault("TRIPUS_TETGEN", _tetgen)

from tripus import _core as _core
from tripus import diagrams as diagrams
from tripus._errors import (
    FileError,
    InputNote,
    InternalError,
    InvalidInput,
    NoMetric,
    Stopped,
    TripusError,
    Undecided,
    Unsupported,
)
from tripus.answers import (
    CanonicalDecomposition,
    CensusEntry,
    Comparison,
    Isometry,
)
from tripus.arcs import BasmajianDiscs, Orthospectrum, ReturnPath
from tripus.diagrams import Diagram
from tripus.groups import AbelianGroup, FundamentalGroup, IsometryGroup
from tripus.manifold import Manifold
from tripus.many import census, load, methods, read_batch, solve_many
from tripus.metric import CellComplex, Metric
from tripus.solid import Parameterisation, parameterise
from tripus.verdicts import AngleStructure, Certificate, Proof, Verdict, Volume

__version__: str = _core.version

for _error in (
    FileError,
    InputNote,
    InternalError,
    InvalidInput,
    NoMetric,
    Stopped,
    TripusError,
    Undecided,
    Unsupported,
):
    _error.__module__ = "tripus"


def __getattr__(name: str) -> object:
    # Loaded when first used, so that the import stays fast.
    if name in ("hyperbolic", "plot", "study", "view"):
        import importlib

        return importlib.import_module(f"tripus.{name}")
    hints = {
        "Link": "tripus.Diagram",
        "Triangulation": "tripus.Manifold",
        "Triangulation3": "tripus.Manifold",
        "ManifoldHP": "Manifold.prove(digits=60)",
        "OrientableCuspedCensus": "tripus.census(), tripus.diagrams.table()",
        "OrientableClosedCensus": "tripus.census()",
        "LinkExteriors": "tripus.diagrams.table('links')",
    }
    hint = f": {hints[name]}" if name in hints else ""
    raise AttributeError(f"module 'tripus' has no attribute {name!r}{hint}")


__all__ = [
    "AbelianGroup",
    "AngleStructure",
    "BasmajianDiscs",
    "CanonicalDecomposition",
    "CellComplex",
    "CensusEntry",
    "Certificate",
    "Comparison",
    "Diagram",
    "FileError",
    "FundamentalGroup",
    "InputNote",
    "InternalError",
    "InvalidInput",
    "Isometry",
    "IsometryGroup",
    "Manifold",
    "Metric",
    "NoMetric",
    "Orthospectrum",
    "Parameterisation",
    "Proof",
    "ReturnPath",
    "Stopped",
    "TripusError",
    "Undecided",
    "Unsupported",
    "Verdict",
    "Volume",
    "census",
    "diagrams",
    "load",
    "methods",
    "parameterise",
    "plot",
    "read_batch",
    "solve_many",
    "study",
    "view",
]
