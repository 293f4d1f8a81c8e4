// Numbers and lists of CAD entities from the choices that bytes stand for.
//   draw_real         any double, mostly small integers       draw_reals      a list of them
//   draw_knots        mostly in order                         fits            what a strip's surface owes
#pragma once

#include <TColStd_HArray1OfReal.hxx>
#include <algorithm>
#include <bit>
#include <vector>

#include "torse/fuzz/choices.hpp"

namespace torse::targets {

/// A small integer, a dyadic number, or any bits.
inline double draw_real(fuzz::Choices& choices) {
  if (choices.once_in(16)) return std::bit_cast<double>(choices.below(~std::uint64_t{0}));
  const double value = choices.between(-64, 64);
  return choices.once_in(4) ? value / 1024 : value;
}

/// `count` numbers from index `lower` on, each `next(value before it)`.
template <class Next>
Handle(TColStd_HArray1OfReal) draw_reals(int lower, int count, const Next& next) {
  if (count < 1) return {};
  Handle(TColStd_HArray1OfReal) list = new TColStd_HArray1OfReal(lower, lower + count - 1);
  double value = 0;
  for (int i = 0; i < count; ++i) {
    value = next(value);
    list->SetValue(lower + i, value);
  }
  return list;
}

/// Knots that rise by eighths or stay, seldom others.
inline Handle(TColStd_HArray1OfReal) draw_knots(fuzz::Choices& choices, int lower, int count, int step) {
  return draw_reals(lower, count, [&](double before) {
    if (choices.once_in(32)) return draw_real(choices);
    return before + choices.between(choices.once_in(2) ? 0 : step, 8) / 8.0;
  });
}

}  // namespace torse::targets
