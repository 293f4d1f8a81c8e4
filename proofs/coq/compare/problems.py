"""The problems on which the extracted programs and the C++ library have to agree, random and degenerate.

  functions    how a line `NAME KEY=VALUE ...` for each function is drawn, and for which classes of inputs: those of directrices.py and surfaces.py too
  total, all_errors, with_errors    where answers are errors
  problems     (function, class, line) for all of them
"""
from fractions import Fraction

import directrices
import doubles
import surfaces
from draw import Draw, line
from inputs import bezier, general, net, of_knots, of_nets, of_numbers, of_rows, spline


def blossom(draw):
    members = spline(draw)
    v = [draw.random.choice(((draw.parameter(), 1), (1, 0), (draw.number(), draw.number()))) for _ in range(draw.n)]
    return members | {"k": draw.piece(), "v": v}


def vertex(draw, first):
    members = net(draw)
    last = draw.last if first or draw.random.random() < 0.9 else draw.last + 1
    return members | {"i": draw.random.randint(first, max(first, last))}


def point(draw):
    return spline(draw) | {"k": draw.piece(), "t": draw.parameter()}


def local(draw):
    """A function of one piece, k >= 1, or of a piece and the one before, with any coordinates."""
    members = spline(draw)
    del members["c"]
    k = draw.piece()
    return members | {"k": k, "t": draw.parameter()}


def following(draw):
    """A piece that has one before it; some mu are 0."""
    draw.fewest = 2
    members = local(draw)
    return members | {"k": draw.random.randint(2, max(2, draw.pieces)), "l": draw.number(), "m": draw.random.choice((0, 1, draw.number(), draw.number()))}


def affine(draw):
    return {"L": draw.number(), "M": 0 if draw.random.random() < 0.1 else draw.number()}


def aumann(draw):
    return bezier(draw) | {"d": draw.point()} | affine(draw)


def first_cell(draw):
    members = net(draw)
    return {key: members[key] for key in "nuLM"}


def cells(draw):
    """A row from its first cell: that of some L*, M*, where M* may be a knot; or any."""
    members = net(draw)
    n, u, lam, m = (members.pop(key) for key in "nuLM")
    cell = {"l": draw.number(), "m": draw.random.choice((1, draw.number()))}
    if n > 0 and draw.random.random() < 0.7:
        m = draw.random.choice(u) if draw.random.random() < 0.3 else m
        if m != u[0]:
            cell = {"l": (lam - u[0]) / (m - u[0]), "m": (m - u[n % len(u)]) / (m - u[0])}
    return members | {"n": n, "u": u, "i": draw.random.randint(2, max(2, draw.last))} | cell


def one_cell(draw):
    members = cells(draw)
    if draw.last < 2:
        members["n"], members["u"], members["i"] = 2, [0, 1, 2, 3], 2
    return {key: members[key] for key in "nuilm"}


def pair(draw):
    """Two rows; often those of a developable surface."""
    draw.usual, draw.highest = 3 if draw.huge else 5, 11
    members = net(draw)
    n, u, c, lam, m, d = (members[key] for key in "nucLMd")
    rows = [d]
    if draw.random.random() < 0.7 and m not in u and n > 0 and len(c) == len(u) - n + 1 > 0:
        for i in range(len(c) - 1):
            rows.append([((u[i + n] - lam) * a + (lam - u[i]) * b - (u[i + n] - m) * e) / (m - u[i]) for a, b, e in zip(c[i], c[i + 1], rows[i])])
        if draw.random.random() < 0.3:
            rows[draw.random.randrange(len(rows))][draw.random.randrange(3)] += 1
    else:
        rows = draw.row()
    return {"n": n, "u": u, "c": c, "d": rows, "k": draw.piece(), "t": draw.number()}


def end_rulings(draw):
    """A curve, mostly clamped, and its end rulings, sometimes parallel, and a point; M* is a knot where the class says so."""
    members = net(draw)
    n, u = draw.n, members["u"]
    if n > 0 and draw.kind != "bad knots" and draw.random.random() < 0.8:
        u[:n], u[-n:] = [u[n - 1]] * n, [u[-n]] * n
        members["M"] = draw.random.choice(u) if draw.kind == "M* at a knot" else members["M"]
    v, factor = draw.point(), draw.number()
    w = [factor * a for a in v] if draw.random.random() < 0.15 else draw.point()
    return members | {"v": v, "w": w, "i": draw.random.randint(1, max(1, draw.last))}


def chord(draw):
    members = end_rulings(draw)
    return {key: members[key] for key in "dvw"}


def rows(draw):
    """A net; M* is sometimes a knot, where a piece may begin."""
    members = net(draw)
    if draw.random.random() < 0.15:
        members["M"] = draw.random.choice(draw.u)
    return members


def restriction(draw):
    members = bezier(draw)
    c = members["c"]
    return {"c": c, "d": [draw.point() for _ in c], "x": draw.number()}


def at_parameter(draw):
    """Three functions at a parameter, and two factors of degree one; many are equal or zero."""
    draw.degree()
    t = draw.number()
    near = (0, 1, t, draw.number(), draw.number(), draw.number())
    x = [draw.random.choice(near) for _ in range(3)]
    if draw.random.random() < 0.1:
        x[2] = x[0]
    f, g = ([draw.random.choice((0, 1, -t, draw.number(), draw.number())) for _ in range(2)] for _ in range(2))
    return {"n": draw.n, "t": t, "x": x, "f": f, "g": g}


def scaling(draw):
    members = at_parameter(draw)
    return {"x": members["x"], "a": draw.random.choice((0, draw.number(), draw.number())), "b": draw.random.choice((0, draw.number(), draw.number()))}


def dependence(draw):
    """The coefficients of a dependence; sums are often 0."""
    l, m = draw.number(), draw.number()
    return {"x": [l, draw.random.choice((-l, draw.number(), draw.number())), m, draw.random.choice((-m, draw.number(), draw.number()))]}


def moebius(draw):
    """A transformation, three functions, a parameter and rows; sometimes one of the numbers is sent to infinity."""
    b = draw.random.choice((1, draw.number(), draw.number(), draw.number()))
    pole = Fraction(1) / (1 - b) if b != 1 else Fraction(0)
    x = [draw.random.choice((pole, draw.number(), draw.number(), draw.number())) for _ in range(3)]
    t = draw.random.choice((-b * pole, draw.number(), draw.number(), draw.number()))
    return bezier(draw) | {"a": b, "x": x, "t": t}


def patch(draw):
    """The rows of a patch, three constants, two of which are sometimes equal, a factor, and a number."""
    members = restriction(draw)
    lam, m = draw.number(), draw.number()
    return members | {"x": [lam, lam if draw.random.random() < 0.1 else m, draw.random.choice((1, 0, draw.number()))], "f": [draw.number(), draw.number()]}


def rational_pair(draw):
    """Two homogeneous rows; often those of a developable surface."""
    draw.usual, draw.highest = 3 if draw.huge else 5, 8
    draw.degree()
    n, u = draw.n, draw.knots()
    lam, m = draw.starred()
    c = draw.row(4)
    d = [draw.point(4)]
    if draw.random.random() < 0.7 and m not in u and n > 0 and len(c) == len(u) - n + 1 > 0:
        sigma = draw.positive()
        for i in range(len(c) - 1):
            d.append([(((u[i + n] - lam) * a + (lam - u[i]) * b) / sigma - (u[i + n] - m) * e) / (m - u[i]) for a, b, e in zip(c[i], c[i + 1], d[i])])
        if draw.random.random() < 0.3:
            d[draw.random.randrange(len(d))][draw.random.randrange(4)] += 1
    else:
        d = draw.row(4)
    return {"n": n, "u": u, "c": c, "d": d, "k": draw.piece(), "t": draw.number()}


def rational_net(draw):
    draw.degree()
    u = draw.knots()
    lam, m = draw.starred()
    c = draw.row(4)
    return {"n": draw.n, "u": u, "c": c, "L": lam, "M": m, "s": 0 if draw.random.random() < 0.05 else draw.number(), "d": draw.point(4)}


def directrix(draw):
    """A Bezier curve, a factor, another that is sometimes 0, and a first point."""
    return bezier(draw) | {"x": draw.random.choice((1, draw.number())), "s": 0 if draw.random.random() < 0.1 else draw.number(), "d": draw.point()}


def interval_of(draw):
    """A piece and any interval."""
    return spline(draw) | {"k": draw.piece(), "a": draw.parameter(), "b": draw.parameter()}


def insertion(draw):
    """A knot in the domain, mostly, sometimes one that is there already."""
    members = spline(draw)
    low, high = draw.u[draw.n - 1], draw.u[max(0, min(draw.last, len(draw.u) - 1))]
    inside = low + Fraction(draw.random.randint(0, 12), 12) * (high - low)
    return members | {"t": draw.parameter() if draw.random.random() < 0.4 else inside}


def mapping(draw):
    """A function in the place of a curve, often at the end of its domain, where the last pieces may be empty."""
    members = insertion(draw)
    if draw.random.random() < 0.3:
        members["t"] = draw.u[max(0, min(draw.last, len(draw.u) - 1))]
    return members | {"c": draw.row(1)}


def cylinder(draw):
    """A row, a direction and its lengths, sometimes too many."""
    c = bezier(draw)["c"]
    return {"c": c, "v": draw.point(), "h": [draw.number() for _ in range(len(c) + (draw.random.random() < 0.1))]}


def cone(draw):
    return {"v": draw.point(), "d": draw.point(), "x": 1 if draw.random.random() < 0.1 else draw.number()}


def tangent(draw):
    """A curve, a parameter and a homogeneous one, sometimes the infinite one."""
    members = point(draw)
    a, w = draw.random.choice(((draw.parameter(), 1), (1, 0), (draw.number(), draw.number())))
    return members | {"a": a, "w": w}


def recovery(draw):
    """Two homogeneous rows, sometimes with a coordinate 0, and one of their cells: any, or with Lambda or M at infinity, or vertices on a line."""
    members = rational_pair(draw)
    c, d, i = members["c"], members["d"], draw.random.randrange(max(1, draw.last))
    if len(c) == len(d) > i + 1 and (way := draw.random.choice((0, 0, 0, 1, 2, 3))):
        x, y = draw.number(), draw.number()
        of_q, of_p, of_side = ((x, -y, y), (1, x, y), (x, y, 0))[way - 1]
        d[i + 1] = [of_q * q + of_p * p + of_side * s for q, p, s in zip(d[i], c[i], c[i + 1])]
    if draw.random.random() < 0.3:
        plane = draw.random.randrange(4)
        for row in c + d:
            row[plane] = 0
    return {key: members[key] for key in "nucd"} | {"i": i}


def composition(draw):
    """A Bezier curve, mostly of a low degree, and a polynomial, sometimes one of the two without points."""
    draw.usual, draw.highest = 3 if draw.huge else 4, 7
    members = bezier(draw)
    e = [draw.random.choice((0, 1, draw.number(), draw.number())) for _ in range(draw.random.randint(1, 4))]
    empty = draw.random.random()
    return {"c": [] if empty < 0.03 else members["c"], "e": [] if 0.02 < empty < 0.05 else e}


def polynomial(draw):
    """A polynomial, often of a lower degree than its list says, an interval, sometimes empty, and a degree, sometimes too low."""
    n = draw.degree()
    f = [draw.random.choice((0, draw.number())) for _ in range(draw.random.choice((n + 2, *range(n + 2), n + 1)))]
    a = draw.number()
    return {"f": f, "n": n, "a": a, "b": a if draw.random.random() < 0.1 else draw.number()}


def piece_of_function(draw):
    """A function over knots, and a piece."""
    members = spline(draw)
    del members["c"]
    return members | {"f": [x for x, in draw.row(1)], "k": draw.piece()}


def products(draw):
    members = first_cell(draw)
    a = draw.random.randint(0, max(0, draw.last))
    return members | {"a": a, "b": draw.random.randint(a, max(a, draw.last))}


def elevation(draw):
    return bezier(draw) | {"i": draw.random.randint(0, 4)}


def steps(draw):
    return {"e": [draw.random.choice((0, draw.number())) for _ in range(draw.degree() + 1)]}


functions = {
    "knots": (of_knots, spline),
    "blossom": (general, blossom),
    "point": (general, point),
    "derivative": (general, point),
    "net": (of_nets, net),
    "net_from": (of_nets, lambda draw: vertex(draw, 0)),
    "printed_net": (of_nets, lambda draw: vertex(draw, 0)),
    "products": (of_knots + ["M* at a knot"], products),
    "eq14": (of_nets, lambda draw: vertex(draw, 1)),
    "eq15": (of_nets, lambda draw: vertex(draw, 1)),
    "eq16": (of_nets, lambda draw: vertex(draw, 1)),
    "local_parameter": (of_knots, local),
    "next_local": (of_knots, following),
    "affine_from_local": (of_numbers, affine),
    "next_affine": (of_knots, following),
    "aumann_net": (of_rows, aumann),
    "first_cell": (of_knots + ["M* at a knot", "L* = M*"], first_cell),
    "next_cell": (of_knots, one_cell),
    "cell_net": (general, cells),
    "restrict_rulings": (of_rows, restriction),
    "determinant": (general + ["L* at a knot", "L* = M*"], pair),
    "find_witness": (general + ["L* at a knot", "L* = M*"], pair),
    "to_blossom": (of_numbers, at_parameter),
    "to_frame": (of_numbers, at_parameter),
    "standard_parameter": (of_numbers, scaling),
    "gauged": (of_numbers, scaling),
    "scaled_weights": (of_numbers, scaling),
    "edge": (of_numbers, at_parameter),
    "unelevated": (of_numbers, at_parameter),
    "elevated_functions": (of_numbers, at_parameter),
    "rational_net": (of_nets, rational_net),
    "from_dependence": (of_numbers, dependence),
    "moebius_parameter": (of_numbers, moebius),
    "moebius_rows": (of_rows, moebius),
    "moebius_functions": (of_numbers, moebius),
    "unshortened": (of_numbers, at_parameter),
    "shortened_functions": (of_numbers, at_parameter),
    "times_linear": (of_rows, patch),
    "edge_curve": (of_rows, patch),
    "edge_patch": (of_rows, directrix),
    "determinant4": (general + ["L* at a knot", "L* = M*"], rational_pair),
    "find_witness4": (general + ["L* at a knot", "L* = M*"], rational_pair),
    "eq20": (of_nets, end_rulings),
    "branch_polynomial": (general, end_rulings),
    "chord_coordinates": (of_numbers, chord),
    "end_rulings": (of_nets, end_rulings),
    "interpolating_net": (of_nets, end_rulings),
    "piecewise_net": (general + ["L* at a knot", "L* = M*"], rows),
    "restricted_points": (general, interval_of),
    "bezier_points": (general, lambda draw: spline(draw) | {"k": draw.piece()}),
    "insert_knot": (general, insertion),
    "mapping_value": (general, mapping),
    "mapping_slope": (general, mapping),
    "identity_mapping": (of_knots, spline),
    "pointwise_sine_squared": (general, pair),
    "coefficients_from_steps": (of_numbers, steps),
    "elevated_points": (of_rows, elevation),
    "cylinder_net": (of_rows, cylinder),
    "cone_vertex": (of_numbers, cone),
    "restricted_lambda": (of_numbers, lambda draw: affine(draw) | {"x": draw.number()}),
    "tangent_point": (general, tangent),
    "last_pair": (general, point),
    "cell_functions": (general + ["L* at a knot", "L* = M*"], recovery),
    "composed_points": (of_rows, composition),
    "bezier_rows": (of_numbers + ["high degree"], polynomial),
    "piece_polynomials": (general, piece_of_function),
    "cone_net": (of_rows, directrix),
    "start_cone_net": (of_rows, directrix),
    "mean_tangent_net": (of_rows, directrix),
    "tangent_net": (of_rows, directrix),
    "mean_chord_net": (of_rows, directrix),
    "affine_net": (of_rows, directrix),
} | directrices.functions | surfaces.functions | doubles.functions
total = {"restrict_rulings", "coefficients_from_steps", "elevated_points", "cone_net", "mean_tangent_net", "tangent_net", "mean_chord_net", "affine_net",
         "moebius_rows", "times_linear", "edge_patch", "restricted_lambda"} | directrices.total | surfaces.total | doubles.all_known
# The classes and functions where every answer is an error, and where some are; in no class or function else are all.
all_errors = {"missing points", "M* at a knot"}
with_errors = {"bad knots"} | set(functions) - total


def problems(seed, count):
    """`count` problems of each class of each function."""
    for name, (kinds, drawn) in functions.items():
        for kind in kinds:
            for i in range(count):
                yield name, kind, line(name, **drawn(Draw(f"{seed} {name} {kind} {i}", kind)))
