// Reads a problem a line and prints the answer of the library's templates with exact rationals, or with running errors:
// the other side of main.ml.
#include <iostream>
#include <stdexcept>
#include <string>

#include "torse/proofs/coq/compare/tables.hpp"

namespace torse::compare {
namespace {

std::string solve(const std::string& line) {
  const Problem problem(line);
  try {
    for (const Table* table : {&over_knots(), &of_rulings(), &of_mappings(), &of_polynomials(), &of_one_piece(),
                               &of_changes(), &of_directrices(), &of_surfaces(), &of_running()}) {
      if (const auto found = table->find(problem.name()); found != table->end()) return found->second(problem).text();
    }
    throw std::out_of_range(problem.name());
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
