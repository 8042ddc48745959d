// Cases drawn fresh: an input of one of the plan's families, of a size from the plan's mix, and where an
// orbit starts in it.
//
// Guarantees: a function of plan and seed. Rows lie between the plan's bounds wherever a family can be made
// to: an input that came out larger loses rows, one that came out smaller is drawn again, some times, and
// then taken as it is.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/campaign/campaign_plan.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

struct FreshTrial {
  property::Trial trial;
  std::string family;
};

class TrialMix {
 public:
  explicit TrialMix(const CampaignPlan& plan);

  [[nodiscard]] FreshTrial draw(std::uint64_t seed) const;
  // Where an orbit starts.
  [[nodiscard]] static property::StartChoice draw_start(std::uint64_t seed);

 private:
  struct Source {
    Family family;
    rc::Gen<Input> generator;
    std::uint64_t weights_before = 0;  // of all sources up to this one, itself included
  };

  [[nodiscard]] const Source& source(std::uint64_t dice) const;
  [[nodiscard]] std::size_t row_target(std::uint64_t dice) const;

  std::size_t fewest_rows_;
  std::size_t most_rows_;
  std::vector<Source> sources_;
};

}  // namespace flowcert::fuzz
