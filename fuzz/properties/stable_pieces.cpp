// Stable sets in one form; see stable_pieces.h for what that guarantees.
#include "fuzz/properties/stable_pieces.h"

#include <map>

#include "oracle/orbit.h"

namespace flowcert::property {

Pieces pieces_of(const StableSet& set) {
  Pieces pieces;
  for (const auto& s : set.segments) {
    pieces.segments.emplace_back(ids(s.samples), s.front, s.back, ids(s.front_contact), ids(s.back_contact),
                                 back_kind_text(s.back_kind));
  }
  for (const auto& i : set.intervals) {
    pieces.intervals.emplace_back(ids(i.polygon), i.front, i.back, i.back_is_stationary);
  }
  for (const auto& s : set.sectors) pieces.sectors.emplace_back(ids(s.samples), s.corners);
  pieces.sort();
  return pieces;
}

Pieces pieces_of(const oracle::PointSet& points, const oracle::StableSet& set) {
  const std::map<oracle::BackKind, std::string> kinds = {{oracle::BackKind::kCritical, "critical"},
                                                         {oracle::BackKind::kRegular, "regular"},
                                                         {oracle::BackKind::kEdge, "edge"},
                                                         {oracle::BackKind::kVertex, "vertex"}};
  Pieces pieces;
  for (const auto& s : set.segments) {
    pieces.segments.emplace_back(ids(s.samples), s.front.position, s.back.position, s.front_contact, s.back_contact,
                                 kinds.at(s.back_kind));
  }
  for (const auto& [polygon, front, back] : set.intervals) {
    pieces.intervals.emplace_back(polygon, front.position, back.position, !oracle::flow_segment(points, back.position));
  }
  for (const auto& [samples, corners] : set.sectors) {
    std::vector<RationalPoint>& positions =
        std::get<1>(pieces.sectors.emplace_back(ids(samples), std::vector<RationalPoint>{}));
    for (const oracle::Corner& corner : corners) positions.push_back(corner.position);
  }
  pieces.sort();
  return pieces;
}

std::optional<std::vector<Ids>> boundary_of(const Pieces& pieces, bool has_vertex) {
  std::map<Ids, std::size_t> times;
  for (const SegmentKey& segment : pieces.segments) {
    if (std::get<5>(segment) == "regular") return std::nullopt;
    if (std::get<5>(segment) == "critical") ++times[std::get<0>(segment)];
  }
  std::vector<Ids> edges;
  for (const auto& [samples, count] : times) {
    if (count % 2 == 1) edges.push_back(samples);
  }
  return has_vertex ? std::nullopt : std::optional(edges);
}

std::string text_of(const RationalPoint& x) { return '(' + x[0].str() + ' ' + x[1].str() + ' ' + x[2].str() + ')'; }
std::string text_of(const Ids& names) {
  std::string text = "{";
  for (const std::size_t name : names) text.append(text.size() > 1 ? " " : "").append(std::to_string(name));
  text += '}';
  return text;
}

std::string text_of(const Pieces& pieces) {
  std::string text;
  for (const auto& [samples, front, back, front_contact, back_contact, kind] : pieces.segments) {
    text += "  segment " + text_of(samples) + ' ' + text_of(front) + text_of(front_contact) + " to " + text_of(back) +
            text_of(back_contact) + ' ' + kind + '\n';
  }
  for (const auto& [polygon, front, back, is_stationary] : pieces.intervals) {
    text += "  interval " + text_of(polygon) + ' ' + text_of(front) + " to " + text_of(back) +
            (is_stationary ? " stationary\n" : "\n");
  }
  for (const auto& [samples, corners] : pieces.sectors) {
    text += "  sector " + text_of(samples);
    for (const RationalPoint& x : corners) text += ' ' + text_of(x);
    text += '\n';
  }
  return text;
}

}  // namespace flowcert::property
