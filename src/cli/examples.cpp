// The worked examples for other programs and for the page.
#include "torse/cli/examples.hpp"

#include "torse/cli/surface_picture.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/exact/rational/rational.hpp"

namespace torse::cli {

using Json = nlohmann::ordered_json;

Json examples_json(const std::vector<proofs::ExampleRow>& rows) {
  Json values = Json::array();
  for (const proofs::ExampleRow& row : rows) {
    values.push_back({{"group", row.group},
                      {"label", row.label},
                      {"printed", row.printed},
                      {"computed", row.computed},
                      {"equal", row.equal}});
  }
  return {{"torse", 1}, {"examples", {{{"id", "FJ21.E8"}, {"source", "FJ21, section 8"}, {"values", values}}}}};
}

Json examples_section() {
  const proofs::Section8Net<Rational> net{proofs::Section8Data<Rational>{}};
  const RuledFile<Rational> surface{net.u, dehomogenize<Rational, 4>(net.p), dehomogenize<Rational, 4>(net.q)};
  return {{"kind", "examples"},
          {"data", examples_json(proofs::section8_rows<Rational>())},
          {"pictures", {surface_picture("FJ21, section 8", surface, known_of(surface, SurfaceClass::tangent), 121)}}};
}

}  // namespace torse::cli
