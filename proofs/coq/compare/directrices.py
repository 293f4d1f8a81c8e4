"""Problems on the rulings of a directrix, ZW06: polynomials a, b, in Bernstein form, and Bezier curves c.

  functions, total    as in problems.py
"""
from fractions import Fraction
from math import comb

from inputs import bezier, of_numbers, of_rows


def bernstein(f, degree):
    """The Bernstein coefficients of a list of coefficients of powers; numbers or points."""
    return [sum((Fraction(comb(i, k), comb(degree, k)) * f[k] for k in range(min(len(f), i + 1))), Fraction(0)) for i in range(degree + 1)]


def product(f, g):
    return [sum((f[i] * g[k - i] for i in range(len(f)) if 0 <= k - i < len(g)), Fraction(0)) for k in range(len(f) + len(g) - 1)]


def slope(f):
    return [k * x for k, x in enumerate(f)][1:] or [Fraction(0)]


def pair(draw):
    """b, and a, which is often b', in its degree or in a higher one."""
    b = [draw.number() for _ in range(draw.random.randint(1, 4))]
    a = [draw.number() for _ in range(draw.random.randint(1, 3))]
    if draw.random.random() < 0.6:
        a = bernstein(slope(bernstein_to_powers(b)), max(0, len(b) - 2) + draw.random.randint(0, 2))
    return {"a": a, "b": b}


def bernstein_to_powers(b):
    n = len(b) - 1
    return [comb(n, k) * sum(((-1) ** (k - i) * comb(k, i) * b[i] for i in range(k + 1)), Fraction(0)) for k in range(n + 1)]


def solvable(draw, c):
    """A curve in the place of c with rulings, for any a and b: the integral of a tau + b tau'."""
    n = len(c) - 1
    a = [draw.number() for _ in range(draw.random.randint(1, 2))]
    b = [draw.number() for _ in range(draw.random.randint(1, 3))]
    coordinates = []
    for _ in range(3):
        tau = [draw.number() for _ in range(n - max(len(a) - 1, len(b) - 2))]
        first, second = product(a, tau), product(b, slope(tau))
        rate = [sum(f[k] for f in (first, second) if k < len(f)) for k in range(max(len(first), len(second)))]
        coordinates.append(bernstein([draw.number()] + [x / (k + 1) for k, x in enumerate(rate)], n))
    return {"c": [list(p) for p in zip(*coordinates)], "a": bernstein(a, len(a) - 1), "b": bernstein(b, len(b) - 1)}


def system(draw):
    """One of the paper's equations; one with a factor a + k b' that is 0, with solutions or without; one with more equations than unknowns, with a
    solution or without; or what is no equation."""
    draw.highest = 8
    c = bezier(draw)["c"]
    n, way = len(c) - 1, draw.random.random()
    if way < 0.05:
        return {"c": c[:1], "a": [draw.number()], "b": [draw.number()]}
    if way < 0.1:
        return {"c": c, "a": [0] * draw.random.randint(1, 2), "b": [0] * draw.random.randint(1, 3)}
    b = [draw.number(), draw.number()]
    if way < 0.25:
        return {"c": c, "a": [-draw.random.choice((n, n, draw.random.randint(0, n))) * (b[1] - b[0])], "b": b}
    if way < 0.5:
        return {"c": c, "a": [draw.number()], "b": b[:draw.random.randint(1, 2)]}
    if way < 0.8 and n >= 3:
        return solvable(draw, c)
    return {"c": c, "a": [draw.number() for _ in range(draw.random.randint(1, 3))], "b": [draw.number() for _ in range(draw.random.randint(1, 4))]}


def curve(draw):
    """A curve, its rulings, a and b."""
    c = bezier(draw)["c"]
    return {"c": c, "d": [draw.point() for _ in c]} | pair(draw)


def aumann(draw):
    return {"n": draw.degree(), "x": draw.random.choice((1, draw.number(), draw.number())), "s": draw.number()}


functions = {
    "is_cone_equation": (of_numbers, pair),
    "solve_directrix": (of_rows, system),
    "times_polynomial": (of_rows, curve),
    "directrix_edge": (of_rows, curve),
    "directrix_vertex": (of_rows, curve),
    "aumann_equation": (of_numbers, aumann),
}
total = {"is_cone_equation", "times_polynomial", "directrix_edge"}
