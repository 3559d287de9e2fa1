#!/usr/bin/env python3
"""Lists the triangulations whose vertex links all have genus 2 or more, by Regina.

    build/venv/bin/python scripts/list_triangulations.py 5 > five.txt

Every connected orientable ideal triangulation with so many tetrahedra, up to relabelling, as one
isomorphism signature a line, sorted. `data/triangulations-2.txt` to `-4.txt` are such lists. Needs
Regina's Python module, which scripts/setup installs in build/venv. Seconds for up to four tetrahedra.
"""

import argparse
import sys

import regina


def signatures(tetrahedra, report=lambda done, count: None):
    """The set of their signatures."""
    found = set()
    pairings = 0

    def take(perms):
        triangulation = perms.triangulate()
        if all(vertex.linkEulerChar() <= -2 for vertex in triangulation.vertices()):
            found.add(triangulation.isoSig())

    def search(pairing, automorphisms):
        nonlocal pairings
        pairings += 1
        report(pairings, len(found))
        regina.GluingPermSearcher3.findAllPerms(
            pairing, automorphisms, True, False, regina.Flags_CensusPurge(), take)

    regina.FacetPairing3.findAllPairings(tetrahedra, regina.BoolSet(False), 0, search)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("tetrahedra", type=int, choices=range(1, 8), metavar="N", help="1 to 7")
    tetrahedra = parser.parse_args().tetrahedra

    def report(pairings, count):
        print(f"face pairing {pairings}: {count} triangulations so far", file=sys.stderr)

    for signature in sorted(signatures(tetrahedra, report)):
        print(signature)


if __name__ == "__main__":
    main()
