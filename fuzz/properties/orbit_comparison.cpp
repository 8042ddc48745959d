// Comparison of orbits; see orbit_comparison.h for what it guarantees.
#include "fuzz/properties/orbit_comparison.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "fuzz/properties/stable_pieces.h"

namespace flowcert::property {
namespace {

std::string to_text(const Ids& names) { return text_of(names); }

std::string to_text(const std::optional<RationalPoint>& x) { return x ? property::to_text(*x) : "infinity"; }

std::string to_text(const std::optional<LimitRecord>& limit) {
  if (!limit) {
    return "limit infinity";
  }
  return "limit " + property::to_text(limit->position) + " of kind " + std::to_string(limit->face_dimension) + "-" +
         std::to_string(limit->hull_dimension) + ", contact " + to_text(limit->contact);
}

// "the end is A against B" where they differ.
template <typename T>
std::string difference_in(const std::string& what, const T& a, const T& b) {
  return a == b ? "" : what + " is " + to_text(a) + " against " + to_text(b);
}

}  // namespace

SegmentRecord record_of(FlowSegment segment) {
  return {type_text(segment.type),      std::move(segment.start), std::move(segment.driver), ids(segment.start_contact),
          ids(segment.crossed_contact), std::move(segment.end),   ids(segment.end_contact)};
}

SegmentRecord record_of(const oracle::PointSet& set, const oracle::FlowSegment& segment) {
  return {oracle::segment_type(set, segment),
          segment.start,
          segment.driver,
          segment.start_contact,
          segment.crossed_contact,
          segment.end,
          segment.end_contact};
}

OrbitRecord record_of(Orbit orbit) {
  OrbitRecord record{std::move(orbit.start), {}, {}};
  for (FlowSegment& segment : orbit.segments) {
    record.segments.push_back(record_of(std::move(segment)));
  }
  if (orbit.limit) {
    record.limit = {std::move(orbit.limit->position), orbit.limit->index.face_dimension,
                    orbit.limit->index.hull_dimension, ids(orbit.limit->contact)};
  }
  return record;
}

OrbitRecord record_of(const oracle::PointSet& set, const RationalPoint& start, const oracle::Orbit& orbit) {
  OrbitRecord record{start, {}, {}};
  for (const oracle::FlowSegment& segment : orbit.segments) {
    record.segments.push_back(record_of(set, segment));
  }
  if (orbit.limit) {
    record.limit = {orbit.limit->center, orbit.limit->face_dimension, orbit.limit->hull_dimension,
                    orbit.limit->contact};
  }
  return record;
}

std::string to_text(const RationalPoint& x) {
  std::ostringstream text;
  text << '(' << x[0] << ", " << x[1] << ", " << x[2] << ')';
  return text.str();
}

std::string to_text(const SegmentRecord& segment) {
  return segment.type + " from " + to_text(segment.start) + " " + to_text(segment.start_contact) + " driven by " +
         to_text(segment.driver) + " across " + to_text(segment.crossed_contact) + " to " + to_text(segment.end) + " " +
         to_text(segment.end_contact);
}

std::string to_text(const OrbitRecord& orbit) {
  std::string text = "start " + to_text(orbit.start) + "\n";
  for (const SegmentRecord& segment : orbit.segments) {
    text += to_text(segment) + "\n";
  }
  return text + to_text(orbit.limit) + "\n";
}

std::string difference(const SegmentRecord& a, const SegmentRecord& b) {
  if (a.type != b.type) {
    return "the type is " + a.type + " against " + b.type;
  }
  for (const std::string& found :
       {difference_in("the start", a.start, b.start), difference_in("the driver", a.driver, b.driver),
        difference_in("the contact set of the start", a.start_contact, b.start_contact),
        difference_in("the crossed contact set", a.crossed_contact, b.crossed_contact),
        difference_in("the end", a.end, b.end),
        difference_in("the contact set of the end", a.end_contact, b.end_contact)}) {
    if (!found.empty()) {
      return found;
    }
  }
  return {};
}

std::string difference(const OrbitRecord& a, const OrbitRecord& b) {
  std::string found = difference_in("the start", a.start, b.start);
  for (std::size_t k = 0; k < std::min(a.segments.size(), b.segments.size()) && found.empty(); ++k) {
    found = difference(a.segments[k], b.segments[k]);
    if (!found.empty()) {
      found.insert(0, "segment " + std::to_string(k) + ": ");
    }
  }
  if (found.empty() && a.segments.size() != b.segments.size()) {
    return std::to_string(a.segments.size()) + " segments against " + std::to_string(b.segments.size());
  }
  return found.empty() && a.limit != b.limit ? to_text(a.limit) + " against " + to_text(b.limit) : found;
}

}  // namespace flowcert::property
