// The same seed gives the same cases with every compiler and on every machine: what they were is in cases.txt.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "support/program.hpp"
#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/run.hpp"

namespace torse::fuzz {
namespace {

using testing::slurp;
using testing::spill;

/// The 64 bits of FNV-1a.
class Digest {
 public:
  void add(const std::string& text) {
    for (const char byte : text) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

std::string input_or_reason(const Property& property, const Scale& scale, std::uint64_t seed, int index) {
  Choices choices = draw_case(property, seed, index);
  try {
    return property.input_text(choices, scale);
  } catch (const Discard& discard) {
    return discard.what();
  }
}

/// A line for each property and effort: a digest of the inputs of the first cases of some seeds.
std::string digests() {
  std::ostringstream lines;
  for (const Property* property : properties()) {
    lines << property->info().name;
    for (const auto effort : {proofs::Effort::quick, proofs::Effort::standard}) {
      Digest digest;
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        for (int index = 0; index < 6; ++index) {
          digest.add(input_or_reason(*property, scale_of(effort), seed, index) + "\n");
        }
      }
      lines << ' ' << std::hex << std::setw(16) << std::setfill('0') << digest.value();
    }
    lines << '\n';
  }
  return lines.str();
}

/// With TORSE_WRITE_TRANSCRIPTS in the environment the file is written anew where it is not so: after a property has
/// changed what it draws.
TEST(Cases, OfASeedAreTheSameEverywhere) {
  const auto file = std::filesystem::path(TORSE_SOURCE_PATH) / "tests/fuzz/cases.txt";
  const std::string now = digests();
  EXPECT_EQ(now, slurp(file));
  if (HasFailure() && std::getenv("TORSE_WRITE_TRANSCRIPTS") != nullptr) spill(file, now);
}

}  // namespace
}  // namespace torse::fuzz
