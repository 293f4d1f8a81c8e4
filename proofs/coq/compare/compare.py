#!/usr/bin/env python3
"""Runs the programs extracted from the compiled theory in build/coq beside the C++ library, on the same problems, and compares the answers as text:
fractions in lowest terms, the bits of doubles, or the error.

usage: compare.py LIBRARY [--count N] [--seed S]     LIBRARY is the program of the CMake target coq_compare; N problems of each class of each function

Fails where an answer differs, where a class of inputs did not do what it is there for, and where a program is extracted and not compared.
"""
import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import problems

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent.parent
build = root / "build" / "coq" / "compare"


def run(arguments, **options):
    done = subprocess.run(arguments, cwd=build, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=600, **options)
    if done.returncode != 0:
        sys.exit(f"{done.stdout[-6000:]}\n{' '.join(map(str, arguments[:3]))}: exit code {done.returncode}")
    return done.stdout


def extracted():
    """The OCaml program, made of the compiled theory."""
    build.mkdir(parents=True, exist_ok=True)
    for name in ("Extraction.v", "doubles.ml", "main.ml"):
        shutil.copyfile(here / name, build / name)
    said = run(["coqc", "-q", "-w", "none", "-R", "..", "Torse", "Extraction.v"])
    text = (build / "programs.ml").read_text() + (build / "running.ml").read_text()
    if "axiom" in said.lower() or "Obj.magic" in text or "failwith" in text:
        sys.exit(f"{said}programs.ml, running.ml: an axiom or a cast")
    sources = ["programs.mli", "programs.ml", "running.mli", "running.ml", "doubles.ml", "main.ml"]
    run(["ocamlfind", "ocamlopt", "-package", "zarith", "-linkpkg", *sources, "-o", "programs"])
    return build / "programs"


def answers(program, lines):
    """A line for each problem; as many processes as processors share them."""
    def of_part(part):
        found = run([program], input="".join(line + "\n" for line in part)).splitlines()
        if len(found) != len(part):
            sys.exit(f"{program}: {len(found)} answers to {len(part)} problems")
        return found

    shares = os.cpu_count()
    found = [None] * len(lines)
    with ThreadPoolExecutor(shares) as pool:
        for share, part in enumerate(pool.map(of_part, [lines[share::shares] for share in range(shares)])):
            found[share::shares] = part
    return found


def table(title, rows):
    print(f"{title:20} {'inputs':>8} {'errors':>8} {'different':>10}")
    for name, (inputs, errors, different) in rows.items():
        print(f"{name:20} {inputs:8} {errors:8} {different:10}")
    print()


def vacuous(rows):
    """The classes that did not do what they are there for, the functions that only one kind of answer came from, by name."""
    for name, (inputs, errors, _) in rows.items():
        if inputs == 0 or errors == inputs and name not in problems.all_errors or errors == 0 and name in problems.with_errors | problems.all_errors:
            yield f"{name}: {inputs} inputs, {errors} errors"
        elif errors < inputs and name in problems.all_errors:
            yield f"{name}: {inputs - errors} inputs without an error"


def left_out(functions):
    """The programs that no function of main.ml calls, and its functions that no problem is for, by name."""
    called = (here / "main.ml").read_text() + (here / "doubles.ml").read_text()
    for names in re.findall(r'^Extraction "[^"]*"(.*?)\.$', (here / "Extraction.v").read_text(), re.M | re.S):
        yield from (f"{name} is extracted and not called" for name in names.split() if not re.search(rf"\b{name.split('.')[-1]}\b", called))
    for name in re.findall(r'^  "(\w+)", ', called, re.M):
        if name not in functions:
            yield f"{name}: no inputs"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    drawn = list(problems.problems(options.seed, options.count))
    lines = [line for _, _, line in drawn]
    by_coq, by_library = answers(extracted(), lines), answers(options.library.resolve(), lines)
    functions, classes, different = collections.defaultdict(lambda: [0, 0, 0]), collections.defaultdict(lambda: [0, 0, 0]), []
    for (name, kind, line), coq, library in zip(drawn, by_coq, by_library):
        for row in (functions[name], classes[kind]):
            row[0] += 1
            row[1] += coq.startswith("error")
            row[2] += coq != library
        if coq != library:
            different.append(f"{line}\n  Coq  {coq}\n  C++  {library}")
    table("function", functions)
    table("class", classes)
    bad = [f"vacuous: {text}" for text in [*vacuous(functions), *vacuous(classes)]] + [*left_out(functions)]
    print("\n".join(different[:5] + bad))
    print(f"{len(lines)} answers of {len(functions)} functions compared with the library, {sum(row[1] for row in functions.values())} of them errors: "
          f"{len(different)} differ")
    sys.exit(1 if different or bad else 0)


main()
