// One maximum matching of what is claimed with what is true: of points, of pieces and of parts (FC-CLAIM-24).
//
// Guarantees: nothing has two partners, and as many claimed things as possible have one. Among such matchings it is one
// in which as many owed true things as possible have a partner. No order decides how many these are. It does not
// recurse, because a chain of exchanges can be as long as the claim. Where claimed things come in the order of the
// truth, one question each is enough.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace flowcert::certify {

// Claimed and true things are places in lists.
struct Matching {
  std::vector<std::optional<std::size_t>> of_claimed;  // the partner, by claimed thing
  std::vector<std::optional<std::size_t>> of_truth;
};

// True things among which partners are looked for, and where the first guess begins: after the latest partner. Those
// that come first are taken first.
struct Candidates {
  std::vector<std::size_t> places;
  std::size_t next = 0;
};

// Whether all that the claimed thing says of itself as a value is right of the true one.
using IsRightOf = std::function<bool(std::size_t claimed, std::size_t truth)>;

// Each claimed thing has candidates, or nullptr. Several may share them.
[[nodiscard]] Matching maximum_matching(const std::vector<Candidates*>& candidates, std::size_t true_count,
                                        const IsRightOf& is_right);

// Exchanges true things that are not owed for owed ones. The candidates must be ascending.
void prefer_owed(Matching& matching, const std::vector<Candidates*>& candidates, const IsRightOf& is_right,
                 const std::function<bool(std::size_t truth)>& is_owed);

}  // namespace flowcert::certify
