"""The text of a file with all its mutants in it, each behind a switch of switches.hpp.

  render     the instrumented text; what follows a site keeps its line number
  change     what a mutant changes: (before, after), on one line each
"""
import re

COMMENT = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*')


def flat(text):
    """On one line, without comments."""
    return re.sub(r"\s*\n\s*", " ", COMMENT.sub(lambda m: m.group(1) or "", text))


def tree(sites):
    """Sites, outer ones first, nested by their ranges: a list of (site, children)."""
    root, stack = [], []
    for site in sites:
        while stack and not (stack[-1][0].start <= site.start and site.end <= stack[-1][0].end):
            stack.pop()
        entry = (site, [])
        (stack[-1][1] if stack else root).append(entry)
        stack.append(entry)
    return root


def render_range(text, start, end, entries):
    out, at = [], start
    for site, children in entries:
        if at <= site.start and site.end <= end:
            out += [text[at:site.start], render_site(text, site, children)]
            at = site.end
    return "".join(out) + text[at:end]


def render_site(text, site, children):
    out = []
    for part in site.parts:
        if isinstance(part, str):
            out.append(part)
        elif part[0] == "slot":
            out.append(str(site.mutants[part[1]].slot))
        else:
            out.append(render_range(text, *part, children))
    written = "".join(out)
    lines = text.count("\n", site.start, site.end)
    return written if written.count("\n") == lines else flat(written) + "\n" * lines


def render(text, sites):
    return render_range(text, 0, len(text), tree(sites))


def change(text, site, mutant):
    after = "".join(p if isinstance(p, str) else text[slice(*p)] for p in mutant.parts)
    return flat(text[site.start:site.end]), flat(after) or "(deleted)"
