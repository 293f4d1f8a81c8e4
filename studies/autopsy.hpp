// Where the digits of a computation are lost.
//   Loss               what one operation does
//   Outcome            a result, and what its error is made of
//   Autopsy, examine   of a record
//   autopsy_of         a construction or the determinants of a surface, by the library's own code
#pragma once

#include <string>
#include <vector>

#include "torse/exact/instrumented/shadow.hpp"
#include "torse/io/construct_file.hpp"

namespace torse::studies {

/// One operation of a record.
struct Loss {
  FormulaPlace place;
  std::string coordinate;  ///< "x", "y", "z" or "w" where all its inputs are of one; else empty
  char kind = '+';
  std::string expression;  ///< in terms of the inputs
  double digits = 0;       ///< decimal digits by which it is less accurate than its operands
  double cancelled = 0;    ///< of a sum: bits by which it is smaller than the larger operand
  double local = 0;        ///< its own rounding error, relative, in u = 2^-53
  double value = 0;
  double exact = 0;
  double share = 0;  ///< of the error of the worst result that comes from its own rounding, -1 to 1 or so
};

/// A result with its name, such as "d[3].y".
struct Outcome {
  std::string name;
  double value = 0;
  double exact = 0;
  double digits = 0;  ///< correct decimal digits, 0 to 15.95
};

/// What a record shows.
struct Autopsy {
  std::size_t operations = 0;
  Outcome worst;           ///< the result with the fewest correct digits
  std::vector<Loss> lost;  ///< operations that lose a digit or more, the worst first, at most 10
  std::vector<Loss> made;  ///< rounding errors that make up the worst result's, the largest first, at most 10
};

/// A result: its name and the number of its operation.
struct Result {
  std::string name;
  int number;
};

/// Throws InvalidInput naming "results" where there are none.
Autopsy examine(const RecordScope& record, const std::vector<Result>& results);

/// Runs the file's construction in double beside exact numbers: methods bspline, bezier (by `route`, one of the routes
/// from d_0 such as "FJ07.13"), rational, cone, tangent and cylinder with M; for a ruled surface the determinants of
/// FJ07.3 or FJ21.C3.1 whose coefficients decide developability. Throws FileError, and UsageError's base Error for
/// what has no autopsy.
Autopsy autopsy_of(const Document& document, const std::string& route);

}  // namespace torse::studies
