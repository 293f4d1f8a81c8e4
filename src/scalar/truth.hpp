// Three-valued answers: a zero test on a ball or on a batch of prime-field lanes may be undecided.
//   Truth            no, unknown, yes
//   !, &, |          Kleene's logic
//   definitely       yes only      possibly   not no
#pragma once

namespace torse {

/// The answer of a predicate that an arithmetic may be unable to decide. It does not convert to bool: `if (truth)`
/// does not compile, a caller says what `unknown` means by `definitely` or `possibly`.
enum class Truth : signed char { no = -1, unknown = 0, yes = 1 };

/// True only for a decided yes.
constexpr bool definitely(Truth t) { return t == Truth::yes; }

/// True unless the answer is a decided no.
constexpr bool possibly(Truth t) { return t != Truth::no; }

/// A decided answer as a Truth.
constexpr Truth truth(bool b) { return b ? Truth::yes : Truth::no; }

constexpr Truth operator!(Truth t) { return static_cast<Truth>(-static_cast<signed char>(t)); }
constexpr Truth operator&(Truth a, Truth b) { return a < b ? a : b; }
constexpr Truth operator|(Truth a, Truth b) { return a < b ? b : a; }

}  // namespace torse
