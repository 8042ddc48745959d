#include "fuzz/properties/stable_pieces.h"

#include <array>
#include <map>

#include "oracle/orbit.h"

namespace flowcert::property {

namespace {

std::vector<PointId> names_of(const Ids& ids) {
  std::vector<PointId> names;
  for (const std::size_t id : ids) names.push_back(static_cast<PointId>(id));
  return names;
}

std::array<PointId, 2> names_of(const std::array<std::size_t, 2>& ids) {
  return {static_cast<PointId>(ids[0]), static_cast<PointId>(ids[1])};
}

// Both implementations have the kinds in the same order.
static_assert(static_cast<int>(BackKind::kVertex) == static_cast<int>(oracle::BackKind::kVertex));

template <class From>
auto all_to_fast(const std::vector<From>& pieces) {
  std::vector<decltype(to_fast(pieces.front()))> made;
  for (const From& piece : pieces) made.push_back(to_fast(piece));
  return made;
}

}  // namespace

Corner<> to_fast(const oracle::Corner& corner) { return {corner.position, corner.at_infinity}; }
EdgePart<> to_fast(const oracle::EdgePart& part) {
  return {names_of(part.polygon), to_fast(part.front), to_fast(part.back)};
}
Crossing<> to_fast(const oracle::Crossing& crossing) {
  return {names_of(crossing.samples), to_fast(crossing.front), to_fast(crossing.back)};
}
Region<> to_fast(const oracle::Region& region) { return {names_of(region.samples), all_to_fast(region.corners)}; }
BackwardSegment<> to_fast(const oracle::BackwardSegment& segment) {
  return {to_fast(static_cast<const oracle::Crossing&>(segment)), names_of(segment.front_contact),
          names_of(segment.back_contact), static_cast<BackKind>(segment.back_kind)};
}

StableSet<> to_fast(const oracle::PointSet& points, const oracle::StableSet& set) {
  StableSet<> made{all_to_fast(set.segments), {}, all_to_fast(set.sectors)};
  for (const oracle::EdgePart& interval : set.intervals) {
    made.intervals.push_back({to_fast(interval), !oracle::flow_segment(points, interval.back.position)});
  }
  return made;
}

UnstableSurface<> to_fast(const oracle::UnstableSurface& set) {
  return {{set.vertices.begin(), set.vertices.end()},
          all_to_fast(set.traces),
          all_to_fast(set.runs),
          all_to_fast(set.sheets),
          all_to_fast(set.segments)};
}

std::optional<std::vector<Ids>> boundary_of(const StableSet<>& set, bool has_vertex) {
  std::map<Ids, std::size_t> times;
  for (const BackwardSegment<>& segment : set.segments) {
    if (segment.back_kind == BackKind::kRegular) return std::nullopt;
    if (segment.back_kind == BackKind::kCritical) ++times[ids(segment.samples)];
  }
  std::vector<Ids> edges;
  for (const auto& [samples, count] : times) {
    if (count % 2 == 1) edges.push_back(samples);
  }
  return has_vertex ? std::nullopt : std::optional(edges);
}

// ---- In words ----

std::string text_of(const RationalPoint& x) { return '(' + x[0].str() + ' ' + x[1].str() + ' ' + x[2].str() + ')'; }
std::string text_of(const Corner<>& corner) { return (corner.at_infinity ? "along " : "") + text_of(corner.position); }
std::string text_of(const Ids& names) {
  std::string text = "{";
  for (const std::size_t name : names) text.append(text.size() > 1 ? " " : "").append(std::to_string(name));
  text += '}';
  return text;
}

namespace {

std::string line_of(const std::string& what, const EdgePart<>& part) {
  return "  " + what + ' ' + text_of(ids(part.polygon)) + ' ' + text_of(part.front) + " to " + text_of(part.back);
}
std::string line_of(const std::string& what, const Region<>& region) {
  std::string text = "  " + what + ' ' + text_of(ids(region.samples));
  for (const Corner<>& corner : region.corners) text += ' ' + text_of(corner);
  return text + '\n';
}

}  // namespace

std::string text_of(const StableSet<>& set) {
  std::string text;
  for (const BackwardSegment<>& s : set.segments) {
    text += "  segment " + text_of(ids(s.samples)) + ' ' + text_of(s.front) + text_of(ids(s.front_contact)) + " to " +
            text_of(s.back) + text_of(ids(s.back_contact)) + ' ' + back_kind_text(s.back_kind) + '\n';
  }
  for (const BackwardInterval<>& interval : set.intervals) {
    text += line_of("interval", interval) + (interval.back_is_stationary ? " stationary\n" : "\n");
  }
  for (const Region<>& sector : set.sectors) text += line_of("sector", sector);
  return text;
}

std::string text_of(const UnstableSurface<>& set) {
  std::string text;
  for (const RationalPoint& x : set.vertices) text += "  vertex " + text_of(x) + '\n';
  for (const EdgePart<>& trace : set.traces) text += line_of("trace", trace) + '\n';
  for (const EdgePart<>& run : set.runs) text += line_of("run", run) + '\n';
  for (const Region<>& sheet : set.sheets) text += line_of("sheet", sheet);
  for (const Crossing<>& s : set.segments) {
    text += "  segment " + text_of(ids(s.samples)) + ' ' + text_of(s.back) + " to " + text_of(s.front) + '\n';
  }
  return text;
}

}  // namespace flowcert::property
