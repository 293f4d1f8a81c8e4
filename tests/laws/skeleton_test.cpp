// The skeleton that docs/add-a-scalar.md offers to copy obeys the laws.
#include "laws/laws.hpp"
#include "laws/skeleton_scalar.hpp"

namespace torse::laws {

INSTANTIATE_TYPED_TEST_SUITE_P(Skeleton, RingLaws, Skeleton, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Skeleton, FieldLaws, Skeleton, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Skeleton, OrderLaws, Skeleton, ScalarName);
INSTANTIATE_TYPED_TEST_SUITE_P(Skeleton, RealLaws, Skeleton, ScalarName);

}  // namespace torse::laws
