// The method of BZZ19 as the paper describes it: the baseline that our own is measured against.
//   PaperOptions        samples, weights, when to stop
//   PaperFit            the mapping and how the minimisation went
//   paper_fit           a continuous mapping (BZZ19.2 to 9)
//   discrete_fit        the discrete mapping method (section 3.1)
#pragma once

#include <string>
#include <vector>

#include "torse/quasi/mapping.hpp"
#include "torse/quasi/search.hpp"

namespace torse::quasi {

/// The paper's values.
struct PaperOptions {
  std::size_t samples = 100;   ///< t_i, evenly spread with both ends
  double energy_weight = 100;  ///< lambda_1
  double normal_weight = 1;    ///< lambda_2
  double end_weight = 1000;    ///< of the squared distances of the end points, for fixed ends
  Ends ends = Ends::fixed;
  double gradient = 1e-7;  ///< stop where the gradient is that small, absolutely or relative to the variables
  double change = 1e-10;   ///< or where ten steps change the objective by less, absolutely and relatively
  int most_steps = 2000;
  bool check_gradient = false;  ///< fill `gradient_error`
};

/// One step of the minimisation.
struct PaperStep {
  double objective;
  double seconds;  ///< since the start
};

/// The best point that was met. Line searches can run into non-finite values or fail; the point so far is kept.
struct PaperFit {
  std::vector<double> beta;  ///< the mapping's coefficients, which the literal formula may leave beyond 1
  double objective = 0;      ///< (BZZ19.9)
  std::string stop;          ///< why the minimisation ended, in words
  bool converged = false;
  int steps = 0;
  int evaluations = 0;
  double gradient_error = 0;  ///< largest difference of the gradient from central differences, near the start, relative
  std::vector<PaperStep> curve;
};

/// Minimises 100 sum E2(t_i) + sum (|N_i|^2 - 1)^2 (BZZ19.9), for fixed ends with 1000 times the squared distances of
/// C2(sigma(0)), C2(sigma(1)) from their places, over the steps eps_j (BZZ19.5) and the normals N_i, by L-BFGS with the
/// analytic gradient, from sigma(t) = t and the normals that fit best there. With eps_0 = 0 at the start sigma(0) = 0
/// for good: the objective is even in eps_0. Throws InvalidInput naming "samples" for less than 2.
PaperFit paper_fit(const Rails& rails, const KnotList<double>& knots, const PaperOptions& options = {});

/// The same for the values T_i = sigma(t_i) themselves (BZZ19.1): as many rulings as samples. The mapping that follows
/// them is the polyline through the points (t_i, T_i): `beta` are the T_i.
PaperFit discrete_fit(const Rails& rails, const PaperOptions& options = {});

}  // namespace torse::quasi
