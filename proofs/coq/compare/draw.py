"""What inputs are drawn from: numbers, points, knots and rows of one class, the same for a seed on every machine; and how they are written.

  Draw          the numbers and splines of one class
  text, line    a value and a problem as they are written
"""
import random
from fractions import Fraction


class Draw:
    """Numbers, points and splines of one class, from one seed."""

    def __init__(self, seed, kind):
        self.random, self.kind = random.Random(seed), kind
        self.huge = kind == "huge fractions"
        self.fewest = 1  # number of pieces, where there are not many
        self.usual, self.highest = 5, 16  # the highest degree, and where it is high

    def number(self, most=9):
        if self.huge:
            return Fraction(self.random.randint(-10**40, 10**40), self.random.randint(1, 10**30))
        return Fraction(self.random.randint(-most, most), self.random.choice((1, 1, 1, 2, 3, 4, 7)))

    def positive(self):
        while (x := abs(self.number())) == 0:
            pass
        return x

    def point(self, dimension=3):
        return [self.number() for _ in range(dimension)]

    def degree(self):
        self.n = self.random.randint(*((6, self.highest) if self.kind == "high degree" else (1, 3) if self.kind == "many pieces" else (1, self.usual)))
        return self.n

    def knots(self):
        """Of degree n with N pieces; clamped, repeated or wrong as the class says."""
        n, pieces = self.n, self.random.randint(*((6, 16) if self.kind == "many pieces" else (self.fewest, 5)))
        count = 2 * n + pieces - 1
        u = [self.number()]
        while len(u) < count:
            u.append(u[-1] + self.positive())
        if self.kind == "clamped knots":
            u[:n], u[-n:] = [u[n - 1]] * n, [u[-n]] * n
        if self.kind in ("repeated knots", "bad knots") and count > 2 * n:
            first = self.random.randint(n, count - n - 1)
            more = self.random.randint(1, n if self.kind == "repeated knots" else n + 1)
            u[first:first + more] = [u[first]] * len(u[first:first + more])
        if self.kind == "bad knots":
            self.spoil(u)
        self.u, self.last = u, len(u) - n
        self.pieces = max(1, self.last - n + 1)
        return u

    def spoil(self, u):
        way = self.random.choice("descending short many degree empty none".split())
        at = self.random.randrange(len(u))
        if way == "descending":
            u[at] -= 100 * self.positive()
        elif way == "short":
            del u[2 * self.n - 1:]
        elif way == "many":
            u[at:at + self.n + 1] = [u[at]] * len(u[at:at + self.n + 1])
        elif way == "degree":
            self.n = 0
        elif way == "empty" and len(u) == 2 * self.n:
            u[self.n] = u[self.n - 1]

    def row(self, dimension=3):
        """L + 1 control points, degenerate as the class says."""
        count = max(1, self.last + 1)
        if self.kind == "missing points":
            count += self.random.choice((-1, 1))
        c = [self.point(dimension) for _ in range(count)]
        if self.kind == "zero edges":
            for i in range(1, count):
                if self.random.random() < 0.5:
                    c[i] = c[i - 1]
        if self.kind == "collinear points":
            foot, along = self.point(dimension), self.point(dimension)
            c = [[a + x * b for a, b in zip(foot, along)] for x in (self.number() for _ in range(count))]
        self.c = c
        return c

    def parameter(self):
        """A parameter, often a knot or on a piece."""
        way = self.random.random()
        if way < 0.2:
            return self.random.choice(self.u)
        if way < 0.6 and len(self.u) > 1:
            i = self.random.randrange(len(self.u) - 1)
            return self.u[i] + Fraction(self.random.randint(0, 4), 4) * (self.u[i + 1] - self.u[i])
        return self.number()

    def piece(self):
        return self.random.randint(1, self.pieces)

    def starred(self):
        """L*, M*."""
        m = self.number(30)
        if self.kind == "M* at a knot":
            m = self.random.choice(self.u)
        elif self.kind != "bad knots":
            while m in self.u:
                m = self.number(30)
        lam = m if self.kind == "L* = M*" else self.random.choice(self.u) if self.kind == "L* at a knot" else self.number(30)
        return lam, m


def text(value):
    if isinstance(value, (int, Fraction)):
        return str(value)
    return (";" if value and isinstance(value[0], (list, tuple)) else ",").join(text(x) for x in value)


def line(name, **members):
    return " ".join([name] + [f"{key}={text(value)}" for key, value in members.items()])
