// The fast implementation and the oracle side by side: both answers in one form, what differs between two of them,
// and which clause an answer breaks by itself.
//
// Guarantees: exact comparison of everything that spec section 3 determines; no tolerance. The order of
// records is part of the answer (FC-OUT-02) and compared as it is.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "flowcert/flow_complex.h"
#include "oracle/stationary_points.h"

namespace flowcert::property {

using Record = oracle::StationaryPoint;

// FC-OUT-02: critical before regular, by index or kind, then by contact set.
inline auto order_key(const Record& record) {
  return std::tuple(!record.is_critical(), record.face_dimension, record.hull_dimension, record.contact);
}

struct StationaryAnswer {
  std::size_t points = 0;
  std::size_t merged_duplicates = 0;
  std::vector<Record> records;
  // Counts as the implementation gives them. The regular ones are of kinds 1-2, 1-3, 2-3.
  std::array<std::size_t, 4> critical{};
  std::array<std::size_t, 3> regular{};
};

inline StationaryAnswer fast_answer(const FlowComplex& complex) {
  const PointSet& points = complex.points();
  const StationaryPoints& all = complex.stationary();
  StationaryAnswer answer{points.row_count(), points.merged_duplicates(), {}, all.critical_counts(), {}};
  const RegularCounts& regular = all.regular_counts();
  answer.regular = {regular.kind12, regular.kind13, regular.kind23};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto contact = all.contact(i);
    const ExactSphere sphere = complex.sphere(i);
    answer.records.push_back({sphere.center,
                              sphere.squared_radius,
                              {contact.begin(), contact.end()},
                              all.index(i).face_dimension,
                              all.index(i).hull_dimension});
  }
  return answer;
}

inline StationaryAnswer oracle_answer(const oracle::PointSet& set) {
  const oracle::Answer all = oracle::stationary_points(set);
  return {all.points, all.merged_duplicates, all.stationary, all.critical_counts(), all.regular_counts()};
}

inline std::string to_text(const Record& record) {
  std::ostringstream text;
  text << "at " << record.center[0] << ' ' << record.center[1] << ' ' << record.center[2] << " index "
       << record.face_dimension;
  if (!record.is_critical()) {
    text << '-' << record.hull_dimension;
  }
  text << " contact";
  for (const std::size_t name : record.contact) {
    text << ' ' << name;
  }
  text << " squared_distance " << record.squared_distance;
  return text.str();
}

inline std::string to_text(const StationaryAnswer& answer) {
  std::ostringstream text;
  text << "points " << answer.points << "\nmerged_duplicates " << answer.merged_duplicates << "\ncritical";
  for (const std::size_t count : answer.critical) {
    text << ' ' << count;
  }
  text << "\nregular";
  for (const std::size_t count : answer.regular) {
    text << ' ' << count;
  }
  for (const Record& record : answer.records) {
    text << '\n' << to_text(record);
  }
  return text.str();
}

// What differs, in one line; empty if nothing does.
inline std::string difference(const StationaryAnswer& fast, const StationaryAnswer& oracle) {
  if (fast.points != oracle.points || fast.merged_duplicates != oracle.merged_duplicates) {
    return "numbers of points or of merged duplicates differ";
  }
  for (std::size_t i = 0; i < std::max(fast.records.size(), oracle.records.size()); ++i) {
    if (i >= oracle.records.size()) {
      return "only the first has " + to_text(fast.records[i]);
    }
    if (i >= fast.records.size()) {
      return "only the second has " + to_text(oracle.records[i]);
    }
    if (fast.records[i] != oracle.records[i]) {
      return "record " + std::to_string(i) + ": " + to_text(fast.records[i]) + " against " + to_text(oracle.records[i]);
    }
  }
  if (fast.critical != oracle.critical || fast.regular != oracle.regular) {
    return "the counts differ, though the records are the same";
  }
  return {};
}

// The first clause that an answer violates, whatever the input is; empty if none.
inline std::string broken_clause(const StationaryAnswer& answer) {
  const std::size_t classes = answer.points - answer.merged_duplicates;
  const auto count = [&](std::size_t index) { return static_cast<long long>(answer.critical.at(index)); };
  const long long euler_sum = count(0) - count(1) + count(2) - count(3);
  if (euler_sum != (classes == 0 ? 0 : 1)) {
    return "FC-INV-01: the Euler sum is " + std::to_string(euler_sum);
  }
  std::set<std::vector<std::size_t>> contacts;
  std::set<RationalPoint> centers;
  std::size_t single = 0;
  for (std::size_t i = 0; i < answer.records.size(); ++i) {
    const Record& record = answer.records[i];
    if (i > 0 && !(order_key(answer.records[i - 1]) < order_key(record))) {
      return "FC-OUT-02: out of order: " + to_text(record);
    }
    if (!contacts.insert(record.contact).second || !centers.insert(record.center).second) {
      return "FC-CRIT-06: named twice: " + to_text(record);
    }
    if (record.hull_dimension == 0) {
      single += record.contact.size() == 1 && record.squared_distance == 0 ? 1 : 0;
    }
  }
  if (single != classes || answer.critical[0] != classes) {
    return "FC-CRIT-04: not every point is a critical point of index 0";
  }
  return {};
}

}  // namespace flowcert::property
