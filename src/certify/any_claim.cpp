#include "certify/any_claim.h"

#include <fmt/format.h>

#include "certify/claim_content.h"
#include "io/input_bytes.h"

namespace flowcert::certify {

AnyClaim any_claim_in(std::string_view bytes, const std::string& name, const std::string& format, bool unlimited) {
  std::string decompressed;
  const std::string_view content = io::plain_content(bytes, name, decompressed, unlimited);
  if (format == "pores" || (format.empty() && is_pore_claim(content, name))) return claimed_pores_of(content, name);
  if (format.empty() && is_cycle_claim(content, name)) return claimed_cycles_of(content, name);
  if (format.empty() && !is_pair_claim(content, name)) return claim_in(content, name, unlimited);
  return claimed_pairs_of(content, name);
}

void require_radii(bool is_of_pores, bool has_radii) {
  if (is_of_pores && !has_radii) throw InvalidInput("--radii is needed: the claim is of the room between balls");
  if (!is_of_pores && has_radii) throw InvalidInput("--radii is for claims of pores");
}

void refuse_levels(const CheckOptions& options, const char* kind) {
  if (options.highest_level == kLevels && options.indices == CheckOptions{}.indices) return;
  throw InvalidInput(fmt::format("--highest-level and --indices are for flow complexes, and the claim is {}", kind));
}

}  // namespace flowcert::certify
