// Makes a failing case small: fewer points, then smaller integers, and a simpler start.
//
// Guarantees: what is returned fails with the same kind of disagreement, and is the same for the same arguments. It
// has no more rows than `failing`. Unless the budget ran out, no single row could be left out, before the start of
// the orbit was turned into coordinates at the end.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "fuzz/properties/property.h"

namespace flowcert::fuzz {

using Judge = std::function<std::optional<property::Disagreement>(const property::Trial&)>;

struct Shrunk {
  property::Trial trial;
  property::Disagreement disagreement;
  std::size_t judged = 0;     // the number of trials that were judged
  bool is_budget_up = false;  // more would have been
};

// `failing` must fail, with the disagreement given. Judges at most `budget` trials.
[[nodiscard]] Shrunk shrunk(const property::Trial& failing, const property::Disagreement& disagreement,
                            const Judge& judge, std::size_t budget);

}  // namespace flowcert::fuzz
