// Every property of torse/fuzz with its choices from bytes: check, construct and recover on structured input. The
// first byte picks the property, the second the scale.
#include <span>
#include <string>

#include "torse/fuzz/properties.hpp"
#include "torse/fuzz/run.hpp"
#include "torse/fuzz/targets/target.hpp"

namespace torse::targets {
namespace {

/// Sizes that take milliseconds under the sanitizers.
constexpr fuzz::Scale scales[] = {{2, 2, 8}, {3, 3, 12}, {4, 3, 40}};

void check(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2) return;
  const std::vector<const fuzz::Property*>& list = fuzz::properties();
  const fuzz::Property& property = *list[bytes[0] % list.size()];
  const fuzz::Scale& scale = scales[bytes[1] % std::size(scales)];
  fuzz::Choices choices = fuzz::Choices::from_bytes(bytes.subspan(2));
  const fuzz::CaseReport report = property.run(choices, scale);
  if (report.result != fuzz::CaseResult::failed) return;
  fuzz::Choices again = fuzz::Choices::from_record(choices.record());
  const std::string file = fuzz::case_file(property, property.input_text(again, scale));
  require(false, std::string(property.info().name) + ": " + report.message + "\n" + file);
}

}  // namespace
}  // namespace torse::targets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  torse::targets::check({data, size});
  return 0;
}
