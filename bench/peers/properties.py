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

sys.dont_write_bytecode = True  # nothing is written beside the sources
from splines import (
    Knots, combine, composed, cross, determinant, developable, inserted, knots_of, minus, negative_somewhere, number,
    polynomials, product, row, same_curve, slope, sum_of, twist, value, wedge,
)


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


def mapping_monotony(case):
    u, beta = knots_of(case["knots"]), [[number(x)] for x in case["beta"]]
    for k in u.pieces():
        negative_somewhere(slope(polynomials(u, beta, k)[0]), u.begin(k), u.end(k))
    return True


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
