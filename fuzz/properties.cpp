#include "torse/fuzz/properties.hpp"

#include "torse/fuzz/properties/ball_verdict.hpp"
#include "torse/fuzz/properties/construction.hpp"
#include "torse/fuzz/properties/curves.hpp"
#include "torse/fuzz/properties/double_net.hpp"
#include "torse/fuzz/properties/double_rows.hpp"
#include "torse/fuzz/properties/file_text.hpp"
#include "torse/fuzz/properties/functions.hpp"
#include "torse/fuzz/properties/joined_rails.hpp"
#include "torse/fuzz/properties/known_warp.hpp"
#include "torse/fuzz/properties/mapped_rails.hpp"
#include "torse/fuzz/properties/mapping_monotony.hpp"
#include "torse/fuzz/properties/number_text.hpp"
#include "torse/fuzz/properties/plate.hpp"
#include "torse/fuzz/properties/rail_jets.hpp"
#include "torse/fuzz/properties/recovery.hpp"
#include "torse/fuzz/properties/refused_file.hpp"
#include "torse/fuzz/properties/refused_input.hpp"
#include "torse/fuzz/properties/repair.hpp"
#include "torse/fuzz/properties/routes.hpp"
#include "torse/fuzz/properties/scrambled_file.hpp"
#include "torse/fuzz/properties/simplified_strip.hpp"
#include "torse/fuzz/properties/small_formulas.hpp"
#include "torse/fuzz/properties/spelling.hpp"
#include "torse/fuzz/properties/strip_crossing.hpp"
#include "torse/fuzz/properties/strip_folds.hpp"
#include "torse/fuzz/properties/verdict_invariance.hpp"
#include "torse/fuzz/properties/verdict_truth.hpp"
#include "torse/fuzz/properties/warp_enclosure.hpp"

namespace torse::fuzz {

const std::vector<const Property*>& properties() {
  // clang-format off
  static const std::vector<const Property*> list{
      &property<BallVerdict>(),
      &property<Construction>(),
      &property<Curves>(),
      &property<DoubleNetProperty>(),
      &property<DoubleRows>(),
      &property<FileText>(),
      &property<FunctionsOfAPatch>(),
      &property<JoinedRails>(),
      &property<KnownWarp>(),
      &property<MappedRails>(),
      &property<MappingMonotony>(),
      &property<NearestNets>(),
      &property<NumberText>(),
      &property<PlateBounds>(),
      &property<RailJets>(),
      &property<RecoveredFunctions>(),
      &property<RefusedFile>(),
      &property<RefusedInput>(),
      &property<Routes>(),
      &property<ScrambledFile>(),
      &property<SimplifiedStrip>(),
      &property<SingularParameters>(),
      &property<SmallFormulas>(),
      &property<Spelling>(),
      &property<StripCrossing>(),
      &property<StripFolds>(),
      &property<VerdictInvariance<3>>(),
      &property<VerdictInvariance<4>>(),
      &property<VerdictTruth<3>>(),
      &property<VerdictTruth<4>>(),
      &property<WarpEnclosures<3>>(),
      &property<WarpEnclosures<4>>(),
  };
  // clang-format on
  return list;
}

const Property* find_property(std::string_view name) {
  for (const Property* property : properties()) {
    if (property->info().name == name) return property;
  }
  return nullptr;
}

}  // namespace torse::fuzz
