"""Rays through truncated tetrahedra in plain Python: what the pages of `tripus view` must show.

They share no formula with the page's shaders beyond the definitions: the cells are tested point by
point in the hyperboloid model, and the inside view follows one geodesic through the universal cover
instead of changing coordinates at every face."""

import math


def product(x, y):
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] - x[3] * y[3]


def apply(m, x):
    return [sum(m[4 * i + j] * x[j] for j in range(4)) for i in range(4)]


def apply_inverse(m, x):
    """The inverse of an isometry is J m^T J."""
    flipped = [x[0], x[1], x[2], -x[3]]
    y = [sum(m[4 * i + j] * flipped[i] for i in range(4)) for j in range(4)]
    return [y[0], y[1], y[2], -y[3]]


def multiply(a, b):
    return [sum(a[4 * i + k] * b[4 * k + j] for k in range(4))
            for i in range(4) for j in range(4)]


def defect(m):
    """How far a matrix is from an isometry."""
    columns = [[m[4 * i + j] for i in range(4)] for j in range(4)]
    return max(abs(product(columns[i], columns[j]) - (0 if i != j else -1 if i == 3 else 1))
               for i in range(4) for j in range(4))


def kinds(shape):
    """Of the vertices of a tetrahedron: 1 hyperideal, 0 ideal, -1 finite."""
    return shape.get("diagonal", [1, 1, 1, 1])


ENDS = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
CUT = 14  # the number of a cut among the walls of a cell


def edge_walls(shape):
    """Of the six edges of a tetrahedron the null vector around which a parabolic one is cut off, or
    []: the planes of its ends touch in its ideal point."""
    return [[shape["scale"] * (a + b)
             for a, b in zip(shape["vertices"][i], shape["vertices"][j])]
            if shape.get("parabolic", 0) >> e & 1 else [] for e, (i, j) in enumerate(ENDS)]


def walls(shape):
    """Of a tetrahedron (normal, level): products are at most the level inside. ([], 0) beside a
    finite vertex, and at edges that are not parabolic."""
    return ([(n, 0) for n in shape["faces"]] +
            [(v if kind >= 0 else [], kind - 1 if kind == 0 else 0)
             for v, kind in zip(shape["vertices"], kinds(shape))] +
            [(v, -1 if v else 0) for v in edge_walls(shape)])


class OutsideTracer:
    """Straight rays against cells in the two balls or the upper half-space, which may be cut, or of
    which one tetrahedron's may be looked through."""

    def __init__(self, data, picture):
        facts = picture.facts
        self.upper, self.klein = facts["model"] == "upper", facts["model"] == "klein"
        self.camera = facts["camera"]
        self.size = (picture.width, picture.height)
        self.cut, self.clear = facts["state"]["cut"], facts["state"]["transparent"]
        self.cells = []
        self.places = []
        self.tetrahedra = [cell["tetrahedron"] for cell in facts["cells"]]
        for cell in facts["cells"]:
            isometry = multiply(facts["toModel"], cell["isometry"])
            self.places.append(isometry)
            self.cells.append([(n and apply(isometry, n), level)
                               for n, level in walls(data["tetrahedra"][cell["tetrahedron"]])])

    def ray(self, x, y):
        """Direction of the ray through a place of the picture, in pixels."""
        tangent, axes = self.camera["tangent"], self.camera["axes"]
        a = (2 * x / self.size[0] - 1) * tangent[0]
        b = (2 * y / self.size[1] - 1) * tangent[1]
        d = [a * axes[i] + b * axes[3 + i] + axes[6 + i] for i in range(3)]
        length = math.sqrt(sum(c * c for c in d))
        return [c / length for c in d]

    def lift(self, p):
        """The point of the hyperboloid at a place of the model; None outside the model."""
        square = sum(c * c for c in p)
        if self.upper:
            if p[2] <= 0:
                return None
            return [p[0] / p[2], p[1] / p[2], (square - 1) / (2 * p[2]), (square + 1) / (2 * p[2])]
        if square >= 1:
            return None
        if self.klein:
            time = 1 / math.sqrt(1 - square)
            return [c * time for c in p] + [time]
        return [2 * c / (1 - square) for c in p] + [(1 + square) / (1 - square)]

    def crossings(self, n, level, o, d):
        """Where a ray crosses the plane, or the horosphere, of the points whose product with n is
        the level: less it, the product is A |p|^2 + 2 b.p + C up to a positive factor."""
        if self.upper:
            A, b, C = n[2] - n[3], (n[0], n[1], -level), -n[2] - n[3]
        elif self.klein:
            A, b, C = 0, [x / 2 for x in n[:3]], -n[3]
        else:
            A, b, C = -n[3] + level, n[:3], -n[3] - level
        od = sum(x * y for x, y in zip(o, d))
        half = A * od + sum(x * y for x, y in zip(b, d))
        c = A * sum(x * x for x in o) + 2 * sum(x * y for x, y in zip(b, o)) + C
        if self.klein and level != 0:  # the square of the product is 1 - |p|^2
            A, half, c = (4 * half * half + 1, 2 * half * c + od,
                          c * c - 1 + sum(x * x for x in o))
        root = half * half - A * c
        if root < 0:
            return []
        q = -(half + math.copysign(math.sqrt(root), half))
        return [value for value in ((q / A if A else None), (c / q if q else None))
                if value is not None and value > 0]

    def see(self, x, y):
        """(cell, surface + 1) seen at a place of the picture, (0, 0) for none."""
        return self.see_point(x, y)[0]

    def see_point(self, x, y):
        """The same, and the point in the coordinates of the cell's tetrahedron."""
        o, d = self.camera["eye"], self.ray(x, y)
        nearest, seen, met = math.inf, (0, 0), None
        for number, normals in enumerate(self.cells):
            if self.tetrahedra[number] == self.clear:
                continue
            ways = [(surface, s) for surface, (n, level) in enumerate(normals) if n
                    for s in self.crossings(n, level, o, d)]
            if self.cut is not None and d[0] != 0:
                ways.append((CUT, (self.cut - o[0]) / d[0]))
            for surface, s in ways:
                if s >= nearest or s <= 0:
                    continue
                place = [a + s * b for a, b in zip(o, d)]
                point = self.lift(place)
                if point is None:
                    continue
                if self.cut is not None and surface != CUT and place[0] > self.cut:
                    continue
                if all(i == surface or not m or product(m, point) <= level
                       for i, (m, level) in enumerate(normals)):
                    nearest, seen = s, (number, surface + 1)
                    met = apply_inverse(self.places[number], point)
        return seen, met


class InsideTracer:
    """One geodesic in the frame of the tetrahedron in which it begins."""

    KINDS = {"wall": 1, "edge": 2}

    def __init__(self, data, picture, tube=0.03, tangent=None):
        self.data = data
        self.frame = picture.facts["frame"]
        self.start = picture.facts["tetrahedron"]
        self.size = (picture.width, picture.height)
        self.tube = math.sinh(tube) ** 2
        aspect = self.size[0] / self.size[1]
        self.tangent = tangent or (0.72 * aspect, 0.72)

    def meet(self, normal, x, u):
        towards = product(normal, u)
        if towards <= 0:
            return math.inf
        ratio = -product(normal, x) / towards
        return math.atanh(max(ratio, 0)) if ratio < 1 else math.inf

    def meet_horosphere(self, v, x, u):
        """Where the product with a null vector rises to -1: with y = e^s,
        (a + b) y^2 + 2 y + a - b = 0."""
        a, b = product(v, x), product(v, u)
        root = 1 - (a + b) * (a - b)
        if b <= 0 or root <= 0:
            return math.inf
        y = (b - a) / (1 + math.sqrt(root))
        return math.log(y) if y > 1 else 0.0

    def meet_tube(self, v, w, x, u):
        """Where the distance from the line through the vertices v and w falls to the radius. The part
        of p along the line is found from its products with v and w; what is left lies across."""
        c, vv, ww = product(v, w), round(product(v, v)), round(product(w, w))

        def across(p, q):
            pv, pw, qv, qw = (product(p, v), product(p, w), product(q, v), product(q, w))
            along = (ww * pv * qv + vv * pw * qw - c * (pv * qw + pw * qv)) / (vv * ww - c * c)
            return product(p, q) - along

        a, b, d = across(x, x) - self.tube, across(x, u), across(u, u) + self.tube
        root = b * b - a * d
        if root <= 0 or a <= 0 or b >= 0:
            return math.inf
        t = a / (-b + math.sqrt(root))
        return math.atanh(t) if t < 1 else math.inf

    def see(self, x, y):
        """(kind, tetrahedron, vertex or edge) seen at a place of the picture; None if it is too far
        for this arithmetic."""
        return self.see_point(x, y)[0]

    def see_point(self, x, y):
        """The same, and the point in the coordinates of that tetrahedron."""
        a = (2 * x / self.size[0] - 1) * self.tangent[0]
        b = (2 * y / self.size[1] - 1) * self.tangent[1]
        length = math.sqrt(a * a + b * b + 1)
        columns = [[self.frame[4 * i + j] for i in range(4)] for j in range(4)]
        u = [(a * r + b * t + f) / length for r, t, f in zip(*columns[:3])]
        p = columns[3]
        place = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
        t, came, gone = self.start, None, 0.0
        for _ in range(60):
            shape = self.data["tetrahedra"][t]
            faces = [apply(place, n) for n in shape["faces"]]
            poles = [apply(place, v) for v in shape["vertices"]]
            exit_at, face = min((self.meet(n, p, u), f) for f, n in enumerate(faces) if f != came)
            events = [(self.meet(v, p, u) if kind > 0 else self.meet_horosphere(v, p, u), 1, i)
                      for i, (v, kind) in enumerate(zip(poles, kinds(shape))) if kind >= 0]
            cut_off = edge_walls(shape)
            events += [(self.meet_horosphere(apply(place, cut_off[e]), p, u), 1, 4 + e)
                       if cut_off[e] else (self.meet_tube(poles[i], poles[j], p, u), 2, e)
                       for e, (i, j) in enumerate(ENDS)]
            # A tube that was met beside an earlier tetrahedron was its business.
            first = min(event for event in events if event[0] >= gone - 1e-9)
            if first[0] < exit_at:
                c, s = math.cosh(first[0]), math.sinh(first[0])
                met = [c * a + s * b for a, b in zip(p, u)]
                return (first[1], t, first[2]), apply_inverse(place, met)
            if exit_at > 6:
                return None, None
            gone = exit_at
            place = multiply(place, self.data["face_pairings"][t][face])
            neighbour, word = self.data["gluings"][t][face]
            came, t = int(word[face]), neighbour
        return None, None
