// STEP and IGES: what is written is judged, since it is what others read.
#include <fmt/format.h>

#include <utility>

#include "torse/cli/cad_process.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/rounding.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/cli/warp.hpp"
#include "torse/exact/decide/words.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

using Json = nlohmann::ordered_json;

/// A face as it is written, with the verdict on that.
struct WrittenFace {
  RoundedSurface rounded;
  bool developable = false;
  WarpVerdict warp{};
};

WrittenFace written_face(const Face& face, const CadWishes& wishes) {
  try {
    WrittenFace written{.rounded = round_surface(*face.surface)};
    written.developable = judge(written.rounded.surface).developable();
    if (!written.developable) written.warp = judge_warp(written.rounded.surface, wishes.max_warp);
    return written;
  } catch (const InvalidInput& invalid) {
    throw FileError(face.file, fmt::format("face {}: {}", in_quotes(face.name), invalid.what()));
  }
}

/// IGES's flag is a claim, so it needs a certificate.
bool flag_of(const WrittenFace& written) { return written.developable || definitely(written.warp.within_limit); }

std::string rounding_text(const RoundedSurface& rounded, const std::string& unit) {
  if (rounded.changed == 0) return "every number as it was";
  return fmt::format("{} of {} numbers rounded, by at most {} {} in the coordinates", rounded.changed, rounded.numbers,
                     decimal_above(rounded.shift, 3), unit);
}

std::string line_of(const WrittenFace& written, const CadWishes& wishes) {
  std::string text = rounding_text(written.rounded, wishes.unit.name) + "; as written ";
  text += written.developable ? "developable"
                              : fmt::format("not developable, the largest warp angle is at most {} degrees",
                                            decimal_above(written.warp.enclosure.upper, 6));
  if (wishes.format == OutputFormat::iges) text += flag_of(written) ? "; flagged as developable" : "; not flagged";
  return text;
}

Json json_of(const WrittenFace& written, const CadWishes& wishes) {
  const WarpEnclosure& warp = written.warp.enclosure;
  Json json{
      {"rounded",
       {{"numbers", written.rounded.numbers}, {"changed", written.rounded.changed}, {"shift", written.rounded.shift}}},
      {"developable", written.developable},
      {"max_warp_deg", {{"lo", warp.lower}, {"hi", warp.upper}}}};
  if (wishes.format == OutputFormat::iges) json["developable_flag"] = flag_of(written);
  return json;
}

std::string cad_file(const CadWishes& wishes, const CadSheets& sheets) {
  const CadFormat format = wishes.format == OutputFormat::step ? CadFormat::step : CadFormat::iges;
  return run_cad(wishes.file, [&](CadFormats& formats) {
    std::string bytes;
    const std::string reason = formats.write(format, sheets, bytes);
    if (!reason.empty()) throw Error(reason);
    return bytes;
  });
}

}  // namespace

Conversion convert_to_cad(const std::vector<Face>& faces, const CadWishes& wishes) {
  CadSheets sheets{.step_unit = wishes.unit.step_name,
                   .iges_unit = wishes.unit.iges_flag,
                   .metres = wishes.unit.metres.to_double(),
                   .tolerance = wishes.tolerance};
  Conversion conversion;
  for (const Face& face : faces) {
    const WrittenFace written = written_face(face, wishes);
    sheets.sheets.push_back(sheet_of(written.rounded, face.name));
    sheets.sheets.back().developable = flag_of(written);
    sheets.sheets.back().outline = wishes.outline;
    conversion.lines.push_back(line_of(written, wishes));
    conversion.faces.push_back(json_of(written, wishes));
  }
  conversion.bytes = cad_file(wishes, sheets);
  return conversion;
}

}  // namespace torse::cli
