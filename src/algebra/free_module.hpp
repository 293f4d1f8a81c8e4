// The free module over a field: points as sparse linear forms in formal generators, so that an identity linear in the
// points is settled for all points in every dimension at once.
//   Form<S>     sum of coefficients times generators, with the operations of point.hpp
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "torse/algebra/point.hpp"
#include "torse/scalar/concepts.hpp"

namespace torse {

/// A linear form over S: terms in increasing order of their generators, none of them known to be zero.
template <Ring S>
class Form {
 public:
  struct Term {
    int generator;
    S coefficient;
  };

  /// Zero.
  Form() = default;

  /// The generator i itself.
  static Form generator(int i) {
    Form form;
    form.terms_.push_back({i, from_int<S>(1)});
    return form;
  }

  const std::vector<Term>& terms() const { return terms_; }

  /// The coefficient of generator i.
  S coefficient(int i) const {
    const auto term = std::ranges::lower_bound(terms_, i, {}, &Term::generator);
    return term != terms_.end() && term->generator == i ? term->coefficient : from_int<S>(0);
  }

  /// Takes generator i out of the form and returns its coefficient.
  S extract(int i) {
    const auto term = std::ranges::lower_bound(terms_, i, {}, &Term::generator);
    if (term == terms_.end() || term->generator != i) return from_int<S>(0);
    S coefficient = std::move(term->coefficient);
    terms_.erase(term);
    return coefficient;
  }

  /// Applies combine(y_i, x_i) to the coefficients of every generator of x, where y is this form.
  template <class Combine>
  void merge(const Form& x, Combine combine) {
    insert_generators_of(x);
    auto y = terms_.begin();
    for (const Term& term : x.terms_) {
      while (y->generator != term.generator) ++y;
      combine(y->coefficient, term.coefficient);
    }
    drop_zeros();
  }

  /// Applies change(y_i) to every coefficient.
  template <class Change>
  void transform(Change change) {
    for (Term& term : terms_) change(term.coefficient);
    drop_zeros();
  }

 private:
  void drop_zeros() {
    std::erase_if(terms_, [](const Term& term) { return definitely(is_zero(term.coefficient)); });
  }

  /// Gives this form a term, with coefficient zero where it is new, for every generator of x. The terms move from the
  /// back, each at most once.
  void insert_generators_of(const Form& x) {
    std::size_t missing = 0;
    auto y = terms_.begin();
    for (const Term& term : x.terms_) {
      while (y != terms_.end() && y->generator < term.generator) ++y;
      if (y == terms_.end() || y->generator != term.generator) ++missing;
    }
    if (missing == 0) return;

    std::size_t from = terms_.size();
    terms_.resize(from + missing);
    std::size_t to = terms_.size();
    std::size_t next = x.terms_.size();
    while (to != from) {
      const int generator = x.terms_[next - 1].generator;
      if (from != 0 && terms_[from - 1].generator >= generator) {
        if (terms_[from - 1].generator == generator) --next;
        terms_[--to] = std::move(terms_[--from]);
      } else {
        terms_[--to] = {generator, from_int<S>(0)};
        --next;
      }
    }
  }

  std::vector<Term> terms_;
};

template <class S>
void add(Form<S>& y, const Form<S>& x) {
  y.merge(x, [](S& yi, const S& xi) { yi += xi; });
}

template <class S>
void subtract(Form<S>& y, const Form<S>& x) {
  y.merge(x, [](S& yi, const S& xi) { yi -= xi; });
}

template <class S>
void add_scaled(Form<S>& y, const std::type_identity_t<S>& a, const Form<S>& x) {
  if (definitely(is_zero(a))) return;
  y.merge(x, [&a](S& yi, const S& xi) { add_product(yi, a, xi); });
}

template <class S>
void scale(Form<S>& y, const std::type_identity_t<S>& a) {
  y.transform([&a](S& yi) { yi *= a; });
}

/// y /= a. Throws DivisionByZero for a known zero in an exact field, for every y.
template <class S>
void divide(Form<S>& y, const std::type_identity_t<S>& a) {
  if (ScalarTraits<S>::prefers_reciprocal || y.terms().empty()) {
    scale(y, from_int<S>(1) / a);
  } else {
    y.transform([&a](S& yi) { yi /= a; });
  }
}

template <class S>
struct PointTraits<Form<S>> {
  using Scalar = S;
  static Form<S> zero() { return {}; }
};

}  // namespace torse
