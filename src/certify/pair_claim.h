// A list of persistence pairs that a program claims, in JSON or in the text format of GUDHI's tools
// (FC-FILE-28, spec/formats/persistence.md).
//
// Guarantees: numbers from JSON are exact, and numbers from text are the decimals that they are (FC-CLAIM-05). A file
// in neither format throws InvalidInput. For text, the message names the line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flowcert/claim.h"
#include "flowcert/rational.h"

namespace flowcert {

// Classes of components, tunnels and voids.
inline constexpr int kPairDimensions = 3;

// A pair as it is.
struct ListedPair {
  int dimension = 0;
  Rational birth;
  std::optional<Rational> death;  // none: the class lasts
};

// The order by dimension, birth and death. A class that lasts comes last.
[[nodiscard]] bool is_before(const ListedPair& a, const ListedPair& b);

// A pair as claimed.
struct ClaimedPair {
  int dimension = 0;
  ClaimedNumber birth;
  std::optional<ClaimedNumber> death;  // none: the class lasts
  std::size_t line = 0;                // of a text; 0 in JSON
};

// Whether no decimal is claimed.
[[nodiscard]] inline bool is_exact_pair(const ClaimedPair& pair) {
  return pair.birth.is_exact && (!pair.death || pair.death->is_exact);
}

// Whether a file is such a list: JSON that says so, a name that ends in ".pers", or lines of a dimension, a birth and a
// death, of which one lasts. Throws InvalidInput for lines of four columns that may be one or another claim.
[[nodiscard]] bool is_pair_claim(std::string_view bytes, const std::string& name);

// Reads what a program has written, without a byte order mark. name: of the file, for messages.
[[nodiscard]] std::vector<ClaimedPair> claimed_pairs_of(std::string_view bytes, const std::string& name);

}  // namespace flowcert
