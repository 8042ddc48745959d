// The profile of a claim (FC-CLAIM-22).
//
// Guarantees: it follows from what is claimed and judged alone. Whether that is right is the verdict's to say.
#pragma once

#include "flowcert/profile.h"

namespace flowcert::certify {

// The profile of one claim, judged at levels 1 to this one. `indices` are those that were judged. If it is not
// `has_points`, the input is the empty set.
[[nodiscard]] Profile profile_of(const Claim& claim, const ClaimedIndices& indices, bool has_points, bool is_exact,
                                 int highest_level);

}  // namespace flowcert::certify
