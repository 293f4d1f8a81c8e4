#include "torse/fuzz/properties/rail_jets.hpp"

#include <algorithm>

#include "torse/fuzz/draw/numbers.hpp"
#include "torse/fuzz/plain/polynomial.hpp"
#include "torse/quasi/rail.hpp"

namespace torse::fuzz {
namespace {

using In = RailJets::In;
using Q = Rational;

/// The power basis to Bernstein's, times 12, which every binomial coefficient up to degree 4 divides.
std::vector<Q> bernstein(const plain::Poly& f, int degree) {
  std::vector<Q> chosen{Q(1)};  // C(degree, k)
  for (int k = 1; k <= degree; ++k) chosen.push_back(chosen.back() * Q(degree - k + 1) / Q(k));
  std::vector<Q> result;
  for (int i = 0; i <= degree; ++i) {
    Q sum;
    Q ways(1);  // C(i, k)
    for (int k = 0; k <= i; ++k) {
      if (static_cast<std::size_t>(k) < f.size()) {
        sum += ways / chosen[static_cast<std::size_t>(k)] * f[static_cast<std::size_t>(k)];
      }
      ways = ways * Q(i - k) / Q(k + 1);
    }
    result.push_back(Q(12) * sum);
  }
  return result;
}

plain::Poly coordinate(const std::vector<Point3>& points, int i) {
  plain::Poly f;
  for (const Point3& x : points) f.push_back(x[i]);
  return f;
}

quasi::Rail rail_of(const In& in) {
  const std::size_t degree = in.points.front().size() + in.weights.front().size() - 2;
  std::vector<Vec<double, 4>> rows;
  for (std::size_t j = 0; j < in.points.size(); ++j) {
    std::vector<std::vector<Q>> columns{bernstein(in.weights[j], static_cast<int>(degree))};
    for (int i = 0; i < 3; ++i) {
      columns.push_back(bernstein(plain::times(in.weights[j], coordinate(in.points[j], i)), static_cast<int>(degree)));
    }
    for (std::size_t k = 0; k <= degree; ++k) {
      rows.push_back(
          {columns[0][k].to_double(), columns[1][k].to_double(), columns[2][k].to_double(), columns[3][k].to_double()});
    }
  }
  std::vector<double> breaks;
  for (const Q& t : in.breaks) breaks.push_back(t.to_double());
  return {static_cast<int>(degree), std::move(breaks), std::move(rows)};
}

}  // namespace

const PropertyInfo& RailJets::info() {
  static const PropertyInfo info{
      "rails.jets",
      "a rail in doubles and its three derivatives are exact where no operation has to be rounded",
      40,
      {"rail=polynomial", "rail=rational", "pieces=1", "pieces=3", "degree=4"}};
  return info;
}

RailJets::In RailJets::draw(Choices& choices, const Scale&, Labels& labels) {
  In in;
  in.breaks = {Q(0), Q(1)};
  while (in.breaks.size() < 4 && choices.once_in(2)) {
    const std::size_t j = static_cast<std::size_t>(choices.below(in.breaks.size() - 1));
    in.breaks.insert(in.breaks.begin() + static_cast<std::ptrdiff_t>(j) + 1, (in.breaks[j] + in.breaks[j + 1]) / Q(2));
  }
  const int of_weights = choices.between(0, 2);
  const int of_points = choices.between(1, 4 - of_weights);
  for (std::size_t j = 0; j + 1 < in.breaks.size(); ++j) {
    std::vector<Point3> points;
    for (int i = 0; i <= of_points; ++i) {
      points.push_back(
          {Q(12 * choices.between(-4, 4)), Q(12 * choices.between(-4, 4)), Q(12 * choices.between(-4, 4))});
    }
    in.points.push_back(std::move(points));
    std::vector<Q> weights{Q(choices.between(1, 4))};
    for (int i = 1; i <= of_weights; ++i) weights.push_back(Q(choices.between(0, 4)));
    in.weights.push_back(std::move(weights));
  }
  in.share = Q(choices.between(0, 3)) / Q(4);
  const bool constant = std::ranges::all_of(
      in.weights, [&](const std::vector<Q>& w) { return w == std::vector<Q>{in.weights.front().front()}; });
  labels.add("rail", constant ? "polynomial" : "rational");
  labels.add("pieces", static_cast<int>(in.points.size()));
  labels.add("degree", of_points + of_weights);
  return in;
}

void RailJets::check(const In& in, Labels&) {
  const quasi::Rail rail = rail_of(in);
  for (std::size_t j = 0; j < in.points.size(); ++j) {
    const Q length = in.breaks[j + 1] - in.breaks[j];
    const quasi::RailJet jet = rail((in.breaks[j] + in.share * length).to_double());
    for (int i = 0; i < 3; ++i) {
      plain::Poly f = coordinate(in.points[j], i);
      Q unit(1);
      for (const quasi::Vector* at : {&jet.point, &jet.first, &jet.second, &jet.third}) {
        require(Q::from_double((*at)[i]) == plain::value(f, in.share) / unit, "a derivative of a rail is wrong");
        f = plain::derivative(f);
        unit *= length;
      }
    }
  }
}

}  // namespace torse::fuzz
