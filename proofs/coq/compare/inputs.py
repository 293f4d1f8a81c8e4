"""What many functions take: splines, nets, Bezier polygons; and the classes of inputs.

  spline, net, bezier      their members
  of_knots, general, of_nets, of_numbers, of_rows   classes for functions of knots, of splines, of nets, of numbers, of Bezier polygons
"""


def spline(draw):
    draw.degree()
    u = draw.knots()
    return {"n": draw.n, "u": u, "c": draw.row()}


def net(draw, **more):
    members = spline(draw)
    lam, m = draw.starred()
    d = members["c"][0] if draw.kind == "zero edges" and draw.random.random() < 0.3 else draw.point()
    return members | {"L": lam, "M": m, "d": d} | more


def bezier(draw):
    draw.degree()
    draw.last = draw.n
    return {"c": draw.row()}


of_knots = ["random", "clamped knots", "repeated knots", "huge fractions", "bad knots", "high degree", "many pieces"]
general = of_knots + ["zero edges", "collinear points", "missing points"]
of_nets = general + ["M* at a knot", "L* at a knot", "L* = M*"]
of_numbers = ["random", "huge fractions"]
of_rows = ["random", "zero edges", "collinear points", "huge fractions", "high degree"]
