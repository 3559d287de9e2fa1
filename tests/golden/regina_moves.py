"""Writes data/moves-golden.tsv: what Regina says about moves, legal and illegal.

    regina-python tests/golden/regina_moves.py > data/moves-golden.tsv     (at the root)

Columns: signature, move (as tripus::topology::to_string writes it), signature of the result or "-"
where Regina refuses the move. Places are in the labels of Regina's fromIsoSig.
"""
import random
from pathlib import Path

import regina

EDGE_ENDS = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
ROWS_A_KIND = {"legal": 40, "refused": 24, "another valence": 6}
DATA = Path("data")


def corners(tri, t, edge, side=0):
    """(tetrahedron, a, b, leaving face, entered face) around an edge."""
    a, b = EDGE_ENDS[edge]
    c, d = EDGE_ENDS[5 - edge]
    if side:
        c, d = d, c
    start = (t, a, b)
    found = []
    while True:
        found.append((t, a, b, c, d))
        tet = tri.tetrahedron(t)
        p = tet.adjacentGluing(c)
        t, a, b, c, d = tet.adjacentTetrahedron(c).index(), p[a], p[b], p[d], p[c]
        if (t, a, b) == start:
            return found


def trials(tri):
    """(kind, move, function that makes it on a copy)."""
    n = tri.size()
    for t in range(n):
        yield "1-4", f"1-4 at tetrahedron {t}", lambda x, t=t: x.pachner(x.tetrahedron(t))
        for f in range(4):
            yield "2-3", f"2-3 at face {f} of tetrahedron {t}", (
                lambda x, t=t, f=f: x.pachner(x.tetrahedron(t).triangle(f)))
            yield "4-1", f"4-1 at vertex {f} of tetrahedron {t}", (
                lambda x, t=t, f=f: x.pachner(x.tetrahedron(t).vertex(f)))
            yield "2-0v", f"2-0 at vertex {f} of tetrahedron {t}", (
                lambda x, t=t, f=f: x.twoZeroMove(x.tetrahedron(t).vertex(f)))
        for e, (a, b) in enumerate(EDGE_ENDS):
            where = f"at edge {a}{b} of tetrahedron {t}"
            yield "3-2", f"3-2 {where}", lambda x, t=t, e=e: x.pachner(edge_of(x, t, e))
            yield "2-0e", f"2-0 {where}", lambda x, t=t, e=e: x.twoZeroMove(edge_of(x, t, e))
            walk = corners(tri, t, e)
            edge = edge_of(tri, t, e)
            ring = [c[0] for c in walk]
            if edge.degree() in (4, 5):
                # Regina's axis 0 has corners 0, 1 on one side and 2, 3 on the other.
                order = [edge.embedding(i).tetrahedron().index() for i in range(4)]
                for axis in (0, 1):
                    halves = {frozenset(ring[axis:axis + 2])}
                    regina_axis = 0 if frozenset(order[0:2]) in halves or \
                        frozenset(order[2:4]) in halves else 1
                    yield "4-4", f"4-4 {where}, axis {axis}", (
                        lambda x, t=t, e=e, k=regina_axis: x.fourFourMove(edge_of(x, t, e), k))
            if edge.degree() <= 2:
                for end in (0, 1):
                    first = edge.embedding(0).vertices()[0]
                    regina_end = end if first == EDGE_ENDS[e][0] else 1 - end
                    yield "2-1", f"2-1 {where}, end {end}", (
                        lambda x, t=t, e=e, k=regina_end: x.twoOneMove(edge_of(x, t, e), k))
            # 0-2 at two different triangles, where the order of copies is no question.
            for side in (0, 1):
                walk = corners(tri, t, e, side)
                steps = random.randrange(len(walk) + 1)
                move = f"0-2 {where}, side {side}, steps {steps}"
                if steps == len(walk):
                    yield "0-2", move, lambda x: False
                    continue
                (t0, a0, b0, c0, d0), (t1, a1, b1, c1, d1) = walk[0], walk[steps]
                if steps and tri.tetrahedron(t0).triangle(c0) == tri.tetrahedron(t1).triangle(c1):
                    continue
                yield "0-2", move, (
                    lambda x, u=walk[0], v=walk[steps]: zero_two(x, u, v))


def edge_of(tri, t, e):
    return tri.tetrahedron(t).edge(*EDGE_ENDS[e])


def zero_two(tri, first, second):
    """Regina's triangle i of an edge is the one opposite vertices()[3] in embedding i."""
    t0, a0, b0, c0, _ = first
    t1, a1, b1, c1, _ = second
    edge = tri.tetrahedron(t0).edge(a0, b0)

    def number(t, a, b, c):
        p = tri.tetrahedron(t).adjacentGluing(c)
        u = tri.tetrahedron(t).adjacentTetrahedron(c).index()
        sides = {(t, frozenset((a, b)), c), (u, frozenset((p[a], p[b])), p[c])}
        for i in range(edge.degree()):
            emb = edge.embedding(i)
            v = emb.vertices()
            if (emb.tetrahedron().index(), frozenset((v[0], v[1])), v[3]) in sides:
                return i
        raise RuntimeError("no number")

    return tri.zeroTwoMove(edge, number(t0, a0, b0, c0), number(t1, a1, b1, c1))


def sources():
    found = []
    for name in ("triangulations-2.txt", "triangulations-3.txt", "triangulations-cusped.txt"):
        found += [s for s in (DATA / name).read_text().split("\n") if s and s[0] != "#"]
    four = [s for s in (DATA / "triangulations-4.txt").read_text().split("\n") if s and s[0] != "#"]
    found += random.sample(four, 100)
    # Closed and non-orientable ones, and small ones where moves are refused for want of room.
    example = regina.Example3
    for tri in (example.threeSphere(), example.rp2xs1(), example.s2xs1(), example.lens(3, 1),
                example.simplicialSphere(), example.lens(5, 2), example.gieseking(),
                example.figureEight(), example.poincare()):
        found.append(tri.isoSig())
    return found


def shaken(tri):
    """A few random moves, so that edges of every small valence and finite vertices turn up."""
    for _ in range(random.randrange(6)):
        copy = regina.Triangulation3(tri)
        choice = random.randrange(5)
        t = copy.tetrahedron(random.randrange(copy.size()))
        if choice == 0:
            copy.pachner(t) if random.random() < 0.4 else copy.pachner(t.triangle(random.randrange(4)))
        elif choice == 1:
            copy.pachner(t.triangle(random.randrange(4)))
        else:
            edge = t.edge(random.randrange(6))
            if edge.degree() == 3 and choice == 2:
                copy.pachner(edge)
            elif choice == 3:
                copy.zeroTwoMove(edge, random.randrange(edge.degree()), random.randrange(edge.degree()))
            elif edge.degree() <= 2:
                copy.twoZeroMove(edge)
        if copy.size() <= 9 and copy.isValid() and not copy.isEmpty():
            tri = copy
    return tri


def main():
    random.seed(20240611)
    counts = {}
    print("# Moves on triangulations as Regina", regina.versionString(),
          "makes them (https://regina-normal.github.io); by tests/golden/regina_moves.py")
    print("# result: signature after the move, - where Regina refuses it")
    print("isosig\tmove\tresult")
    pool = sources()
    seen = set()
    for _ in range(6000):
        tri = regina.Triangulation3.fromIsoSig(random.choice(pool))
        tri = regina.Triangulation3.fromIsoSig(shaken(tri).isoSig())
        rows = list(trials(tri))
        random.shuffle(rows)
        for kind, move, act in rows:
            copy = regina.Triangulation3(tri)
            legal = act(copy)
            if legal and copy.isEmpty():
                raise RuntimeError(move)
            sort = "legal" if legal else \
                "refused" if has_right_valence(tri, kind, move) else "another valence"
            key = (kind, sort)
            if counts.get(key, 0) >= ROWS_A_KIND[sort] or (tri.isoSig(), key) in seen:
                continue
            seen.add((tri.isoSig(), key))
            counts[key] = counts.get(key, 0) + 1
            print(tri.isoSig(), move, copy.isoSig() if legal else "-", sep="\t")


def has_right_valence(tri, kind, move):
    """A refusal then has another reason."""
    words = move.replace(",", "").split()
    if kind in ("2-3", "0-2", "1-4"):
        return True
    tet = tri.tetrahedron(int(words[6]))
    if kind in ("4-1", "2-0v"):
        return tet.vertex(int(words[3])).degree() == (4 if kind == "4-1" else 2)
    edge = tet.edge(int(words[3][0]), int(words[3][1]))
    return edge.degree() == {"3-2": 3, "4-4": 4, "2-0e": 2, "2-1": 1}[kind]


if __name__ == "__main__":
    main()
