// A claim of any kind that `check` judges, and what its options may say of it.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "certify/cycle_claim.h"
#include "certify/layer.h"
#include "certify/pair_claim.h"
#include "certify/pore_claims.h"
#include "flowcert/check.h"

namespace flowcert::certify {

// A claimed flow complex, a persistence diagram, cycles, or pores.
using AnyClaim = std::variant<Claim, std::vector<ClaimedPair>, CycleClaim, PoreClaim>;

// The claim in these bytes, which may be compressed. format: "pers", "pores", or empty: the content and the name's
// ending say it. Throws InvalidInput, "NAME:LINE: reason".
[[nodiscard]] AnyClaim any_claim_in(std::string_view bytes, const std::string& name, const std::string& format,
                                    bool unlimited);

// Throws InvalidInput if atoms have radii and the claim is not of pores, or the other way round.
void require_radii(bool is_of_pores, bool has_radii);
// Throws InvalidInput if levels or indices are chosen, which only claims of flow complexes have. kind: "of cycles".
void refuse_levels(const CheckOptions& options, const char* kind);

}  // namespace flowcert::certify
