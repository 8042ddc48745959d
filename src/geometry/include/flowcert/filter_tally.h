// How often each predicate was asked for, and how often its filter left it open so that exact arithmetic had to
// answer (paper, Table 4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace flowcert {

enum class Predicate : std::uint8_t {
  kAngle,        // h(q): acute, right or obtuse (FC-SIGN-01)
  kSideOfPlane,  // s(o,f): the side of a facet's plane on which a circumcentre lies (FC-SIGN-03)
  kCospherical,  // five points on one sphere (FC-VOR-01)
  kCoplanar,     // two hull facets in one plane (FC-VOR-02)
  kCocircular,   // four coplanar points on one circle (FC-VOR-02)
};
inline constexpr std::size_t kPredicateCount = 5;
inline constexpr std::array<const char*, kPredicateCount> kPredicateNames = {"angle", "side_of_plane", "cospherical",
                                                                             "coplanar", "cocircular"};

struct FilterCount {
  std::uint64_t calls = 0;
  std::uint64_t failures = 0;

  FilterCount& operator+=(const FilterCount& other) {
    calls += other.calls;
    failures += other.failures;
    return *this;
  }
  friend bool operator==(const FilterCount&, const FilterCount&) = default;
};

// A count for each of n questions.
template <class Question, std::size_t n>
struct Tally {
  std::array<FilterCount, n> counts{};

  FilterCount& operator[](Question q) { return counts[static_cast<std::size_t>(q)]; }
  const FilterCount& operator[](Question q) const { return counts[static_cast<std::size_t>(q)]; }
  Tally& operator+=(const Tally& other) {
    for (std::size_t k = 0; k < n; ++k) counts[k] += other.counts[k];
    return *this;
  }
};
using FilterTally = Tally<Predicate, kPredicateCount>;

}  // namespace flowcert
