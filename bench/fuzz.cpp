// How fast cases are drawn and checked: every property against the same one written with Python's fractions
// (peers/properties.py) on the same cases, and double.net at n = 3, L = 10 where its bound decides.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "side_by_side.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/properties/double_net.hpp"
#include "torse/fuzz/run.hpp"

namespace {

using torse::bench::processor_seconds;
using torse::fuzz::Choices;
using torse::fuzz::Property;

constexpr int cases_each = 40;
constexpr double seconds_each = 0.25;
const torse::fuzz::Scale scale = torse::fuzz::scale_of(torse::proofs::Effort::quick);

/// What the peer says of a property.
struct Peer {
  int cases = 0;
  double seconds = 0;
  int failed = 0;
};

/// The first cases of a property that are not discarded, as lines for the peer.
std::string lines_of(const Property& property) {
  std::string lines;
  for (int index = 0, kept = 0; kept < cases_each && index < 4 * cases_each; ++index) {
    Choices choices = torse::fuzz::draw_case(property, 1, index);
    try {
      lines += "{\"property\": \"" + std::string(property.info().name) +
               "\", \"input\": " + property.input_text(choices, scale) + "}\n";
      ++kept;
    } catch (const torse::fuzz::Discard&) {
      continue;
    }
  }
  return lines;
}

/// Runs the peer on a file of cases.
std::map<std::string, Peer> ask_peer(const std::string& script, const std::string& file) {
  std::map<std::string, Peer> peers;
  FILE* const pipe = popen(("python3 '" + script + "' '" + file + "'").c_str(), "r");
  if (pipe == nullptr) return peers;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
    std::istringstream words(line.data());
    std::string name;
    Peer peer;
    if (words >> name >> peer.cases >> peer.seconds >> peer.failed) peers[name] = peer;
  }
  if (pclose(pipe) != 0) std::fprintf(stderr, "%s: failed\n", script.c_str());
  return peers;
}

/// Cases drawn and checked in a second of processor time.
double rate(const Property& property) {
  int cases = 0;
  const double start = processor_seconds();
  while (processor_seconds() - start < seconds_each) {
    for (int i = 0; i < 10; ++i) {
      Choices choices = torse::fuzz::draw_case(property, 1, cases++ % (4 * cases_each));
      if (property.run(choices, scale).result == torse::fuzz::CaseResult::failed) {
        std::fprintf(stderr, "%s: a case fails\n", std::string(property.info().name).c_str());
        std::exit(1);
      }
    }
  }
  return cases / (processor_seconds() - start);
}

/// Draws and checks case `index` of double.net at n = 3, L = 10. False if its bound does not decide.
bool decided_case(int index) {
  using Net = torse::fuzz::DoubleNetProperty;
  Choices choices = torse::fuzz::draw_case(torse::fuzz::property<Net>(), 2, index);
  torse::fuzz::Labels labels;
  Net::In in = Net::draw_sized(choices, 3, 10, labels);
  in.exact = false;
  Net::check(in, labels);
  return labels.list().back().second != "decided exactly";
}

/// Such cases in a second of processor time, drawing included, where the bound decides.
double decided_rate() {
  std::vector<int> decided;
  for (int index = 0; index < 50000; ++index) {
    try {
      if (decided_case(index)) decided.push_back(index);
    } catch (const torse::fuzz::Discard&) {
      continue;
    }
  }
  const double start = processor_seconds();
  for (const int index : decided) decided_case(index);
  return static_cast<double>(decided.size()) / (processor_seconds() - start);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: fuzz PEERS\n"), 2;
  const std::string file = std::string(argv[0]) + ".cases";
  std::ofstream out(file);
  for (const Property* property : torse::fuzz::properties()) out << lines_of(*property);
  out.close();
  const auto peers = ask_peer(std::string(argv[1]) + "/properties.py", file);
  std::remove(file.c_str());

  std::printf("## Fuzzing: cases per second and core\n\n");
  std::printf("Effort quick; torse draws and checks, Python's fractions check the same cases.\n\n");
  std::printf("| property | torse | Python | torse is faster by |\n|---|--:|--:|--:|\n");
  for (const Property* property : torse::fuzz::properties()) {
    const std::string name(property->info().name);
    const double mine = rate(*property);
    const auto peer = peers.find(name);
    if (peer == peers.end()) {
      std::printf("| %s | %.0f | | |\n", name.c_str(), mine);
      continue;
    }
    if (peer->second.failed != 0) {
      return std::fprintf(stderr, "%s: the peer says that %d cases fail\n", name.c_str(), peer->second.failed), 1;
    }
    const double theirs = peer->second.cases / peer->second.seconds;
    std::printf("| %s | %.0f | %.0f | %.0f |\n", name.c_str(), mine, theirs, mine / theirs);
    std::fflush(stdout);
  }
  const double decided = decided_rate();
  std::printf("\ndouble.net with n = 3, L = 10, where the bound decides, drawing included: %.0f cases a second.\n",
              decided);
  torse::bench::goal("At least 100000 exactly checked cases of doubles per second and core", decided >= 100000);
}
