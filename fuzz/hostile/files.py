"""Hostile files, made without any randomness: each is within some limit of docs/formats.md, at it or beyond it.

files(folder, only)   writes those whose names match `only`; yields (name, path, commands), a command being its
words, FILE and OUT standing for names
"""

import itertools
import json
import os
import re
import sys

import cad_files

sys.set_int_max_str_digits(0)


def numbers(modulus, multiplier):
    """A stream of integers below the modulus that looks random and is the same everywhere."""
    state = 1
    while True:
        state = state * multiplier % modulus
        yield state


def points(count, coordinate):
    return [[coordinate(i, j) for j in range(3)] for i in range(count)]


def ruled(degree, knots, c, d, c_weights=None, d_weights=None):
    def row(pts, weights):
        return {"points": pts, **({"weights": weights} if weights else {})}
    return {"torse": 1, "type": "ruled", "degree": degree, **({"knots": knots} if knots else {}),
            "c": row(c, c_weights), "d": row(d, d_weights)}


def construct(method, degree, knots, c, **more):
    return {"torse": 1, "type": "construct", "method": method, "degree": degree,
            **({"knots": knots} if knots else {}), "c": {"points": c}, **more}


def uniform(degree, count):
    return list(range(count + degree - 1))


def helix(i, j):
    """Integers on a bent line in space: neighbouring points are never collinear."""
    return (i, i * i % 97, i * i * i % 89)[j]


def shifted(pts, step):
    return [[x + s for x, s in zip(p, step)] for p in pts]


def scaled(pts, factor):
    return [[x * factor for x in p] for p in pts]


def digits(length, seed):
    """A number of so many digits."""
    block = str(3 ** (2000 + 7 * seed))
    return "9" + (block * (length // len(block) + 1))[: length - 1]


def fraction(length, seed):
    return digits(length, seed) + "/" + digits(length, seed + 1)


SURFACE = (["check", "FILE"], ["check", "FILE", "--max-warp", "0.5"], ["recover", "FILE"], ["recover", "FILE", "--json", "OUT"],
           ["check", "FILE", "--repair", "OUT"], ["convert", "FILE", "-o", "OUT.obj"],
           ["convert", "FILE", "-o", "OUT.json"], ["convert", "FILE", "-o", "OUT.step"], ["convert", "FILE", "-o", "OUT.igs"],
           ["unroll", "FILE", "-o", "OUT.svg"])
READING = (["check", "FILE"],)
CAD = (["check", "FILE"], ["convert", "FILE", "-o", "OUT.json"])


def texts():
    """Files that are text first: what stands in them is never a surface."""
    mebibyte = 1 << 20
    yield "nested arrays, 60 MiB", lambda: "[" * (60 * mebibyte)
    yield "nested objects, 60 MiB", lambda: '{"a":' * (12 * mebibyte)
    yield "blanks, 63 MiB", lambda: " " * (63 * mebibyte) + "{}"
    yield "65 MiB", lambda: " " * (65 * mebibyte)
    yield "a string of 60 MiB", lambda: '"' + "a" * (60 * mebibyte) + '"'
    yield "escapes, 60 MiB", lambda: '["' + "\\u00e9" * (10 * mebibyte) + '"]'
    yield "a number of 60 MiB", lambda: "1" * (60 * mebibyte)
    yield "values, 63 MiB", lambda: "[" + "1," * (31 * mebibyte) + "1]"
    yield "empty arrays, 60 MiB", lambda: "[" + "[]," * (20 * mebibyte) + "1]"
    yield "empty strings, 2 million", lambda: "[" + '"",' * 2097000 + "1]"
    yield "keys, a million", lambda: "{" + ",".join('"%d":1' % i for i in range(1000000)) + "}"
    yield "a key of 60 MiB", lambda: '{"' + "k" * (60 * mebibyte) + '":1}'
    yield "lines, 60 MiB", lambda: "[" + "\n" * (60 * mebibyte) + "x]"


def stream_points(count, multiplier):
    stream = numbers(1000003, multiplier)
    return points(count, lambda i, j: next(stream))


def long_rail(count=100000):
    return points(count, helix)


def ratio(i, j):
    return "%d/%d" % (i + j, 2 * i + 2 * j + 1)


def tens(i, j):
    return "%de%d" % (helix(i, j), 4000 if (i + j) % 2 else -4000)


def doubled(count, degree=3):
    """A cone over a long rail."""
    return ruled(degree, uniform(degree, count), long_rail(count), scaled(long_rail(count), 2))


def opposite(c):
    """A cone over a rail of text coordinates with the origin as vertex."""
    return ruled(len(c) - 1, None, c, [["-" + x for x in p] for p in c])


def digit_rail(length, count=4, seed=0):
    return points(count, lambda i, j: digits(length, seed + 3 * i + j))


def fraction_rail(length, count=4, seed=0):
    return points(count, lambda i, j: fraction(length, seed + 7 * i + 2 * j))


def nearly_cone():
    near = scaled(long_rail(200), 2)
    near[100][0] = "200.%s1" % ("0" * 3000)
    return ruled(3, uniform(3, 200), long_rail(200), near)


def nearly_cone_of_fractions(length):
    """The surface whose warp angle no number of fixed length tells from 0."""
    surface = opposite(fraction_rail(length))
    point = surface["d"]["points"][1]
    point[0] = point[0][:-1] + ("2" if point[0][-1] == "1" else "1")
    return surface


def weighted(count, weight, degree=3):
    weights = [weight(i) for i in range(count)]
    return {**doubled(count, degree), "c": {"points": long_rail(count), "weights": weights},
            "d": {"points": scaled(long_rail(count), 2), "weights": weights}}


def fraction_knots(count):
    return ["%d/%d" % (i * (3 * i + 1) + 1, 3 * i + 1) for i in range(count)]


def surfaces():
    """Ruled surfaces."""
    most = 100000
    u = uniform(3, most)
    yield "cylinder, 100000 points", lambda: ruled(3, u, long_rail(), shifted(long_rail(), (1, 2, 5)))
    yield "cone, 100000 points", lambda: doubled(most)
    yield "not developable, 100000 points", lambda: ruled(3, u, long_rail(), stream_points(most, 5))
    yield "cone of fractions, 100000 points", lambda: ruled(
        3, u, points(most, ratio), points(most, lambda i, j: "%d/%d" % (2 * (i + j), 2 * i + 2 * j + 1)))
    yield "fractions, 100000 points", lambda: ruled(3, u, points(most, ratio), points(most, lambda i, j: "1/%d" % (3 * i + j + 1)))
    yield "knots of fractions, 20000 points", lambda: ruled(3, fraction_knots(20002), long_rail(20000), scaled(long_rail(20000), 3))
    yield "exponents -4000, 100000 points", lambda: ruled(3, u, points(most, lambda i, j: "%de-4000" % helix(i, j)),
                                                          points(most, lambda i, j: "%de-4000" % (2 * helix(i, j))))
    yield "hexadecimal exponents, 100000 points", lambda: ruled(3, u, points(most, lambda i, j: "0x%xp-20000" % helix(i, j)),
                                                                points(most, lambda i, j: "0x%xp20000" % (2 * helix(i, j))))
    for count in (1000, 8000):
        yield "exponents of both signs, %d points" % count, lambda: ruled(
            3, uniform(3, count), points(count, tens), points(count, lambda i, j: tens(i + 1, 2 - j)))
    for length in (10000, 100000, 1000000):
        yield "%d digits, not developable" % length, lambda: ruled(3, None, digit_rail(length), digit_rail(length, seed=20))
        yield "%d digits, cone" % length, lambda: opposite(digit_rail(length))
    for length in (1000, 10000, 45000, 400000):
        yield "fractions of %d digits, cone" % length, lambda: opposite(fraction_rail(length))
        yield "fractions of %d digits, not developable" % length, lambda: ruled(3, None, fraction_rail(length),
                                                                                fraction_rail(length, seed=99))
    yield "degree 100, cone", lambda: ruled(100, None, long_rail(101), scaled(long_rail(101), 2))
    yield "degree 100, not developable", lambda: ruled(100, None, long_rail(101), stream_points(101, 7))
    yield "degree 100, weights", lambda: {**weighted(101, lambda i: i % 7 + 1, 100), "knots": [0] * 100 + [1] * 100}
    yield "degree 100, cone of fractions of 1000 digits", lambda: opposite(fraction_rail(1000, 101))
    yield "degree 100, fractions of 1000 digits", lambda: ruled(100, None, fraction_rail(1000, 101), fraction_rail(1000, 101, 2000))
    yield "degree 100, 100000 points", lambda: doubled(most, 100)
    yield "degree 100, 100000 points, not developable", lambda: ruled(100, uniform(100, most), long_rail(), stream_points(most, 5))
    yield "degree 30, 20000 points", lambda: doubled(20000, 30)
    yield "nearly a cone, 1e-3001", nearly_cone
    for length in (1000, 10000, 35000):
        yield "nearly a cone of fractions of %d digits" % length, lambda: nearly_cone_of_fractions(length)
    for degree in (30, 50):
        yield "degree %d, cone" % degree, lambda: ruled(degree, None, long_rail(degree + 1), scaled(long_rail(degree + 1), 2))
    for length in (100, 300):
        yield "degree 100, cone of fractions of %d digits" % length, lambda: opposite(fraction_rail(length, 101))
    yield "degree 30, cone of fractions of 1000 digits", lambda: opposite(fraction_rail(1000, 31))
    yield "degree 100, 120 points of 30 digits", lambda: {**opposite(fraction_rail(30, 120)), "degree": 100, "knots": uniform(100, 120)}
    yield "degree 30, 300 points", lambda: doubled(300, 30)
    yield "32000 points", lambda: doubled(32000)
    yield "knots from 1e-4000 to 1e4000", lambda: ruled(1, ["1e%d" % (4 * i - 4000) for i in range(2000)], long_rail(2000),
                                                        scaled(long_rail(2000), 2))
    yield "one point, 100000 times", lambda: ruled(3, u, points(most, lambda i, j: 1), points(most, lambda i, j: 1))
    yield "a line, 100000 points", lambda: ruled(3, u, points(most, lambda i, j: i), points(most, lambda i, j: 2 * i))
    yield "weights of both signs, 1000 points", lambda: weighted(1000, lambda i: 1 if i % 2 else -1)


def clamped(degree, count):
    return [0] * degree + list(range(1, count - degree)) + [count - degree] * degree


def constructions():
    """Inputs of torse construct, with the method."""
    most = 100000
    linear = {"Lambda": "-1/3", "M": "-2/7", "d0": [1, 2, 5]}
    for count in (300, 3000, 100000):
        yield "bspline", "bspline, %d points" % count, lambda: construct("bspline", 3, uniform(3, count), long_rail(count), **linear)
    yield "bspline", "bspline, knots of fractions", lambda: construct("bspline", 3, fraction_knots(1002), long_rail(1000), **linear)
    yield "bspline", "bspline, degree 100", lambda: construct("bspline", 100, uniform(100, 1000), long_rail(1000), **linear)
    yield "bezier", "bezier, degree 100", lambda: construct("bezier", 100, None, long_rail(101), **linear)
    for degree, length in ((100, 10000), (100, 100000), (3, 400000)):
        yield "bezier", "bezier, degree %d, fractions of %d digits" % (degree, length), lambda: construct(
            "bezier", degree, None, long_rail(degree + 1), Lambda=fraction(length, 1), M=fraction(length, 5), d0=[1, 2, 5])
    yield "rational", "rational, 3000 points", lambda: construct("rational", 3, uniform(3, 3000), long_rail(3000), sigma="5/3",
                                                                 omega0="7/11", **linear)
    yield "cylinder", "cylinder, 100000 points", lambda: construct("cylinder", 3, uniform(3, most), long_rail(), d0=[1, 2, 5])
    yield "cylinder", "cylinder with M, 100000 points", lambda: construct("cylinder", 3, uniform(3, most), long_rail(), M="-2/7",
                                                                          d0=[1, 2, 5])
    yield "cone", "cone, fractions of 100000 digits", lambda: construct("cone", 3, None, fraction_rail(100000), Lambda="5/7",
                                                                        d0=[1, 2, 5])
    yield "cone", "cone, 100000 points", lambda: construct("cone", 3, uniform(3, most), long_rail(), Lambda="5/7", d0=[1, 2, 5])
    yield "tangent", "tangent, 100000 points", lambda: construct("tangent", 3, uniform(3, most), long_rail())
    yield "tangent", "tangent, degree 100, 100000 points", lambda: construct("tangent", 100, uniform(100, most), long_rail())
    ends = {"va": [1, 2, 5], "vb": [3, -1, 2], "Lambda": "-1/3"}
    for degree, count in ((3, 50), (3, 101), (3, 201), (100, 201)):
        yield "interpolate", "interpolate, degree %d, %d points" % (degree, count), lambda: construct(
            "interpolate", degree, clamped(degree, count), long_rail(count), **ends)
    for count, length in ((12, 10000), (201, 1000)):
        yield "interpolate", "interpolate, %d points of %d digits" % (count, length), lambda: construct(
            "interpolate", 3, clamped(3, count), digit_rail(length, count), **ends)
    yield "directrix", "directrix, degree 100", lambda: construct(
        "directrix", 100, None, long_rail(101), a=[i * i % 1009 for i in range(101)], b=[i ** 3 % 1013 for i in range(101)])
    yield "directrix", "directrix, degree 100, 1000 digits", lambda: construct(
        "directrix", 100, None, digit_rail(1000, 101), a=[digits(1000, i) for i in range(101)], b=[digits(1000, 200 + i) for i in range(101)])
    yield "directrix", "directrix, degree 100, family", lambda: construct("directrix", 100, None, long_rail(101), a=[2], b=[0, 1],
                                                                          v=[0, 0, 1])


def in_child(task):
    """Runs the task in a process of its own: the memory of this one stays small, since the commands inherit its peak."""
    pid = os.fork()
    if pid == 0:
        task()
        os._exit(0)
    if os.waitpid(pid, 0)[1] != 0:
        raise RuntimeError("a hostile file cannot be written")


def files(folder, only=""):
    """The files are made one after the other: each is removed when the next one is asked for."""
    path = os.path.join(folder, "hostile.json")

    def written(text):
        with open(path, "w", encoding="ascii") as file:
            file.write(text())

    for name, text, commands in catalogue():
        if re.search(only, name):
            in_child(lambda: written(text))
            yield name, path, commands
            os.remove(path)


def catalogue():
    """(name, function that makes the text, commands)"""
    for name, text in texts():
        yield name, text, READING
    for name, value in surfaces():
        yield name, lambda: json.dumps(value()), SURFACE
    for name, text in itertools.chain(cad_files.steps(), cad_files.igs()):
        yield name, text, CAD
    for method, name, value in constructions():
        yield name, lambda: json.dumps(value()), (["construct", method, "FILE", "-o", "OUT.json"],)
