#include "torse/fuzz/properties/file_text.hpp"

#include <algorithm>

#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/fuzz/properties/file_meaning.hpp"

namespace torse::fuzz {
namespace {

/// Parameters by their keys, so that texts can be compared.
std::string in_order(FileMeant meant) {
  std::ranges::sort(meant.parameters, {}, &ParameterMeant::key);
  return write_input(meant);
}

template <class S>
void check_reading(const Document& document, const FileMeant& meant) {
  require(in_order(meaning_of<S>(document, meant.type)) == in_order(meant), "the file is read as something else");
  const std::optional<std::string> written = written_again<S>(document);
  if (!written) return;
  const Document again("again", *written);
  require(in_order(meaning_of<S>(again, meant.type)) == in_order(meant),
          "what is written for the file is something else");
  require(written_again<S>(again) == written, "what is written for what was written differs");
}

}  // namespace

const PropertyInfo& FileText::info() {
  static const PropertyInfo info{
      "text.file",
      "a valid file of any type is read as what it means, in every layout and by both arithmetics; writing it and "
      "reading it again gives the same numbers",
      25,
      {"type=curve", "type=ruled", "type=rails", "type=construct", "knots=absent", "knots=papers", "knots=cad",
       "method=bspline", "method=bezier", "method=rational", "method=cylinder", "method=cone", "method=tangent",
       "method=interpolate", "method=directrix"}};
  return info;
}

FileText::In FileText::draw(Choices& choices, const Scale& scale, Labels& labels) {
  DrawnFile file = draw_file(choices, scale, labels);
  return {{write_json(choices, file.tree).text}, std::move(file.meant)};
}

void FileText::check(const In& in, Labels&) {
  const Document document("file", in.text.text);
  check_reading<Rational>(document, in.meant);
  check_reading<CppRational>(document, in.meant);
}

}  // namespace torse::fuzz
