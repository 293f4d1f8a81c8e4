#!/usr/bin/python3
"""Mutation score of src/ and exact/: ./x mutate runs this; docs/building.md tells how it works.

  Workshop    the instrumented copy of the tree below build/mutation, and its build
"""
import argparse
import hashlib
import json
import pickle
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
import instrument
import report
import sites
from suite import SLOTS, Suite

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
EFFORTS = {"quick": 100, "standard": 400, "deep": None}
SOURCES = ("src/", "exact/")
CONFIGURE = ["-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=None", "-D", "CCACHE=", "-D", "TORSE_STRICT=OFF", "-D", "TORSE_CHECKS=OFF"]
FLAGS = f"-std=c++20 -O1 -w -Wno-narrowing -D_GLIBCXX_ASSERTIONS -include {HERE / 'switches.hpp'}"
ROUNDS = 12
KNOWN_LEFT_OUT = HERE / "left_out.json"  # a copy of what a run has found: without it the headers' go through a whole failing build


def say(text):
    print(text, flush=True)


def give_up(text):
    """There is no score: exit code 2, as 1 is for mutants that survive."""
    print(text, file=sys.stderr, flush=True)
    raise SystemExit(2)


def find_sites(job):
    """The sites of a file, kept in a folder by what they depend on: the text and how it is searched."""
    store, root, file, flags = job
    key = file.encode() + (Path(root) / file).read_bytes() + Path(sites.__file__).read_bytes()
    kept = store / (hashlib.sha256(key).hexdigest() + ".pickle")
    if kept.exists():
        return pickle.loads(kept.read_bytes())
    found = sites.find(root, file, flags)
    kept.write_bytes(pickle.dumps(found))
    return found


class Workshop:
    def __init__(self, folder, jobs):
        self.folder, self.jobs = folder, jobs
        self.tree, self.build = folder / "tree", folder / "build"
        self.left_out_file = folder / "left_out.json"
        self.texts, self.sites = {}, {}
        known = [json.loads(f.read_text()) for f in (KNOWN_LEFT_OUT, self.left_out_file) if f.exists()]
        self.left_out = {digest for digests in known for digest in digests}

    def files(self):
        """All files of the project, relative to the root: what x calls its sources, and what the tests read."""
        top = [p for p in ROOT.iterdir() if p.name not in ("build", ".git", ".cache")]
        found = [p for t in top for p in ([t] if t.is_file() else t.rglob("*")) if p.is_file()]
        return sorted(str(p.relative_to(ROOT)) for p in found if "__pycache__" not in p.parts)

    def write(self, file, text):
        """Leaves a file alone that has this text already, so that what depends on it is not built anew."""
        path = self.tree / file
        if not path.exists() or path.read_bytes() != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text)

    def copy(self):
        files = self.files()
        for file in files:
            if not file.startswith(SOURCES) or not file.endswith((".hpp", ".cpp")):
                self.write(file, (ROOT / file).read_bytes())
                if file == "x":
                    shutil.copymode(ROOT / file, self.tree / file)
        for path in [p for p in self.tree.rglob("*") if p.is_file()]:
            if str(path.relative_to(self.tree)) not in files:
                path.unlink()
        return [f for f in files if f.startswith(SOURCES) and f.endswith((".hpp", ".cpp"))]

    def configure(self):
        log = subprocess.run(["cmake", "-S", str(self.tree), "-B", str(self.build), *CONFIGURE, "-D",
                              f"CMAKE_CXX_FLAGS={FLAGS}"], capture_output=True, text=True)
        if log.returncode != 0:
            give_up(log.stdout + log.stderr)

    def include_flags(self):
        commands = json.loads((self.build / "compile_commands.json").read_text())
        words = [w for c in commands for w in re.findall(r"-isystem \S+|-I\S+", c["command"])]
        return [part for word in dict.fromkeys(words) for part in word.split()]

    def instrument(self):
        sources = self.copy()
        for file in sources:  # CMake and libclang need to see all files before there is a text for them
            if not (self.tree / file).exists():
                self.write(file, (ROOT / file).read_bytes())
        self.configure()
        flags = self.source_flags(self.include_flags())
        store = self.folder / "sites"
        store.mkdir(exist_ok=True)
        say(f"reading {len(sources)} sources")
        with ProcessPoolExecutor(self.jobs) as pool:
            found = list(pool.map(find_sites, [(store, str(ROOT), f, flags) for f in sources], chunksize=4))
        for file, (text, places) in zip(sources, found):
            self.texts[file], self.sites[file] = text, places
        self.number()

    def source_flags(self, flags):
        """The build folder's include/ links into the copy: libclang reads the originals through links of their own."""
        links = self.folder / "include" / "torse"
        links.mkdir(parents=True, exist_ok=True)
        for link in (self.build / "include" / "torse").iterdir():
            mine = links / link.name
            if not mine.is_symlink():
                mine.symlink_to(ROOT / link.resolve().relative_to(self.tree.resolve()))
        return [f"-I{links.parent}" if f == f"-I{self.build}/include" else f for f in flags]

    def number(self):
        """Slots by digest, so that they stay as they are when other lines change."""
        taken = set()
        for mutant in sorted((m for s in self.sites.values() for p in s for m in p.mutants), key=lambda m: m.digest):
            slot = int(mutant.digest, 16) % (SLOTS - 1)
            while slot in taken:
                slot = (slot + 1) % (SLOTS - 1)
            taken.add(slot)
            mutant.slot = slot
        self.left_out &= {m.digest for places in self.sites.values() for p in places for m in p.mutants}

    def kept(self, file):
        return [s for s in self.sites[file] if not any(m.digest in self.left_out for m in s.mutants)]

    def mutants(self):
        return {m.digest: (file, site, m) for file in self.sites for site in self.kept(file) for m in site.mutants}

    def leave_out(self, log):
        """Leaves out the sites of the lines that the compiler complains about. Returns how many."""
        places = set(re.findall(rf"{re.escape(str(self.tree))}/(\S+?):(\d+):\d+: (?:error|  required)", log))
        places |= set(re.findall(rf"{re.escape(str(self.build))}/include/torse/(\S+?):(\d+):\d+: (?:error|  required)", log))
        count = 0
        for name, line in places:
            for file in self.sites:
                if file != name and not file.endswith("/" + name):
                    continue
                text = self.texts[file]
                for site in self.kept(file):
                    first = text.count("\n", 0, site.start) + 1
                    if first == int(line) or first <= int(line) <= first + text.count("\n", site.start, site.end):
                        self.left_out.update(m.digest for m in site.mutants)
                        count += len(site.mutants)
        return count

    def compile(self, *targets):
        for _ in range(ROUNDS):
            for file in self.sites:
                self.write(file, instrument.render(self.texts[file], self.kept(file)).encode("latin-1"))
            say("building the instrumented tree")
            log = subprocess.run(["ninja", "-C", str(self.build), "-k", "0", "-j", str(self.jobs), *targets],
                                 capture_output=True, text=True)
            (self.folder / "build.log").write_text(log.stdout)
            if log.returncode == 0:
                return
            count = self.leave_out(log.stdout)
            self.left_out_file.write_text(json.dumps(sorted(self.left_out)))
            say(f"left out {count} mutants that cannot be switched at run time")
            if count == 0:
                break
        give_up(f"the instrumented tree does not build: {self.folder / 'build.log'}")


def read_equivalent(path):
    """digest: (line number, the rest of the line). A line is: digest  id when it was written  reason"""
    found = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            digest, _, rest = line.strip().partition(" ")
            found[digest] = (number, rest.strip())
    return found


def check_equivalent(equivalent, mutants):
    stale = [f"{HERE / 'equivalent.txt'}:{n}: stale: no mutant has the digest {d}: {rest}"
             for d, (n, rest) in equivalent.items() if d not in mutants]
    if stale:
        give_up("\n".join(stale))


def sample(mutants, count, seed, paths):
    """The first `count` by a hash with the seed: which ones are drawn does not depend on the others."""
    chosen = [m for m in mutants.values() if not paths or m[0].startswith(tuple(paths))]
    chosen.sort(key=lambda m: hashlib.sha256(f"{seed} {m[2].digest}".encode()).digest())
    return chosen[:count]


def arguments():
    parser = argparse.ArgumentParser(prog="./x mutate", description="mutation score of src/ and exact/")
    parser.add_argument("words", nargs="*", metavar="N|PATH", help="how many mutants; files or folders to take them from")
    parser.add_argument("--effort", choices=EFFORTS, default="standard", help="quick 100, standard 400, deep all")
    parser.add_argument("--seed", type=int, default=1, help="which of them (default 1)")
    parser.add_argument("--mutant", metavar="ID", action="append", help="this one alone (repeatable): file:line:column:operator or its digest")
    parser.add_argument("--campaign", type=float, default=0, metavar="SECONDS", help="ask a campaign too about those that survive the tests")
    parser.add_argument("--jobs", type=int, default=2, help="tests at a time (default 2)")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="also write the table there")
    options = parser.parse_args()
    numbers = [w for w in options.words if w.isdigit()]
    options.count = int(numbers[0]) if numbers else EFFORTS[options.effort]
    options.paths = [w for w in options.words if not w.isdigit()]
    return options


def main():
    options = arguments()
    folder = ROOT / "build" / "mutation"
    folder.mkdir(parents=True, exist_ok=True)
    workshop = Workshop(folder, options.jobs)
    workshop.instrument()
    mutants = workshop.mutants()
    equivalent = read_equivalent(HERE / "equivalent.txt")
    check_equivalent(equivalent, mutants)
    workshop.compile()
    mutants = workshop.mutants()
    suite = Suite(workshop.build, options.jobs)
    for test in suite.baseline(folder / "baseline.json", say):
        say(f"fails without a mutant, so it is left out: {test.name} of {test.program}")
    passed = suite.passed()
    missed = [(file, m) for file, _, m in mutants.values() if m.slot not in passed]
    (folder / "unreached.txt").write_text(report.unreached(missed, workshop.texts))
    say(f"{len(missed)} of {len(mutants)} mutants are reached by no test: {folder / 'unreached.txt'}")
    if options.mutant:
        chosen = [m for m in mutants.values() if {m[2].id, m[2].digest} & set(options.mutant)]
        unknown = set(options.mutant) - {name for _, _, m in chosen for name in (m.id, m.digest)}
        if unknown:
            give_up(f"no mutant {', '.join(sorted(unknown))}")
    else:
        chosen = sample(mutants, options.count, options.seed, options.paths)
    if options.campaign and (found := suite.campaign(options.campaign)):
        give_up(f"the campaign fails without a mutant: {found}")
    start = time.monotonic()
    rows = []

    def judge(choice):
        file, site, mutant = choice
        before, after = instrument.change(workshop.texts[file], site, mutant)
        row = {"id": mutant.id, "digest": mutant.digest, "file": file, "before": before, "after": after}
        if mutant.digest in equivalent and not options.mutant:
            row.update(result="equivalent", stage="", by=equivalent[mutant.digest][1], seconds=0.0)
        else:
            row.update(suite.judge(mutant, file))
        if row["result"] == "survived" and options.campaign:
            row["campaign"] = suite.campaign(options.campaign, mutant)
        return row

    with ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(judge, chosen):
            rows.append(row)
            if row["result"] == "survived" or options.mutant:
                say(report.line(row))
            elif len(rows) % 50 == 0:
                say(f"{len(rows)} of {len(chosen)}")
    summary = report.summary(rows, len(mutants), len(workshop.left_out), options.seed, time.monotonic() - start)
    (folder / ("mutant.json" if options.mutant else "report.json")).write_text(json.dumps({**summary, "mutants": rows}, indent=1) + "\n")
    say(report.table(summary))
    if options.markdown:
        options.markdown.write_text(report.markdown(summary))
    return 1 if summary["total"]["survived"] else 0


if __name__ == "__main__":
    sys.exit(main())
