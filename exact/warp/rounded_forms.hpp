// Vectors of forms in doubles with one rigorous error bound. With s + t = 1 the largest Bernstein coefficient is a norm
// that obeys |f g| <= |f| |g|, so an error bound costs a few operations for a whole product of polynomials.
//   RoundedForms<K>      K forms of equal degree, the bound of their error and of their size
//   rounded_dot          sum_j x_j y_j            rounded_cross     x x y
//   sum, difference      of two forms
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace torse {

namespace rounding {

/// The largest degree of a RoundedForms: its binomials fit 128 bits.
inline constexpr int most_degree = 130;
__extension__ using Binomial = unsigned __int128;
/// The relative error of one operation in double, 2^-53.
inline constexpr double unit = 0x1p-53;
/// A result of up to 1000 operations on positive doubles, times `up`, is not below the exact one.
inline constexpr double up = 1 + 1024 * unit;
/// What underflow may take away from a result: far more than thousands of times 2^-1075.
inline constexpr double underflow = 0x1p-1000;

/// C(d, i) and 1 / C(d, i) for d <= most_degree, with relative errors of 2^-53 and 2^-52.
struct Binomials {
  using Row = std::array<double, most_degree + 1>;
  std::array<Row, most_degree + 1> value{};
  std::array<Row, most_degree + 1> inverse{};

  constexpr Binomials() {
    std::array<Binomial, most_degree + 1> row{1};
    for (std::size_t d = 0; d <= most_degree; ++d) {
      for (std::size_t i = d; d > 0 && i > 0; --i) row[i] += row[i - 1];
      for (std::size_t i = 0; i <= d; ++i) {
        value[d][i] = static_cast<double>(row[i]);
        inverse[d][i] = 1 / value[d][i];
      }
    }
  }
};
inline constexpr Binomials binomials;

}  // namespace rounding

/// K forms of degree d: coefficient i of form j is C(d, i) times a Bernstein coefficient b, and
///   |at(j, i) - C(d, i) b| <= C(d, i) radius(),   |b| <= norm(),   |at(j, i)| <= C(d, i) norm().
template <int K>
class RoundedForms {
 public:
  /// Zero, exactly.
  explicit RoundedForms(int degree) : degree_(degree) {
    for (auto& form : f_) std::fill_n(form.begin(), degree + 1, 0.0);
  }

  int degree() const { return degree_; }
  double radius() const { return radius_; }
  double norm() const { return norm_; }
  double at(int j, int i) const { return f_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]; }
  double& at(int j, int i) { return f_[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]; }
  const double* form(int j) const { return f_[static_cast<std::size_t>(j)].data(); }
  double* form(int j) { return f_[static_cast<std::size_t>(j)].data(); }

  /// Sets radius and norm, the coefficients being there with an error of at most `radius` C(d, i).
  void close(double radius) {
    const auto& inverse = rounding::binomials.inverse[static_cast<std::size_t>(degree_)];
    double largest = 0;
    for (const auto& form : f_) {
      for (std::size_t i = 0; i <= static_cast<std::size_t>(degree_); ++i) {
        largest = std::max(largest, std::abs(form[i]) * inverse[i]);
      }
    }
    radius_ = radius * rounding::up + rounding::underflow;
    norm_ = (largest + radius_) * rounding::up;
  }

  /// The coefficients sum_m x y of sums of `factors` products of two forms, of which one coefficient is a sum of
  /// `terms`: the inherited error, the rounding error terms 2^-53 sum |x| |y|.
  template <int X, int Y>
  void close_products(const RoundedForms<X>& x, const RoundedForms<Y>& y, int factors) {
    const double terms = factors * (std::min(x.degree(), y.degree()) + 1);
    close(factors * (x.norm() * y.radius() + x.radius() * y.norm() + terms * rounding::unit * x.norm() * y.norm()));
  }

 private:
  int degree_;
  double radius_ = 0;
  double norm_ = 0;
  std::array<std::array<double, rounding::most_degree + 1>, static_cast<std::size_t>(K)> f_;
};

namespace detail {

/// h += sign x y.
inline void add_form_product(double* h, double sign, const double* x, int dx, const double* y, int dy) {
  for (int i = 0; i <= dx; ++i) {
    const double factor = sign * x[i];
    for (int j = 0; j <= dy; ++j) h[i + j] += factor * y[j];
  }
}

}  // namespace detail

/// sum_j x_j y_j.
template <int K>
RoundedForms<1> rounded_dot(const RoundedForms<K>& x, const RoundedForms<K>& y) {
  RoundedForms<1> h(x.degree() + y.degree());
  for (int j = 0; j < K; ++j) detail::add_form_product(h.form(0), 1, x.form(j), x.degree(), y.form(j), y.degree());
  h.close_products(x, y, K);
  return h;
}

/// x x y.
inline RoundedForms<3> rounded_cross(const RoundedForms<3>& x, const RoundedForms<3>& y) {
  RoundedForms<3> h(x.degree() + y.degree());
  for (int j = 0; j < 3; ++j) {
    const int k = (j + 1) % 3;
    const int l = (j + 2) % 3;
    detail::add_form_product(h.form(j), 1, x.form(k), x.degree(), y.form(l), y.degree());
    detail::add_form_product(h.form(j), -1, x.form(l), x.degree(), y.form(k), y.degree());
  }
  h.close_products(x, y, 2);
  return h;
}

/// x_0 y_j - y_0 x_j for j = 1, 2, 3.
inline RoundedForms<3> rounded_minors(const RoundedForms<4>& x, const RoundedForms<4>& y) {
  RoundedForms<3> h(x.degree() + y.degree());
  for (int j = 0; j < 3; ++j) {
    detail::add_form_product(h.form(j), 1, x.form(0), x.degree(), y.form(j + 1), y.degree());
    detail::add_form_product(h.form(j), -1, y.form(0), y.degree(), x.form(j + 1), x.degree());
  }
  h.close_products(x, y, 2);
  return h;
}

/// x + sign y for forms of equal degree.
inline RoundedForms<1> rounded_sum(RoundedForms<1> x, double sign, const RoundedForms<1>& y) {
  for (int i = 0; i <= x.degree(); ++i) x.at(0, i) += sign * y.at(0, i);
  x.close(x.radius() + y.radius() + rounding::unit * (x.norm() + y.norm()));
  return x;
}

}  // namespace torse
