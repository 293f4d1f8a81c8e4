// A property is a statement about all inputs of a kind, written once: fuzzing draws the inputs, a saved case brings its
// own.
//   PropertyInfo      name, statement, what a run must have met
//   Failed, Discard   thrown by a check that does not hold, and by a drawing that makes no case
//   require           throws Failed unless a condition holds
//   CaseReport        what became of one case
//   Property          a property whose type of input is hidden      property<P>()    the property of a struct P
// A property is a struct P with
//   static const PropertyInfo& info();
//   struct In;                                                  plain exact data, see input_text.hpp for its fields
//   static In draw(Choices&, const Scale&, Labels&);            an input whose true answer is known by construction
//   static void check(const In&, Labels&);                      throws Failed; any other exception is a failure too
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "torse/fuzz/choices.hpp"
#include "torse/fuzz/input_text.hpp"
#include "torse/fuzz/labels.hpp"
#include "torse/fuzz/scale.hpp"

namespace torse::fuzz {

/// What a reader needs to know of a property.
struct PropertyInfo {
  std::string_view name;       ///< "verdict.truth"
  std::string_view statement;  ///< in words
  /// Cases of one seed: such that a seed takes some milliseconds.
  int batch = 1;
  /// Labels "key=value" that a run of enough cases has met; one that it has not met makes the run vacuous.
  std::vector<std::string_view> must_meet = {};
  /// Labels "key=value" that at least half of all labels with this key are, in such a run.
  std::vector<std::string_view> mostly = {};
};

/// A property does not hold.
class Failed : public std::exception {
 public:
  explicit Failed(std::string message) : message_(std::move(message)) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

/// What was drawn is no case: a hypothesis does not hold.
class Discard : public std::exception {
 public:
  explicit Discard(std::string reason) : reason_(std::move(reason)) {}
  const char* what() const noexcept override { return reason_.c_str(); }

 private:
  std::string reason_;
};

/// Throws Failed with this message unless `holds`.
inline void require(bool holds, const char* message) {
  if (!holds) throw Failed(message);
}

/// What may become of a case.
enum class CaseResult { held, failed, discarded };

/// One case: what became of it, why, and its labels.
struct CaseReport {
  CaseResult result = CaseResult::held;
  std::string message;
  Labels labels;
};

/// A property whose type of input is hidden.
class Property {
 public:
  virtual ~Property() = default;
  virtual const PropertyInfo& info() const = 0;
  /// Draws a case and checks it.
  virtual CaseReport run(Choices& choices, const Scale& scale) const = 0;
  /// The input of a case as a JSON object. Throws Discard where the choices make no case.
  virtual std::string input_text(Choices& choices, const Scale& scale) const = 0;
  /// Checks an input that was written by input_text. Throws FileError for one that is none.
  virtual CaseReport replay(const Value& input) const = 0;
};

namespace detail {

/// Runs `body(report)`; exceptions become the report's result.
template <class Body>
CaseReport guarded(const Body& body) {
  CaseReport report;
  try {
    body(report);
  } catch (const Discard& discard) {
    report.result = CaseResult::discarded;
    report.message = discard.what();
  } catch (const Failed& failed) {
    report.result = CaseResult::failed;
    report.message = failed.what();
  } catch (const std::exception& error) {
    report.result = CaseResult::failed;
    report.message = std::string("unexpected error: ") + error.what();
  }
  return report;
}

template <class P>
class PropertyOf final : public Property {
 public:
  const PropertyInfo& info() const override { return P::info(); }
  CaseReport run(Choices& choices, const Scale& scale) const override {
    return guarded([&](CaseReport& report) { P::check(P::draw(choices, scale, report.labels), report.labels); });
  }
  std::string input_text(Choices& choices, const Scale& scale) const override {
    Labels labels;
    return write_input(P::draw(choices, scale, labels));
  }
  CaseReport replay(const Value& input) const override {
    const auto in = read_input<typename P::In>(input);
    return guarded([&](CaseReport& report) { P::check(in, report.labels); });
  }
};

}  // namespace detail

/// The property of a struct P.
template <class P>
const Property& property() {
  static const detail::PropertyOf<P> instance;
  return instance;
}

}  // namespace torse::fuzz
