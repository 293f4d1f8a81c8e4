// recover.functions, recover.singular: what is read off a net, checked at parameters by definition.
#pragma once

#include <vector>

#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/property.hpp"

namespace torse::fuzz {

/// A developable net, and the shares of each piece where it is looked at.
struct RecoveryInput {
  Net<4> net;
  std::vector<Rational> shares;
  template <class Self, class Visitor>
  static void fields(Self& in, Visitor& visit) {
    visit("net", in.net);
    visit("shares", in.shares);
  }
};

/// Lambda, M, sigma, lambda, mu, nu, the edge of regression.
struct RecoveredFunctions {
  using In = RecoveryInput;
  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

/// The singular parameters of the patch.
struct SingularParameters {
  using In = RecoveryInput;
  static const PropertyInfo& info();
  static In draw(Choices& choices, const Scale& scale, Labels& labels);
  static void check(const In& in, Labels& labels);
};

}  // namespace torse::fuzz
