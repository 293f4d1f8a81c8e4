// The figures of the papers: what they show is what they say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "torse/developable/condition.hpp"
#include "torse/figures/figure.hpp"

namespace torse::figures {

static void PrintTo(const PaperFigure& paper, std::ostream* out) { *out << paper.id; }

namespace {

using testing::HasSubstr;
using Row = Vec<Rational, 4>;

TEST(Figures, AreThoseOfThePapers) {
  EXPECT_EQ(fj07_figures().size(), 8U);
  EXPECT_EQ(zw06_figures().size(), 7U);
  EXPECT_EQ(fj21_figures().size(), 4U);
  EXPECT_EQ(bzz19_figures().size(), 3U);
  std::set<std::string> ids;
  for (const PaperFigure& paper : all_figures()) ids.insert(paper.id);
  EXPECT_EQ(ids.size(), 22U);
}

class EachFigure : public testing::TestWithParam<PaperFigure> {};

TEST_P(EachFigure, ShowsSurfacesOfTheClassThatItNames) {
  const Figure figure = GetParam().draw();
  ASSERT_FALSE(figure.surfaces.empty());
  for (const FigureSurface& shown : figure.surfaces) {
    const Surface& surface = shown.surface;
    const auto witness = find_witness<Rational, 4>(surface.knots, surface.c_row(), surface.d_row());
    EXPECT_EQ(witness.has_value(), shown.kind == SurfaceClass::none) << shown.name;
    if (witness) continue;
    EXPECT_EQ(name_of(classify<Rational>(surface.knots, surface.c_row(), surface.d_row()).kind), name_of(shown.kind))
        << shown.name;
  }
}

// Elements that are opened and those that are closed, without the ones that close themselves.
std::pair<std::size_t, std::size_t> elements(const std::string& svg) {
  std::size_t opened = 0;
  std::size_t closed = 0;
  for (std::size_t i = svg.find('<'); i != std::string::npos; i = svg.find('<', i + 1)) {
    const std::size_t end = svg.find('>', i);
    if (svg[i + 1] == '/') ++closed;
    if (svg[i + 1] != '/' && svg[i + 1] != '?' && svg[end - 1] != '/') ++opened;
  }
  return {opened, closed};
}

TEST_P(EachFigure, IsAPageWithTitleCaptionAndPictures) {
  const Figure figure = GetParam().draw();
  const std::string svg = figure_svg(GetParam(), figure);
  EXPECT_THAT(svg, HasSubstr("<title>" + GetParam().id));
  EXPECT_FALSE(std::regex_search(svg, std::regex("[\" ,LM>]-?(nan|inf)[\" ,LZ<]")));
  const auto [opened, closed] = elements(svg);
  EXPECT_EQ(opened, closed);
  EXPECT_FALSE(figure.caption.empty());
  EXPECT_EQ(figure_svg(GetParam(), GetParam().draw()), svg) << "drawn twice, it differs";
}

std::string test_name(const testing::TestParamInfo<PaperFigure>& info) {
  std::string name = info.param.id;
  std::erase(name, '.');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Papers, EachFigure, testing::ValuesIn(all_figures()), test_name);

TEST(Figures, SayWhatWasFound) {
  const auto caption = [](std::string_view id) {
    for (const PaperFigure& paper : all_figures()) {
      if (paper.id == id) return paper.draw().caption;
    }
    return std::string();
  };
  // Lam_k, M_k by hand: (L* - u)/(length of the piece).
  EXPECT_THAT(caption("FJ07.Fig7"), HasSubstr("Lam_3 = -11, M_3 = -9"));
  EXPECT_THAT(caption("FJ07.Fig7"), HasSubstr("none are found"));
  EXPECT_THAT(caption("FJ07.Fig8"), HasSubstr("found to be 13/10 to 17/10"));
  EXPECT_THAT(caption("FJ07.Fig3"), HasSubstr("vertex is (10/3, 5/3, 5)"));
  EXPECT_THAT(caption("FJ21.Fig8.1"), HasSubstr("v(t) = 3/2 t + 3"));
}

}  // namespace
}  // namespace torse::figures
