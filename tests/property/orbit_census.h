// What orbits a property met: where they started, and the types of their segments.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/properties/drawn_start.h"

namespace flowcert::property {

// The types of Table 1 of the paper (FC-FLOW-02).
inline const std::set<std::string> kTableOne = {"V-E-V",   "V-E-inf", "E-E-V", "E-E-inf", "V-F-V",  "V-F-E",
                                                "V-F-inf", "E-F-V",   "E-F-E", "E-F-inf", "F-F-V",  "F-F-E",
                                                "F-F-inf", "C-C-V",   "C-C-E", "C-C-F",   "C-C-inf"};

// How often there were segments of each type.
using TypeCensus = std::map<std::string, std::size_t>;

// So many choices; their number does not shrink.
inline rc::Gen<std::vector<StartChoice>> start_choices(std::size_t count) {
  return rc::gen::container<std::vector<StartChoice>>(count, start_choice());
}

// Starts by kind and by the Voronoi face that they are in.
class StartCensus {
 public:
  void add(const oracle::PointSet& set, StartKind kind, const oracle::Point& start);

  // The percentage of all starts, or of the starts of a kind, whose face has this letter ('V', 'E', 'F', 'C').
  [[nodiscard]] int percent(char letter) const;
  [[nodiscard]] int percent(StartKind kind, char letter) const;
  // A row for each kind.
  void print() const;

 private:
  using Row = std::array<std::size_t, 4>;  // by the dimension of the contact set

  std::array<Row, kStartKindCount> seen_{};
};

inline constexpr std::string_view kLetters = "CFEV";

inline int percentage(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<int>(100 * part / whole);
}

inline void StartCensus::add(const oracle::PointSet& set, StartKind kind, const oracle::Point& start) {
  const auto contact = oracle::select(set.points, set.nearest_places(start));
  ++seen_[static_cast<std::size_t>(kind)][static_cast<std::size_t>(oracle::affine_dimension(contact))];
}

inline int StartCensus::percent(char letter) const {
  std::size_t part = 0;
  std::size_t whole = 0;
  for (const Row& row : seen_) {
    part += row.at(kLetters.find(letter));
    whole += std::accumulate(row.begin(), row.end(), std::size_t{0});
  }
  return percentage(part, whole);
}

inline int StartCensus::percent(StartKind kind, char letter) const {
  const Row& row = seen_[static_cast<std::size_t>(kind)];
  return percentage(row.at(kLetters.find(letter)), std::accumulate(row.begin(), row.end(), std::size_t{0}));
}

inline void StartCensus::print() const {
  std::printf("%-12s %7s %7s %7s %7s\n", "starts", "in V", "in E", "in F", "in C");
  for (std::size_t kind = 0; kind < kStartKindCount; ++kind) {
    const Row& row = seen_[kind];
    std::printf("%-12s %7zu %7zu %7zu %7zu\n", kStartKindNames[kind], row[3], row[2], row[1], row[0]);
  }
}

}  // namespace flowcert::property
