// A run is a list of numbered cases over the families. A program outside is asked one input after the other. Whoever
// judges the answer can make the input again from the case's id.
//
// Guarantees: a case is a function of level, seed, number and chosen families alone; how many cases the run has does
// not matter. Its id is one word of printable ASCII that says all of that, and has a digest of the input. So an id
// that is damaged, or that another version of the generators made, is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/inputs/families.h"

namespace flowcert::fuzz {

// Level 1 has up to 8 points in most cases, level 2 up to 10. Level 3 has all that a family may have, and in some
// cases of three families hundreds.
inline constexpr int kCaseLevels = 3;
// With so many cases, an account of a byte for each case stays small.
inline constexpr std::size_t kMostCases = 10'000'000;

[[nodiscard]] std::size_t usual_cases(int level);

struct CaseRun {
  int level = 1;
  std::uint64_t seed = 1;
  std::size_t cases = usual_cases(1);
  // Places in families(), ascending, each once; empty: all of them.
  std::vector<std::size_t> chosen;
  // Cases of more points are left out. The others keep their numbers.
  std::optional<std::size_t> most_points = {};

  friend bool operator==(const CaseRun&, const CaseRun&) = default;
};

// The places of families by name, in any order; empty where all are named or none. Throws
// std::invalid_argument, one line, for a name that is no family's.
[[nodiscard]] std::vector<std::size_t> chosen_families(const std::vector<std::string>& names);

// The families of a run, in the order in which its cases take turns.
[[nodiscard]] std::vector<std::string> family_names(const CaseRun& run);

// Numbers count from 0.
[[nodiscard]] const Family& family_of_case(const CaseRun& run, std::size_t number);
[[nodiscard]] Input input_of_case(const CaseRun& run, std::size_t number);

// "1:7:12/500:9f3c": level, seed, number, cases, digest; then the families, if not all: ":lattice-2,shell". Where
// cases are left out, the most points that one may have come after their number: "1:7:12/500/8:9f3c".
[[nodiscard]] std::string case_id(const CaseRun& run, std::size_t number, const Input& input);

struct NamedCase {
  CaseRun run;
  std::size_t number = 0;
  Input input;
};
// Returns nothing if the text is not, to the letter, the id of a case that is not left out.
[[nodiscard]] std::optional<NamedCase> case_named(std::string_view id);

}  // namespace flowcert::fuzz
