"""The problems of running error analysis: doubles and bounds, as the integers that their bits are.

  functions    as in problems.py
  all_known    those of them whose bounds are never infinite
"""
import struct

everywhere = range(-1075, 1024)
exponents = {"doubles": range(-30, 31), "tiny doubles": range(-1075, -899), "huge doubles": range(900, 1024), "doubles of tiny products": range(-560, -439),
             "doubles of huge products": range(440, 561), "all doubles": everywhere,
             "doubles beside 2^-960": [-961, -960, -481, -480, 0, 480, 481]}  # where underflow begins to count; often exact
classes = [*exponents, "infinities"]


def bits(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def double(whole):
    return struct.unpack("<d", struct.pack("<Q", whole))[0]


def finite(x):
    return x if abs(x) < float("inf") else 0.0


def plain(draw):
    return draw.kind == "doubles beside 2^-960" and draw.random.random() < 0.5


def value(draw):
    """Often with few bits, or beside a power of two."""
    pick = draw.random
    if pick.random() < 0.1:
        return pick.choice((0.0, -0.0))
    if draw.kind == "infinities" and pick.random() < 0.3:
        return pick.choice((float("inf"), -float("inf"), float("nan")))
    fraction = 0 if plain(draw) else pick.choice((0, 1, pick.randrange(8), 2**52 - 1, 2**52 - 1 - pick.randrange(8), pick.randrange(16) << 48, pick.getrandbits(52)))
    field = max(0, pick.choice(exponents.get(draw.kind, everywhere)) + 1023)
    return double(pick.getrandbits(1) << 63 | field << 52 | fraction)


def bound(draw, x):
    """None, one in proportion, one beside the value, the least one, any; infinite for an infinite value."""
    pick, size = draw.random, abs(x)
    if not size < float("inf") or draw.kind == "infinities" and pick.random() < 0.2:
        return float("inf")
    if plain(draw):
        return 0.0
    if pick.random() < 0.5:
        return pick.choice((0.0, double(max(0, bits(size) - pick.choice((0, 0, 1, 2))))))
    return pick.choice((size * 2.0**-pick.randint(0, 60), double(1), finite(abs(value(draw)))))


def running(draw, x):
    return [bits(x), bits(bound(draw, x))]


def one(draw):
    return {"x": running(draw, value(draw))}


def two(draw):
    """The second is often near the first, or near its opposite."""
    x = value(draw)
    near = finite(double(bits(finite(x)) ^ draw.random.randrange(8))) * draw.random.choice((-1, 1))
    return {"x": running(draw, x), "y": running(draw, near if draw.random.random() < 0.3 else value(draw))}


def integer(draw):
    """64 bits, often beside a power of two."""
    pick = draw.random
    size = pick.choice((2**pick.choice((52, 53, 53, 54, 62)) + pick.randint(-2, 2), pick.getrandbits(63), pick.getrandbits(pick.randint(1, 60))))
    return {"x": pick.choice((-1, 1)) * size}


functions = {
    "running_sum": (classes, two),
    "running_difference": (classes, two),
    "running_product": (classes, two),
    "running_quotient": (classes, two),
    "running_opposite": (classes, one),
    "running_root": (classes, one),
    "running_number": (classes, lambda draw: {"x": bits(value(draw))}),
    "running_integer": (["doubles"], integer),
    "running_is_zero": (classes, one),
    "running_less": (classes, two),
}
all_known = {"running_integer"}
