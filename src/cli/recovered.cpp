// JSON and words for recovered functions.
#include "torse/cli/recovered.hpp"
#include "torse/exact/decide/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "torse/cli/function_report.hpp"
#include "torse/cli/surface_report.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;
using Piece = PieceFunctions<Rational>;
using Edge = EdgeOfRegression<Rational>;
using Function = RationalFunctionOfT;

/// As many lines of functions as a person reads; --json has all.
constexpr std::size_t most_lines = 12;

/// With so many bits in a cubic net, the recovery takes some seconds and a third of a gigabyte.
constexpr std::size_t most_bits = std::size_t{1} << 21;

/// Why Lam, M or sigma is missing, or none.
std::optional<std::string> excluded_case(const Piece& f) {
  if (f.sweep == Sweep::curve) return "c = d: no surface, no function is unique";
  if (f.sweep == Sweep::line) return "all rulings lie on one line: no surface, no function is unique";
  if (f.c_is_a_point()) return "c is one point: M does not exist";
  if (f.d_is_a_point()) return "d is one point: Lambda and sigma do not exist";
  if (f.lambda_infinite() && f.m_infinite()) {
    return "lambda_0 + lambda_1 = 0 and mu_0 + mu_1 = 0: Lambda and M are at infinity, sigma has no value";
  }
  if (f.lambda_infinite()) return "lambda_0 + lambda_1 = 0: Lambda and sigma are at infinity";
  if (f.m_infinite()) return "mu_0 + mu_1 = 0: M is at infinity, sigma is 0";
  return std::nullopt;
}

Json polynomials_json(const std::vector<RationalPolynomial>& list) {
  Json json = Json::array();
  for (const RationalPolynomial& f : integer_coefficients(list)) json.push_back(coefficients_json(f));
  return json;
}

Json edge_json(const std::optional<Edge>& edge) {
  if (!edge) return nullptr;
  return {{"degree", edge->degree},
          {"v", function_json(edge->v)},
          {"row", polynomials_json({edge->row.begin(), edge->row.end()})}};
}

Json patch_json(const RecoveredSpan& span) {
  if (!span.edge) return nullptr;
  const std::optional<ConstantPatch<Rational>> patch = constant_patch(span.piece, *span.edge);
  if (!patch) return nullptr;
  const RuledFile<Rational> surface{bezier_knots<Rational>(span.edge->degree - 1, span.piece.begin, span.piece.end),
                                    dehomogenize<Rational, 4>(patch->p), dehomogenize<Rational, 4>(patch->q)};
  return {{"Lambda", patch->lambda.text()},
          {"M", patch->m.text()},
          {"sigma", "1"},
          {"surface", Json::parse(write_ruled(surface))}};
}

Json span_json(const RecoveredSpan& span) {
  const Piece& f = span.piece;
  const auto frame = f.frame();
  const std::optional<std::string> excluded = excluded_case(f);
  Json json{{"from", f.begin.text()},
            {"to", f.end.text()},
            {"Lambda", function_json(f.lambda())},
            {"M", function_json(f.m())},
            {"sigma", function_json(f.sigma())},
            {"constant", f.constant()},
            {"excluded", excluded ? Json(*excluded) : Json()},
            {"lambda", function_json(frame ? std::optional<Function>(frame->lambda) : std::nullopt)},
            {"mu", function_json(frame ? std::optional<Function>(frame->mu) : std::nullopt)},
            {"nu", function_json(frame ? std::optional<Function>(frame->nu) : std::nullopt)}};
  json["dependence"] = polynomials_json({f.alpha, f.beta, f.gamma, f.delta});
  json["edge"] = edge_json(span.edge);
  json["constant_patch"] = patch_json(span);
  return json;
}

/// The edge of the whole surface; v only where all spans agree. None for a cylinder and where there is no surface.
std::optional<Edge> common_edge(const RecoveredFace& recovered) {
  if (recovered.judgement->classification.kind == SurfaceClass::cylinder) return std::nullopt;
  std::optional<Edge> common;
  for (const RecoveredSpan& span : recovered.spans) {
    if (!span.edge) continue;
    if (!common) {
      common = span.edge;
      continue;
    }
    common->degree = std::max(common->degree, span.edge->degree);
    if (common->v != span.edge->v) common->v.reset();
  }
  return common;
}

std::string functions_text(const Piece& f) {
  const auto shown = [](const char* name, const std::optional<Function>& function) {
    return function ? fmt::format("  {} = {}", name, function_text(*function)) : std::string();
  };
  const std::optional<std::string> excluded = excluded_case(f);
  return shown("Lambda", f.lambda()) + shown("M", f.m()) + shown("sigma", f.sigma()) +
         (excluded ? "  (" + *excluded + ")" : "");
}

bool same_functions(const Piece& f, const Piece& g) {
  return f.lambda() == g.lambda() && f.m() == g.m() && f.sigma() == g.sigma() && excluded_case(f) == excluded_case(g);
}

/// The functions, neighbouring spans with equal ones on one line.
std::string spans_text(const std::vector<RecoveredSpan>& spans) {
  std::string text;
  std::size_t lines = 0;
  for (std::size_t i = 0; i < spans.size();) {
    const Piece& first = spans[i].piece;
    std::size_t next = i + 1;
    while (next < spans.size() && same_functions(first, spans[next].piece)) ++next;
    if (lines++ == most_lines) return text + "  ... and further spans: --json has all\n";
    text += fmt::format("  t in [{}, {}]:{}\n", short_number(first.begin), short_number(spans[next - 1].piece.end),
                        functions_text(first));
    i = next;
  }
  return text;
}

std::string edge_text(const RecoveredFace& recovered) {
  const std::optional<Edge> edge = common_edge(recovered);
  if (!edge || recovered.judgement->classification.kind == SurfaceClass::cone) return "";
  return fmt::format("  edge of regression (1-v) p + v q of degree {}{}\n", edge->degree,
                     edge->v ? ": v = " + function_text(*edge->v) : "");
}

std::string replay_of(std::vector<std::string> words) {
  words.insert(words.begin(), {"torse", "recover"});
  return printable(command_line(words));
}

RecoveredFace recover_face(Face face) {
  RecoveredFace result{.face = std::move(face), .replay = ""};
  result.replay = replay_of(words_of(result.face));
  if (!result.face.surface) return result;
  const RuledFile<Rational>& surface = *result.face.surface;
  result.judgement = judge(surface);
  if (!result.judgement->developable()) return result;
  result.beyond_budget = !within_budget(surface, most_bits);
  if (result.beyond_budget) return result;
  const std::vector<Piece> pieces =
      recover_pieces<Rational>(surface.knots, homogeneous(surface.c), homogeneous(surface.d));
  result.singular = find_singularities(pieces);
  for (const Piece& piece : pieces) result.spans.push_back({piece, edge_of(piece)});
  return result;
}

}  // namespace

std::vector<RecoveredFace> recover_faces(const std::string& file, const std::string& choice) {
  std::vector<RecoveredFace> list;
  try {
    for (Face& face : read_faces(file, choice)) list.push_back(recover_face(std::move(face)));
  } catch (const FileError& error) {
    list.push_back({.face = {.file = file, .name = name_of_file(file)}, .replay = replay_of(words_of(file, choice))});
    list.back().error = error;
  }
  return list;
}

Json recovered_json(const RecoveredFace& recovered) {
  Json json = face_json(recovered.face);
  if (!recovered.judgement) return json;
  const Judgement& judgement = *recovered.judgement;
  json["developable"] = judgement.developable();
  json["class"] = name_of(judgement.classification.kind);
  if (judgement.witness) {
    json["witness"] = witness_json(*judgement.witness, recovered.face.surface->knots);
    return json;
  }
  if (judgement.classification.vertex) json["vertex"] = point_json(*judgement.classification.vertex);
  if (judgement.classification.direction) json["direction"] = point_json(*judgement.classification.direction);
  if (recovered.beyond_budget) {
    for (const char* key : {"spans", "edge", "singular"}) json[key] = nullptr;
    return json;
  }
  json["spans"] = Json::array();
  for (const RecoveredSpan& span : recovered.spans) json["spans"].push_back(span_json(span));
  const std::optional<Edge> edge = common_edge(recovered);
  json["edge"] = edge ? Json{{"degree", edge->degree}, {"v", function_json(edge->v)}} : Json();
  json["singular"] = singular_json(recovered.singular);
  return json;
}

std::string recovered_text(const RecoveredFace& recovered) {
  return spans_text(recovered.spans) + edge_text(recovered);
}

}  // namespace torse::cli
