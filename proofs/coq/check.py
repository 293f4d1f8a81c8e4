#!/usr/bin/env python3
"""Builds the Coq theory in build/coq, has coqchk look at it again, and compares what was proved with the committed files:

  theorems.json        every theorem under its claim id: statement as Coq prints it, and what it assumes; every definition as Coq prints it; every
                       notation that other files see
  index.md             the same for readers
  ../coq_theorems.hpp  the ids and names for the ledger

usage: check.py [--build | --write]     with --build the theory is built and nothing else, with --write the three files are rewritten instead
"""
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
build = root / "build" / "coq"
memory = 8 << 30  # bytes of address space for each program
library = "Torse"
preludes = ("Prelude", "Prelude_binary")  # export scopes and settings, which would change how Coq prints
of_library = ("FJ07", "FJ21", "ZW06", "BZZ19")
papers = {"FJ07": "Fernández-Jambrina 2007", "FJ21": "Fernández-Jambrina 2021", "ZW06": "Zhang and Wang 2006",
          "BZZ19": "Bo, Zheng and Zhang 2019", "blossoms": "Blossoms", "rounding": "Rounding errors"}
without_claim = {"BZZ19.9"}  # theorems of a paper that the library has no claim for: the function of (9) is minimised, it is no identity
title_of_part = {"Hypotheses": "Hypotheses", "Paper": "The paper"}


closed = "Closed under the global context"


def may_rest_on_axioms(entry):
    """Those about binary numbers, on the axioms of Coq's real numbers."""
    return entry["id"].startswith("rounding.binary")


def fail(text):
    print(text)
    sys.exit(1)


def run(arguments, seconds, **options):
    """The output of a program under limits of time and memory."""
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    try:
        done = subprocess.run(arguments, cwd=build, timeout=seconds, preexec_fn=limit, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    except subprocess.TimeoutExpired:
        fail(f"{' '.join(arguments[:3])}: not done after {seconds} s")
    if done.returncode != 0:
        fail(f"{done.stdout[-6000:]}\n{' '.join(arguments[:3])}: exit code {done.returncode}")
    return done.stdout


def sources():
    """The .v files in the order of _CoqProject."""
    listed = [line for line in (here / "_CoqProject").read_text().split() if line.endswith(".v")]
    for file in {*listed} ^ {path.name for path in here.glob("*.v")}:
        fail(f"{file}: " + ("_CoqProject lists it and it is not there" if file in listed else "_CoqProject does not list it"))
    return listed


def without_comments(text):
    """Coq text without comments, which nest."""
    kept, depth, i = [], 0, 0
    while i < len(text):
        if text.startswith("(*", i):
            depth, i = depth + 1, i + 2
        elif text.startswith("*)", i) and depth:
            depth, i = depth - 1, i + 2
        else:
            if depth == 0:
                kept.append(text[i])
            i += 1
    return "".join(kept)


forbidden = re.compile(r"\b(Admitted|Axioms?|Parameters?|Conjecture|admit|give_up|bypass_check|Unset (Guard|Positivity|Universe) Checking)\b")

theorem = re.compile(r"\(\*\* (?P<id>[A-Za-z0-9.]+) (?P<word>\w+): (?P<text>.*?) ?\*\)\n"
                     r"(?P<statement>(?:Theorem|Lemma) (?P<name>\w+).*?\.)\nProof", re.S)


def under_hypotheses(before):
    """Whether a section that is open at the end of this text has stated a hypothesis."""
    open_sections = [False]
    for word in re.findall(r"^(Section|End|Hypothes[ie]s)\b", without_comments(before), re.M):
        if word == "Section":
            open_sections.append(False)
        elif word == "End":
            open_sections.pop()
        else:
            open_sections[-1] = True
    return any(open_sections)


def theorems():
    """Every statement with a claim id, in the order of the files."""
    found = []
    for file in sources():
        text = (here / file).read_text()
        if word := forbidden.search(without_comments(text)):
            fail(f"{file}: {word.group()} has no place here")
        entries = [match.groupdict() | {"file": file} for match in theorem.finditer(text)]
        if len(entries) != text.count("\n(** "):
            fail(f"{file}: {text.count(chr(10) + '(** ')} comments begin with (** but {len(entries)} are followed by a statement with a claim id")
        for entry, match in zip(entries, theorem.finditer(text)):
            entry["under_hypotheses"] = under_hypotheses(text[: match.start()])
            stem = re.sub(r"\W", "_", entry["id"])
            if entry["id"].split(".")[0] not in papers or entry["name"] != f"{stem}_{entry['word']}":
                fail(f"{file}: {entry['name']} should be called {stem}_{entry['word']}")
        found += entries
    names = [entry["name"] for entry in found]
    if len(set(names)) != len(names):
        fail("two theorems have the same name")
    return found


def check_claims(found):
    """Every claim of the library has a theorem, and every theorem of a paper a claim."""
    claims = {claim["id"] for claim in json.loads((here.parent / "ledger.json").read_text())["claims"]}
    proved = {entry["id"] for entry in found if entry["id"].split(".")[0] in of_library}
    for identifier in sorted(claims - proved):
        fail(f"the library has a claim {identifier} and there is no theorem about it")
    for identifier in sorted(proved - claims - without_claim):
        fail(f"there is a theorem about {identifier} and the library has no such claim")


def definitions():
    """The names that the statements are written with."""
    pattern = re.compile(r"^\s*(?:#\[[^]]*\]\s*)?(?:(?:Local|Global|Program|Polymorphic|Monomorphic)\s+)*"
                         r"(?:Definition|Fixpoint|CoFixpoint|Function|Inductive|CoInductive|Variant|Record|Structure|Class|Instance|Canonical)\s+(\w+)", re.M)
    return [f"{file[:-2]}.{name}" for file in sources() for name in pattern.findall(without_comments((here / file).read_text()))]


def notations():
    """What is said outside sections of how Coq reads and prints, by file: other files see it."""
    word = re.compile(r"^\s*(Section|End|(?:Global\s+|Reserved\s+)?(?:Notation|Infix|Coercion)\b.*?\.)(?=\s)", re.M | re.S)
    seen = {}
    for file in sources():
        depth = 0
        for said in word.findall(without_comments((here / file).read_text())):
            depth += (said == "Section") - (said == "End")
            if depth == 0 and said != "End":
                seen.setdefault(file[:-2], []).append(" ".join(said.split()))
    return seen


def compile_theory():
    build.mkdir(parents=True, exist_ok=True)
    for file in [*build.glob("*.v"), *build.glob("*.vo")]:
        if not (here / file.name).with_suffix(".v").exists():
            file.unlink()
    for file in [*sources(), "_CoqProject"]:
        target = build / file
        if not target.exists() or target.read_bytes() != (here / file).read_bytes():
            shutil.copyfile(here / file, target)
    run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile.coq"], 60)
    run(["make", "-s", "-f", "Makefile.coq", "-j", str(os.cpu_count())], 1800)


def check_files():
    """Has coqchk look at the compiled files; those of other libraries are taken as they are. It is quicker with the young heap that coqc has."""
    files = (word for file in sources() for word in ("-norec", f"{library}.{file[:-2]}"))
    run(["coqchk", "-silent", "-R", ".", library, *files], 900, env=os.environ | {"OCAMLRUNPARAM": "s=32M,o=200"})


def together(name, theorems):
    """A term that rests on what any of these theorems rests on."""
    return f"Definition {name} := {' '.join(f'let _ := @{theorem} in' for theorem in theorems)} tt."


def printed(found, definitions):
    """What Coq says of each theorem, (statement, axioms), and of each definition. Print Assumptions takes about a second for each term, as it
    walks through the whole library, so it is asked about two: the theorems that may rest on nothing, and the others, which all get the axioms of
    any of them."""
    full = lambda entry: f"{entry['file'][:-2]}.{entry['name']}"  # another file may have a lemma of the same name
    names = [full(entry) for entry in found]
    free = [full(entry) for entry in found if not may_rest_on_axioms(entry)]
    others = [full(entry) for entry in found if may_rest_on_axioms(entry)]
    modules = [file[:-2] for file in sources()]
    script = ["From mathcomp Require Import all_ssreflect all_algebra."]
    script += [f"From {library} Require {' '.join(modules)}."]
    script += [f"From {library} Require Import {' '.join(module for module in modules if module not in preludes)}."]
    script += ["Set Printing Width 110.", "Definition torse_next := tt.", together("torse_free", free), together("torse_others", others)]
    questions = [f"Check {name}." for name in names] + [f"Print {name}." for name in definitions]
    questions += ["Print Assumptions torse_free.", "Print Assumptions torse_others."]
    for question in questions:
        script += ["Print torse_next.", question]
    (build / "Listing.v").write_text("\n".join([*script, "Print torse_next."]) + "\n")
    text = re.sub(" +$", "", run(["coqc", "-q", "-w", "none", "-R", ".", library, "Listing.v"], 300), flags=re.M)
    answers = [block.strip() for block in re.split(r"torse_next = tt\s+: unit\n", text)[1:-1]]
    if len(answers) != len(questions):
        fail(f"{text[-3000:]}\nListing.v: {len(answers)} answers for {len(questions)} questions")
    of_free, of_others = answers[-2:]
    if of_free != closed:
        fail(f"a theorem that may rest on no axiom does:\n{of_free}")
    axioms = [] if of_others == closed else re.findall(r"^(?!Axioms:)([\w.]+)\s*:", of_others, re.M)
    facts = [(answer.split(":", 1)[1].strip(), axioms if name in others else []) for name, answer in zip(names, answers)]
    return facts, dict(zip(definitions, answers[len(names):]))


def parts(text):
    """A comment's statement, hypotheses and remark on the paper."""
    text = " ".join(text.split())
    pieces = re.split(r" ?(Hypotheses|Paper): ", text)
    return pieces[0], dict(zip(pieces[1::2], pieces[2::2]))


def order(identifier):
    paper, _, rest = identifier.partition(".")
    return list(papers).index(paper), [(0, int(piece), "") if piece.isdigit() else (1, 0, piece) for piece in re.findall(r"\d+|[A-Za-z]+", rest)]


def index(found):
    lines = ["# The theorems, by claim", "",
             "Written by `./x coq` from the Coq files; [README.md](README.md) says how to read them. Each holds for every degree and every number of",
             "pieces, over any field unless it says otherwise. Where a paper omits a hypothesis or claims too much, the line *The paper* says so.", ""]
    paper = None
    for identifier in sorted({entry["id"] for entry in found}, key=order):
        if identifier.split(".")[0] != paper:
            paper = identifier.split(".")[0]
            lines += [f"## {papers[paper]}", ""]
        lines += [f"### {identifier}", ""]
        for entry in (entry for entry in found if entry["id"] == identifier):
            text, more = parts(entry["text"])
            axioms = "" if not entry["axioms"] else " It rests on no axioms but " + ", ".join(f"`{axiom}`" for axiom in entry["axioms"]) + "."
            lines += [f"**{entry['word'].replace('_', ' ')}** ([{entry['file']}]({entry['file']})): {text}{axioms}"]
            lines += [f"\n*{title_of_part[part]}*: {words}" for part, words in more.items()]
            whole = f"Theorem {entry['name']} : {entry['printed']}." if entry["under_hypotheses"] else entry["statement"]
            lines += ["", "```coq", whole, "```", ""]
    return "\n".join(lines)


def header(found):
    ids = sorted({entry["id"] for entry in found if entry["id"].split(".")[0] in of_library}, key=order)
    rows = "".join(f'    CoqTheorem{{"{identifier}", "{entry["name"]}"}},\n' for identifier in ids for entry in found if entry["id"] == identifier)
    count = rows.count("\n")
    return ("// The theorems of proofs/coq that Coq's kernel accepts without axioms, by claim. Written by `./x coq`; do not edit.\n"
            "//   CoqTheorem, coq_theorems\n#pragma once\n\n#include <array>\n#include <string_view>\n\nnamespace torse::proofs {\n\n"
            "/// A machine-checked theorem and the claim that it proves, for every degree and every number of pieces.\n"
            "struct CoqTheorem {\n  std::string_view claim;\n  std::string_view name;\n};\n\n"
            f"// clang-format off\ninline constexpr std::array<CoqTheorem, {count}> coq_theorems{{\n{rows}}};\n// clang-format on\n\n"
            "}  // namespace torse::proofs\n")


def main():
    found = theorems()
    check_claims(found)
    compile_theory()
    if "--build" in sys.argv[1:]:
        return
    with ThreadPoolExecutor() as pool:
        checked = pool.submit(check_files)
        facts, defined = printed(found, sorted(set(definitions())))
        checked.result()
    for entry, (statement, axioms) in zip(found, facts):
        entry["printed"], entry["axioms"] = statement, axioms
    golden = {"theorems": [{key: entry[source] for key, source in (("id", "id"), ("name", "name"), ("file", "file"), ("statement", "printed"), ("axioms", "axioms"))}
                           for entry in found], "definitions": defined, "notations": notations()}
    files = {here / "theorems.json": json.dumps(golden, indent=1, ensure_ascii=False) + "\n", here / "index.md": index(found),
             here.parent / "coq_theorems.hpp": header(found)}
    stale = 0
    for path, text in files.items():
        if "--write" in sys.argv[1:]:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            stale += 1
            (build / path.name).write_text(text)
            subprocess.run(["diff", "-u", str(path), str(build / path.name)], check=False)
            print(f"{path.relative_to(root)} differs from what Coq says")
    claims = {entry["id"] for entry in found}
    print(f"{len(found)} theorems for {len(claims)} claims, {sum(1 for entry in found if entry['axioms'])} with axioms")
    if stale:
        sys.exit(1)


if __name__ == "__main__":
    main()
