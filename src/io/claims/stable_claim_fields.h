// The keys of a record of the exchange format that tell its stable set (spec/formats.md, section 2).
#pragma once

#include "flowcert/claim.h"
#include "io/claims/exchange_value.h"

namespace flowcert::io {

// Throws InvalidInput, with the place, for what is not as the format says.
[[nodiscard]] ClaimedStable stable_of(const ExchangeValue& value);
[[nodiscard]] ClaimedSkeleton skeleton_of(const ExchangeValue& value);
[[nodiscard]] ClaimedSurface surface_of(const ExchangeValue& value);

}  // namespace flowcert::io
