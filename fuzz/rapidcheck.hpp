// The generators as RapidCheck's: rc::check([] { const auto net = *torse::fuzz::gen(torse::fuzz::draw_net); ... }).
//   gen            a drawing function as a generator whose values shrink to simpler valid ones
//   testable       a property of this library for rc::check
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "torse/fuzz/run.hpp"

namespace torse::fuzz {

namespace detail {

/// The record of the first drawing that is not discarded.
template <class Draw>
Record first_record(rc::Random random, const Draw& draw) {
  for (;;) {
    rc::Random next = random.split();
    Choices choices = Choices::from_seed(next.next());
    try {
      draw(choices);
      return trimmed(choices.record());
    } catch (const Discard&) {
      continue;
    }
  }
}

/// The records that an edit makes of a record and that `draw` accepts, as a sequence of RapidCheck.
template <class Draw>
class SimplerRecords {
 public:
  SimplerRecords(Record record, Draw draw)
      : record_(std::move(record)), edits_(edits(record_)), draw_(std::move(draw)) {}
  rc::Maybe<Record> operator()() {
    while (next_ < edits_.size()) {
      Choices choices = Choices::from_record(edited(record_, edits_[next_++]));
      try {
        draw_(choices);
        Record next = trimmed(choices.record());
        if (simpler(next, record_)) return next;
      } catch (const Discard&) {
        continue;
      }
    }
    return rc::Nothing;
  }

 private:
  Record record_;
  std::vector<Edit> edits_;
  std::size_t next_ = 0;
  Draw draw_;
};

}  // namespace detail

/// `draw(Choices&, const Scale&)` as a generator. RapidCheck's size, 0 to 100, scales `largest`. A drawing that is
/// discarded is drawn again. Shrinking edits the choices and draws again, so every shrunk value is one that could have
/// been drawn.
template <class Draw>
auto gen(Draw draw, Scale largest = {}) {
  using T = decltype(draw(std::declval<Choices&>(), largest));
  return rc::Gen<T>([draw, largest](const rc::Random& random, int size) {
    const auto part = [size](int all) {
      return std::max(1, all * std::min(size, rc::kNominalSize) / rc::kNominalSize);
    };
    const Scale scale{part(largest.degree), part(largest.pieces), part(largest.bits)};
    const auto draw_at_scale = [draw, scale](Choices& choices) { return draw(choices, scale); };
    using Sequence = detail::SimplerRecords<decltype(draw_at_scale)>;
    auto records = rc::shrinkable::shrinkRecur(detail::first_record(random, draw_at_scale), [=](const Record& record) {
      return rc::makeSeq<Sequence>(record, draw_at_scale);
    });
    return rc::shrinkable::map(std::move(records), [draw_at_scale](Record record) {
      Choices again = Choices::from_record(std::move(record));
      return draw_at_scale(again);
    });
  });
}

/// How RapidCheck shows a case: as the JSON of its input.
template <HasFields In>
void showValue(const In& in, std::ostream& out) {
  out << write_input(in);
}

/// A property as something that rc::check runs. The case goes through its file, as a saved one does.
inline auto testable(const Property& property, Scale largest = {}) {
  return [&property, largest] {
    const auto draw = [&property](Choices& choices, const Scale& scale) {
      return case_file(property, property.input_text(choices, scale));
    };
    const std::string file = *gen(draw, largest);
    const CaseReport report = replay_case(Document("case", file));
    if (report.result == CaseResult::discarded) RC_DISCARD(report.message);
    if (report.result == CaseResult::failed) RC_FAIL(report.message);
  };
}

}  // namespace torse::fuzz
