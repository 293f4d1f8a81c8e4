#include "torse/studies/routes.hpp"

#include <limits>

#include "torse/scalar/errors.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {
namespace {

const std::vector<Arithmetic>& arithmetics() {
  static const std::vector<Arithmetic> list{
      {"float", std::numeric_limits<float>::digits, run_float},
      {"double", std::numeric_limits<double>::digits, run_double},
      {"long double", std::numeric_limits<long double>::digits, run_long_double},
      {"float128", 113, run_float128},
      {"mpfr53", 53, run_mpfr53},
      {"mpfr113", 113, run_mpfr113},
      {"mpfr200", 200, run_mpfr200},
      {"exact", 0, run_exact},
  };
  return list;
}

}  // namespace

std::vector<std::string> route_names() {
  std::vector<std::string> names;
  for (const RouteInfo& info : route_infos()) names.push_back(info.name);
  return names;
}

std::vector<std::string> scalar_names() {
  std::vector<std::string> names;
  for (const Arithmetic& scalar : arithmetics()) {
    if (scalar.precision > 0) names.push_back(scalar.name);
  }
  return names;
}

const Arithmetic& arithmetic(const std::string& name) {
  for (const Arithmetic& scalar : arithmetics()) {
    if (scalar.name == name) return scalar;
  }
  throw Error("no arithmetic has the name " + name);
}

}  // namespace torse::studies
