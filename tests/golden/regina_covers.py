"""Writes data/covers-golden.tsv: the covers of small degree that Regina finds, by their homology.

    regina-python tests/golden/regina_covers.py > data/covers-golden.tsv     (at the root)

Columns: signature, degree, how many connected covers have which first homology.
"""
from collections import Counter
from pathlib import Path

import regina

DATA = Path("data")


def listed(name, stride=1):
    lines = (DATA / name).read_text().split("\n")
    return [line for line in lines if line and line[0] != "#"][::stride]


def subjects():
    """(signature, largest degree)"""
    example = regina.Example3
    for signature in listed("triangulations-2.txt"):
        yield signature, 5
    for signature in listed("triangulations-cusped.txt", 8):
        yield signature, 4
    for signature in listed("triangulations-3.txt", 12) + listed("triangulations-4.txt", 500):
        yield signature, 3
    # Closed, with torsion, non-orientable, and with few covers or none.
    for tri in (example.threeSphere(), example.lens(8, 3), example.poincare(), example.weeks(),
                example.s2xs1(), example.rp2xs1(), example.gieseking(), example.figureEight(),
                example.smallClosedNonOrblHyperbolic()):
        yield tri.isoSig(), 6


def main():
    print("# Connected covers as Regina", regina.versionString(),
          "enumerates them (https://regina-normal.github.io); by tests/golden/regina_covers.py")
    print("# homology: of the covers, each with the number of covers that have it; - where there is none")
    print("isosig\tdegree\thomology")
    for signature, largest in subjects():
        group = regina.Triangulation3.fromIsoSig(signature).fundamentalGroup()
        for degree in range(2, largest + 1):
            found = Counter(cover.abelianisation().str() for cover in group.enumerateCovers(degree))
            text = "; ".join(f"{name} x {found[name]}" for name in sorted(found))
            print(signature, degree, text or "-", sep="\t")


if __name__ == "__main__":
    main()
