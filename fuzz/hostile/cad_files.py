"""Hostile STEP and IGES files: circles, wrong references and counts, nesting, floods of entities, strings and numbers without end.

steps()   (name, function that makes the text)
igs()     the same for IGES

Whatever these files hold is within the bytes of a file, and each is read or refused, as the program likes.
"""

MEBIBYTE = 1 << 20

HEADER = ("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
          "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n")
FOOTER = "ENDSEC;\nEND-ISO-10303-21;\n"

CONTEXT = ["(LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.))", "(NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.))",
           "(NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT())",
           "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),#1,'distance_accuracy_value','')",
           "(GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#4)) GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2,#3)) "
           "REPRESENTATION_CONTEXT('',''))"]
FIRST = len(CONTEXT) + 1


def step(entities):
    """The file of the context and these entities, the first of which is #6."""
    lines = ["#%d=%s;\n" % (i + 1, text) for i, text in enumerate([*CONTEXT, *entities])]
    return HEADER + "".join(lines) + FOOTER


def shown(entities, item):
    """The same with `item` as a shape of the file."""
    last = FIRST + len(entities)
    return step([*entities, "GEOMETRIC_SET('',(%s))" % item,
                 "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(#%d),#5)" % last,
                 "APPLICATION_CONTEXT('automotive design')", "PRODUCT_CONTEXT('',#%d,'mechanical')" % (last + 2),
                 "PRODUCT('part','part','',(#%d))" % (last + 3), "PRODUCT_DEFINITION_FORMATION('','',#%d)" % (last + 4),
                 "PRODUCT_DEFINITION_CONTEXT('part definition',#%d,'design')" % (last + 2),
                 "PRODUCT_DEFINITION('design','',#%d,#%d)" % (last + 5, last + 6),
                 "PRODUCT_DEFINITION_SHAPE('','',#%d)" % (last + 7), "SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)" % (last + 8, last + 1)])


def point(x, y, z):
    return "CARTESIAN_POINT('',(%s,%s,%s))" % (x, y, z)


CORNERS = [point("0.", "0.", "0."), point("0.", "1.", "0."), point("1.", "0.", "0."), point("1.", "1.", "0.")]


def patch(knots="(2,2),(2,2),(0.,1.),(0.,1.)", degrees="1,1", rows="((#6,#7),(#8,#9))", name="p"):
    surface = "B_SPLINE_SURFACE_WITH_KNOTS('%s',%s,%s,.UNSPECIFIED.,.F.,.F.,.F.,%s,.UNSPECIFIED.)" % (name, degrees, rows, knots)
    return shown([*CORNERS, surface], "#10")


def grid(rows, columns):
    """One face of degree 1 over rows x columns points."""
    entities = [point("%d." % i, "%d." % j, "%d." % (i * j % 7)) for i in range(rows) for j in range(columns)]
    lists = ",".join("(" + ",".join("#%d" % (FIRST + i * columns + j) for j in range(columns)) + ")" for i in range(rows))

    def simple(count):
        return "(2," + "1," * (count - 2) + "2)", "(" + ",".join("%d." % k for k in range(count)) + ")"
    (u, ku), (v, kv) = simple(rows), simple(columns)
    entities.append("B_SPLINE_SURFACE_WITH_KNOTS('',1,1,(%s),.UNSPECIFIED.,.F.,.F.,.F.,%s,%s,%s,%s,.UNSPECIFIED.)" % (lists, u, v, ku, kv))
    return shown(entities, "#%d" % (FIRST + rows * columns))


def many_patches(count):
    entities = list(CORNERS)
    for _ in range(count):
        entities.append("B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#6,#7),(#8,#9)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),"
                        ".UNSPECIFIED.)")
    return shown(entities, ",".join("#%d" % (FIRST + 4 + i) for i in range(count)))


def offsets(count, last):
    """Surfaces, each of which is an offset of the next."""
    entities = [*CORNERS[:1], "DIRECTION('',(0.,0.,1.))", "DIRECTION('',(1.,0.,0.))", "AXIS2_PLACEMENT_3D('',#6,#7,#8)", "PLANE('',#9)"]
    entities += ["OFFSET_SURFACE('',#%d,1.,.F.)" % (FIRST + 6 + i) for i in range(count - 1)]
    entities.append("OFFSET_SURFACE('',%s,1.,.F.)" % last)
    return shown(entities, "#11")


def assembly(count):
    """A representation that stands twice in the next, and so on: 2^count places of one patch."""
    entities = [*CORNERS, "DIRECTION('',(0.,0.,1.))", "DIRECTION('',(1.,0.,0.))", "AXIS2_PLACEMENT_3D('',#6,#10,#11)",
                "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#6,#7),(#8,#9)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)",
                "GEOMETRIC_SET('',(#13))", "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION('',(#12,#14),#5)"]
    below = 15
    for _ in range(count):
        entities.append("REPRESENTATION_MAP(#12,#%d)" % below)
        own = FIRST + len(entities) - 1
        entities += ["MAPPED_ITEM('',#%d,#12)" % own, "MAPPED_ITEM('',#%d,#12)" % own,
                     "SHAPE_REPRESENTATION('',(#12,#%d,#%d),#5)" % (own + 1, own + 2)]
        below = own + 3
    return step([*entities, "APPLICATION_CONTEXT('automotive design')", "PRODUCT_CONTEXT('',#%d,'mechanical')" % (below + 1),
                 "PRODUCT('part','part','',(#%d))" % (below + 2), "PRODUCT_DEFINITION_FORMATION('','',#%d)" % (below + 3),
                 "PRODUCT_DEFINITION_CONTEXT('part definition',#%d,'design')" % (below + 1),
                 "PRODUCT_DEFINITION('design','',#%d,#%d)" % (below + 4, below + 5),
                 "PRODUCT_DEFINITION_SHAPE('','',#%d)" % (below + 6), "SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)" % (below + 7, below)])


def steps():
    for count in (10000, 100000):
        yield "STEP, a rail of %d points" % count, lambda: grid(count, 2)
    yield "STEP, 300 x 300 points", lambda: grid(300, 300)
    yield "STEP, 2000 patches", lambda: many_patches(2000)
    yield "STEP, 60000 patches", lambda: many_patches(60000)
    yield "STEP, 2^8 places", lambda: assembly(8)
    yield "STEP, 2^30 places", lambda: assembly(30)
    yield "STEP, an offset of itself", lambda: offsets(1, "#11")
    yield "STEP, a circle of 10000 offsets", lambda: offsets(10000, "#11")
    yield "STEP, 100000 offsets in a row", lambda: offsets(100000, "#10")
    yield "STEP, a set of itself", lambda: step(["GEOMETRIC_SET('',(#6))"])
    yield "STEP, a million points", lambda: step([point("1.", "2.", "3.")] * MEBIBYTE)
    yield "STEP, 64 MiB of entities of no kind", lambda: step(["NOTHING()"] * (3 * MEBIBYTE))
    yield "STEP, one entity 3 million times", lambda: HEADER + "#1=NOTHING();\n" * (3 * MEBIBYTE) + FOOTER
    yield "STEP, the name #99999999999999999999", lambda: HEADER + "#99999999999999999999=NOTHING();\n" + FOOTER
    yield "STEP, references to nothing", lambda: step([*CORNERS, "GEOMETRIC_SET('',(" + ",".join("#%d" % (1000 + i) for i in range(4 * MEBIBYTE)) + "))"])
    yield "STEP, lists in lists", lambda: patch(rows="(" * (20 * MEBIBYTE) + ")" * (20 * MEBIBYTE))
    yield "STEP, 100000 lists in lists", lambda: patch(rows="(" * 100000 + ")" * 100000)
    yield "STEP, a list without end", lambda: HEADER + "#1=CARTESIAN_POINT('',(" + "1.," * (20 * MEBIBYTE)
    yield "STEP, a string without end", lambda: HEADER + "#1=CARTESIAN_POINT('" + "a" * (60 * MEBIBYTE)
    yield "STEP, a comment without end", lambda: HEADER + "/*" + "a" * (60 * MEBIBYTE)
    yield "STEP, a name of 60 MiB", lambda: patch(name="a" * (60 * MEBIBYTE))
    yield "STEP, a number of 30 MiB", lambda: patch("(2,2),(2,2),(0.,1.),(0.,1%s.)" % ("0" * (30 * MEBIBYTE)))
    yield "STEP, multiplicities of 2 billion", lambda: patch("(2000000000,2000000000),(2,2),(0.,1.),(0.,1.)")
    yield "STEP, a million knots for 2 rows", lambda: patch("(%s2),(2,2),(%s1e7),(0.,1.)" % ("1," * MEBIBYTE, "".join("%d.," % i for i in range(MEBIBYTE))))
    yield "STEP, degree 2 billion", lambda: patch(degrees="2000000000,1")
    yield "STEP, degree -1", lambda: patch(degrees="-1,1")
    yield "STEP, rows of different length", lambda: patch(rows="((#6,#7),(#8))")
    yield "STEP, no rows", lambda: patch(rows="()")
    yield "STEP, a row of 4 million times one point", lambda: patch(rows="((%s#7),(#8,#9))" % ("#6," * (4 * MEBIBYTE)))
    yield "STEP, a header of 60 MiB", lambda: HEADER.replace("'2;1'", "'" + "a" * (60 * MEBIBYTE) + "'") + FOOTER
    yield "STEP, zeros", lambda: "ISO-10303-21;" + "\0" * (60 * MEBIBYTE)


GLOBAL = "1H,,1H;,4Hpart,8Hpart.igs,5Htorse,5Htorse,32,38,6,308,15,4Hpart,1.,2,2HMM,1,0.01,15H20260101.000000,1.E-05,1000.,5Htorse,5Htorse,11,0,15H20260101.000000;"


class Iges:
    """Entities with parameters, in lines of 80 columns."""

    def __init__(self):
        self.directory = []
        self.parameters = []

    def add(self, kind, parameters, form=0, matrix=0, dependent=False, first=None, lines=None):
        name = len(self.directory) + 1
        start = len(self.parameters) + 1
        text = "%d,%s;" % (kind, parameters)
        at = 0
        while at < len(text):
            end = len(text) if len(text) - at <= 64 else (text.rfind(",", at, at + 63) + 1 or at + 64)
            self.parameters.append(text[at:end].ljust(64) + "%8d" % name)
            at = end
        count = len(self.parameters) - start + 1
        self.directory.append("%8d" * 8 % (kind, start if first is None else first, 0, 0, 0, 0, matrix, 0) + ("00010000" if dependent else "00000000"))
        self.directory.append("%8d" * 5 % (kind, 0, 0, count if lines is None else lines, form) + " " * 24 + "%8d" % 0)
        return name

    def line(self, y):
        return self.add(110, "0.,%s,0.,1.,%s,0." % (y, y), dependent=True)

    def text(self, header=GLOBAL, totals=None):
        sections = [("S", ["A part."]), ("G", [header[i:i + 72] for i in range(0, len(header), 72)]), ("D", self.directory), ("P", self.parameters)]
        counts = "".join("%s%7d" % (letter, len(lines) if totals is None else totals) for letter, lines in sections)
        rows = ["%s%s%7d\n" % (line.ljust(72), letter, i % 10000000 + 1) for letter, lines in [*sections, ("T", [counts])] for i, line in enumerate(lines)]
        return "".join(rows)


def ruled(count=1, curves=None, **directory):
    """Ruled surfaces between two lines, or between entities of these numbers."""
    file = Iges()
    ends = (file.line("0."), file.line("1."))
    for _ in range(count):
        file.add(118, "%d,%d,0,1" % (curves or ends), form=1, **directory)
    return file.text()


def spline(upper, degree, numbers, tail="0.,1.,0.,0.,0."):
    """A ruled surface of a curve 126 whose counts may say anything."""
    file = Iges()
    curve = file.add(126, "%s,%s,0,0,1,0,%s,%s" % (upper, degree, ",".join(numbers), tail), dependent=True)
    file.add(118, "%d,%d,0,1" % (curve, file.line("1.")), form=1)
    return file.text()


def long_spline(count):
    knots = ["0.", *("%d." % i for i in range(count)), "%d." % (count - 1)]
    poles = ["%d.,%d.,%d." % (i, i * i % 97, i * i % 89) for i in range(count)]
    return spline(count - 1, 1, [*knots, *["1."] * count, *poles], "0.,%d.,0.,0.,0." % (count - 1))


def chain(count, last):
    """Curves 130, each an offset of the next; the last of `last`."""
    file = Iges()
    other = file.line("0.")
    for i in range(count):
        below = len(file.directory) + 3 if i + 1 < count else last
        file.add(130, "%d,1,0,0,0.,0.,1.,0.,0.,0.,0.,1.,0.,1." % below, dependent=True)
    file.add(118, "%d,%d,0,1" % (3, other), form=1)
    return file.text()


def matrices(count, last):
    file = Iges()
    numbers = "1.,0.,0.,0.,0.,1.,0.,0.,0.,0.,1.,1."
    for i in range(count):
        file.add(124, numbers, matrix=len(file.directory) + 3 if i + 1 < count else last)
    file.add(118, "%d,%d,0,1" % (file.line("0."), file.line("1.")), form=1, matrix=1)
    return file.text()


def subfigures(levels, instances, first=None):
    """Each subfigure is so many instances of the one before; the innermost holds a ruled surface, and `first`."""
    file = Iges()
    below = file.add(118, "%d,%d,0,1" % (file.line("0."), file.line("1.")), form=1, dependent=True)
    for level in range(levels):
        inner = [below] if level == 0 else [
            file.add(408, "%d,%d.,%d.,%d.,1." % (below, i, level, i * level), dependent=True) for i in range(instances)]
        if first is not None and level == 0:
            inner.append(first)
        below = file.add(308, "0,1Hs,%d,%s" % (len(inner), ",".join(map(str, inner))), dependent=True)
    file.add(408, "%d,0.,0.,0.,1." % below)
    return file.text()


def igs():
    for count in (10000, 100000, 200000):
        yield "IGES, a rail of %d points" % count, lambda: long_spline(count)
    yield "IGES, 1000 ruled surfaces", lambda: ruled(1000)
    yield "IGES, 200000 ruled surfaces", lambda: ruled(200000)
    yield "IGES, 250000 lines", lambda: lines(250000)
    for name in ("-1", "2", "5", "999999", "9" * 30):
        yield "IGES, curve %s" % name, lambda: ruled(curves=(int(name), 3))
    yield "IGES, a curve that is its surface", lambda: ruled(curves=(5, 5))
    yield "IGES, parameters from line 20000000", lambda: ruled(first=20000000)
    yield "IGES, parameters in 99999999 lines", lambda: ruled(lines=99999999)
    yield "IGES, parameters in -1 lines", lambda: ruled(lines=-1)
    yield "IGES, matrix 999999", lambda: ruled(matrix=999999)
    yield "IGES, a matrix of itself", lambda: matrices(1, 1)
    yield "IGES, a circle of 1000 matrices", lambda: matrices(1000, 1)
    yield "IGES, 50000 matrices", lambda: matrices(50000, 0)
    yield "IGES, a subfigure of itself", lambda: subfigures(2, 1, 9)
    yield "IGES, 2^16 instances of subfigures", lambda: subfigures(17, 2)
    yield "IGES, 2^60 instances of subfigures", lambda: subfigures(61, 2)
    yield "IGES, 30000 subfigures in each other", lambda: subfigures(30000, 1)
    yield "IGES, an offset of itself", lambda: chain(1, 3)
    yield "IGES, a circle of 1000 offsets", lambda: chain(1000, 3)
    yield "IGES, 30000 offsets in a row", lambda: chain(30000, 1)
    for upper, degree in ((2000000000, 1), (1, 2000000000), (-1, 1), (1, -1), (-5, 7), (2147483647, 2147483647), (100000000, 1)):
        yield "IGES, spline of upper index %d and degree %d" % (upper, degree), lambda: spline(upper, degree, ["0.", "0.", "1.", "1."])
    yield "IGES, surface of 2 billion points", lambda: surface(45000, 45000)
    yield "IGES, surface of -1 points", lambda: surface(-1, -1)
    yield "IGES, totals of 9999999", lambda: Iges().text(totals=9999999)
    yield "IGES, a string of 2 billion characters", lambda: Iges().text(GLOBAL.replace("4Hpart", "2000000000Hpart", 1))
    yield "IGES, a number of 50 MiB", lambda: spline(1, 1, ["0." + "0" * (50 * MEBIBYTE), "0.", "1.", "1."])
    yield "IGES, a header of 50 MiB", lambda: Iges().text(GLOBAL.replace("4Hpart", "%dH%s" % (50 * MEBIBYTE, "a" * (50 * MEBIBYTE)), 1))
    yield "IGES, a line of 60 MiB", lambda: "A part.".ljust(72) + "S      1" + "a" * (60 * MEBIBYTE)
    yield "IGES, 60 MiB of the start section", lambda: ("A part.".ljust(72) + "S      1\n") * (60 * MEBIBYTE // 81)
    yield "IGES, commas", lambda: spline(1, 1, [","] * (20 * MEBIBYTE))


def lines(count):
    file = Iges()
    for i in range(count):
        file.add(110, "0.,%d.,0.,1.,%d.,0." % (i, i))
    return file.text()


def surface(rows, columns):
    file = Iges()
    file.add(128, "%d,%d,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,0.,0.,0.,1.,0.,1.,1.,0.,0.,1.,0.,1." % (rows, columns))
    return file.text()
