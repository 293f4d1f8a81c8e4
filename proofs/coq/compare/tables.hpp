// The functions of the comparison by name.
//   Function, Table           from a problem to the answer of the library, by name
//   over_knots, of_rulings, of_mappings, of_polynomials, of_one_piece, of_changes, of_directrices,
//   of_surfaces, of_running   all of them
#pragma once

#include <map>
#include <string>

#include "torse/proofs/coq/compare/problem.hpp"

namespace torse::compare {

using Function = Answer (*)(const Problem&);
using Table = std::map<std::string, Function>;

/// The functions of splines, of their pieces and cells.
const Table& over_knots();
/// Interpolation between rulings, and the rows of all pieces.
const Table& of_rulings();
/// Mappings, and the warp of a ruling.
const Table& of_mappings();
/// Composition, and polynomials in their two forms.
const Table& of_polynomials();
/// The functions of Bezier polygons, and those at one parameter.
const Table& of_one_piece();
/// Those of FJ21 that change the functions Lam, M, sigma, and the edge of regression.
const Table& of_changes();
/// The rulings of a directrix, ZW06.
const Table& of_directrices();
/// Splines over more knots and of a higher degree, the conditions of BZZ19 and its surface.
const Table& of_surfaces();
/// Running error analysis of doubles.
const Table& of_running();

}  // namespace torse::compare
