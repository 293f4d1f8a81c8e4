// The errors the library throws. Each says what was wrong and, where there is one, the place in the input.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace torse {

/// Base of every error thrown by torse.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A division by an element that is known to be zero.
class DivisionByZero : public Error {
 public:
  DivisionByZero() : Error("division by zero") {}
  using Error::Error;
};

/// An input that no formula applies to: sizes that do not match, a parameter at a knot, a zero weight ...
/// `place` names the member, as "knots[3]" or "Lambda"; `what()` is "place: reason".
class InvalidInput : public Error {
 public:
  InvalidInput(std::string place, const std::string& reason) : Error(place + ": " + reason), place_(std::move(place)) {}

  /// The member of the input that is wrong.
  const std::string& place() const { return place_; }

 private:
  std::string place_;
};

/// A step that an arithmetic cannot decide, such as choosing a pivot among balls that all contain zero.
class Undecided : public Error {
 public:
  using Error::Error;
};

}  // namespace torse
