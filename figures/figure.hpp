// The figures of the papers, drawn from what the library computes.
//   Panel, Figure         pictures beside one another, with what they show
//   FigureSurface         a surface of a figure, exactly, and the class that it must have
//   PaperFigure           a figure that can be drawn       all_figures    of the four papers
//   figure_svg            the page
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "torse/developable/classify.hpp"
#include "torse/developable/ruled.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/figures/scene.hpp"
#include "torse/figures/svg.hpp"

namespace torse::figures {

/// The rows of a surface are homogeneous, w (1, c).
using Surface = RuledSpline<Rational, Vec<Rational, 4>>;

/// A surface that a figure shows. A developable one has the class that the exact decision finds; a quasi-developable
/// one has `none`.
struct FigureSurface {
  std::string name;
  Surface surface;
  SurfaceClass kind;
};

/// A picture with its title.
struct Panel {
  std::string title;
  std::variant<Scene, SvgPlot> picture;
};

/// A drawn figure. The caption says what is seen, with the numbers that were computed for it.
struct Figure {
  std::string caption;
  std::vector<Panel> panels;
  std::vector<FigureSurface> surfaces;
};

/// A figure of a paper: "FJ07.Fig1" and what it shows.
struct PaperFigure {
  std::string id;
  std::string title;
  Figure (*draw)();
};

/// In the order of the papers.
std::vector<PaperFigure> all_figures();

std::vector<PaperFigure> fj07_figures();
std::vector<PaperFigure> zw06_figures();
std::vector<PaperFigure> fj21_figures();
std::vector<PaperFigure> bzz19_figures();

/// The page of a figure: its title, the panels in rows of three at most, the caption.
std::string figure_svg(const PaperFigure& paper, const Figure& figure);

}  // namespace torse::figures
