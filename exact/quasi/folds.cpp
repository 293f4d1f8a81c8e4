#include "torse/exact/quasi/folds.hpp"

#include "torse/developable/warp.hpp"
#include "torse/exact/roots/negative_place.hpp"

namespace torse {

using Q = Rational;

template <int D>
std::optional<RulingPlace> find_fold(const KnotList<Q>& u, std::span<const Vec<Q, D>> c, std::span<const Vec<Q, D>> d) {
  for (const int k : u.proper_pieces()) {
    const auto [m, n] = normal_forms(ruling_forms(u, c, d, k));
    const auto share = negative_place(Bernstein<Q>::from_form(dot(m, n)));
    if (!share) continue;
    const Q& begin = u.piece_begin(k);
    return RulingPlace{k, begin + *share * (u.piece_end(k) - begin)};
  }
  return std::nullopt;
}

template std::optional<RulingPlace> find_fold<3>(const KnotList<Q>&, std::span<const Vec<Q, 3>>,
                                                 std::span<const Vec<Q, 3>>);
template std::optional<RulingPlace> find_fold<4>(const KnotList<Q>&, std::span<const Vec<Q, 4>>,
                                                 std::span<const Vec<Q, 4>>);

}  // namespace torse
