// Orbits of the fast implementation and of the oracle in one form, and what differs between two of them.
//
// Guarantees: exact comparison of everything that spec section 8 determines, segment by segment: type, start,
// driver, end, all three contact sets, and where the orbit ends; no tolerance.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/orbit.h"
#include "flowcert/rational.h"
#include "flowcert/stationary_points.h"
#include "oracle/orbit.h"

namespace flowcert::property {

struct SegmentRecord {
  std::string type;  // as in the table
  RationalPoint start;
  RationalPoint driver;
  std::vector<std::size_t> start_contact;
  std::vector<std::size_t> crossed_contact;
  std::optional<RationalPoint> end;
  std::vector<std::size_t> end_contact;

  friend bool operator==(const SegmentRecord&, const SegmentRecord&) = default;
};

struct LimitRecord {
  RationalPoint position;
  int face_dimension = 0;
  int hull_dimension = 0;
  std::vector<std::size_t> contact;

  friend bool operator==(const LimitRecord&, const LimitRecord&) = default;
};

struct OrbitRecord {
  RationalPoint start;
  std::vector<SegmentRecord> segments;
  std::optional<LimitRecord> limit;

  friend bool operator==(const OrbitRecord&, const OrbitRecord&) = default;
};

SegmentRecord record_of(FlowSegment segment);
SegmentRecord record_of(const oracle::PointSet& set, const oracle::FlowSegment& segment);
OrbitRecord record_of(Orbit orbit);
OrbitRecord record_of(const oracle::PointSet& set, const RationalPoint& start, const oracle::Orbit& orbit);

std::string to_text(const RationalPoint& x);
std::string to_text(const SegmentRecord& segment);
// A line for the start, for each segment, and for the limit.
std::string to_text(const OrbitRecord& orbit);

// What differs, in one line; empty if nothing does.
std::string difference(const SegmentRecord& a, const SegmentRecord& b);
std::string difference(const OrbitRecord& a, const OrbitRecord& b);

}  // namespace flowcert::property
