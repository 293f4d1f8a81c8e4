// Drawn nets: the truth they bring is confirmed by the library's oracle and by sampling the determinant, every kind of
// net is met, and shrinking keeps them valid.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "torse/developable/classify.hpp"
#include "torse/developable/condition.hpp"
#include "torse/fuzz/draw/knots.hpp"
#include "torse/fuzz/draw/net.hpp"
#include "torse/fuzz/draw/weights.hpp"
#include "torse/fuzz/plain/truth.hpp"
#include "torse/fuzz/rapidcheck.hpp"

namespace torse::fuzz {
namespace {

constexpr int draws = 100;

/// Calls `visit(net)` for many drawn nets; too many discards are an error.
template <class Draw, class Visit>
void for_many(const Draw& draw, const Scale& scale, int count, const Visit& visit) {
  int discarded = 0;
  for (int seed = 0; seed < count; ++seed) {
    Choices choices = Choices::from_seed(static_cast<std::uint64_t>(seed));
    SCOPED_TRACE("seed " + std::to_string(seed));
    try {
      visit(draw(choices, scale));
    } catch (const Discard&) {
      ++discarded;
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_LE(discarded * 50, count);
}

std::string class_by_library(const Net<4>& net) {
  return std::string(name_of(classify<Rational>(net.knots, net.c, net.d).kind));
}

/// The verdict by the library's oracle and by samples, the class by the library.
void expect_truth(const Net<4>& net) {
  const auto witness = find_witness<Rational, 4>(net.knots, net.c, net.d);
  EXPECT_EQ(net.developable, !witness.has_value()) << net.made;
  EXPECT_EQ(net.developable, plain::holds_by_samples(plain::strip_of(net.knots, net.c, net.d))) << net.made;
  EXPECT_EQ(net.klass, net.developable ? class_by_library(net) : "none") << net.made;
  if (net.common) {
    const auto whole = plain::class_of(net.knots, net.c, net.d);
    ASSERT_TRUE(whole.common.has_value());
    EXPECT_EQ(*whole.common, *net.common);
  }
}

TEST(Net, ThePolynomialTruthIsConfirmed) {
  for_many(draw_net, {}, draws, [](const Net<3>& net) {
    const auto witness = find_witness<Rational, 3>(net.knots, net.c, net.d);
    EXPECT_EQ(net.developable, !witness.has_value());
    expect_truth(with_weights(net));
  });
}

TEST(Net, TheRationalTruthIsConfirmed) {
  for_many(draw_rational_net, {}, draws, [](const Net<4>& net) {
    EXPECT_NE(weight_kind(weights_of(net)), "zero");
    expect_truth(net);
  });
  for_many(draw_row_net, {}, draws, expect_truth);
}

TEST(Net, LargerNetsAreAsTrue) { for_many(draw_rational_net, scale_of(proofs::Effort::standard), 8, expect_truth); }

TEST(Net, ConstantFunctionsAreThoseOfTheNet) {
  int met = 0;
  for_many(draw_developable_rational_net, {}, draws, [&](const Net<4>& net) {
    if (!net.functions) return;
    ++met;
    const auto& [lambda, m, sigma] = *net.functions;
    const plain::Strip strip = plain::strip_of(net.knots, net.c, net.d);
    const Rational n(net.knots.degree());
    for (std::size_t j = 0; j < strip.p.rows.size(); ++j) {
      // p[t^<n-1>, x] = p + (x-t)/n p'
      const Rational t = (strip.p.breaks[j] + Rational(3) * strip.p.breaks[j + 1]) / Rational(4);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto polar = [&](const plain::Poly& f, const Rational& x) {
          return plain::value(f, t) + (x - t) / n * plain::value(plain::derivative(f), t);
        };
        EXPECT_EQ(polar(strip.p.rows[j][i], lambda), sigma * polar(strip.q.rows[j][i], m)) << net.made;
      }
    }
  });
  EXPECT_GT(met, draws / 6);
}

TEST(Net, EveryKindIsMet) {
  std::set<std::string> met;
  const auto collect = [&](const auto& net) {
    Labels labels;
    add_net_labels(labels, net);
    for (const auto& [key, value] : labels.list()) met.insert(std::string(key) + '=' + value);
  };
  for_many(draw_net, {}, 2 * draws, collect);
  for_many(draw_row_net, {}, 2 * draws, collect);
  for (const char* label :
       {"class=plane",        "class=cylinder",   "class=cone",       "class=tangent",   "class=none",
        "made=plane",         "made=cylinder",    "made=cone",        "made=linear",     "made=edge",
        "made=curve",         "made=joined",      "disguise=none",    "disguise=knots",  "disguise=swap",
        "disguise=parameter", "disguise=degree",  "disguise=part",    "disguise=mix",    "disguise=map",
        "disguise=moebius",   "disguise=factors", "made=line",        "made=free",       "knots=bezier",
        "knots=extreme",      "knots=full",       "knots=repeated",   "knots=clamped",   "knots=unclamped",
        "knots=mixed",        "polygon=point",    "polygon=line",     "polygon=plane",   "polygon=coincident",
        "polygon=huge",       "polygon=tiny",     "polygon=dyadic",   "polygon=integer", "polygon=fraction",
        "weights=zero",       "weights=one",      "weights=negative", "weights=extreme", "weights=positive",
        "miss=none",          "miss=to 20",       "miss=to 60",       "miss=beyond 60",  "degree=1",
        "degree=2",           "degree=3",         "pieces=1",         "pieces=2",        "pieces=3"}) {
    EXPECT_TRUE(met.contains(label)) << label;
  }
}

TEST(Net, ShrunkNetsAreValid) {
  const auto shrinkable = gen(draw_rational_net)(rc::Random(7), 100);
  auto shrinks = shrinkable.shrinks();
  for (int i = 0; i < 40; ++i) {
    const auto next = shrinks.next();
    if (!next) break;
    expect_truth(next->value());
  }
}

TEST(Net, TheSimplestOneIsABezierPlane) {
  Choices zeros = Choices::from_record({});
  const Net<3> net = draw_net(zeros, {});
  EXPECT_EQ(net.knots.size(), 2);
  EXPECT_EQ(net.klass, "plane");
}

TEST(Net, IsWrittenAndReadBack) {
  Choices choices = Choices::from_seed(12);
  const Net<4> net = draw_row_net(choices, {});
  const std::string text = write_input(net);
  const Document document("net", text);
  EXPECT_EQ(write_input(read_input<Net<4>>(document.root())), text);
}

}  // namespace
}  // namespace torse::fuzz
