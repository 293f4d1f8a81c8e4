// The switches that tests/mutation/mutate.py writes into a copy of the sources: every mutant is compiled in, none is
// on.
//   on            whether mutant k is the one that runs            (environment: TORSE_MUTANT)
//   trace         which mutants a run has reached                  (environment: TORSE_MUTANT_TRACE)
//   op            an operator and what mutants put in its place    minus, negation   a sign that is there or is not
//   index         a subscript, one more and one less
// No mutant acts in constant evaluation, so that the copy always compiles.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <type_traits>
#include <utility>

namespace torse_mutation {

/// As many mutants as a trace has bytes. mutate.py knows this number too.
inline constexpr unsigned slots = 1U << 20U;

/// Bits of a trace: the mutant was reached, and there it is a valid expression or is none.
inline constexpr unsigned char valid = 1;
inline constexpr unsigned char invalid = 2;

/// The file that takes the trace, shared with every process that the test starts; none unless it is asked for.
inline unsigned char* open_trace() {
  const char* path = std::getenv("TORSE_MUTANT_TRACE");
  if (path == nullptr) return nullptr;
  const int file = ::open(path, O_RDWR);
  if (file < 0) return nullptr;
  void* memory = ::mmap(nullptr, slots, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<unsigned char*>(memory);
}

inline unsigned active_from_environment() {
  const char* text = std::getenv("TORSE_MUTANT");
  return text == nullptr ? slots : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

inline unsigned char* const trace = open_trace();
inline const unsigned active = active_from_environment();

constexpr void reach(unsigned k, unsigned char bit) {
  if (!std::is_constant_evaluated() && trace != nullptr) trace[k] |= bit;
}

constexpr bool on(unsigned k) {
  if (std::is_constant_evaluated()) return false;
  reach(k, valid);
  return k == active;
}

#define TORSE_MUTATION_BINARY(name, symbol)                                                            \
  struct name {                                                                                        \
    template <class A, class B>                                                                        \
    static constexpr auto of(A&& a, B&& b) -> decltype(std::forward<A>(a) symbol std::forward<B>(b)) { \
      return std::forward<A>(a) symbol std::forward<B>(b);                                             \
    }                                                                                                  \
  };
TORSE_MUTATION_BINARY(add, +)
TORSE_MUTATION_BINARY(sub, -)
TORSE_MUTATION_BINARY(mul, *)
TORSE_MUTATION_BINARY(div, /)
TORSE_MUTATION_BINARY(mod, %)
TORSE_MUTATION_BINARY(lt, <)
TORSE_MUTATION_BINARY(le, <=)
TORSE_MUTATION_BINARY(gt, >)
TORSE_MUTATION_BINARY(ge, >=)
TORSE_MUTATION_BINARY(eq, ==)
TORSE_MUTATION_BINARY(ne, !=)
TORSE_MUTATION_BINARY(both, &)
TORSE_MUTATION_BINARY(either, |)
TORSE_MUTATION_BINARY(add_to, +=)
TORSE_MUTATION_BINARY(sub_from, -=)
TORSE_MUTATION_BINARY(mul_by, *=)
TORSE_MUTATION_BINARY(div_by, /=)
#undef TORSE_MUTATION_BINARY

struct first {
  template <class A, class B>
  static constexpr auto of(A&& a, B&&) -> decltype(std::forward<A>(a)) {
    return std::forward<A>(a);
  }
};
struct second {
  template <class A, class B>
  static constexpr auto of(A&&, B&& b) -> decltype(std::forward<B>(b)) {
    return std::forward<B>(b);
  }
};

/// Expressions of Eigen are evaluated, so that the original and the mutant are of one type.
template <class T>
struct Plain {
  using type = T;
};
template <class T>
requires(!std::is_reference_v<T>) && requires { typename T::PlainObject; }
struct Plain<T> {
  using type = typename T::PlainObject;
};

template <class Op, class A, class B>
using Result = typename Plain<decltype(Op::of(std::declval<A>(), std::declval<B>()))>::type;

/// Operator Op in the place of another, as mutant k.
template <class Op>
struct Instead {
  unsigned k;
};

template <class Op, class A, class B>
constexpr auto op(A&& a, B&& b) -> Result<Op, A, B> {
  return Op::of(std::forward<A>(a), std::forward<B>(b));
}

/// a Op b, or what the first mutant that is on puts in its place.
template <class Op, class A, class B, class Other, class... Rest>
constexpr auto op(A&& a, B&& b, Instead<Other> mutant, Rest... rest) -> Result<Op, A, B> {
  if constexpr (requires { static_cast<Result<Op, A, B>>(Other::of(std::forward<A>(a), std::forward<B>(b))); }) {
    if (on(mutant.k)) return static_cast<Result<Op, A, B>>(Other::of(std::forward<A>(a), std::forward<B>(b)));
  } else {
    reach(mutant.k, invalid);
  }
  return op<Op>(std::forward<A>(a), std::forward<B>(b), rest...);
}

/// -a, or a as mutant k.
template <class A>
constexpr auto minus(A&& a, unsigned k) {
  using Value = typename Plain<decltype(-std::forward<A>(a))>::type;
  return on(k) ? static_cast<Value>(a) : static_cast<Value>(-std::forward<A>(a));
}

/// !a, or a as mutant k.
template <class A>
constexpr auto negation(A&& a, unsigned k) -> decltype(!std::forward<A>(a)) {
  using Value = decltype(!std::forward<A>(a));
  return on(k) ? static_cast<Value>(a) : static_cast<Value>(!std::forward<A>(a));
}

/// The place i of a subscript, i + 1 or i - 1; keys that are no integers are left alone.
template <class I>
constexpr decltype(auto) index(I&& i, unsigned more, unsigned less) {
  using Value = std::remove_cvref_t<I>;
  if constexpr (std::is_integral_v<Value>) {
    return static_cast<Value>(on(more) ? i + 1 : on(less) ? i - 1 : i);
  } else {
    reach(more, invalid);
    reach(less, invalid);
    return std::forward<I>(i);
  }
}

}  // namespace torse_mutation
