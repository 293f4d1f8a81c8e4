// Descartes' rule against roots that are known: none where it says so.
#include "torse/exact/decide/rootless.hpp"

#include <gtest/gtest.h>

namespace torse {
namespace {

using Q = Rational;

Polynomial<Q> with_roots(std::initializer_list<Q> roots) {
  Polynomial<Q> f(1);
  for (const Q& x : roots) f = f * Polynomial<Q>(std::vector<Q>{-x, Q(1)});
  return f;
}

TEST(SurelyRootless, RootsAtTheEndsAreRoots) {
  EXPECT_FALSE(surely_rootless(with_roots({Q(3)}), Q(1), Q(3)));
  EXPECT_FALSE(surely_rootless(with_roots({Q(1)}), Q(1), Q(3)));
  EXPECT_FALSE(surely_rootless(with_roots({Q(1), Q(3)}), Q(1), Q(3)));
  EXPECT_FALSE(surely_rootless(with_roots({Q(3), Q(3)}), Q(1), Q(3)));
  EXPECT_FALSE(surely_rootless(with_roots({ratio<Q>(3, 2)}), Q(1), Q(3)));
  EXPECT_FALSE(surely_rootless(Polynomial<Q>(), Q(1), Q(3)));
}

TEST(SurelyRootless, RootsOutsideAreNone) {
  EXPECT_TRUE(surely_rootless(with_roots({Q(4)}), Q(1), Q(3)));
  EXPECT_TRUE(surely_rootless(with_roots({Q(0), Q(4)}), Q(1), Q(3)));
  EXPECT_TRUE(surely_rootless(-with_roots({Q(0), Q(-1), Q(7)}), Q(1), Q(3)));
  EXPECT_TRUE(surely_rootless(Polynomial<Q>(-5), Q(1), Q(3)));
}

}  // namespace
}  // namespace torse
