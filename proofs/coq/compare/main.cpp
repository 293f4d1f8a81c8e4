// Reads a problem a line and prints the answer of the library's templates with exact rationals: the other side of
// main.ml.
#include <iostream>

#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

std::string solve(const std::string& line) {
  const Problem problem(line);
  try {
    const Table& table = over_knots().contains(problem.name()) ? over_knots() : of_one_piece();
    return table.at(problem.name())(problem).text();
  } catch (const InvalidInput& e) {
    return "error " + e.place();
  } catch (const DivisionByZero&) {
    return "error division";
  }
}

}  // namespace
}  // namespace torse::compare

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << torse::compare::solve(line) << '\n';
}
