// Random straight-line programs, run by several arithmetics on the same inputs.
#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "torse/exact/rational/cpp_rational.hpp"

namespace torse::test {

/// Steps on a growing list of values: the inputs, then the constants 0..3, then each step's result.
struct Program {
  struct Step {
    char operation;
    std::size_t left;
    std::size_t right;
  };

  /// All values of the program, the inputs first.
  template <class S>
  std::vector<S> run(std::vector<S> values) const {
    for (int i = 0; i <= 3; ++i) values.push_back(from_int<S>(i));
    for (const Step& step : steps) {
      const S& x = values[step.left];
      const S& y = values[step.right];
      switch (step.operation) {
        case '+':
          values.push_back(x + y);
          break;
        case '-':
          values.push_back(x - y);
          break;
        case '*':
          values.push_back(x * y);
          break;
        default:
          values.push_back(x / y);
          break;
      }
    }
    return values;
  }

  std::vector<Step> steps;
};

inline CppRational random_rational(std::mt19937_64& random) {
  std::uniform_int_distribution<int> numerator(-99, 99);
  std::uniform_int_distribution<int> denominator(1, 99);
  return ratio<CppRational>(numerator(random), denominator(random));
}

inline std::vector<CppRational> random_point(std::mt19937_64& random, std::size_t size) {
  std::vector<CppRational> point;
  for (std::size_t i = 0; i < size; ++i) point.push_back(random_rational(random));
  return point;
}

inline std::vector<std::string> texts(const std::vector<CppRational>& values) {
  std::vector<std::string> result;
  for (const CppRational& value : values) result.push_back(value.text());
  return result;
}

/// A program of the given operations that divides only by what is not zero at one random point.
inline Program random_program(std::mt19937_64& random, std::size_t inputs, int length, const std::string& operations) {
  Program program;
  const std::vector<CppRational> point = random_point(random, inputs);
  for (int i = 0; i < length; ++i) {
    const std::vector<CppRational> values = program.run(point);
    std::uniform_int_distribution<std::size_t> pick(0, values.size() - 1);
    std::uniform_int_distribution<std::size_t> kind(0, operations.size() - 1);
    Program::Step step{operations[kind(random)], pick(random), pick(random)};
    if (step.operation == '/' && values[step.right].sign() == 0) step.operation = '+';
    program.steps.push_back(step);
  }
  return program;
}

}  // namespace torse::test
