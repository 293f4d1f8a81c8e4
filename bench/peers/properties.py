"""Properties of fuzz/ written with Python's fractions: the peer of bench/fuzz.cpp.

usage: properties.py FILE
FILE holds a case a line: {"property": NAME, "input": {...}} as torse writes them. Prints "NAME CASES SECONDS FAILED" for
each property that is written here: processor seconds of making fractions out of the texts and of the checks, not of
reading JSON.
"""
import json
import sys
import time
from fractions import Fraction


def number(text):
    if not isinstance(text, str):
        return Fraction(text)
    if "x" not in text:
        return Fraction(text)
    mantissa, exponent = text.replace("0x", "").split("p")
    whole, _, part = mantissa.partition(".")
    return Fraction(int(whole + part, 16)) / 16 ** len(part) * Fraction(2) ** int(exponent)


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


def linear_net(u, c, lam, m, d0):
    """FJ07.13."""
    d = [d0]
    for i in range(len(c) - 1):
        left = combine(u.u[i + u.n] - lam, c[i], lam - u.u[i], c[i + 1])
        rest = combine(Fraction(1), left, m - u.u[i + u.n], d[i])
        d.append([x / (m - u.u[i]) for x in rest])
    return d


def eq14(u, c, lam, m, d0):
    """FJ07.14 unrolled: every vertex by the product of the factors of d and the sum of those of c."""
    d = [d0]
    for last in range(1, len(c)):
        total = [Fraction(0)] * len(d0)
        product = Fraction(1)
        for i in reversed(range(last)):
            left = combine(u.u[i + u.n] - lam, c[i], lam - u.u[i], c[i + 1])
            total = combine(Fraction(1), total, product / (m - u.u[i]), left)
            product *= (m - u.u[i + u.n]) / (m - u.u[i])
        d.append(combine(Fraction(1), total, product, d0))
    return d


def eq16(u, c, lam, m, d0):
    """FJ07.16: d_N - c_N = P(0,N) (d_0 - c_0) + (L* - M*) sum P(i+1,N) (c_{i+1} - c_i) / (M* - u_i)."""
    d = [d0]
    for last in range(1, len(c)):
        total = [Fraction(0)] * len(d0)
        product = Fraction(1)
        for i in reversed(range(last)):
            total = combine(Fraction(1), total, (lam - m) * product / (m - u.u[i]), minus(c[i + 1], c[i]))
            product *= (m - u.u[i + u.n]) / (m - u.u[i])
        ruling = combine(Fraction(1), total, product, minus(d0, c[0]))
        d.append(combine(Fraction(1), c[last], Fraction(1), ruling))
    return d


def knots_of(value):
    return Knots(value["degree"], [number(x) for x in value["list"]])


def text_number(case):
    x = number(case["x"])
    return number(str(x)) == x


def text_spelling(case):
    text = bytes.fromhex(case["text"]).decode("latin-1")
    if not case["value"]:
        return True
    sign, text = (-1, text[1:]) if text.startswith("-") else (1, text.lstrip("+"))
    return sign * number(text.lower()) == number(case["value"][0])


def double_net(case):
    net = case["net"]
    u = Knots(net["degree"], [number(x) for x in net["knots"]])
    c, m = row(net["c"]), number(net["m"])
    if m in u.u:
        return True
    d = linear_net(u, c, number(net["lambda"]), m, [number(x) for x in net["d0"]])
    k = case["piece"]
    t = u.begin(k) + (u.end(k) - u.begin(k)) * number(case["share"])
    if case["moved"] < 0:
        return twist(u, c, d, k, t) == 0
    i, j = divmod(case["moved"], 3)
    rounded = [[Fraction(float(x)) for x in point] for point in d]
    rounded[i][j] += number(case["shift"]) * (abs(rounded[i][j]) or 1)
    if twist(u, c, rounded, k, t) == 0:
        developable(u, c, rounded)
    return True


def double_rows(case):
    """Transformations (insert, elevate, moebius, tangent) are checked before they are made."""
    net = case["net"]
    u = Knots(net["degree"], [number(x) for x in net["knots"]])
    w = [number(x) for x in case["weights"]]
    p = [[s] + [s * x for x in point] for s, point in zip(w, row(net["c"]))]
    s = number(case["weight"])
    q0 = [s] + [s * number(x) for x in net["d0"]]
    lam, m, factor = number(net["lambda"]), number(net["m"]), number(case["factor"])
    name = case["function"]
    if name == "cone":
        q = [q0]
        for a, b in zip(p, p[1:]):
            q.append(combine(Fraction(1), q[-1], factor, minus(b, a)))
    elif name == "cylinder":
        q = [combine(Fraction(1), x, x[1] * factor, q0) for x in p]
    elif name == "7.1":
        q = linear_net(u, [[x / factor for x in point] for point in p], lam, m, q0)
    else:
        q = {"14": eq14, "16": eq16}.get(name, linear_net)(u, p, lam, m, q0)
    if name == "restrict":
        q = [combine(1 - factor, x, factor, y) for x, y in zip(p, q)]
    return developable(u, p, q)


def routes(case):
    u, c = knots_of(case["knots"]), row(case["c"])
    f = case["functions"]
    lam, m, d0 = number(f["lambda"]), number(f["m"]), [number(x) for x in case["d0"]]
    d = linear_net(u, c, lam, m, d0)
    back = c if lam in u.u else linear_net(u, d, m, lam, c[0])  # the roles of c and d exchanged
    return d == eq14(u, c, lam, m, d0) == eq16(u, c, lam, m, d0) and back == c and developable(u, c, d)


def verdict_truth(case):
    return developable(knots_of(case["knots"]), row(case["c"]), row(case["d"])) == bool(case["developable"])


def verdict_mapped(case):
    net, m = case["net"], row(case["map"]["rows"])
    u = knots_of(net["knots"])

    def moved(points):
        rows = [x if len(x) == 4 else [Fraction(1)] + x for x in row(points)]
        return [[sum(a * b for a, b in zip(line, x)) for line in m] for x in rows]

    return developable(u, moved(net["c"]), moved(net["d"])) == bool(net["developable"])


PROPERTIES = {
    "text.number": text_number,
    "text.spelling": text_spelling,
    "double.net": double_net,
    "double.rows": double_rows,
    "routes": routes,
    "verdict.truth": verdict_truth,
    "verdict.rational_truth": verdict_truth,
    "verdict.affine": verdict_mapped,
    "verdict.projective": verdict_mapped,
}


def main():
    cases = {}
    for line in open(sys.argv[1], encoding="utf-8"):
        case = json.loads(line)
        cases.setdefault(case["property"], []).append(case["input"])
    for name, inputs in cases.items():
        check = PROPERTIES.get(name)
        if check is None:
            continue
        start = time.process_time()
        failed = sum(not check(case) for case in inputs)
        print(name, len(inputs), time.process_time() - start, failed)


if __name__ == "__main__":
    main()
