// Bounds of a quotient N / D of two polynomials in Bernstein form on [0, 1], where D > 0: it is not larger than the
// largest quotient N_i / D_i of their coefficients, and this bound converges quadratically under subdivision.
//   QuotientBound            what the coefficients say
//   enclosure                of a Rational or a Ball as an Interval
//   quotient_enclosure       of a quotient of two of them
//   RoundedQuotient          coefficients in double with error bounds
//   BernsteinQuotient<S>     coefficients in a field
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "torse/algebra/bernstein.hpp"
#include "torse/exact/ball/ball.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/warp/rounded_forms.hpp"
#include "torse/scalar/interval.hpp"

namespace torse {

/// An upper bound of N / D, infinite while D is not certified to be positive, and what the coefficients would say if
/// they had no error.
struct QuotientBound {
  double value;
  double nominal;
};

/// A polynomial quotient with the operations of the search.
template <class Q>
concept BoundedQuotient = std::movable<Q> && requires(const Q& q) {
  { q.upper() } -> std::same_as<QuotientBound>;
  { q.lower_at_begin() } -> std::same_as<double>;  // a lower bound of the value at 0
  { q.lower_at_end() } -> std::same_as<double>;
  { q.split() } -> std::same_as<std::pair<Q, Q>>;  // over [0, 1/2] and [1/2, 1]
};

/// The value, rounded outwards.
inline Interval enclosure(const Rational& x) {
  const double nearest = x.to_double();
  if (std::isfinite(nearest)) {
    const Rational exact = Rational::from_double(nearest);
    if (exact == x) return Interval::point(nearest);
    return exact < x ? Interval::hull(nearest, -detail::next_below(-nearest))
                     : Interval::hull(detail::next_below(nearest), nearest);
  }
  return x.sign() > 0 ? Interval::hull(detail::next_below(nearest), nearest)
                      : Interval::hull(nearest, -detail::next_below(-nearest));
}

/// x / y for y > 0, rounded outwards; exact where that is cheap. Reducing a fraction of long numbers is not, so these
/// are compared by their leading 53 bits.
inline Interval quotient_enclosure(const Rational& x, const Rational& y) {
  constexpr std::size_t short_number = 2048;
  if (x.sign() == 0 ||
      std::max({x.numerator_bits(), x.denominator_bits(), y.numerator_bits(), y.denominator_bits()}) <= short_number) {
    return enclosure(Rational(x / y));
  }
  long top = 0, bottom = 0, part = 0;
  double above = mpz_get_d_2exp(&top, mpq_numref(x.mpq())) * mpz_get_d_2exp(&part, mpq_denref(y.mpq()));
  top += part;
  const double below = mpz_get_d_2exp(&bottom, mpq_denref(x.mpq())) * mpz_get_d_2exp(&part, mpq_numref(y.mpq()));
  bottom += part;
  // Each of the four numbers lacks a relative 2^-52 at most, and three operations round: less than 2^-49 together.
  constexpr double error = 0x1p-49;
  above /= below;
  const long exponent = std::clamp(top - bottom, -5000L, 5000L);
  const double outer = std::ldexp(above * (1 + error), static_cast<int>(exponent));
  const double inner = std::ldexp(above * (1 - error), static_cast<int>(exponent));
  const double lower = detail::next_below(std::min(inner, outer));
  const double upper = -detail::next_below(-std::max(inner, outer));
  return Interval::hull(lower == detail::infinity ? std::numeric_limits<double>::max() : lower,
                        upper == -detail::infinity ? std::numeric_limits<double>::lowest() : upper);
}

template <int Bits>
Interval enclosure(const Ball<Bits>& x) {
  const double middle = x.midpoint();
  const double radius = x.radius();
  if (!x.is_finite() || !std::isfinite(middle) || !std::isfinite(radius)) return Interval::line();
  const double reach = -detail::next_below(-radius);
  return Interval::hull(lower_sum(detail::next_below(middle), -reach), -lower_sum(detail::next_below(-middle), -reach));
}

template <int Bits>
Interval quotient_enclosure(const Ball<Bits>& x, const Ball<Bits>& y) {
  return enclosure(x / y);
}

/// N and D in doubles, with the errors of their coefficients. Movable at the cost of one pointer.
class RoundedQuotient {
 public:
  /// Takes forms of equal degree.
  RoundedQuotient(const RoundedForms<1>& numerator, const RoundedForms<1>& denominator)
      : size_(static_cast<std::size_t>(numerator.degree()) + 1), b_(2 * size_) {
    const auto& inverse = rounding::binomials.inverse[size_ - 1];
    for (std::size_t i = 0; i < size_; ++i) {
      b_[i] = numerator.form(0)[i] * inverse[i];
      b_[size_ + i] = denominator.form(0)[i] * inverse[i];
    }
    numerator_error_ = (numerator.radius() + 4 * rounding::unit * numerator.norm()) * rounding::up;
    denominator_error_ = (denominator.radius() + 4 * rounding::unit * denominator.norm()) * rounding::up;
    numerator_norm_ = numerator.norm();
    denominator_norm_ = denominator.norm();
  }

  QuotientBound upper() const {
    double most = 0;
    double nominal = 0;
    double least = detail::infinity;
    for (std::size_t i = 0; i < size_; ++i) {
      least = std::min(least, b_[size_ + i]);
      most = std::max(most, (b_[i] + numerator_error_) / (b_[size_ + i] - denominator_error_));
      nominal = std::max(nominal, b_[i] / b_[size_ + i]);
    }
    if (!(least > 0)) nominal = detail::infinity;
    if (!(least > denominator_error_)) most = detail::infinity;
    return {most * rounding::up, nominal};
  }

  double lower_at_begin() const { return lower_at(0); }
  double lower_at_end() const { return lower_at(size_ - 1); }

  /// Half sums, each with a relative error of 2^-53 of the norm.
  std::pair<RoundedQuotient, RoundedQuotient> split() const {
    std::pair<RoundedQuotient, RoundedQuotient> halves{RoundedQuotient(*this, size_), RoundedQuotient(*this, size_)};
    halve(0, halves);
    halve(size_, halves);
    return halves;
  }

 private:
  /// The coefficients still missing, with the errors that a subdivision leaves.
  RoundedQuotient(const RoundedQuotient& whole, std::size_t size)
      : size_(size), b_(2 * size), numerator_norm_(whole.numerator_norm_), denominator_norm_(whole.denominator_norm_) {
    const double levels = static_cast<double>(size) * rounding::unit;
    numerator_error_ = (whole.numerator_error_ + levels * numerator_norm_ + rounding::underflow) * rounding::up;
    denominator_error_ = (whole.denominator_error_ + levels * denominator_norm_ + rounding::underflow) * rounding::up;
  }

  double lower_at(std::size_t i) const {
    const double least = b_[i] - numerator_error_;
    const double most = b_[size_ + i] + denominator_error_;
    const double value = least > 0 && most > 0 ? least / most * (1 - 8 * rounding::unit) : 0;
    return value > rounding::underflow ? value : 0;
  }

  void halve(std::size_t from, std::pair<RoundedQuotient, RoundedQuotient>& halves) const {
    double* left = halves.first.b_.data() + from;
    double* row = halves.second.b_.data() + from;
    std::copy_n(b_.data() + from, size_, row);
    left[0] = row[0];
    for (std::size_t r = 1; r < size_; ++r) {
      for (std::size_t i = 0; i + r < size_; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
      left[r] = row[0];
    }
  }

  std::size_t size_;
  std::vector<double> b_;  // the coefficients of N, then those of D
  double numerator_error_ = 0;
  double denominator_error_ = 0;
  double numerator_norm_ = 0;
  double denominator_norm_ = 0;
};

/// N and D over an exact field or over balls. N may carry a constant factor, so that tiny angles do not underflow.
template <Field S>
class BernsteinQuotient {
 public:
  BernsteinQuotient(Bernstein<S> numerator, Bernstein<S> denominator)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {}

  QuotientBound upper() const {
    QuotientBound bound{0, 0};
    for (int i = 0; i <= numerator_.degree(); ++i) {
      if (!definitely(less(from_int<S>(0), denominator_[i]))) {
        const bool hopeful = maybe_positive(denominator_[i]);
        bound = {detail::infinity, hopeful ? bound.nominal : detail::infinity};
        if (!hopeful) return bound;
        continue;
      }
      if constexpr (ScalarTraits<S>::exact) {
        bound.value = std::max(bound.value, quotient_enclosure(numerator_[i], denominator_[i]).upper());
        bound.nominal = bound.value;  // nothing hides in the error
      } else {
        const S ratio = numerator_[i] / denominator_[i];
        bound.value = std::max(bound.value, enclosure(ratio).upper());
        bound.nominal = std::max(bound.nominal, ratio.midpoint());
      }
    }
    return bound;
  }

  double lower_at_begin() const { return lower_at(0); }
  double lower_at_end() const { return lower_at(numerator_.degree()); }

  std::pair<BernsteinQuotient, BernsteinQuotient> split() const {
    std::pair<Bernstein<S>, Bernstein<S>> n = numerator_.subdivide(half());
    std::pair<Bernstein<S>, Bernstein<S>> d = denominator_.subdivide(half());
    return {BernsteinQuotient(std::move(n.first), std::move(d.first)),
            BernsteinQuotient(std::move(n.second), std::move(d.second))};
  }

 private:
  static S half() { return ratio<S>(1, 2); }
  /// Whether the middle of a ball is; exact numbers have been decided.
  static bool maybe_positive(const S& x) {
    if constexpr (ScalarTraits<S>::exact) {
      return false;
    } else {
      return x.midpoint() > 0;
    }
  }
  double lower_at(int i) const {
    if (!definitely(less(from_int<S>(0), denominator_[i]))) return 0;
    return std::max(0.0, quotient_enclosure(numerator_[i], denominator_[i]).lower());
  }

  Bernstein<S> numerator_;
  Bernstein<S> denominator_;
};

}  // namespace torse
