#!/usr/bin/env python3
"""Checks the numbered equations of docs/theory.md on random samples, in plain Python.

It shares no code with the library: closed forms are compared with finite differences, with each
other, and with published digits. Prints one line an equation; exit status 1 if one fails.
"""

import cmath
import math
import random
import sys

EDGES = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
SAMPLES = 25
# zeta(2), zeta(4), ...: the first few in closed form, the others by their fast series.
ZETA = [math.pi**2 / 6, math.pi**4 / 90, math.pi**6 / 945, math.pi**8 / 9450, math.pi**10 / 93555]
ZETA += [sum(k ** (-2.0 * n) for k in range(1, 40)) for n in range(6, 40)]
failures = 0


def report(label, error, bound):
    global failures
    good = error <= bound
    failures += not good
    print(f"{'ok  ' if good else 'FAIL'} {label}: largest error {error:.1e}, allowed {bound:.0e}")


def others(i, j):
    return [v for v in range(4) if v not in (i, j)]


def symmetric(values, diagonal=1.0):
    m = [[diagonal] * 4 for _ in range(4)]
    for value, (i, j) in zip(values, EDGES):
        m[i][j] = m[j][i] = value
    return m


def det(m):
    if len(m) == 1:
        return m[0][0]
    return sum((-1) ** c * m[0][c] * det([r[:c] + r[c + 1 :] for r in m[1:]]) for c in range(len(m)))


def gram(l):
    return symmetric([-math.cosh(x) for x in l])


def cofactors(g):
    def minor(i, j):
        return [[g[r][c] for c in range(4) if c != j] for r in range(4) if r != i]

    return [[(-1) ** (i + j) * det(minor(i, j)) for j in range(4)] for i in range(4)]


def angles(l):
    """Equation (9)."""
    g, theta = gram(l), []
    c, root = cofactors(g), math.sqrt(-det(g))
    for x, (i, j) in zip(l, EDGES):
        k, m = others(i, j)
        theta.append(math.atan2(root * math.sinh(x), c[k][m]))
    return theta


def paper_angle(l, i, j):
    """Equations (13) and (14): hexagon law, then triangle law at vertex i."""
    e = symmetric(l, 0.0)

    def side(k, m):
        a, b = e[i][k], e[i][m]
        return (math.cosh(e[k][m]) + math.cosh(a) * math.cosh(b)) / (math.sinh(a) * math.sinh(b))

    k, m = others(i, j)
    near, next_, far = side(j, k), side(j, m), side(k, m)
    return math.acos((near * next_ - far) / math.sqrt((near * near - 1) * (next_ * next_ - 1)))


def jacobian(l, diagonal):
    """Equations (17) to (20)."""
    a = symmetric([math.cosh(x) for x in l])
    s = symmetric([math.sinh(x) for x in l])
    g = gram(l)
    c, d = cofactors(g), -det(g)
    root = math.sqrt(d)
    p = [-c[i][i] for i in range(4)]
    cosine = symmetric([math.cos(t) for t in angles(l)])
    J = [[0.0] * 6 for _ in range(6)]
    for row, (i, j) in enumerate(EDGES):
        k, m = others(i, j)
        for col, (u, v) in enumerate(EDGES):
            if {u, v} == {k, m}:
                J[row][col] = s[i][j] * s[k][m] / root
            elif {u, v} == {i, j}:
                if diagonal == "lengths":
                    J[row][col] = (
                        2 * a[i][j] * a[k][m] - a[i][k] * a[j][m] - a[i][m] * a[j][k]
                        + c[k][m] * ((a[i][j] + a[i][m] * a[j][m]) / p[k]
                                     + (a[i][j] + a[i][k] * a[j][k]) / p[m])
                    ) / root
                else:
                    J[row][col] = math.sqrt(p[0] * p[1] * p[2] * p[3]) / d**1.5 * (
                        cosine[i][k] * cosine[j][m] + cosine[i][m] * cosine[j][k]
                        + cosine[i][j] * (cosine[i][m] * cosine[j][m] + cosine[i][k] * cosine[j][k])
                    )
            else:
                (shared,) = {i, j} & {u, v}
                (outside,) = {0, 1, 2, 3} - {i, j, u, v}
                J[row][col] = -s[i][j] * s[u][v] / root * c[shared][outside] / p[outside]
    return J


def clausen(x):
    """Cl2 by its power series about 0 and by duplication: Cl2(2x) = 2 Cl2(x) - 2 Cl2(pi - x)."""
    x = math.remainder(x, 2 * math.pi)
    if abs(x) < 1e-300:
        return 0.0
    if abs(x) > 2 * math.pi / 3:
        return 2 * clausen(x / 2) - 2 * clausen(math.pi - x / 2)
    total = x * (1 - math.log(abs(x)))
    for n, zeta in enumerate(ZETA, start=1):
        total += zeta * x * (x / (2 * math.pi)) ** (2 * n) / (n * (2 * n + 1))
    return total


def volume(theta):
    """Equations (24) and (25)."""
    A, B, C, F, E, D = theta  # edges 01 02 03 12 13 23
    g = symmetric([-math.cos(x) for x in (D, E, F, C, B, A)])  # faces i, j meet opposite edge ij
    root = math.sqrt(-det(g))
    q = sum(math.sin(x) * math.sin(y) for x, y in ((A, D), (B, E), (C, F)))
    sums = (A + D, B + E, C + F, A + B + F, A + C + E, B + C + D, D + E + F, A + B + C + D + E + F)
    denominator = complex(sum(math.cos(x) for x in sums), sum(math.sin(x) for x in sums))

    def S(z):
        phi = math.atan2(z.imag, z.real)
        plus = (0, A + B + D + E, A + C + D + F, B + C + E + F)
        minus = (A + B + C, A + E + F, B + D + F, C + D + E)
        return (sum(clausen(phi + x) for x in plus)
                - sum(clausen(phi + math.pi + x) for x in minus))

    z_plus = -2 * complex(q, root) / denominator
    z_minus = -2 * complex(q, -root) / denominator
    assert abs(abs(z_plus) - 1) < 1e-9 and abs(abs(z_minus) - 1) < 1e-9
    return (S(z_minus) - S(z_plus)) / 4


def difference(f, l, index, h=1e-3):
    """Fifth-order central difference."""
    def at(step):
        return f([x + step * (n == index) for n, x in enumerate(l)])

    return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h)


def simpson(f, a, b, n=2000):
    h = (b - a) / n
    return h / 3 * (f(a) + f(b) + sum((4 if i % 2 else 2) * f(a + i * h) for i in range(1, n)))


def sample(random_, good=True):
    while True:
        l = [random_.uniform(0.3, 2.5) for _ in EDGES]
        d = det(gram(l))
        if (d < -0.5) if good else (d > 1e-6):
            return l


def cholesky_definite(m):
    n = len(m)
    m = [row[:] for row in m]
    for k in range(n):
        if m[k][k] <= 0:
            return False
        for i in range(k + 1, n):
            f = m[i][k] / m[k][k]
            for j in range(n):
                m[i][j] -= f * m[k][j]
    return True


def certificate_identities(random_, tetrahedra=5, edges=4):
    """Largest error of (51) and (52) for random edge classes, multipliers and angles."""
    corners = [(t, i, j) for t in range(tetrahedra) for i, j in EDGES]
    edge_of = {c: n % edges for n, c in enumerate(corners)}
    x = {c: random_.random() for c in corners}
    for e in range(edges):
        total = sum(x[c] for c in corners if edge_of[c] == e)
        x.update({c: 2 * x[c] / total for c in corners if edge_of[c] == e})
    w = {(t, v): random_.random() for t in range(tetrahedra) for v in range(4)}
    u = [random_.uniform(-1, 1) for _ in range(edges)]
    a = {c: w[c[0], c[1]] + w[c[0], c[2]] - u[edge_of[c]] for c in corners}
    s = {p: sum(x[c] for c in corners if c[0] == p[0] and p[1] in c[1:]) for p in w}
    R = sum(w.values()) - 2 * sum(u)
    valence = [sum(edge_of[c] == e for c in corners) for e in range(edges)]
    return max(
        abs(R - sum(a[c] * x[c] for c in corners) - sum(w[p] * (1 - s[p]) for p in w)),
        abs(sum(a.values()) + sum(w.values()) - 4 * sum(w.values())
            + sum(d * y for d, y in zip(valence, u))))


def lorentz(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3]


def circle_plane(k, u, k2):
    """Equation (64) backwards."""
    return [u.real, u.imag, (k2 - k) / 2, (k2 + k) / 2]


def paper_circles(theta):
    """Equations (65) to (68): the normals of f1..f4, v1..v4, and the two sides of (67)."""
    t4, t6, t2, t5, t3, t1 = theta  # edges 01 02 03 12 13 23
    sine = math.sin(t1)
    c3 = complex((math.cos(t1) * math.cos(t3) + math.cos(t2)) / sine, math.cos(t3))
    c4 = complex((math.cos(t1) * math.cos(t5) + math.cos(t6)) / sine, math.cos(t5))
    u = math.cos(t4) + (c3 * c4.conjugate()).real
    q, p = abs(c3) ** 2 - 1, abs(c4) ** 2 - 1
    root = math.sqrt(u * u - p * q)
    R = q / (u + root)
    along = cmath.exp(1j * t1)
    planes = [circle_plane(0, -1j, 0), circle_plane(0, 1j * along, 0), circle_plane(1, c3, q),
              circle_plane(1 / R, c4, R * p)]
    for direction in (along, 1):
        x, x2 = (c3 * direction.conjugate()).real, (c4 * direction.conjugate()).real
        k, m = 2 * (x2 - x / R), R * p - q / R
        planes.append(circle_plane(k, m * direction, 2 * m * x - k * q))
    planes.append(circle_plane(1 / (R * math.sqrt(p)), 0j, -R * math.sqrt(p)))
    planes.append(circle_plane(-1 / math.sqrt(q), 0j, math.sqrt(q)))
    normals = symmetric([-math.cos(theta[5 - n]) for n in range(6)])
    minors = [abs(-det([r[:3] for r in normals[:3]]) - q * sine**2),
              abs(-det([[normals[i][j] for j in (0, 1, 3)] for i in (0, 1, 3)]) - p * sine**2),
              abs(-det(normals) - root**2 * sine**2)]
    return planes, max(minors)


def check_circles(theta, note):
    planes, minors = paper_circles(theta)
    note("(67) minors", minors)
    for n, (k, m) in enumerate(EDGES):
        note("(65) (66) faces meet at the dihedral angles",
             abs(lorentz(planes[k], planes[m]) + math.cos(theta[5 - n])))
    for i in range(4):
        for j in range(4):
            if i != j:
                note("(68) truncations are orthogonal to their faces",
                     abs(lorentz(planes[4 + i], planes[j])) / max(map(abs, planes[4 + i])))


def check_moebius(random_, note):
    """Equations (60) and (61) for a random M, and (75) for its images of three points."""
    def number():
        return complex(random_.gauss(0, 1), random_.gauss(0, 1))

    a, b, c = number(), number(), number()
    M = [[a, b], [c, (1 + b * c) / a]]
    sigma = [[[0, 1], [1, 0]], [[0, 1j], [-1j, 0]], [[1, 0], [0, -1]], [[1, 0], [0, 1]]]

    def product(p, q):
        return [[sum(p[i][k] * q[k][j] for k in (0, 1)) for j in (0, 1)] for i in (0, 1)]

    star = [[M[j][i].conjugate() for j in (0, 1)] for i in (0, 1)]
    columns = []
    for s in sigma:
        h = product(product(M, s), star)
        columns.append([h[0][1].real, h[0][1].imag, (h[0][0] - h[1][1]).real / 2,
                        (h[0][0] + h[1][1]).real / 2])
    size = columns[3][3]
    for i in range(4):
        for j in range(4):
            expected = 0 if i != j else (-1 if i == 3 else 1)
            note("(60) gives isometries", abs(lorentz(columns[i], columns[j]) - expected) / size**2)
    for C in sigma:
        total = [[0, 0], [0, 0]]
        for m in range(4):
            for n in range(4):
                term = product(product(sigma[m], C), sigma[n])
                for i in (0, 1):
                    for j in (0, 1):
                        total[i][j] += columns[n][m] * term[i][j]
        trace = sum(product(star, C)[i][i] for i in (0, 1))
        note("(61)", max(abs(total[i][j] - 2 * trace * M[i][j]) for i in (0, 1) for j in (0, 1))
             / size**2)


def check_area(random_, note):
    """Equation (75) against pi minus the angles of the triangle."""
    sides = [random_.uniform(0.5, 1.5) for _ in range(3)]
    if max(sides) >= sum(sides) - max(sides) - 0.05:
        return
    ch, sh = [math.cosh(d) for d in sides], [math.sinh(d) for d in sides]
    angle_sum = sum(math.acos((ch[(i + 1) % 3] * ch[(i + 2) % 3] - ch[i])
                              / (sh[(i + 1) % 3] * sh[(i + 2) % 3])) for i in range(3))
    p, q, r = (c - 1 for c in ch)
    root = math.sqrt(2 * (p * q + q * r + r * p) - p * p - q * q - r * r + 2 * p * q * r)
    note("(75)", abs(2 * math.atan2(root, 4 + p + q + r) - (math.pi - angle_sum)))


def radial(q):
    return (1 / (1 - q) - math.atanh(math.sqrt(q)) / math.sqrt(q)) / (2 * q)


def check_divergence(note):
    """Equation (74): div (y g(|y|^2)) = 3 g + 2 q g'(q)."""
    for q in (0.05, 0.3, 0.7, 0.9):
        h = 1e-4 * (1 - q)
        slope = (8 * (radial(q + h) - radial(q - h)) - (radial(q + 2 * h) - radial(q - 2 * h))) / (12 * h)
        note("(74) divergence", abs(3 * radial(q) + 2 * q * slope - (1 - q) ** -2))


def check_proofs(note):
    """Equations (91) to (97): tails of the series, and the bounds on one-edge triangulations."""
    exp_tail = math.fsum(1.05 ** (n - 2) / math.factorial(n) for n in range(21, 60))
    atan_tail = 0.42**44 / 47
    log_tail = math.fsum(0.172 ** (2 * n - 2) / (2 * n + 1) for n in range(13, 60))
    note("(91) tails beyond their bounds", max(0.0, exp_tail / 1e-19 - 1, atan_tail / 7e-19 - 1, log_tail / 2e-20 - 1))
    for x, d in ((0.1, 1.0), (3.0, -0.7), (10.0, 0.5), (0.5, 1e-3)):
        bound = math.cosh(x) * abs(d) * (1 + 2 * abs(d))
        note("(92)", max(0.0, abs(math.sinh(x + d) - math.sinh(x)) / bound - 1))
        note("(92)", max(0.0, abs(math.cosh(x + d) - math.cosh(x)) / bound - 1))
    zeta = [ZETA[n] if n < len(ZETA) else 1.0 for n in range(40)]
    c = [2 * zeta[n - 1] / ((2 * math.pi) ** (2 * n) * 2 * n * (2 * n + 1)) for n in range(1, 18)]
    for a in (0.01, 0.7, 1.5, 2.15):
        series = a * (1 - math.log(a)) + math.fsum(c[n - 1] * a ** (2 * n + 1) for n in range(1, 17))
        note("(93) near 0", abs(series - clausen(a)))
    for y in (0.01, 0.5, 1.1):
        terms = math.fsum((4**n - 1) * c[n - 1] * y ** (2 * n + 1) for n in range(1, 17))
        note("(93) near pi", abs(y * math.log(2) - terms - clausen(math.pi - y)))
    note("(93) tails beyond their bounds", max(0.0, c[16] * 2.15**32 / 0.87 / 1.3e-19 - 1,
                                               4**17 * c[16] * 1.1**32 / 0.87 / 5.2e-19 - 1))

    # One edge class of valence 6 g, all lengths equal: H'' = g times the sum of the entries of J.
    for genus in (2, 3):
        t = math.pi / (3 * genus)
        exact = math.acosh(math.cos(t) / (2 * math.cos(t) - 1))
        best = genus * volume([t] * 6)
        for off in (-1e-2, -1e-3, 1e-3, 1e-2):
            ends = [exact + 1.5 * off * k / 10 for k in range(11)]
            J = [jacobian([l] * 6, "lengths") for l in ends]
            # The least eigenvalue of J is u (2C - 1)(3C - 1)/(1 - C), (21), which rows have as sums.
            d = 6 * genus * min(math.fsum(row[0]) for row in J)
            l = exact + off
            theta = angles([l] * 6)
            K = 2 * math.pi - genus * math.fsum(theta)
            note("(95) beyond the bound", max(0.0, abs(off) - abs(K) / d))
            delta = genus * volume(theta) - K * l / 2 - best
            note("(96) (97) delta below 0", max(0.0, -delta - 1e-14))
            note("(96) (97) delta beyond the bound", max(0.0, delta - K * K / d / 4))


def mixed_gram(l, kinds):
    """Equation (77); kinds are G_vv. Returns the Gram matrix and s."""
    g, s = symmetric([0.0] * 6), symmetric([0.0] * 6)
    for x, (i, j) in zip(l, EDGES):
        if kinds[i] == 0 or kinds[j] == 0:
            entry = slope = (2 if kinds[i] == kinds[j] else 1) * math.exp(x)
        elif kinds[i] == kinds[j]:
            entry, slope = math.cosh(x), math.sinh(x)
        else:
            entry, slope = math.sinh(x), math.cosh(x)
        g[i][j] = g[j][i] = -entry
        s[i][j] = s[j][i] = slope
    for v in range(4):
        g[v][v] = float(kinds[v])
    return g, s


def mixed_angles(l, kinds):
    """Equation (9) with (77), or None if there is no such tetrahedron."""
    g, s = mixed_gram(l, kinds)
    c, d = cofactors(g), -det(g)
    if d <= 0 or any(c[v][v] >= 0 for v in range(4)):
        return None
    return [math.atan2(math.sqrt(d) * s[i][j], c[others(i, j)[0]][others(i, j)[1]]) for i, j in EDGES]


def check_vertices_of_every_kind(random_, note):
    for kinds in [(a, b, c, d) for a in (1, 0, -1) for b in (1, 0, -1) for c in (1, 0, -1) for d in (1, 0, -1)]:
        for _ in range(200):
            l = [random_.uniform(0.3, 1.5) for _ in range(6)]
            theta = mixed_angles(l, kinds)
            if theta and all(0.1 < t < 2.8 for t in theta):
                break
        else:
            continue
        g, s = mixed_gram(l, kinds)
        for i, j in EDGES:
            note("(77) s^2 = G_ij^2 - G_ii G_jj", abs(s[i][j] ** 2 - g[i][j] ** 2 + g[i][i] * g[j][j]))
        # Schlaefli's formula holds for these lengths whatever the mixture.
        J = [[difference(lambda x: mixed_angles(x, kinds)[a], l, e) for a in range(6)]
             for e in range(6)]
        dV = [difference(lambda x: volume(mixed_angles(x, kinds)), l, e) for e in range(6)]
        for e in range(6):
            note("(23) (77) Schlaefli's formula for every mixture of vertices",
                 abs(dV[e] + sum(x * t for x, t in zip(l, J[e])) / 2))
        for v in range(4):
            if kinds[v] != 0:
                continue
            at = [e for e, ends in enumerate(EDGES) if v in ends]
            moved = mixed_angles([x + 0.7 * (e in at) for e, x in enumerate(l)], kinds)
            note("(78) moving a horosphere changes no angle", max(abs(x - y) for x, y in zip(moved, theta)))
            note("(78) angles at an ideal vertex sum to pi", abs(sum(theta[e] for e in at) - math.pi))
            # (80): the horosphere's triangle has the dihedral angles for its angles.
            i, (j, k, m) = v, [w for w in range(4) if w != v]

            def side(a, b):
                return math.sqrt(g[a][a] / g[i][a] ** 2 + g[b][b] / g[i][b] ** 2
                                 - 2 * g[a][b] / (g[i][a] * g[i][b]))

            x, y, z = side(j, k), side(j, m), side(k, m)
            angle = theta[EDGES.index((min(i, j), max(i, j)))]
            note("(80) triangle on the horosphere", abs((x * x + y * y - z * z) / (2 * x * y) - math.cos(angle)))


def main():
    random_ = random.Random(20)
    errors = {}

    def note(label, error):
        errors[label] = max(errors.get(label, 0.0), error)

    for _ in range(SAMPLES):
        l = sample(random_)
        theta = angles(l)
        for n, (i, j) in enumerate(EDGES):
            note("(13) (14) paper's route = Gram route", abs(theta[n] - paper_angle(l, i, j)))
            note("(13) (14) same angle at the other end", abs(theta[n] - paper_angle(l, j, i)))
        g = gram(l)
        c, d = cofactors(g), -det(g)
        a, s = symmetric([math.cosh(x) for x in l]), symmetric([math.sinh(x) for x in l])
        for i, j in EDGES:
            k, m = others(i, j)
            explicit = (-a[k][m] * s[i][j] ** 2 + a[i][k] * a[i][m] + a[j][k] * a[j][m]
                        + a[i][j] * (a[i][k] * a[j][m] + a[i][m] * a[j][k]))
            note("(7) explicit cofactor", abs(explicit / c[k][m] - 1))
            note("(8) Jacobi's identity",
                 abs((c[k][k] * c[m][m] - c[k][m] ** 2) / (d * s[i][j] ** 2) - 1))
        J, J2 = jacobian(l, "lengths"), jacobian(l, "cosines")
        for row in range(6):
            note("(19) = (20) the two diagonals", abs(J[row][row] - J2[row][row]))
            for col in range(6):
                numeric = difference(lambda x: angles(x)[row], l, col)
                kind = "(19)" if row == col else "(17)" if row + col == 5 else "(18)"
                note(kind + " against differences", abs(J[row][col] - numeric))
                note("J symmetric", abs(J[row][col] - J[col][row]))
        note("J positive definite", 0.0 if cholesky_definite(J) else 1.0)
        for n in range(6):
            numeric = difference(lambda x: volume(angles(x)), l, n)
            note("(23) Schlaefli", abs(numeric + sum(l[m] * J[m][n] for m in range(6)) / 2))
            numeric = difference(
                lambda x: 2 * volume(angles(x)) + sum(p * q for p, q in zip(angles(x), x)), l, n)
            note("(30) gradient of the co-volume", abs(numeric - theta[n]))

        l = sample(random_, good=False)
        c = cofactors(gram(l))
        signs = []
        for i, j in EDGES:
            k, m = others(i, j)
            note("(15) degenerate: |cos| >= 1", max(0.0, 1 - c[k][m] ** 2 / (c[k][k] * c[m][m])))
            signs.append(c[k][m] < 0)
        flat = [n for n in range(6) if signs[n]]
        note("(15) degenerate pattern", 0.0 if len(flat) == 2 and sum(flat) == 5 else 1.0)
        longer = list(l)
        longer[flat[0]] += random_.uniform(0, 5)
        c = cofactors(gram(longer))
        for n, (i, j) in enumerate(EDGES):
            k, m = others(i, j)
            cosine = c[k][m] / math.sqrt(c[k][k] * c[m][m])
            note("(54) the pattern stays", max(0.0, 1 - (-cosine if n in flat else cosine)))

    for _ in range(SAMPLES):
        check_circles(angles(sample(random_)), note)
        check_moebius(random_, note)
        check_area(random_, note)
    check_divergence(note)
    check_proofs(note)

    check_vertices_of_every_kind(random.Random(9), note)
    bounds = {"(13)": 1e-9, "J sym": 1e-9, "(15)": 1e-12, "(54)": 1e-9}
    for label in sorted(errors):
        report(label, errors[label], next((b for k, b in bounds.items() if label.startswith(k)), 1e-7))

    # Regular tetrahedra: (21), (26), (27), and the first manifolds.
    for t in (0.2, 0.5, 0.9, 1.0):
        C = math.cos(t)
        l = math.acosh(C / (2 * C - 1))
        J = jacobian([l] * 6, "lengths")
        unit = J[0][5]
        note("(21)", abs(J[0][0] + 4 * J[0][1] + J[0][5] - unit * (2 * C - 1) * (3 * C - 1) / (1 - C)))
        note("(21)", abs(J[0][0] - J[0][5] - unit * (2 * C - 1) * (1 + C) / (1 - C)))
        note("(21)", abs(J[0][0] - 2 * J[0][1] + J[0][5] - unit * (1 + C) / (1 - C)))
        note("(26)", max(abs(x - t) for x in angles([l] * 6)))
    report("(21) regular tetrahedron, eigenvalues of J (absolute, up to 1e2)", errors["(21)"], 1e-9)
    report("(26) regular tetrahedron, length of angle", errors["(26)"], 1e-12)

    v8 = 3.66386237670887606
    report("(27) octahedron constant = 4 Catalan", abs(8 * clausen(math.pi / 2) / 2 - v8), 1e-14)
    for t in (math.pi / 6, math.pi / 9):
        integral = simpson(lambda s: math.acosh(max(1.0, math.cos(s) / (2 * math.cos(s) - 1))), 1e-9, t)
        report(f"(27) regular tetrahedron of angle pi/{math.pi / t:.0f}, quadrature",
               abs(volume([t] * 6) - (v8 - 3 * integral)), 1e-9)
    published = {2: 6.45199027083503287, 3: 10.42860158023565817, 4: 14.23817002481015732,
                 5: 17.98726236750444991}
    for genus, value in published.items():
        report(f"(28) one-edge triangulation, genus {genus}",
               abs(genus * volume([math.pi / (3 * genus)] * 6) - value), 1e-13)
    report("(51) (52) certificate identities", certificate_identities(random.Random(7)), 1e-12)
    l = math.acosh((3 + math.sqrt(3)) / 4)
    report("(5) length of the tripus", abs(l - 0.596133894890837), 1e-15)
    report("(5) angles of the tripus", max(abs(x - math.pi / 6) for x in angles([l] * 6)), 1e-14)
    h = 2 * sum(sum(row) for row in jacobian([l] * 6, "lengths"))
    print(f"     second derivative of H at the tripus {h:.12f}: explicit Euler needs dt < {2 / h:.6f}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
