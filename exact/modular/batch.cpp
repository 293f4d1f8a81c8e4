// The members of Batch that are not lane-by-lane loops: the shared inversion, constants, text.
#include "torse/exact/modular/batch.hpp"

namespace torse {

std::uint64_t Batch::broadcast(const Modulus& m, Constant c, LaneMask& undefined) {
  if (static_cast<std::uint64_t>(c.den) % m.prime() == 0) {
    undefined = ~LaneMask{0};
    return 0;
  }
  return m.encode(c);
}

Batch Batch::reciprocal() const {
  Batch r;
  r.undefined_ = undefined_;
  if (modulus_ == nullptr) {
    if (constant_.num == 0) {
      r.undefined_ = ~LaneMask{0};
    } else {
      r.constant_ = Constant{1, 1} / constant_;
    }
    return r;
  }

  // Node i of the tree holds the product of its children 2i and 2i+1; the leaves are the lanes, with 1 for zero. Down
  // from the inverted root, a child's inverse is its parent's inverse times its sibling.
  const Modulus m = *modulus_;
  std::uint64_t tree[2 * lanes];
  LaneMask zero = 0;
  for (int i = 0; i < lanes; ++i) {
    zero |= LaneMask{lane_[i] == 0} << i;
    tree[lanes + i] = lane_[i] == 0 ? m.one() : lane_[i];
  }
  for (int i = lanes - 1; i >= 1; --i) tree[i] = m.multiply(tree[2 * i], tree[2 * i + 1]);
  tree[1] = m.inverse(tree[1]);
  for (int i = 1; i < lanes; ++i) {
    const std::uint64_t left = tree[2 * i];
    tree[2 * i] = m.multiply(tree[i], tree[2 * i + 1]);
    tree[2 * i + 1] = m.multiply(tree[i], left);
  }
  std::copy_n(tree + lanes, lanes, r.lane_);
  r.modulus_ = modulus_;
  r.undefined_ |= zero;
  return r;
}

std::string Batch::text() const {
  constexpr int shown = 4;
  if (undefined_ == ~LaneMask{0}) return "?";
  if (modulus_ == nullptr) return constant_.text();
  std::string s = "[";
  for (int i = 0; i < shown; ++i) {
    s.append((undefined_ >> i) & 1 ? "?" : std::to_string(value(i))).append(", ");
  }
  return s.append("...]");
}

}  // namespace torse
