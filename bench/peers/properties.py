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
    return sign * number(text) == number(case["value"][0])


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


def mapping_monotony(case):
    u, beta = knots_of(case["knots"]), [[number(x)] for x in case["beta"]]
    for k in u.pieces():
        negative_somewhere(slope(polynomials(u, beta, k)[0]), u.begin(k), u.end(k))
    return True


def cross(x, y):
    return [sum_of(product(x[(i + 1) % 3], y[(i + 2) % 3]), product(x[(i + 2) % 3], y[(i + 1) % 3]), -1) for i in range(3)]


def wedge(x, y):
    return [sum_of(product(x[0], y[i]), product(y[0], x[i]), -1) for i in (1, 2, 3)]


def strip_folds(case):
    net = case["net"]
    u, c, d = knots_of(net["knots"]), row(net["c"]), row(net["d"])
    for k in u.pieces():
        p, q = polynomials(u, c, k), polynomials(u, d, k)
        ruling = wedge(p, q)
        m, n = cross(wedge(p, [slope(f) for f in p]), ruling), cross(wedge(q, [slope(f) for f in q]), ruling)
        total = []
        for f, g in zip(m, n):
            total = sum_of(total, product(f, g))
        if negative_somewhere(total, u.begin(k), u.end(k)):
            return True
    return True


def rail_jets(case):
    breaks, share = [number(x) for x in case["breaks"]], number(case["share"])
    for begin, end, points, weights in zip(breaks, breaks[1:], case["points"], case["weights"]):
        w = [number(x) for x in weights]
        for column in zip(*row(points)):
            # x w = r, differentiated three times
            r, jet = product(w, list(column)), []
            ws = [w, slope(w) or [Fraction(0)], slope(slope(w)) or [Fraction(0)], slope(slope(slope(w))) or [Fraction(0)]]
            for order in range(4):
                total = value(r, share)
                choose = 1
                for i in range(order):
                    total -= choose * value(ws[order - i], share) * jet[i]
                    choose = choose * (order - i) // (i + 1)
                jet.append(total / value(w, share))
                r = slope(r) or [Fraction(0)]
            f = list(column)
            for order, x in enumerate(jet):
                if x / (end - begin) ** order != value(f, share) / (end - begin) ** order:
                    return False
                f = slope(f) or [Fraction(0)]
    return True


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


def curves(case):
    """The insertion of both parameters and a part between them; blossoms, elevation and the rest are not here."""
    u, points = knots_of(case["knots"]), row(case["rows"])
    fine, rows = u, points
    for text in (case["from"], case["to"]):
        t = number(text)
        while fine.u.count(t) < u.n:
            fine, rows = inserted(fine, rows, t)
    return same_curve(u, points, fine, rows)


def joined_rails(case):
    """The determinant over both rails' pieces, at more parameters than its degree."""
    curves_ = [(knots_of(case[r]["knots"]), row(case[r]["rows"])) for r in "cd"]
    (u, c), (v, d) = curves_
    begin, end = u.begin(1), u.end(len(u.u) - 2 * u.n + 1)
    first, last = v.begin(1), v.end(len(v.u) - 2 * v.n + 1)
    factor = (end - begin) / (last - first)
    v = Knots(v.n, [begin + factor * (t - first) for t in v.u])
    breaks = sorted({w.begin(k) for w in (u, v) for k in w.pieces()} | {end})
    vanishes = True
    for a, b in zip(breaks, breaks[1:]):
        count = 2 * (u.n + v.n) + 1
        j = next(k for k in u.pieces() if a < u.end(k))
        k = next(k for k in v.pieces() if a < v.end(k))
        for i in range(count):
            t = a + (b - a) * Fraction(i, count - 1)
            p, dp = u.at(c, j, t)
            q, dq = v.at(d, k, t)
            if determinant([dp, minus(q, p), dq] if len(p) == 3 else [p, dp, q, dq]) != 0:
                vanishes = False
                break
    return not case["net"] or vanishes == bool(case["net"][0]["developable"])


def recovered_functions(case):
    """Lambda, M, sigma at the parameters, by Cramer's rule from p + x p' = y q + z q'; where they are constants, those."""
    net = case["net"]
    u, c, d = knots_of(net["knots"]), row(net["c"]), row(net["d"])
    known = net["functions"]
    for k in u.pieces():
        for share in case["shares"]:
            t = u.begin(k) + (u.end(k) - u.begin(k)) * number(share)
            p, dp = u.at(c, k, t)
            q, dq = u.at(d, k, t)
            for drop in range(4):
                keep = [i for i in range(4) if i != drop]
                columns = [[-dp[i] for i in keep], [q[i] for i in keep], [dq[i] for i in keep]]
                bottom = determinant(columns)
                if bottom == 0:
                    continue
                right = [p[i] for i in keep]
                x = determinant([right, columns[1], columns[2]]) / bottom
                sigma = determinant([columns[0], right, columns[2]]) / bottom
                z = determinant([columns[0], columns[1], right]) / bottom
                if known and sigma != 0:
                    f = {name: number(known[0][name]) for name in ("lambda", "m", "sigma")}
                    found = (u.n * x + t, u.n * z / sigma + t, sigma)
                    if found != (f["lambda"], f["m"], f["sigma"]):
                        return False
                break
    return True


def composed(f, g):
    total = []
    for a in reversed(f):
        total = sum_of(product(total, g), [a]) if total else [a]
    return total


def mapped_rails(case):
    """The polynomials of both rows over the mapping; snapping it to the knots is not here."""
    c, d = ((knots_of(case[r]["knots"]), row(case[r]["rows"])) for r in "cd")
    u, beta = knots_of(case["knots"]), [[number(x)] for x in case["beta"]]
    for k in u.pieces():
        sigma = polynomials(u, beta, k)[0]
        middle = (u.begin(k) + u.end(k)) / 2
        for (v, rows), t in ((c, middle), (d, value(sigma, middle))):
            piece = next(j for j in v.pieces() if t < v.end(j) or j == v.pieces()[-1])
            for f in polynomials(v, rows, piece):
                if v is d[0] and value(composed(f, sigma), middle) != value(f, value(sigma, middle)):
                    return False
    return True


def text_file(case):
    """The numbers of a file; its members are not checked."""
    text = bytes.fromhex(case["text"]).decode("utf-8-sig", "surrogateescape")
    file = json.loads(text, parse_float=str, parse_int=str)
    meant = case["meant"]

    def fraction(x):
        sign, x = (-1, x[1:]) if x.startswith("-") else (1, x.lstrip("+"))
        return sign * number(x)

    for rail in "cd":
        if isinstance(file.get(rail), dict):
            points = [[fraction(x) for x in point] for point in file[rail].get("points", [])]
            if points != row(meant[rail]["points"]):
                return False
    return True


PROPERTIES = {
    "verdict.balls": verdict_truth,
    "mapping.monotony": mapping_monotony,
    "strip.folds": strip_folds,
    "rails.jets": rail_jets,
    "rails": joined_rails,
    "rails.mapped": mapped_rails,
    "recover.functions": recovered_functions,
    "curves": curves,
    "text.file": text_file,
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
