// Numbers as groups of seven bits, the lowest first; texts and lists behind their size.
#include "torse/fuzz/campaign/messages.hpp"

#include <string_view>

#include "torse/proofs/random.hpp"
#include "torse/scalar/errors.hpp"

namespace torse::fuzz {
namespace {

class Writer {
 public:
  void put(std::uint64_t number) {
    for (; number >= 0x80; number >>= 7) bytes_ += static_cast<char>(0x80 | (number & 0x7F));
    bytes_ += static_cast<char>(number);
  }
  void put(const std::string& text) {
    put(text.size());
    bytes_ += text;
  }
  void put(const Distribution& distribution) {
    put(distribution.counts().size());
    for (const auto& [key, values] : distribution.counts()) {
      put(key);
      put(values.size());
      for (const auto& [value, count] : values) {
        put(value);
        put(count);
      }
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      if (bytes_.empty()) fail();
      const auto group = static_cast<unsigned char>(bytes_.front());
      bytes_.remove_prefix(1);
      value |= std::uint64_t{group & 0x7FU} << shift;
      if (group < 0x80) return value;
    }
    fail();
  }
  /// A size of what is still to come, every element of which takes a byte at least.
  std::size_t size() {
    const std::uint64_t value = number();
    if (value > bytes_.size()) fail();
    return static_cast<std::size_t>(value);
  }
  std::string text() {
    const std::size_t length = size();
    std::string value(bytes_.substr(0, length));
    bytes_.remove_prefix(length);
    return value;
  }
  Distribution distribution() {
    Distribution read;
    for (std::size_t keys = size(); keys > 0; --keys) {
      const std::string key = text();
      for (std::size_t values = size(); values > 0; --values) {
        const std::string value = text();
        read.add(key, value, number());
      }
    }
    return read;
  }
  std::size_t property(const Plan& plan) {
    const std::uint64_t index = number();
    if (index >= plan.properties.size()) fail();
    return static_cast<std::size_t>(index);
  }
  void expect_end() const {
    if (!bytes_.empty()) fail();
  }

 private:
  [[noreturn]] static void fail() { throw Error("a message of another process makes no sense"); }

  std::string_view bytes_;
};

void put_tally(Writer& writer, const Tally& tally) {
  for (const std::uint64_t number : {tally.cases, tally.failed, tally.discarded}) writer.put(number);
  writer.put(tally.labels);
  writer.put(tally.discards);
  writer.put(tally.failures.size());
  for (const SavedCase& saved : tally.failures) {
    writer.put(static_cast<std::uint64_t>(saved.index));
    writer.put(saved.message);
    writer.put(saved.text);
  }
}

Tally read_tally(Reader& reader, std::uint64_t seed) {
  Tally tally;
  tally.cases = reader.number();
  tally.failed = reader.number();
  tally.discarded = reader.number();
  tally.labels = reader.distribution();
  tally.discards = reader.distribution();
  for (std::size_t left = reader.size(); left > 0; --left) {
    SavedCase saved;
    saved.seed = seed;
    saved.index = static_cast<int>(reader.number());
    saved.message = reader.text();
    saved.text = reader.text();
    tally.failures.push_back(std::move(saved));
  }
  return tally;
}

}  // namespace

std::uint64_t plan_number(const Plan& plan, const std::string& build) {
  return proofs::seed_of(0, build + " " + plan.text(), 0);
}

std::string to_bytes(const Report& report, const Plan& plan) {
  Writer writer;
  writer.put(report.plan);
  writer.put(report.wanted);
  writer.put(report.last ? 1U : 0U);
  writer.put(report.error);
  writer.put(report.results.size());
  for (const UnitResult& result : report.results) {
    writer.put(plan.place(result.series));
    writer.put(result.seed);
    writer.put(static_cast<std::uint64_t>(result.microseconds));
    put_tally(writer, result.tally);
  }
  return writer.take();
}

std::string to_bytes(const std::vector<Unit>& units) {
  Writer writer;
  writer.put(units.size());
  for (const Unit& unit : units) {
    writer.put(unit.property);
    writer.put(unit.seed);
  }
  return writer.take();
}

std::uint64_t report_plan(const std::string& bytes) { return Reader(bytes).number(); }

Report report_from(const std::string& bytes, const Plan& plan) {
  Reader reader(bytes);
  Report report;
  report.plan = reader.number();
  report.wanted = reader.number();
  report.last = reader.number() != 0;
  report.error = reader.text();
  for (std::size_t left = reader.size(); left > 0; --left) {
    UnitResult result;
    result.series = plan.series(reader.property(plan));
    result.seed = reader.number();
    result.microseconds = static_cast<std::int64_t>(reader.number());
    result.tally = read_tally(reader, result.seed);
    report.results.push_back(std::move(result));
  }
  reader.expect_end();
  return report;
}

std::vector<Unit> orders_from(const std::string& bytes, const Plan& plan) {
  Reader reader(bytes);
  std::vector<Unit> units;
  for (std::size_t left = reader.size(); left > 0; --left) {
    const std::size_t property = reader.property(plan);
    units.push_back({property, reader.number()});
  }
  reader.expect_end();
  return units;
}

}  // namespace torse::fuzz
