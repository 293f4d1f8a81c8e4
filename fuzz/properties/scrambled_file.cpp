#include "torse/fuzz/properties/scrambled_file.hpp"

#include "torse/exact/rational/cpp_rational.hpp"
#include "torse/fuzz/properties/file_meaning.hpp"

namespace torse::fuzz {
namespace {

/// What a text is read as, in words: its numbers or the error.
struct Reading {
  bool accepted = false;
  std::string text;
};

template <class S>
Reading read(const std::string& text) {
  try {
    const Document document("file", text);
    return {true, write_input(meaning_of<S>(document, file_type(document)))};
  } catch (const FileError& error) {
    return {false, error.what()};
  }
}

bool well_formed(const SplineMeant& spline) {
  const auto n = static_cast<std::size_t>(spline.degree);
  const std::vector<Rational>& u = spline.knots;
  const std::size_t count = spline.points.size();
  if (count < n + 1 || u.size() != count - 1 + n || spline.weights.size() != count) return false;
  for (std::size_t i = 1; i < u.size(); ++i) {
    if (u[i] < u[i - 1] || (i >= n && u[i] == u[i - n])) return false;
  }
  for (const Rational& weight : spline.weights) {
    if (weight.sign() == 0) return false;
  }
  return u[n - 1] < u[count - 1];
}

void check_accepted(const std::string& text) {
  const Document document("file", text);
  const FileMeant meant = meaning_of<Rational>(document, file_type(document));
  require(well_formed(meant.c), "an ill-formed curve is accepted");
  require(meant.d.points.empty() || well_formed(meant.d), "an ill-formed second curve is accepted");
  if (const auto written = written_again<Rational>(document)) {
    require(read<Rational>(*written).text == write_input(meant), "what is written is read as something else");
  }
}

}  // namespace

const PropertyInfo& ScrambledFile::info() {
  static const PropertyInfo info{
      "text.scrambled",
      "a file with bytes changed at random is refused with an error, or it is well-formed and comes back from what is "
      "written for it; both arithmetics agree",
      40,
      {"result=accepted", "result=refused"}};
  return info;
}

ScrambledFile::In ScrambledFile::draw(Choices& choices, const Scale& scale, Labels& labels) {
  const DrawnFile file = draw_file(choices, scale, labels);
  return {{scrambled(choices, write_json(choices, file.tree).text)}};
}

void ScrambledFile::check(const In& in, Labels& labels) {
  const Reading reading = read<Rational>(in.text.text);
  labels.add("result", reading.accepted ? "accepted" : "refused");
  require(read<CppRational>(in.text.text).text == reading.text, "the two arithmetics read different things");
  if (reading.accepted) check_accepted(in.text.text);
}

}  // namespace torse::fuzz
