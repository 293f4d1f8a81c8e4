// The Gaussian curvature of a ruled surface by other libraries, each where it was found when this was built.
//   OcctSurface      OpenCASCADE's GeomLProp_SLProps            SislSurface      SISL's s2500
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "torse/algebra/eigen.hpp"
#include "torse/scalar/builtin.hpp"
#include "torse/spline/knots.hpp"

#ifdef TORSE_BENCH_OCCT
#include <GeomLProp_SLProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#endif
#ifdef TORSE_BENCH_SISL
#include <sisl.h>
#endif

namespace torse::bench {

using Points = std::vector<Vec<double, 3>>;

/// K is NaN where the library does not define it.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

#ifdef TORSE_BENCH_OCCT
class OcctSurface {
 public:
  OcctSurface(const KnotList<double>& u, const Points& c, const Points& d) : properties_(surface(u, c, d), 2, 1e-12) {}

  /// K at parameter t, half way between the boundary curves.
  double curvature(double t) {
    properties_.SetParameters(t, 0.5);
    return properties_.IsCurvatureDefined() ? properties_.GaussianCurvature() : undefined;
  }

 private:
  static Handle(Geom_Surface) surface(const KnotList<double>& u, const Points& c, const Points& d) {
    const int count = static_cast<int>(c.size());
    TColgp_Array2OfPnt poles(1, count, 1, 2);
    for (int i = 0; i < count; ++i) {
      const auto point = [&](const Points& row) {
        const Vec<double, 3>& x = row[static_cast<std::size_t>(i)];
        return gp_Pnt(x[0], x[1], x[2]);
      };
      poles.SetValue(i + 1, 1, point(c));
      poles.SetValue(i + 1, 2, point(d));
    }
    std::vector<double> knots;
    std::vector<int> multiplicities;
    for (const double x : u.cad_list()) {
      if (knots.empty() || knots.back() != x) {
        knots.push_back(x);
        multiplicities.push_back(0);
      }
      ++multiplicities.back();
    }
    const TColStd_Array1OfReal u_knots(knots.front(), 1, static_cast<int>(knots.size()));
    const TColStd_Array1OfInteger u_multiplicities(multiplicities.front(), 1, static_cast<int>(knots.size()));
    TColStd_Array1OfReal v_knots(1, 2);
    v_knots.SetValue(1, 0);
    v_knots.SetValue(2, 1);
    TColStd_Array1OfInteger v_multiplicities(1, 2);
    v_multiplicities.Init(2);
    return new Geom_BSplineSurface(poles, u_knots, v_knots, u_multiplicities, v_multiplicities, u.degree(), 1);
  }

  GeomLProp_SLProps properties_;
};
#endif

#ifdef TORSE_BENCH_SISL
class SislSurface {
 public:
  SislSurface(const KnotList<double>& u, const Points& c, const Points& d) {
    std::vector<double> coefficients;
    for (const Points* row : {&c, &d}) {
      for (const Vec<double, 3>& x : *row) coefficients.insert(coefficients.end(), {x[0], x[1], x[2]});
    }
    std::vector<double> u_knots = u.cad_list();
    std::vector<double> v_knots{0, 0, 1, 1};
    constexpr int polynomial = 1, copied = 1;
    surface_ = newSurf(static_cast<int>(c.size()), 2, u.degree() + 1, 2, u_knots.data(), v_knots.data(),
                       coefficients.data(), polynomial, 3, copied);
  }
  SislSurface(const SislSurface&) = delete;
  SislSurface& operator=(const SislSurface&) = delete;
  ~SislSurface() { freeSurf(surface_); }

  /// K at parameter t, half way between the boundary curves.
  double curvature(double t) {
    double at[2] = {t, 0.5};
    double k = 0;
    int status = 0;
    s2500(surface_, 0, 0, 0, at, &left_u_, &left_v_, &k, &status);
    return status < 0 ? undefined : k;
  }

 private:
  SISLSurf* surface_ = nullptr;
  int left_u_ = 0;
  int left_v_ = 0;
};
#endif

}  // namespace torse::bench
