#include "torse/cad/iges_weights.hpp"

#include <IGESData_FileRecognizer.hxx>
#include <IGESData_IGESType.hxx>
#include <IGESData_Protocol.hxx>
#include <IGESData_UndefinedEntity.hxx>
#include <IGESFile_Read.hxx>
#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_BSplineSurface.hxx>
#include <Interface_UndefinedContent.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColStd_HArray2OfReal.hxx>
#include <TColgp_HArray1OfXYZ.hxx>
#include <TColgp_HArray2OfXYZ.hxx>
#include <TCollection_HAsciiString.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <gp_Pnt.hxx>
#include <optional>

#include "torse/cad/read.hpp"

namespace torse::cad {
namespace {

/// Knows no entity, so that each keeps its parameters as text.
class NoEntities : public IGESData_FileRecognizer {
  void Eval(const IGESData_IGESType&) override { SetKO(); }
};

/// The parameters of all entities as they are in the file.
class IgesTexts {
 public:
  explicit IgesTexts(std::string path) : model_(new IGESData_IGESModel) {
    const Handle(IGESData_Protocol) protocol = new IGESData_Protocol;
    const Handle(IGESData_FileRecognizer) none = new NoEntities;
    if (IGESFile_Read(path.data(), model_, protocol, none) != 0) throw unreadable();
  }

  /// Numbers `first`, ... of an entity; the one behind its type is 1.
  std::vector<double> numbers(int entity, int first, int count) const {
    if (entity < 1 || entity > model_->NbEntities()) throw unreadable();
    const auto plain = Handle(IGESData_UndefinedEntity)::DownCast(model_->Value(entity));
    if (plain.IsNull()) throw unreadable();
    const Handle(Interface_UndefinedContent) content = plain->UndefinedContent();
    if (content.IsNull() || content->NbParams() < first + count - 1) throw unreadable();
    std::vector<double> list;
    for (int i = first; i < first + count; ++i) {
      if (content->IsParamEntity(i)) throw unreadable();
      std::string text = content->ParamValue(i)->ToCString();
      std::ranges::replace_if(
          text, [](char c) { return c == 'D' || c == 'd'; }, 'E');
      list.push_back(std::strtod(text.c_str(), nullptr));
    }
    return list;
  }

 private:
  static Unreadable unreadable() { return Unreadable("expected the weights of an IGES spline, found no numbers"); }

  Handle(IGESData_IGESModel) model_;
};

Handle(TColStd_HArray1OfReal) array_of(int first, int last, const auto& value) {
  const Handle(TColStd_HArray1OfReal) array = new TColStd_HArray1OfReal(first, last);
  for (int i = first; i <= last; ++i) array->SetValue(i, value(i));
  return array;
}

void set_weights(IGESGeom_BSplineCurve& curve, const std::vector<double>& weights) {
  const int last = curve.UpperIndex();
  const Handle(TColgp_HArray1OfXYZ) poles = new TColgp_HArray1OfXYZ(0, last);
  for (int i = 0; i <= last; ++i) poles->SetValue(i, curve.Pole(i).XYZ());
  curve.Init(last, curve.Degree(), curve.IsPlanar(), curve.IsClosed(), false, curve.IsPeriodic(),
             array_of(-curve.Degree(), last + 1, [&](int i) { return curve.Knot(i); }),
             array_of(0, last, [&](int i) { return weights[static_cast<std::size_t>(i)]; }), poles, curve.UMin(),
             curve.UMax(), curve.Normal());
}

void set_weights(IGESGeom_BSplineSurface& surface, const std::vector<double>& list) {
  const int last_u = surface.UpperIndexU();
  const int last_v = surface.UpperIndexV();
  const Handle(TColgp_HArray2OfXYZ) poles = new TColgp_HArray2OfXYZ(0, last_u, 0, last_v);
  const Handle(TColStd_HArray2OfReal) weights = new TColStd_HArray2OfReal(0, last_u, 0, last_v);
  for (int j = 0; j <= last_v; ++j) {
    for (int i = 0; i <= last_u; ++i) {
      poles->SetValue(i, j, surface.Pole(i, j).XYZ());
      weights->SetValue(i, j, list[static_cast<std::size_t>(j * (last_u + 1) + i)]);
    }
  }
  surface.Init(last_u, last_v, surface.DegreeU(), surface.DegreeV(), surface.IsClosedU(), surface.IsClosedV(), false,
               surface.IsPeriodicU(), surface.IsPeriodicV(),
               array_of(-surface.DegreeU(), last_u + 1, [&](int i) { return surface.KnotU(i); }),
               array_of(-surface.DegreeV(), last_v + 1, [&](int j) { return surface.KnotV(j); }), weights, poles,
               surface.UMin(), surface.UMax(), surface.VMin(), surface.VMax());
}

/// Where the weights of a spline begin: behind its sizes, properties and knots.
int first_weight(const IGESGeom_BSplineCurve& curve) { return 6 + curve.UpperIndex() + curve.Degree() + 2 + 1; }

int first_weight(const IGESGeom_BSplineSurface& surface) {
  return 9 + (surface.UpperIndexU() + surface.DegreeU() + 2) + (surface.UpperIndexV() + surface.DegreeV() + 2) + 1;
}

int weight_count(const IGESGeom_BSplineCurve& curve) { return curve.UpperIndex() + 1; }

int weight_count(const IGESGeom_BSplineSurface& surface) {
  return (surface.UpperIndexU() + 1) * (surface.UpperIndexV() + 1);
}

/// Whether OpenCASCADE sees no weights where the file may have some.
template <class Spline>
bool doubtful(const Spline& spline) {
  return !spline.IsPolynomial(true) && spline.IsPolynomial();
}

template <class Spline>
void restore(Spline& spline, int number, const IgesTexts& texts) {
  const std::vector<double> weights = texts.numbers(number, first_weight(spline), weight_count(spline));
  if (std::ranges::count(weights, weights.front()) < static_cast<std::ptrdiff_t>(weights.size())) {
    set_weights(spline, told_apart(weights));
  }
}

}  // namespace

std::vector<double> told_apart(std::vector<double> weights) {
  constexpr double enough = 1e-9;
  double difference = 0;
  double largest = 0;
  for (const double w : weights) {
    difference = std::max(difference, std::abs(w - weights.front()));
    largest = std::max(largest, std::abs(w));
  }
  if (difference == 0 || difference >= enough) return weights;
  const int exponent = std::max(std::ilogb(enough) - std::ilogb(difference) + 1, -std::ilogb(largest));
  for (double& w : weights) w = std::scalbn(w, exponent);
  return weights;
}

void restore_weights(const std::string& path, const Handle(IGESData_IGESModel) & model) {
  std::optional<IgesTexts> texts;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto curve = Handle(IGESGeom_BSplineCurve)::DownCast(model->Value(i));
    const auto surface = Handle(IGESGeom_BSplineSurface)::DownCast(model->Value(i));
    const bool needed = (!curve.IsNull() && doubtful(*curve)) || (!surface.IsNull() && doubtful(*surface));
    if (!needed || !complaint_of(model, i).empty()) continue;
    if (!texts) texts.emplace(path);
    if (!curve.IsNull()) restore(*curve, i, *texts);
    if (!surface.IsNull()) restore(*surface, i, *texts);
  }
}

}  // namespace torse::cad
