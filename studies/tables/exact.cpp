// The routes over the rationals, and their list.
#include "torse/studies/route_table.hpp"
#include "torse/studies/tables.hpp"

namespace torse::studies {

Computed run_exact(std::size_t route, const Case& in) { return run_in<Rational>(route, in); }

const std::vector<RouteInfo>& route_infos() {
  static const std::vector<RouteInfo> infos = [] {
    std::vector<RouteInfo> list;
    for (const Route<Rational>& route : route_table<Rational>()) list.push_back(route.info);
    return list;
  }();
  return infos;
}

}  // namespace torse::studies
