"""Integer matrices, small ones: diagonal form and kernels."""

from __future__ import annotations

Matrix = list[list[int]]


def diagonal(rows: Matrix, columns: int) -> tuple[list[int], Matrix]:
    """Row and column operations to a diagonal matrix: its entries other than 0, not divisors of
    each other, and the column operations as a matrix [columns x columns]."""
    a = [list(row) for row in rows]
    turned = [[int(i == j) for j in range(columns)] for i in range(columns)]
    found: list[int] = []
    while True:
        k = len(found)
        pivots = [(abs(a[i][j]), i, j) for i in range(k, len(a)) for j in range(k, columns) if a[i][j]]
        if not pivots:
            return found, turned
        _, i, j = min(pivots)
        a[k], a[i] = a[i], a[k]
        for row in (*a, *turned):
            row[k], row[j] = row[j], row[k]
        while True:
            p = a[k][k]
            for i in range(k + 1, len(a)):
                q = a[i][k] // p
                if q:
                    a[i] = [x - q * y for x, y in zip(a[i], a[k])]
            for j in range(k + 1, columns):
                q = a[k][j] // p
                if q:
                    for row in (*a, *turned):
                        row[j] -= q * row[k]
            left = [i for i in range(k + 1, len(a)) if a[i][k]]
            right = [j for j in range(k + 1, columns) if a[k][j]]
            if not left and not right:
                break
            if left:
                a[k], a[left[0]] = a[left[0]], a[k]
            else:
                for row in (*a, *turned):
                    row[k], row[right[0]] = row[right[0]], row[k]
        found.append(abs(a[k][k]))


def torsion_and_rank(rows: Matrix, columns: int) -> tuple[list[int], int]:
    """Of the abelian group with these relations: the prime powers that are orders of its finite
    cyclic summands, in order, and its rank."""
    entries, _ = diagonal(rows, columns)
    powers = []
    for d in entries:
        p = 2
        while d > 1:
            if p * p > d:
                p = d
            power = 1
            while d % p == 0:
                d, power = d // p, power * p
            if power > 1:
                powers.append(power)
            p += 1
    return sorted(powers), columns - len(entries)


def kernel(rows: Matrix, columns: int) -> Matrix:
    """A basis of the integer vectors x with rows x = 0."""
    entries, turned = diagonal(rows, columns)
    return [[row[j] for row in turned] for j in range(len(entries), columns)]
