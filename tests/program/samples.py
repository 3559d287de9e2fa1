"""One manifold in every form that the program reads, and covers of it, built here."""

import json

# The gluing table of docs/theory.md (4): tetrahedra and words by face.
TRIPUS_GLUINGS = [
    [(1, "1230"), (1, "3012"), (1, "0321"), (1, "0213")],
    [(0, "1230"), (0, "3012"), (0, "0321"), (0, "0213")],
]

# A class in H^1 of the tripus: the sheets that its faces shift by, opposite on the two sides.
TRIPUS_CLASS = [[0, 1, -1, 0], [-1, 0, 1, 0]]


def as_json(gluings, name="tripus"):
    return json.dumps({"name": name, "gluings": gluings})


def disjoint_union(*parts):
    gluings = []
    for part in parts:
        base = len(gluings)
        gluings += [[(base + t, word) for t, word in row] for row in part]
    return gluings


def tripus_cover(degree):
    """The cyclic cover of that degree: 2 degree tetrahedra, degree edge classes of valence 12, a
    connected boundary component of genus degree + 1."""
    count = len(TRIPUS_GLUINGS)
    return [
        [((sheet + TRIPUS_CLASS[t][f]) % degree * count + TRIPUS_GLUINGS[t][f][0],
          TRIPUS_GLUINGS[t][f][1]) for f in range(4)]
        for sheet in range(degree) for t in range(count)
    ]


def as_snappea(gluings, name="tripus"):
    lines = ["% Triangulation", name, "not_attempted 0.0", "unknown_orientability", "CS_unknown",
             "", "0 0", "", str(len(gluings))]
    for row in gluings:
        lines.append(" ".join(str(t) for t, _ in row))
        lines.append(" ".join(word for _, word in row))
        lines.append("-1 -1 -1 -1")
        lines += [" 0" * 16] * 4 + ["0.0 0.0", ""]
    return "\n".join(lines) + "\n"


def as_regina_table(gluings):
    lines = ["  Tet  |  glued to:      (012)      (013)      (023)      (123)",
             "  -----+-------------------------------------------------------"]
    for number, row in enumerate(gluings):
        entries = []
        for face in (3, 2, 1, 0):
            t, word = row[face]
            entries.append(f"{t} ({''.join(word[v] for v in range(4) if v != face)})")
        lines.append(f"  {number}  |  " + "  ".join(entries))
    return "\n".join(lines) + "\n"


def as_regina_second(gluings, name="tripus"):
    """The XML of Regina's second generation: a permutation is the byte p0 + 4 p1 + 16 p2 + 64 p3."""
    def code(word):
        return sum(int(digit) << (2 * place) for place, digit in enumerate(word))

    rows = "\n".join(
        '<tet desc=""> ' + " ".join(f"{t} {code(word)}" for t, word in row) + " </tet>"
        for row in gluings)
    return (f'<?xml version="1.0"?>\n<reginadata engine="5.0">\n'
            f'<packet type="3-Manifold Triangulation" typeid="3" label="{name}">\n'
            f'<tetrahedra ntet="{len(gluings)}">\n{rows}\n</tetrahedra>\n</packet>\n</reginadata>\n')


TRIPUS_FORMATS = {
    "signature.txt": "cPcbbbihq\n",
    "commented.txt": "# the tripus\n\n  cPcbbbihq   # two tetrahedra\n",
    "gluings.json": as_json(TRIPUS_GLUINGS),
    "byte-order-mark.json": "\ufeff" + as_json(TRIPUS_GLUINGS),
    "triangulation.tri": as_snappea(TRIPUS_GLUINGS),
    "windows.tri": as_snappea(TRIPUS_GLUINGS).replace("\n", "\r\n"),
    "table": as_regina_table(TRIPUS_GLUINGS),
    "data.rga": as_regina_second(TRIPUS_GLUINGS),
    "json without the suffix": as_json(TRIPUS_GLUINGS),
}
