// The properties that a campaign holds every input to. Each has a name, and says what it found if it does not hold.
//
// Guarantees: the fast implementation and the oracle are used as they are, and compared exactly. Nothing is caught or
// repaired but exceptions, which are disagreements too. A property is a function of the trial alone. The kind of a
// disagreement says what is wrong without saying where, so that it can stay the same while the input shrinks.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fuzz/inputs/input.h"
#include "fuzz/properties/orbit_starts.h"

namespace flowcert::property {

// An input, and where an orbit starts in it: by a choice that depends on the input, or as coordinates.
struct Trial {
  fuzz::Input input;
  std::variant<StartChoice, oracle::Point> start;
};
// The input must not be empty.
[[nodiscard]] oracle::Point start_of(const Trial& trial);

struct Disagreement {
  std::string kind;       // a few words with hyphens: "missing", "segment-type"
  std::string clause;     // of the spec, that one of the two violates: "FC-CRIT-05"
  std::string complaint;  // one line
  // Both answers, as text of any number of lines, and whose they are.
  std::string first_name, first;
  std::string second_name, second;
};

inline constexpr std::size_t kAnyRows = std::numeric_limits<std::size_t>::max();

struct Property {
  std::string name;  // kebab-case
  std::string description;
  // An input of more rows takes the oracle too long, and passes.
  std::size_t most_rows = 12;
  // In a campaign that names no properties, one case in so many is held to it; with 0, none.
  std::size_t one_in = 1;
  // So many inputs are tried to make a failing one small.
  std::size_t shrinking_budget = 3000;
  // A kind of disagreement that is slow to find again, and so many inputs are tried to make such a failing one small.
  std::string slow_kind = {};
  std::size_t slow_shrinking_budget = 0;
  std::function<std::optional<Disagreement>(const Trial&)> check = {};
};

// critical-points, orbit, unstable-manifolds, stable-sets and persistence: the fast implementation against the oracle.
// What flows does so twice, by the usual kernel and by the lazy one with binary search, whichever is the usual one.
// orbit-kernels, unstable-kernels and stable-kernels: the fast implementation against itself, kernel by kernel.
// threads: the same, by numbers of threads. It is for a campaign of its own, under ThreadSanitizer.
// certificate: the fast implementation against the certificate checker, on inputs of any size.
[[nodiscard]] const std::vector<Property>& properties();
// Nothing for a name that is no property's.
[[nodiscard]] const Property* property_named(std::string_view name);

// Something is wrong with the machine, not with the trial: a disk is full, no process can be started.
class MachineFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What the property says of the trial. An exception is a disagreement of kind "throws". But MachineFailure is thrown
// on, and std::system_error is thrown as a MachineFailure. An input with too many rows passes.
[[nodiscard]] std::optional<Disagreement> disagreement(const Property& property, const Trial& trial);

}  // namespace flowcert::property
