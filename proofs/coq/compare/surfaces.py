"""Problems on splines over more knots and of a higher degree, on the conditions of BZZ19 and on its surface.

  functions, total    as in problems.py
"""
from fractions import Fraction

from inputs import general, net, of_knots, of_nets, of_numbers, spline


def cell(draw):
    members = spline(draw)
    return members | {"i": draw.random.randrange(max(1, draw.last)), "t": draw.parameter()}


def point(draw):
    return spline(draw) | {"k": draw.piece(), "t": draw.parameter()}


def bezier_piece(draw):
    """A knot list, and the Bezier points of a piece."""
    draw.degree()
    n, u, last, k = draw.n, draw.knots(), draw.last, draw.piece()
    return {"n": draw.n, "u": u, "c": [draw.point() for _ in range(n + 1)], "k": k, "i": draw.random.randint(k - 1, min(k + n - 1, last))}


def more(draw):
    """Knots that hold those of u from the start to the end of its domain, sometimes one too often; others before and after it."""
    members = spline(draw)
    n, u = draw.n, members["u"]
    inside = u[n - 1:draw.last + 1]
    if n == 0 or draw.kind == "bad knots" or len(inside) < 2:
        return members | {"v": u}
    low, high = inside[0], inside[-1]
    for _ in range(draw.random.randint(0, 4)):
        inside.append(draw.random.choice((draw.random.choice(inside), low + Fraction(draw.random.randint(0, 12), 12) * (high - low))))
    before, after = (u[:n - 1], u[draw.last + 1:]) if draw.random.random() < 0.4 else (
        sorted(low - abs(draw.number()) for _ in range(n - 1)), sorted(high + abs(draw.number()) for _ in range(n - 1)))
    return members | {"v": before + sorted(inside) + after}


def raised(draw):
    draw.highest = 8
    return spline(draw)


def two_lists(draw):
    """Two knot lists of one degree, whose domains may have nothing in common."""
    members = spline(draw)
    v = draw.knots() if draw.random.random() < 0.5 else sorted(draw.random.choice(members["u"]) + draw.random.choice((0, 1)) for _ in members["u"])
    return {"n": members["n"], "u": members["u"], "v": v if draw.kind != "bad knots" else members["u"]}


def mapping(draw, times, values):
    """A mapping of degree 1 or 2 with these values at these times, simple or double knots."""
    if draw.random.random() < 0.5:
        return {"d": 1, "w": times, "b": values}
    b = values[:1]
    for low, high in zip(values, values[1:]):
        b += [low + Fraction(draw.random.randint(0, 4), 4) * (high - low), high]
    return {"d": 2, "w": [t for t in times for _ in range(2)], "b": b}


def surface(draw):
    """Two curves and a mapping that passes the knots of the second one at knots of its own, mostly: or it misses one, goes back or outside, or begins too
    soon."""
    draw.usual = 3
    first = spline(draw)
    low, high = (draw.u[draw.n - 1], draw.u[min(draw.last, len(draw.u) - 1)]) if draw.n else (Fraction(0), Fraction(1))
    second = spline(draw)
    inside = sorted(set(second["u"][max(0, draw.n - 1):draw.last + 1])) or [Fraction(0)]
    values = sorted(inside + [inside[0] + Fraction(draw.random.randint(0, 6), 6) * (inside[-1] - inside[0]) for _ in range(draw.random.randint(1, 3))])
    way = draw.random.random()
    if way < 0.1 and len(values) > 2:
        del values[draw.random.randrange(1, len(values) - 1)]
    elif way < 0.16:
        values[draw.random.randrange(len(values))] += draw.random.choice((-1, 1)) * draw.positive()
    elif way < 0.2:
        values[0], values[-1] = values[-1], values[0]
    if way > 0.8:
        values = values[:draw.random.randint(2, len(values))]
    steps = [Fraction(0)]
    for _ in values[1:]:
        steps.append(steps[-1] + draw.positive())
    if 0.2 < way < 0.25:
        low -= draw.positive()
    times = [low + s / steps[-1] * (high - low) for s in steps]
    return first | {"p": second["n"], "v": second["u"], "e": second["c"]} | mapping(draw, times, values) | {"s": draw.random.randint(0, 1)}


def tangents(draw):
    """A vector, a ruling and the tangents at its ends, sometimes with all in one plane, and the vector normal to it."""
    v, w, a, b = (draw.point() for _ in range(4))
    if draw.random.random() < 0.3:
        x = draw.number()
        b = [x * s + t for s, t in zip(w, a)]
    return {"v": v, "d": w, "a": a, "b": b}


plain = [kind for kind in general if kind not in ("high degree", "many pieces")]
functions = {
    "cell_point": (general, cell),
    "eq16_rulings": (of_nets, net),
    "derivative_sum": (general, point),
    "spline_vertex": (of_knots, bezier_piece),
    "refined": (general, more),
    "elevate": (general, raised),
    "breakpoints": (of_knots, two_lists),
    "quasi_surface": (plain, surface),
    "ruling_determinant": (of_numbers, tangents),
    "normal_products": (of_numbers, tangents),
    "normal_residual": (of_numbers, tangents),
    "unit_penalty": (of_numbers, tangents),
}
total = {"ruling_determinant", "normal_products", "normal_residual", "unit_penalty"}
