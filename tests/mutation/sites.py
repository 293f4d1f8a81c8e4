"""Where a C++ file can be mutated: its syntax tree by libclang, its operators by their spelling.

  Mutant    one change at one place
  Site      a range of the text and how it is written with all its mutants in it
  find      the sites of one file, outer ones first

Parts of a text are strings, ranges (start, end) of the source and slots ("slot", i) of the i-th mutant of the site.
"""
import hashlib
import re
from dataclasses import dataclass

from clang import cindex
from clang.cindex import CursorKind as Kind

# An operator, its function object in switches.hpp, and (name, operator, function object) of what takes its place.
BINARY = {
    "+": ("add", [("add_sub", "-", "sub")]),
    "-": ("sub", [("sub_add", "+", "add")]),
    "*": ("mul", [("mul_div", "/", "div"), ("mul_add", "+", "add"), ("mul_second", None, "second")]),
    "/": ("div", [("div_mul", "*", "mul"), ("div_first", None, "first")]),
    "%": ("mod", [("mod_div", "/", "div")]),
    "<": ("lt", [("lt_le", "<=", "le"), ("lt_ge", ">=", "ge")]),
    "<=": ("le", [("le_lt", "<", "lt"), ("le_gt", ">", "gt")]),
    ">": ("gt", [("gt_ge", ">=", "ge"), ("gt_le", "<=", "le")]),
    ">=": ("ge", [("ge_gt", ">", "gt"), ("ge_lt", "<", "lt")]),
    "==": ("eq", [("eq_ne", "!=", "ne")]),
    "!=": ("ne", [("ne_eq", "==", "eq")]),
    "&": ("both", [("both_either", "|", "either")]),
    "|": ("either", [("either_both", "&", "both")]),
    "+=": ("add_to", [("add_sub", "-=", "sub_from")]),
    "-=": ("sub_from", [("sub_add", "+=", "add_to")]),
    "*=": ("mul_by", [("mul_div", "/=", "div_by")]),
    "/=": ("div_by", [("div_mul", "*=", "mul_by")]),
}
LOGICAL = {"&&": ("and_or", "||"), "||": ("or_and", "&&")}
COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")
OPERATOR = re.compile(r"\s*(&&|\|\||[-+*/%<>=!]=|[-+*/%<>&|])(?![<>&|=])\s*")
SPACE = "::torse_mutation::"
# Words whose brackets hold what the compiler alone evaluates. Angle brackets of templates have no space before them.
CONSTANT = re.compile(r"\b(?:static_assert|decltype|sizeof|alignas|noexcept|if constexpr|requires) ?(?=\()"
                      r"|(?:(?<=[\w\]])(?<!\boperator)|\btemplate )(?=<[^<=\s])")
# Statements that only reserve or free memory: no result tells of them, the sanitizers do.
MEMORY = re.compile(r"\w+_(init|init2|clear)\(|[\w.>-]+\.(reserve|shrink_to_fit)\(")
# The head of a function that must not return: without its throw it means nothing.
NO_RETURN = re.compile(r"\[\[noreturn\]\][^;{}]*$|\bvoid [\w:]*throw_\w+\([^;{}]*$")
NOT_MUTATED = (Kind.PARM_DECL, Kind.ENUM_DECL, Kind.TYPEDEF_DECL, Kind.TYPE_ALIAS_DECL, Kind.TYPE_ALIAS_TEMPLATE_DECL,
               Kind.STATIC_ASSERT, Kind.TYPE_REF, Kind.TEMPLATE_REF)
FUNCTIONS = (Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.CONVERSION_FUNCTION,
             Kind.FUNCTION_TEMPLATE)
VARIABLES = (Kind.VAR_DECL, Kind.FIELD_DECL)
OPERATIONS = (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR, Kind.CALL_EXPR, Kind.UNEXPOSED_EXPR)
BODIES = (Kind.COMPOUND_STMT, Kind.IF_STMT, Kind.FOR_STMT, Kind.WHILE_STMT, Kind.CXX_FOR_RANGE_STMT)


@dataclass
class Mutant:
    name: str       # of the operator
    at: int         # offset of what changes
    parts: list     # the site's text with this change
    id: str = ""
    digest: str = ""
    slot: int = 0


@dataclass
class Site:
    start: int
    end: int
    parts: list
    mutants: list


def slot(i):
    return ("slot", i)


def switch(changed, original):
    """Parts that are `changed` where mutant 0 is on."""
    return ["(" + SPACE + "on(", slot(0), ") ? ", *changed, " : ", *original, ")"]


def closing(text, start):
    """The offset after the bracket that closes the one at start."""
    pairs = {"(": ")", "[": "]", "{": "}", "<": ">"}
    angle = text[start] == "<"
    stack = []
    for i in range(start, len(text)):
        c = text[i]
        if c in "([{" or (c == "<" and angle):
            stack.append(pairs[c])
        elif stack and c == stack[-1]:
            stack.pop()
            if not stack:
                return i + 1
    return len(text)


class Finder:
    def __init__(self, text):
        self.text = text
        self.sites = []
        self.seen = set()
        self.constant = [(m.start(), closing(text, m.end())) for m in CONSTANT.finditer(text)]

    # Nodes

    def range(self, node):
        return node.extent.start.offset, node.extent.end.offset

    def add(self, node, parts, mutants, extent=None):
        start, end = extent or self.range(node)
        key = (start, end, tuple(m.name for m in mutants))
        if mutants and key not in self.seen:
            self.seen.add(key)
            self.sites.append(Site(start, end, parts, mutants))

    def is_constant(self, start, end):
        return any(a <= start and end <= b for a, b in self.constant)

    def operation(self, node):
        """(lhs, operator, offset of it, rhs) of a node that is spelled as a binary operation."""
        if node.kind not in OPERATIONS:
            return None
        start, end = self.range(node)
        children = [c for c in node.get_children() if c.kind.is_expression()]
        if len(children) < 2:
            return None
        left, right = self.range(children[0]), self.range(children[-1])
        found = OPERATOR.match(self.text, left[1])
        if left[0] != start or right[1] != end or not found or found.end() != right[0]:
            return None
        return left, found.group(1), found.start(1), right

    def operand(self, node, sign):
        """The operand of a node that is spelled as this prefix operator."""
        start, end = self.range(node)
        if node.kind not in (Kind.UNARY_OPERATOR, *OPERATIONS) or self.text[start:start + 1] != sign:
            return None
        children = [self.range(c) for c in node.get_children() if c.kind.is_expression()]
        children = [c for c in children if c[0] > start and c[1] == end]
        return children[0] if children and not self.text[start + 1:children[0][0]].strip() else None

    def has_negation(self, node):
        """Whether the operators in the condition have mutants that negate it."""
        while not self.operation(node):
            inner = [c for c in node.get_children()
                     if node.kind == Kind.PAREN_EXPR or self.range(c) == self.range(node)]
            if len(inner) != 1:
                break
            node = inner[0]
        found = self.operation(node)
        return (found and found[1] in COMPARISONS) or self.operand(node, "!") or \
            node.kind in (Kind.CXX_BOOL_LITERAL_EXPR, Kind.CXX_THROW_EXPR)

    # Mutants of one kind each

    def binary(self, node):
        found = self.operation(node)
        if not found:
            return
        left, sign, at, right = found
        if sign in LOGICAL:
            name, other = LOGICAL[sign]
            changed = ["(", left, " " + other + " ", right, ")"]
            self.add(node, switch(changed, ["(", (left[0], right[1]), ")"]), [Mutant(name, at, changed)])
        elif sign in BINARY and "string" not in node.type.spelling:
            function, others = BINARY[sign]
            parts = [SPACE + "op<" + SPACE + function + ">(", left, (left[1], at), ",", right]
            mutants = []
            for i, (name, other, instead) in enumerate(others):
                parts += [", " + SPACE + "Instead<" + SPACE + instead + ">{", slot(i), "}"]
                changed = [left, " " + other + " ", right] if other else [left if instead == "first" else right]
                mutants.append(Mutant(name, at, changed))
            self.add(node, parts + [")"], mutants)

    def unary(self, node):
        for sign, name, function in (("-", "unsign", "minus"), ("!", "unnot", "negation")):
            inner = self.operand(node, sign)
            if inner:
                self.add(node, [SPACE + function + "(", inner, ", ", slot(0), ")"],
                         [Mutant(name, self.range(node)[0], [inner])])

    def subscript(self, node):
        end = self.range(node)[1]
        children = [c for c in node.get_children() if c.kind.is_expression()]
        if node.kind not in (Kind.ARRAY_SUBSCRIPT_EXPR, *OPERATIONS) or self.text[end - 1] != "]" or not children:
            return
        places = [self.range(c) for c in children if self.text[self.range(c)[1]:end].strip() == "]"]
        if not places or not self.text[:places[-1][0]].rstrip().endswith("["):
            return
        start, end = places[-1]
        if self.text[start] == '"':
            return
        self.add(node, [SPACE + "index(", (start, end), ", ", slot(0), ", ", slot(1), ")"],
                 [Mutant("index_more", start, [(start, end), " + 1"]), Mutant("index_less", start, [(start, end), " - 1"])],
                 (start, end))

    def literal(self, node):
        start, end = self.range(node)
        text = self.text[start:end]
        if node.kind == Kind.INTEGER_LITERAL and re.fullmatch(r"[012](U|L|UL)?", text):
            value, suffix = int(text[0]), text[1:]
            more, less = str(value + 1) + suffix, str(value - 1) + suffix
            if value == 0 and "U" in suffix:
                self.add(node, switch([more], [text]), [Mutant("literal_more", start, [more])])
            else:
                self.add(node, ["(" + SPACE + "on(", slot(0), ") ? " + more + " : " + SPACE + "on(", slot(1),
                                ") ? " + less + " : " + text + ")"],
                         [Mutant("literal_more", start, [more]), Mutant("literal_less", start, [less])])
        other = {"true": "false", "false": "true", "Truth::yes": "Truth::no", "Truth::no": "Truth::yes"}.get(text)
        if other and node.kind in (Kind.CXX_BOOL_LITERAL_EXPR, Kind.DECL_REF_EXPR):
            self.add(node, switch([other], [text]), [Mutant("flip", start, [other])])

    def call(self, node):
        if node.kind != Kind.CALL_EXPR:
            return
        start, end = self.range(node)
        extreme = re.match(r"(?:std::)?(min|max)(?=[(<])", self.text[start:end])
        if extreme:
            at = start + extreme.start(1)
            other = {"min": "max", "max": "min"}[extreme.group(1)]
            changed = [(start, at), other, (at + 3, end)]
            return self.add(node, switch(changed, [(start, end)]), [Mutant("min_max", at, changed)])
        if self.text.startswith("std::swap(", start):
            return
        arguments = list(node.get_arguments())
        if len(arguments) != 2:
            return
        first, second = (self.range(a) for a in arguments)
        types = {re.sub(r"^const ((std::)?\w+)$", r"\1", a.type.spelling) for a in arguments}
        if len(types) != 1 or "<dependent type>" in types or self.text[slice(*first)] == self.text[slice(*second)]:
            return
        if self.text[second[1]:end].strip() != ")" or self.text[:first[0]].rstrip()[-1:] != "(":
            return
        changed = [(start, first[0]), second, ", ", first, (second[1], end)]
        self.add(node, switch(changed, [(start, end)]), [Mutant("swap", first[0], changed)])

    def truth(self, node, kind, original):
        start, end = extent = self.range(node)
        if self.has_negation(node):
            return
        changed = ["!(", extent, ")"]
        self.add(node, switch(changed, [original + "(", extent, ")"]), [Mutant(kind, start, changed)])

    def condition(self, node):
        start, _ = self.range(node)
        if node.kind not in (Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR):
            return
        first = next(iter(node.get_children()), None)
        if first is None or not first.kind.is_expression():
            return
        before, after = self.text[start:self.range(first)[0]], self.text[self.range(first)[1]:]
        question = node.kind == Kind.CONDITIONAL_OPERATOR and not before and re.match(r"\s*\?", after)
        if question or (re.fullmatch(r"(if|while) \(", before) and after.startswith(")")):
            self.truth(first, "negate", "static_cast<bool>")

    def statement(self, node, parent):
        deletable = node.kind.is_expression() or node.kind in (Kind.BREAK_STMT, Kind.CONTINUE_STMT)
        if parent.kind not in BODIES or not deletable:
            return
        start, end = self.range(node)
        thrower = self.text.startswith("throw", start) and len(list(parent.get_children())) == 1
        if thrower and parent.kind == Kind.COMPOUND_STMT and NO_RETURN.search(self.text[:self.range(parent)[0]]):
            return
        semicolon = re.match(r"\s*;", self.text[end:])
        head = parent.kind != Kind.COMPOUND_STMT and not re.search(r"(\)|\belse)\s*$", self.text[:start])
        if not semicolon or head:
            return
        end += semicolon.end()
        self.add(node, ["{ if (!" + SPACE + "on(", slot(0), ")) ", (start, end), " }"],
                 [Mutant("delete", start, [])], (start, end))

    # The tree

    def visit(self, node, parent, result):
        kind = node.kind
        start, end = self.range(node)
        if kind in NOT_MUTATED or self.is_constant(start, end):
            return
        if parent.kind in BODIES and MEMORY.match(self.text[start:end]):
            return
        if kind == Kind.UNEXPOSED_DECL and " concept " in self.text[start:end]:
            return
        if kind in FUNCTIONS:
            return self.visit_function(node)
        if kind in VARIABLES:
            return self.visit_variable(node, result)
        if kind == Kind.LAMBDA_EXPR:
            result = ""
        named = parent.kind in VARIABLES + FUNCTIONS and re.match(r"\w+[({]", self.text[start:end])
        self.statement(node, parent)
        self.condition(node)
        if kind.is_expression() and not (named and kind == Kind.CALL_EXPR):
            if parent.kind == Kind.RETURN_STMT and re.fullmatch(r"bool|(torse::)?Truth", result):
                self.truth(node, "return_other", "")
            self.binary(node)
            self.unary(node)
            self.subscript(node)
            self.literal(node)
            self.call(node)
        children = list(node.get_children())
        if kind in (Kind.CASE_STMT, Kind.DECL_REF_EXPR, Kind.MEMBER_REF_EXPR):
            children = children[1:] if kind == Kind.CASE_STMT else [c for c in children if c.kind != Kind.INTEGER_LITERAL]
        for child in children:
            self.visit(child, node, result)

    def visit_function(self, node):
        before = None
        for child in node.get_children():
            if child.kind == Kind.COMPOUND_STMT or before == Kind.MEMBER_REF:
                self.visit(child, node, node.result_type.spelling)
            before = child.kind

    def visit_variable(self, node, result):
        start, _ = self.range(node)
        name = node.location.offset
        if re.search(r"\bconstexpr\b", self.text[start:name]):
            return
        for child in node.get_children():
            at = self.range(child)[0]
            if child.kind.is_expression() and at >= name and (
                    at == name or re.search(r"[=({]", self.text[name:at])):
                self.visit(child, node, result)


def name_mutants(file, text, sites):
    """Ids by place; digests by the text of the line, so that they outlive a move of the line."""
    lines = text.split("\n")
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)
    count, nth = {}, []
    for line in lines:
        count[line.strip()] = count.get(line.strip(), 0) + 1
        nth.append(count[line.strip()])
    for site in sites:
        for mutant in site.mutants:
            row = text.count("\n", 0, mutant.at)
            column = mutant.at - starts[row]
            indent = len(lines[row]) - len(lines[row].lstrip())
            mutant.id = f"{file}:{row + 1}:{column + 1}:{mutant.name}"
            key = f"{file}\n{lines[row].strip()}\n{column - indent}\n{nth[row]}\n{mutant.name}"
            mutant.digest = hashlib.sha256(key.encode("latin-1")).hexdigest()[:12]


def find(root, file, flags):
    path = f"{root}/{file}"
    with open(path, encoding="latin-1", newline="") as source:
        text = source.read()
    unit = cindex.Index.create().parse(path, args=["-x", "c++", "-std=c++20", "-w", *flags])
    errors = [d for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise SystemExit(f"{file}: libclang cannot read it: {errors[0]}")
    finder = Finder(text)
    for node in unit.cursor.get_children():
        if node.location.file and node.location.file.name == path:
            finder.visit(node, unit.cursor, "")
    sites = sorted(finder.sites, key=lambda s: (s.start, -s.end))
    name_mutants(file, text, sites)
    return text, sites
