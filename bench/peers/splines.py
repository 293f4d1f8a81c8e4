"""Numbers, points, polynomials and B-splines in Python's fractions, for properties.py."""
from fractions import Fraction


def number(text):
    if not isinstance(text, str):
        return Fraction(text)
    text = text.lower()
    if "x" not in text:
        return Fraction(text)
    mantissa, _, exponent = text.replace("0x", "").partition("p")
    whole, _, part = mantissa.partition(".")
    return Fraction(int(whole + part or "0", 16)) / 16 ** len(part) * Fraction(2) ** int(exponent or 0)


def row(points):
    return [[number(x) for x in point] for point in points]


def combine(a, x, b, y):
    return [a * s + b * t for s, t in zip(x, y)]


def minus(x, y):
    return [s - t for s, t in zip(x, y)]


def determinant(m):
    """By elimination."""
    m, value = [list(r) for r in m], Fraction(1)
    for i in range(len(m)):
        pivot = next((j for j in range(i, len(m)) if m[j][i] != 0), None)
        if pivot is None:
            return Fraction(0)
        if pivot != i:
            m[i], m[pivot], value = m[pivot], m[i], -value
        value *= m[i][i]
        for j in range(i + 1, len(m)):
            factor = m[j][i] / m[i][i]
            m[j] = [x - factor * y for x, y in zip(m[j], m[i])]
    return value


class Knots:
    """The papers' list: L + n knots."""

    def __init__(self, degree, u):
        self.n, self.u = degree, u

    def pieces(self):
        count = len(self.u) - 2 * self.n + 1
        return [k for k in range(1, count + 1) if self.begin(k) < self.end(k)]

    def begin(self, k):
        return self.u[self.n + k - 2]

    def end(self, k):
        return self.u[self.n + k - 1]

    def at(self, points, k, t):
        """Point and derivative at t on piece k, by de Boor's recursion."""
        n = self.n
        level = points[k - 1 : k + n]
        for r in range(1, n):
            level = [self.step(level, k, r, j, t) for j in range(len(level) - 1)]
        slope = [n * d / (self.end(k) - self.begin(k)) for d in minus(level[1], level[0])]
        return self.step(level, k, n, 0, t), slope

    def step(self, level, k, r, j, t):
        lo, hi = self.u[k + j + r - 2], self.u[k + j + self.n - 1]
        return combine((hi - t) / (hi - lo), level[j], (t - lo) / (hi - lo), level[j + 1])


def twist(u, c, d, k, t):
    """[c', d-c, d'] of points, [p, p', q, q'] of homogeneous rows."""
    p, dp = u.at(c, k, t)
    q, dq = u.at(d, k, t)
    return determinant([dp, minus(q, p), dq] if len(p) == 3 else [p, dp, q, dq])


def developable(u, c, d):
    """The determinant vanishes at more parameters than its degree."""
    for k in u.pieces():
        count = len(c[0]) * (u.n - 1) + 1
        for i in range(count):
            t = u.begin(k) + (u.end(k) - u.begin(k)) * Fraction(i, max(count - 1, 1))
            if twist(u, c, d, k, t) != 0:
                return False
    return True


def knots_of(value):
    return Knots(value["degree"], [number(x) for x in value["list"]])


def product(f, g):
    total = [Fraction(0)] * (len(f) + len(g) - 1)
    for i, a in enumerate(f):
        for j, b in enumerate(g):
            total[i + j] += a * b
    return total


def value(f, t):
    total = Fraction(0)
    for a in reversed(f):
        total = total * t + a
    return total


def slope(f):
    return [i * a for i, a in enumerate(f)][1:]


def sum_of(f, g, factor=1):
    size = max(len(f), len(g))
    return [a + factor * b for a, b in zip(f + [Fraction(0)] * (size - len(f)), g + [Fraction(0)] * (size - len(g)))]


def polynomials(u, points, k):
    """Every coordinate on piece k by its values at degree + 1 parameters (Newton's interpolation)."""
    places = [u.begin(k) + (u.end(k) - u.begin(k)) * Fraction(i, u.n) for i in range(u.n + 1)]
    values = [u.at(points, k, t)[0] for t in places]
    rows = []
    for column in zip(*values):
        table = list(column)
        for r in range(1, len(table)):
            for i in range(len(table) - 1, r - 1, -1):
                table[i] = (table[i] - table[i - 1]) / (places[i] - places[i - r])
        f = [table[-1]]
        for a, t in zip(reversed(table[:-1]), reversed(places[:-1])):
            f = sum_of(product(f, [-t, Fraction(1)]), [a])
        rows.append(f)
    return rows


def trimmed(f):
    while f and f[-1] == 0:
        f = f[:-1]
    return f


def divided(f, g):
    """Quotient and rest."""
    quotient = [Fraction(0)] * max(0, len(f) - len(g) + 1)
    while len(f) >= len(g):
        factor = f[-1] / g[-1]
        quotient[len(f) - len(g)] = factor
        f = trimmed([a - factor * b for a, b in zip(f, [0] * (len(f) - len(g)) + g)][:-1])
    return quotient, f


def sturm(f):
    """Sturm's sequence of f, divided by its last member so that roots are simple."""
    sequence = [trimmed(f), trimmed(slope(f))]
    while sequence[-1]:
        rest = divided(sequence[-2], sequence[-1])[1]
        sequence.append([-a / abs(rest[-1]) for a in rest])
    sequence.pop()
    return [divided(g, sequence[-1])[0] for g in sequence]


def variations(sequence, t):
    signs = [x > 0 for x in (value(g, t) for g in sequence) if x != 0]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def falls_below_zero(f, sequence, a, b):
    """Whether f < 0 somewhere in (a, b)."""
    middle = (a + b) / 2
    if value(f, middle) < 0:
        return True
    end = value(f, b)
    inside = variations(sequence, a) - variations(sequence, b) - (end == 0)
    if inside == 0 or (inside == 1 and value(f, a) > 0 and end > 0):
        return False
    return falls_below_zero(f, sequence, a, middle) or falls_below_zero(f, sequence, middle, b)


def negative_somewhere(f, a, b):
    return bool(trimmed(f)) and falls_below_zero(f, sturm(f), a, b)


def cross(x, y):
    return [sum_of(product(x[(i + 1) % 3], y[(i + 2) % 3]), product(x[(i + 2) % 3], y[(i + 1) % 3]), -1) for i in range(3)]


def wedge(x, y):
    return [sum_of(product(x[0], y[i]), product(y[0], x[i]), -1) for i in (1, 2, 3)]


def same_curve(u, points, v, others):
    """Values at degree + 1 parameters of every piece of v."""
    for k in v.pieces():
        for i in range(v.n + 1):
            t = v.begin(k) + (v.end(k) - v.begin(k)) * Fraction(i, v.n)
            piece = next(j for j in u.pieces() if t < u.end(j) or j == u.pieces()[-1])
            if v.at(others, k, t)[0] != u.at(points, piece, t)[0]:
                return False
    return True


def inserted(u, points, t):
    """Boehm's knot insertion."""
    n, knots = u.n, u.u
    inside = t < knots[len(knots) - n]
    k = max(i for i, x in enumerate(knots) if x <= t) if inside else knots.index(t) - 1
    fine = []
    for i in range(len(points) + 1):
        if i <= k - n + 1:
            fine.append(points[i])
        elif i > k + 1:
            fine.append(points[i - 1])
        else:
            a = (t - knots[i - 1]) / (knots[i + n - 1] - knots[i - 1])
            fine.append(combine(1 - a, points[i - 1], a, points[i]))
    return Knots(n, knots[: k + 1] + [t] + knots[k + 1 :]), fine


def composed(f, g):
    total = []
    for a in reversed(f):
        total = sum_of(product(total, g), [a]) if total else [a]
    return total
