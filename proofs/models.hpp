// Which points the claims run on, per scalar (see PointModel in table.hpp).
#pragma once

#include "torse/exact/instrumented/degree.hpp"
#include "torse/exact/instrumented/faulty.hpp"
#include "torse/exact/modular/batch.hpp"
#include "torse/exact/rational/rational.hpp"
#include "torse/exact/symbolic/rational_function.hpp"
#include "torse/proofs/table.hpp"

namespace torse::proofs {

template <>
inline constexpr PointModel point_model<RationalFunction> = PointModel::generators;
template <>
inline constexpr PointModel point_model<Batch> = PointModel::line;
template <>
inline constexpr PointModel point_model<Degree> = PointModel::line;
template <>
inline constexpr PointModel point_model<Faulty<Rational>> = PointModel::line;
template <>
inline constexpr PointModel point_model<Faulty<Batch>> = PointModel::line;

}  // namespace torse::proofs
