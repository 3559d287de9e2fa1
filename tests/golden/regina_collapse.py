"""Writes data/collapse-golden.tsv: what Regina says about edge collapses, legal and illegal.

    regina-python tests/golden/regina_collapse.py > data/collapse-golden.tsv     (at the root)

Columns: signature, tetrahedron, edge 0..5 in the labels of Regina's fromIsoSig, signature of the
result or "-" where Regina refuses the collapse. With a number as argument, that many rows of any
kind, for a comparison at large.
"""
import random
import sys

import regina
from regina_moves import EDGE_ENDS, edge_of, shaken, sources

ROWS_A_KIND = {"legal": 120, "refused": 120, "same ends": 12, "no finite end": 12}


def kind_of(edge, legal):
    if legal:
        return "legal"
    if edge.vertex(0) == edge.vertex(1):
        return "same ends"
    if edge.vertex(0).isIdeal() and edge.vertex(1).isIdeal():
        return "no finite end"
    return "refused"


def with_finite_vertices(tri):
    """New vertices in tetrahedra or faces, then shaken until their stars meet themselves."""
    tri = regina.Triangulation3(tri)
    for _ in range(random.randrange(1, 3)):
        t = tri.tetrahedron(random.randrange(tri.size()))
        tri.pachner(t)
    for _ in range(random.randrange(4)):
        tri = shaken(tri)
    return tri


def main():
    random.seed(20260702)
    rows = int(sys.argv[1]) if len(sys.argv) > 1 else 0
    print("# Edge collapses as Regina", regina.versionString(),
          "makes them (https://regina-normal.github.io); by tests/golden/regina_collapse.py")
    print("# result: signature after the collapse, - where Regina refuses it")
    print("isosig\ttetrahedron\tedge\tresult")
    pool = sources()
    counts = {}
    printed = 0
    seen = set()
    for _ in range(100 * rows if rows else 4000):
        tri = regina.Triangulation3.fromIsoSig(random.choice(pool))
        if random.random() < 0.8:
            tri = with_finite_vertices(tri)
        tri = regina.Triangulation3.fromIsoSig(tri.isoSig())
        for t in range(tri.size()):
            for e in range(len(EDGE_ENDS)):
                copy = regina.Triangulation3(tri)
                legal = copy.collapseEdge(edge_of(copy, t, e))
                kind = kind_of(edge_of(tri, t, e), legal)
                key = (tri.isoSig(), kind)
                if not rows and (counts.get(kind, 0) >= ROWS_A_KIND[kind] or key in seen):
                    continue
                seen.add(key)
                counts[kind] = counts.get(kind, 0) + 1
                print(tri.isoSig(), t, e, copy.isoSig() if legal else "-", sep="\t")
                printed += 1
                if printed == rows:
                    return


if __name__ == "__main__":
    main()
