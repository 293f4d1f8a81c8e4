"""FJ07.16 against FJ07.13 in SymPy, n = 3, every knot, L*, M* and control point a symbol, at every vertex.

python3 eq16_sympy.py L VARIANT: prints the seconds of processor time of one proof. VARIANT is
  together, cancel, simplify, ratsimp   the difference of the two sides as an expression, then this function
  field       sympy.polys.fields, the control points generators of the field too
  forms       sympy.polys.fields, a point as its coefficients: linear forms in the control points
"""

import sys
import time

import sympy
from sympy.polys.fields import field

DEGREE = 3


class Form:
    """A linear form in the control points with coefficients in a field."""

    def __init__(self, terms):
        self.terms = terms

    def __add__(self, other):
        terms = dict(self.terms)
        for key, value in other.terms.items():
            terms[key] = terms[key] + value if key in terms else value
        return Form(terms)

    def __sub__(self, other):
        return self + other * -1

    def __mul__(self, factor):
        return Form({key: value * factor for key, value in self.terms.items()})

    def __truediv__(self, divisor):
        return Form({key: value / divisor for key, value in self.terms.items()})

    def __eq__(self, zero):
        return not any(self.terms.values())


def recursion(u, c, d, lam, m):
    """d_0..d_L by FJ07.13."""
    row = [d]
    for i in range(len(c) - 1):
        high, low = u[i + DEGREE], u[i]
        row.append((c[i] * (high - lam) + c[i + 1] * (lam - low) - row[i] * (high - m)) / (m - low))
    return row


def closed_form(u, c, d, lam, m, vertex):
    """d_N - c_N by FJ07.16."""
    total, p = d - d, m**0
    for i in reversed(range(vertex)):
        total = total + (c[i + 1] - c[i]) * (p / (m - u[i]))
        p *= (m - u[i + DEGREE]) / (m - u[i])
    return (d - c[0]) * p + total * (lam - m)


def symbols(last, variant):
    """Knots, L*, M* and control points, and the function that brings a difference to zero."""
    parameters = [f"u{i}" for i in range(last + DEGREE)] + ["L", "M"]
    points = [f"c{i}" for i in range(last + 1)] + ["d"]
    if variant == "field":
        return field(parameters + points, sympy.ZZ)[1:], lambda value: value
    if variant == "forms":
        x = field(parameters, sympy.ZZ)[1:]
        return x + tuple(Form({i: x[0] ** 0}) for i in range(last + 2)), lambda value: value
    rule = getattr(sympy, variant)
    if variant == "together":
        return sympy.symbols(parameters + points), lambda value: sympy.expand(sympy.numer(rule(value)))
    return sympy.symbols(parameters + points), rule


def main(last, variant):
    x, rule = symbols(last, variant)
    start = time.process_time()
    knots = last + DEGREE
    u, lam, m, c, d = x[:knots], x[knots], x[knots + 1], x[knots + 2 : -1], x[-1]
    row = recursion(u, c, d, lam, m)
    for vertex in range(1, last + 1):
        assert rule(row[vertex] - c[vertex] - closed_form(u, c, d, lam, m, vertex)) == 0, vertex
    print(time.process_time() - start)


main(int(sys.argv[1]), sys.argv[2])
