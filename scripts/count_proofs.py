#!/usr/bin/env python3
"""Counts what `tripus prove --batch LIST --json` says, from standard input.

    tripus prove --batch five.txt --json | scripts/count_proofs.py > five-counts.txt

One line a count; geometric triangulations that are not proved are named at the end.
"""

import collections
import json
import sys


def largest_radius(proof):
    return max(float(radius) for radius in proof["radii"])


def main():
    counts = collections.Counter()
    widest = 0.0
    unproved = []
    for line in sys.stdin:
        answer = json.loads(line)
        if "error" in answer:
            counts["not read"] += 1
            continue
        outcome, proof = answer["outcome"], answer["proof"]
        proved = proof["proved"]
        counts["triangulations"] += 1
        counts[outcome] += 1
        high = min(answer["edge_valences"]) >= 6
        counts["all valences >= 6"] += high
        if outcome == "degenerate":
            counts["degenerate, proved"] += proved
        if outcome != "geometric":
            if high:
                unproved.append((answer["input"], outcome))
            continue
        counts["geometric, proved"] += proved
        counts["all valences >= 6, proved geometric"] += high and proved
        if not proved:
            unproved.append((answer["input"], proof["reason"]))
            continue
        counts["geometric, proved in doubles alone"] += proof["bits"] == 53
        counts["geometric, proved with escalated tetrahedra"] += proof["escalated"] > 0
        widest = max(widest, largest_radius(proof))
    for name in sorted(counts):
        print(f"{name}: {counts[name]}")
    print(f"largest radius of a length: {widest:.3g}")
    for signature, reason in unproved:
        print(f"not proved: {signature}: {reason}")


if __name__ == "__main__":
    main()
