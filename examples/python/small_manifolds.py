"""All manifolds that three tetrahedra make: from triangulations to a table of manifolds.

    build/venv/bin/python examples/python/small_manifolds.py [LIST]
"""

import pathlib
import sys

import tripus

default = pathlib.Path(__file__).parents[2] / "data" / "triangulations-3.txt"
triangulations = tripus.solve_many(sys.argv[1] if len(sys.argv) > 1 else default, prove=True)
print(triangulations["outcome"].value_counts().to_string())

geometric = triangulations[triangulations["outcome"] == "geometric"].copy()
geometric["manifold"] = [tripus.Manifold(t).isometry_signature() for t in geometric["input"]]
geometric["width"] = geometric["volume_upper"] - geometric["volume_lower"]
table = geometric.groupby("manifold").agg(
    volume=("volume", "first"), triangulations=("input", "count"), width=("width", "max"))
print(table.sort_values("volume").head(10).to_string())
print(f"{len(table)} manifolds; the volumes are proved to within {table['width'].max():.1e}")
