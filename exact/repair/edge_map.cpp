// Blossoms of products: the mean over the ways to share out the arguments.
#include "torse/exact/repair/edge_map.hpp"

#include <algorithm>
#include <bit>

#include "torse/algebra/bernstein.hpp"
#include "torse/algebra/free_module.hpp"
#include "torse/spline/blossom.hpp"

namespace torse::repair {
namespace {

KnotList<Rational> edge_knots(const KnotList<Rational>& u, int j) {
  const int rho = u.degree() + 1 - j;
  std::vector<Rational> knots(static_cast<std::size_t>(rho), u.domain_begin());
  for (int i = 0, run = 1; i < u.size(); ++i, ++run) {
    if (i > 0 && u[i] != u[i - 1]) run = 1;
    const bool inside = u.domain_begin() < u[i] && u[i] < u.domain_end();
    if (inside && run > j) knots.push_back(u[i]);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(rho), u.domain_end());
  return KnotList<Rational>(rho, std::move(knots));
}

/// A piece of the edge on which point i of a row over u acts, 0 for none.
int piece_below(const KnotList<Rational>& u, const KnotList<Rational>& edge, int i) {
  for (int k = std::max(1, i + 1 - u.degree()); k <= std::min(i + 1, u.pieces()); ++k) {
    if (definitely(u.piece_empty(k))) continue;
    for (int e = 1; e <= edge.pieces(); ++e) {
      if (edge.piece_begin(e) <= u.piece_begin(k) && u.piece_end(k) <= edge.piece_end(e)) return e;
    }
  }
  return 0;
}

/// For l = 0..j the blossoms of S^{j-l} T^l at some arguments, given by their T.
std::vector<Rational> monomial_blossoms(const std::vector<Rational>& arguments) {
  std::vector<Rational> product{Rational(1)};  // of S + z T over the arguments, by powers of z
  for (const Rational& t : arguments) {
    product.push_back(Rational(0));
    for (std::size_t l = product.size(); l-- > 0;) {
      product[l] = (Rational(1) - t) * product[l] + (l > 0 ? t * product[l - 1] : Rational(0));
    }
  }
  const int j = static_cast<int>(arguments.size());
  for (int l = 0; l <= j; ++l) product[static_cast<std::size_t>(l)] /= binomial<Rational>(j, l);
  return product;
}

/// At [l][0] and [l][1] the blossoms at u_i, ..., u_{i+n-1} of S^{j-l} T^l r_S and S^{j-l} T^l r_T, divided by rho.
std::vector<std::array<Form<Rational>, 2>> product_blossoms(const KnotList<Rational>& u, const EdgeFamily& family,
                                                            const KnotList<Rational>& edge, int piece, int i) {
  std::vector<Form<Rational>> generators;
  for (int k = 0; k <= edge.last(); ++k) generators.push_back(Form<Rational>::generator(k));
  const Rational share = Rational(1) / binomial<Rational>(u.degree(), family.j);
  std::vector<std::array<Form<Rational>, 2>> sums(static_cast<std::size_t>(family.j) + 1);
  for (unsigned chosen = 0; chosen < (1U << u.degree()); ++chosen) {
    if (std::popcount(chosen) != family.j) continue;
    std::vector<Rational> factor_arguments;
    std::vector<Parameter<Rational>> edge_arguments;
    for (int k = 0; k < u.degree(); ++k) {
      if ((chosen >> k & 1U) != 0) {
        factor_arguments.push_back((u[i + k] - family.begin) / (family.end - family.begin));
      } else {
        edge_arguments.push_back(at(u[i + k]));
      }
    }
    const std::vector<Rational> factors = monomial_blossoms(factor_arguments);
    for (std::size_t side = 0; side < 2; ++side) {
      std::vector<Parameter<Rational>> arguments = edge_arguments;
      arguments.push_back(at(side == 0 ? family.begin : family.end));
      const Form<Rational> r = blossom<Rational, Form<Rational>>(edge, generators, piece, arguments);
      for (std::size_t l = 0; l < factors.size(); ++l) add_scaled(sums[l][side], share * factors[l], r);
    }
  }
  return sums;
}

}  // namespace

std::optional<EdgeMap> edge_map(const KnotList<Rational>& u, const EdgeFamily& family) {
  const KnotList<Rational> edge = edge_knots(u, family.j);
  const std::size_t count = static_cast<std::size_t>(family.j) + 1;
  EdgeMap map{family.constants(), static_cast<std::size_t>(edge.last()) + 1, {}};
  for (int i = 0; i <= u.last(); ++i) {
    const int piece = piece_below(u, edge, i);
    if (piece == 0) return std::nullopt;
    const auto blossoms = product_blossoms(u, family, edge, piece, i);
    for (std::size_t row = 0; row < 2; ++row) {
      const auto add = [&](std::size_t constant, const Form<Rational>& form, const Rational& factor) {
        for (const auto& term : form.terms()) {
          const Rational coefficient = factor * term.coefficient;
          map.terms.push_back({2 * static_cast<std::size_t>(i) + row, constant,
                               static_cast<std::size_t>(term.generator), coefficient,
                               Real::from_rational(coefficient)});
        }
      };
      for (std::size_t l = 0; l < count; ++l) {
        if (family.homogeneous) {
          add(2 * row * count + l, blossoms[l][0], Rational(1));
          add((2 * row + 1) * count + l, blossoms[l][1], Rational(1));
        } else {
          add(row * count + l, blossoms[l][0], Rational(1));
          add(row * count + l, blossoms[l][1], Rational(-1));
          add(2 * count, blossoms[l][1], binomial<Rational>(family.j, static_cast<int>(l)));
        }
      }
    }
  }
  return map;
}

}  // namespace torse::repair
