// The picture of torse fit: both strips in their frames, the diagrams and their scales.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "regress/fit_rails.hpp"

namespace torse::testing {
namespace {

using ::testing::HasSubstr;

/// The picture holds as many quadrangles as rulings but one for either strip, and all three diagrams.
TEST_F(Fit, DrawsItself) {
  for (const char* method : {"warp", "paper"}) {
    const ProgramResult result = run(strip, {"--method", method, "--coefficients", "10", "--svg", file("picture.svg")});
    EXPECT_EQ(result.exit, 0) << result.err;
    const std::string svg = slurp(scratch / "picture.svg");
    EXPECT_THAT(svg, HasSubstr("</svg>"));
    for (const char* title : {"mapping", "warp along the first rail", "convergence"})
      EXPECT_THAT(svg, HasSubstr(title));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    std::size_t quadrangles = 0;
    for (std::size_t at = svg.find("Z\"/>"); at != std::string::npos; at = svg.find("Z\"/>", at + 1)) ++quadrangles;
    EXPECT_GT(quadrangles, 400U);
    std::size_t rulings = 0;  // every eighth, from the first on, in two strips
    for (std::size_t at = svg.find("\"ruling\""); at != std::string::npos; at = svg.find("\"ruling\"", at + 1))
      ++rulings;
    EXPECT_EQ(rulings, 2 * ((quadrangles / 2 + 1 + 7) / 8));
    // Each strip in its frame of 430 by 310, which one of them fills in a direction.
    const std::regex corner("[M ]([-0-9.]+),([-0-9.]+)(?=[ Z\"])");
    double reach = 0;
    const std::string strips = svg.substr(0, svg.find(">mapping<"));
    for (std::sregex_iterator found(strips.begin(), strips.end(), corner), end; found != end; ++found) {
      const double x = std::stod(found->str(1));
      const double y = std::stod(found->str(2));
      const double across = std::abs(x - (x < 480 ? 245 : 715)) / 215;
      const double up = std::abs(y - 205) / 155;
      EXPECT_LE(std::max(across, up), 1.0001) << found->str();
      reach = std::max({reach, across, up});
    }
    EXPECT_NEAR(reach, 1, 1e-4);
  }
}

/// The convergence ends with the last step, a part of the time that the fit took: the same clock, in milliseconds.
TEST_F(Fit, DrawsTheConvergenceInMilliseconds) {
  for (const char* method : {"warp", "paper"}) {
    const json report = this->report(strip, {"--method", method, "--coefficients", "10", "--svg", file("picture.svg")});
    const double milliseconds = 1000 * report.at("seconds").get<double>();
    const std::string svg = slurp(scratch / "picture.svg");
    const std::string last = "<text x=\"920.00\" y=\"705.00\" text-anchor=\"middle\">";
    const std::size_t at = svg.find(last, svg.find(">convergence</text>"));
    ASSERT_NE(at, std::string::npos);
    const double end = std::stod(svg.substr(at + last.size(), 20));
    EXPECT_LE(end, 1.01 * milliseconds);   // three digits
    EXPECT_GT(end, 0.002 * milliseconds);  // seconds would be at most a thousandth, whatever the machine does meanwhile
  }
}

/// Strips along x begin on the side of their smaller x.
TEST_F(Fit, DrawsXToTheRight) {
  for (const double direction : {1.0, -1.0}) {
    json rails = json::parse(plain);
    for (const char* rail : {"c", "d"}) {
      for (json& xyz : rails[rail]["points"]) xyz[0] = direction * xyz[0].get<double>();
    }
    const ProgramResult result = run(rails.dump(), {"--method", "same", "--svg", file("picture.svg")});
    ASSERT_EQ(result.exit, 0) << result.err;
    const std::string svg = slurp(scratch / "picture.svg");
    const double middle = 30 + 430.0 / 2;
    EXPECT_GT((middle - std::stod(svg.substr(svg.find("d=\"M") + 4, 20))) * direction, 50);
  }
}

}  // namespace
}  // namespace torse::testing
