#!/usr/bin/python3
"""A mutant that is switched on does what the mutated text does: both are compiled and run, for every mutant of a sample.

The first argument is the compiler.
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
import instrument
import mutate
import sites

HERE = Path(__file__).resolve().parent
HEAD = '#include "head.hpp"\n'
INCLUDED = """#pragma once
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
namespace torse {
enum class Truth : signed char { no = -1, unknown = 0, yes = 1 };
inline Truth operator!(Truth t) { return static_cast<Truth>(-static_cast<int>(t)); }
}  // namespace torse
"""
SAMPLE = """using torse::Truth;
static_assert(1 + 1 == 2);
constexpr int frozen = 2 + 1;
template <int N>
bool contains(const std::array<int, N>& a, int x) {
  for (int i = 0; i < N; ++i) {  // a comment: i < n
    if (a[i] == x) return true;
  }
  return false;
}
inline int difference(int a, int b) { return a - b; }
inline Truth positive(int x) { return x > 0 ? Truth::yes : Truth::no; }
inline bool opposite(bool b) { return contains<2>({1, 0}, b); }
template <class S>
S polynomial(const S& x, const S& y) {
  S sum = x * x + 2 * y;
  sum += x / y;
  sum -= -y;
  sum *= y;
  if (!(x < y) && y != 0) sum = difference(sum,
                                           x);
  if (opposite(x > y)) sum += 1;
  while (sum > 1000) {
    sum /= 2;
    if (sum % 3 == 1 || sum <= 7) break;
  }
  return std::min(sum, static_cast<S>(5000)) + std::max<S>(x, y);
}
inline std::string run() {
  std::string out = "i < n";
  const std::array<int, 4> grid{0, 7, 3, 9};
  for (int x = 1; x <= 3; ++x) {
    for (int y = 1; y >= -1; --y) {
      if (y == 0) continue;
      out += ' ' + std::to_string(polynomial<int>(x * 31, y * 8));
      if (contains<4>(grid, x)) out += '!';
      if ((x & y) > 1 || (x | 4) == 4) out += '*';
      if (positive(y) == Truth::yes && opposite(y > 0)) out += '+';
    }
  }
  if (frozen != 3) throw std::runtime_error("never");
  return out;
}
"""
GUARDED = """#include <cstdio>
#include <csignal>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>
template <class F> void report(F run) {
  std::fflush(stdout);
  if (fork() == 0) {
    alarm(2);
    std::string text;
    try { text = run(); } catch (const std::exception& e) { text = e.what(); }
    std::printf("%s", text.c_str());
    std::fflush(stdout);
    _Exit(0);
  }
  int status = 0;
  wait(&status);
  std::printf("|%d\\n", WIFEXITED(status) ? 0 : 1);
}
"""


class MutantsOfASample(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        (cls.folder / "head.hpp").write_text(INCLUDED)
        (cls.folder / "sample.cpp").write_text(HEAD + SAMPLE)
        cls.text, cls.sites = sites.find(str(cls.folder), "sample.cpp", [])
        cls.mutants = [(s, m) for s in cls.sites for m in s.mutants]
        for slot, (_, mutant) in enumerate(cls.mutants):
            mutant.slot = slot

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def compile(self, name, text, *flags):
        (self.folder / f"{name}.cpp").write_text(text)
        program = str(self.folder / name)
        subprocess.run([COMPILER, "-std=c++20", "-O0", "-w", "-D_GLIBCXX_ASSERTIONS", *flags, f"{program}.cpp", "-o", program], check=True)
        return program

    def run_program(self, program, **environment):
        return subprocess.run([program], capture_output=True, text=True, env=environment).stdout

    def test_every_kind_is_found_and_nothing_that_is_constant(self):
        names = {m.name for _, m in self.mutants}
        operators = {m[0] for _, others in sites.BINARY.values() for m in others}
        self.assertEqual(names, operators | {"and_or", "or_and", "negate", "unnot", "unsign", "flip", "return_other", "swap",
                                             "index_more", "index_less", "literal_more", "literal_less", "min_max", "delete"})
        lines = {int(m.id.split(":")[1]) - HEAD.count("\n") for _, m in self.mutants}
        self.assertFalse(lines & {2, 3, 4, 5}, "static_assert, constexpr and template parameters have mutants")

    def test_lines_keep_their_numbers(self):
        self.assertEqual(instrument.render(self.text, self.sites).count("\n"), self.text.count("\n"))

    def test_switched_on_is_as_written(self):
        variants = []
        for number, (site, mutant) in enumerate(self.mutants):
            changed = "".join(p if isinstance(p, str) else self.text[slice(*p)] for p in mutant.parts)
            text = self.text[:site.start] + changed + (";" if mutant.name == "delete" else "") + self.text[site.end:]
            variants.append(f"namespace mutant{number} {{\n{text[len(HEAD):]}}}\n")
        calls = "".join(f"  report(mutant{n}::run);\n" for n in range(len(variants)))
        written = self.compile("written", HEAD + "".join(variants) + GUARDED + "int main() {\n" + calls + "}\n")
        switched = self.compile("switched", instrument.render(self.text, self.sites) + GUARDED + "int main() { report(run); }\n",
                                "-include", str(HERE / "switches.hpp"))
        original = self.run_program(switched)
        expected = self.run_program(written).splitlines(keepends=True)
        different = 0
        for (site, mutant), result in zip(self.mutants, expected, strict=True):
            with self.subTest(mutant.id, change=instrument.change(self.text, site, mutant)):
                self.assertEqual(self.run_program(switched, TORSE_MUTANT=str(mutant.slot)), result)
            different += result != original
        self.assertGreater(different, len(expected) * 3 // 4)

    def test_digests_follow_their_lines(self):
        (self.folder / "moved.cpp").write_text("// One line more.\n" + HEAD + SAMPLE)
        _, moved = sites.find(str(self.folder), "moved.cpp", [])
        sites.name_mutants("sample.cpp", "// One line more.\n" + HEAD + SAMPLE, moved)
        self.assertEqual([m.digest for s in moved for m in s.mutants], [m.digest for _, m in self.mutants])
        self.assertEqual(len({m.digest for _, m in self.mutants}), len(self.mutants))


if __name__ == "__main__":
    COMPILER = sys.argv.pop(1)
    unittest.main()
