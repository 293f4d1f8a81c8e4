// Q(x_1, ..., x_m) through FLINT: a constant is held as an fmpq, everything else as a reduced fmpz_mpoly_q. Keeping the
// two apart makes 0, 1 and small ratios free of polynomial work and lets a constant belong to every context.
#include "torse/exact/symbolic/rational_function.hpp"

#include <cstring>

#include "torse/exact/symbolic/flint_headers.hpp"
#include "torse/exact/symbolic/simple_fraction.hpp"
#include "torse/scalar/errors.hpp"

namespace torse {

struct SymbolicContext::Ring {
  explicit Ring(std::size_t variables) { fmpz_mpoly_ctx_init(polynomials, static_cast<slong>(variables), ORD_LEX); }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;
  ~Ring() { fmpz_mpoly_ctx_clear(polynomials); }

  fmpz_mpoly_ctx_t polynomials;
};

/// Typed views of the storage. `Pair` is the C library's fmpz_mpoly_q.
struct RationalFunction::Access {
  using Pair = fmpz_mpoly_q_struct;
  static_assert(sizeof(Pair) <= sizeof(storage_) && alignof(Pair) <= 8 && sizeof(fmpq) <= sizeof(storage_));

  static Pair* pair(RationalFunction& x) { return reinterpret_cast<Pair*>(x.storage_); }
  static const Pair* pair(const RationalFunction& x) { return reinterpret_cast<const Pair*>(x.storage_); }
  static fmpq* number(RationalFunction& x) { return reinterpret_cast<fmpq*>(x.storage_); }
  static const fmpq* number(const RationalFunction& x) { return reinterpret_cast<const fmpq*>(x.storage_); }
  static const fmpz_mpoly_ctx_struct* ring(const SymbolicContext* context) { return context->ring_->polynomials; }
  static const fmpz_mpoly_ctx_struct* ring(const RationalFunction& x) { return ring(x.context_); }

  /// The context of a result of x and y, at least one of which is not a constant.
  static const SymbolicContext* common(const RationalFunction& x, const RationalFunction& y) {
    if (x.context_ == nullptr) return y.context_;
    if (y.context_ != nullptr && x.context_ != y.context_) {
      throw InvalidInput("RationalFunction", "the operands belong to two different contexts");
    }
    return x.context_;
  }

  /// z = what `compute(pair, ring)` writes; z may be an operand of the computation.
  template <class Compute>
  static RationalFunction& assign(RationalFunction& z, const SymbolicContext* context, Compute&& compute) {
    if (z.context_ != context) {
      RationalFunction fresh;
      fresh.context_ = context;
      fmpz_mpoly_q_init(pair(fresh), ring(context));
      assign(fresh, context, compute);
      return z = std::move(fresh);
    }
    compute(pair(z), ring(context));
    if (fmpz_mpoly_q_is_fmpq(pair(z), ring(context))) demote(z);
    return z;
  }

  static void multiply(Pair* z, const Pair* x, const Pair* y, const fmpz_mpoly_ctx_struct* ring) {
    if (is_simple(y, ring)) {
      detail::multiply_by_simple(z, x, &y->num, &y->den, ring);
    } else if (is_simple(x, ring)) {
      detail::multiply_by_simple(z, y, &x->num, &x->den, ring);
    } else {
      fmpz_mpoly_q_mul(z, x, y, ring);
    }
  }

  static void divide(Pair* z, const Pair* x, const Pair* y, const fmpz_mpoly_ctx_struct* ring) {
    if (is_simple(y, ring)) {
      detail::multiply_by_simple(z, x, &y->den, &y->num, ring);
    } else {
      fmpz_mpoly_q_div(z, x, y, ring);
    }
  }

  static bool is_simple(const Pair* x, const fmpz_mpoly_ctx_struct* ring) {
    return detail::is_simple(&x->num, ring) && detail::is_simple(&x->den, ring);
  }

  /// A pair that holds a constant becomes a number.
  static void demote(RationalFunction& z) {
    fmpq_t value;
    fmpq_init(value);
    fmpz_mpoly_get_fmpz(fmpq_numref(value), fmpz_mpoly_q_numref(pair(z)), ring(z));
    fmpz_mpoly_get_fmpz(fmpq_denref(value), fmpz_mpoly_q_denref(pair(z)), ring(z));
    fmpz_mpoly_q_clear(pair(z), ring(z));
    z.context_ = nullptr;
    *number(z) = *value;
  }

  /// The value of a polynomial at rational numbers.
  static void evaluate(fmpq_t value, const fmpz_mpoly_struct& polynomial, const fmpz_mpoly_ctx_struct* ring,
                       fmpq* const* point) {
    fmpq_mpoly_struct view{};
    fmpq_init(view.content);
    fmpq_one(view.content);
    *view.zpoly = polynomial;
    fmpq_mpoly_ctx_struct view_ring{};
    *view_ring.zctx = *ring;
    fmpq_mpoly_evaluate_all_fmpq(value, &view, point, &view_ring);
  }

  /// The least k >= 0 with |i| <= 2^k.
  static std::int64_t bits_above(const fmpz_t i) {
    fmpz_t below;
    fmpz_init(below);
    fmpz_abs(below, i);
    if (!fmpz_is_zero(below)) fmpz_sub_ui(below, below, 1);
    const flint_bitcnt_t bits = fmpz_bits(below);
    fmpz_clear(below);
    return static_cast<std::int64_t>(bits);
  }

  /// The least k >= 0 with |polynomial| <= 2^k.
  static std::int64_t norm_bits(const fmpz_mpoly_struct& polynomial) {
    fmpz_t norm;
    fmpz_init(norm);
    for (slong i = 0; i < polynomial.length; ++i) {
      if (fmpz_sgn(polynomial.coeffs + i) > 0) {
        fmpz_add(norm, norm, polynomial.coeffs + i);
      } else {
        fmpz_sub(norm, norm, polynomial.coeffs + i);
      }
    }
    const std::int64_t bits = bits_above(norm);
    fmpz_clear(norm);
    return bits;
  }
};

namespace {

/// An array of rationals that FLINT owns.
class Numbers {
 public:
  explicit Numbers(std::size_t size) : values_(size), pointers_(size) {
    for (std::size_t i = 0; i < size; ++i) {
      fmpq_init(&values_[i]);
      pointers_[i] = &values_[i];
    }
  }
  Numbers(const Numbers&) = delete;
  Numbers& operator=(const Numbers&) = delete;
  ~Numbers() {
    for (fmpq& value : values_) fmpq_clear(&value);
  }
  fmpq* operator[](std::size_t i) { return pointers_[i]; }
  fmpq* const* data() const { return pointers_.data(); }

 private:
  std::vector<fmpq> values_;
  std::vector<fmpq*> pointers_;
};

/// The C string as a std::string, freed.
std::string adopt(char* text) {
  std::string result(text);
  flint_free(text);
  return result;
}

}  // namespace

SymbolicContext::SymbolicContext(std::vector<std::string> names) : names_(std::move(names)) {
  if (names_.empty()) throw InvalidInput("names", "a field of rational functions needs an indeterminate");
  ring_ = std::make_unique<Ring>(names_.size());
}

SymbolicContext::~SymbolicContext() = default;

RationalFunction SymbolicContext::variable(int i) const {
  static_cast<void>(name(i));
  RationalFunction x;
  return RationalFunction::Access::assign(
      x, this, [i](fmpz_mpoly_q_struct* z, const fmpz_mpoly_ctx_struct* ring) { fmpz_mpoly_q_gen(z, i, ring); });
}

RationalFunction::RationalFunction(const RationalFunction& x) : context_(x.context_) {
  if (context_ == nullptr) {
    fmpq_init(Access::number(*this));
    fmpq_set(Access::number(*this), Access::number(x));
  } else {
    fmpz_mpoly_q_init(Access::pair(*this), Access::ring(*this));
    fmpz_mpoly_q_set(Access::pair(*this), Access::pair(x), Access::ring(*this));
  }
}

RationalFunction& RationalFunction::operator=(const RationalFunction& x) {
  if (this == &x) return *this;
  if (context_ != x.context_) return *this = RationalFunction(x);
  if (context_ == nullptr) {
    fmpq_set(Access::number(*this), Access::number(x));
  } else {
    fmpz_mpoly_q_set(Access::pair(*this), Access::pair(x), Access::ring(*this));
  }
  return *this;
}

void RationalFunction::construct() { fmpq_init(Access::number(*this)); }

void RationalFunction::construct(std::int64_t i) {
  construct();
  fmpq_set_si(Access::number(*this), i, 1);
}

void RationalFunction::construct(std::uint64_t i) {
  construct();
  fmpq_set_ui(Access::number(*this), i, 1);
}

void RationalFunction::release() noexcept {
  if (context_ == nullptr) {
    fmpq_clear(Access::number(*this));
  } else {
    fmpz_mpoly_q_clear(Access::pair(*this), Access::ring(*this));
  }
}

void RationalFunction::take(RationalFunction& x) noexcept {
  context_ = std::exchange(x.context_, nullptr);
  std::memcpy(storage_, x.storage_, sizeof storage_);
  x.construct();
}

void RationalFunction::negate() {
  if (context_ == nullptr) {
    fmpq_neg(Access::number(*this), Access::number(*this));
  } else {
    fmpz_mpoly_q_neg(Access::pair(*this), Access::pair(*this), Access::ring(*this));
  }
}

bool RationalFunction::equals(const RationalFunction& x) const {
  if (context_ != x.context_) return false;
  if (context_ == nullptr) return fmpq_equal(Access::number(*this), Access::number(x)) != 0;
  return fmpz_mpoly_q_equal(Access::pair(*this), Access::pair(x), Access::ring(*this)) != 0;
}

RationalFunction& RationalFunction::set_sum(const RationalFunction& x, const RationalFunction& y) {
  using A = Access;
  if (x.context_ == nullptr && y.context_ == nullptr) {
    fmpq_add(A::number(*this), A::number(x), A::number(y));
    return *this;
  }
  if (x.is_zero()) return *this = y;
  if (y.is_zero()) return *this = x;
  return A::assign(*this, A::common(x, y), [&](A::Pair* z, const fmpz_mpoly_ctx_struct* ring) {
    if (x.context_ == nullptr) {
      fmpz_mpoly_q_add_fmpq(z, A::pair(y), A::number(x), ring);
    } else if (y.context_ == nullptr) {
      fmpz_mpoly_q_add_fmpq(z, A::pair(x), A::number(y), ring);
    } else {
      fmpz_mpoly_q_add(z, A::pair(x), A::pair(y), ring);
    }
  });
}

RationalFunction& RationalFunction::set_difference(const RationalFunction& x, const RationalFunction& y) {
  using A = Access;
  if (x.context_ == nullptr && y.context_ == nullptr) {
    fmpq_sub(A::number(*this), A::number(x), A::number(y));
    return *this;
  }
  if (x.is_zero()) return *this = -y;
  if (y.is_zero()) return *this = x;
  return A::assign(*this, A::common(x, y), [&](A::Pair* z, const fmpz_mpoly_ctx_struct* ring) {
    if (x.context_ == nullptr) {
      fmpz_mpoly_q_sub_fmpq(z, A::pair(y), A::number(x), ring);
      fmpz_mpoly_q_neg(z, z, ring);
    } else if (y.context_ == nullptr) {
      fmpz_mpoly_q_sub_fmpq(z, A::pair(x), A::number(y), ring);
    } else {
      fmpz_mpoly_q_sub(z, A::pair(x), A::pair(y), ring);
    }
  });
}

RationalFunction& RationalFunction::set_product(const RationalFunction& x, const RationalFunction& y) {
  using A = Access;
  if (x.context_ == nullptr && y.context_ == nullptr) {
    fmpq_mul(A::number(*this), A::number(x), A::number(y));
    return *this;
  }
  if (x.is_zero() || y.is_zero()) return *this = RationalFunction();
  return A::assign(*this, A::common(x, y), [&](A::Pair* z, const fmpz_mpoly_ctx_struct* ring) {
    if (x.context_ == nullptr) {
      fmpz_mpoly_q_mul_fmpq(z, A::pair(y), A::number(x), ring);
    } else if (y.context_ == nullptr) {
      fmpz_mpoly_q_mul_fmpq(z, A::pair(x), A::number(y), ring);
    } else {
      A::multiply(z, A::pair(x), A::pair(y), ring);
    }
  });
}

RationalFunction& RationalFunction::set_quotient(const RationalFunction& x, const RationalFunction& y) {
  using A = Access;
  if (y.is_zero()) throw DivisionByZero();
  if (x.context_ == nullptr && y.context_ == nullptr) {
    fmpq_div(A::number(*this), A::number(x), A::number(y));
    return *this;
  }
  if (x.is_zero()) return *this = RationalFunction();
  return A::assign(*this, A::common(x, y), [&](A::Pair* z, const fmpz_mpoly_ctx_struct* ring) {
    if (x.context_ == nullptr) {
      fmpz_mpoly_q_inv(z, A::pair(y), ring);
      fmpz_mpoly_q_mul_fmpq(z, z, A::number(x), ring);
    } else if (y.context_ == nullptr) {
      fmpz_mpoly_q_div_fmpq(z, A::pair(x), A::number(y), ring);
    } else {
      A::divide(z, A::pair(x), A::pair(y), ring);
    }
  });
}

bool RationalFunction::is_zero() const { return context_ == nullptr && fmpq_is_zero(Access::number(*this)) != 0; }

std::int64_t RationalFunction::length() const {
  if (context_ == nullptr) return is_zero() ? 1 : 2;
  return Access::pair(*this)->num.length + Access::pair(*this)->den.length;
}

Shape RationalFunction::shape() const {
  if (context_ == nullptr) {
    const fmpq* q = Access::number(*this);
    return {0, 0, Access::bits_above(&q->num), Access::bits_above(&q->den)};
  }
  const Access::Pair* q = Access::pair(*this);
  return {fmpz_mpoly_total_degree_si(&q->num, Access::ring(*this)),
          fmpz_mpoly_total_degree_si(&q->den, Access::ring(*this)), Access::norm_bits(q->num),
          Access::norm_bits(q->den)};
}

std::string RationalFunction::evaluate(const std::vector<std::string>& point) const {
  if (context_ == nullptr) return text();
  if (point.size() != static_cast<std::size_t>(context_->size())) {
    throw InvalidInput("point", "one value is needed for each indeterminate");
  }
  Numbers at(point.size());
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (fmpq_set_str(at[i], point[i].c_str(), 10) != 0 || fmpz_is_zero(fmpq_denref(at[i]))) {
      throw InvalidInput("point[" + std::to_string(i) + "]", "'" + point[i] + "' is not a rational number");
    }
    fmpq_canonicalise(at[i]);
  }
  Numbers value(2);
  Access::evaluate(value[0], Access::pair(*this)->num, Access::ring(*this), at.data());
  Access::evaluate(value[1], Access::pair(*this)->den, Access::ring(*this), at.data());
  if (fmpq_is_zero(value[1])) throw DivisionByZero();
  fmpq_div(value[0], value[0], value[1]);
  return adopt(fmpq_get_str(nullptr, 10, value[0]));
}

std::string RationalFunction::text() const {
  if (context_ == nullptr) return adopt(fmpq_get_str(nullptr, 10, Access::number(*this)));
  std::vector<const char*> names;
  for (const std::string& name : context_->names_) names.push_back(name.c_str());
  const auto polynomial = [&](const fmpz_mpoly_struct& p) {
    return adopt(fmpz_mpoly_get_str_pretty(&p, names.data(), Access::ring(*this)));
  };
  const Access::Pair* q = Access::pair(*this);
  if (fmpz_mpoly_is_one(&q->den, Access::ring(*this))) return polynomial(q->num);
  return "(" + polynomial(q->num) + ")/(" + polynomial(q->den) + ")";
}

}  // namespace torse
