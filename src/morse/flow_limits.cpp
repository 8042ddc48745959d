#include "flowcert/flow_limits.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <utility>

#include "geometry/contract.h"
#include "geometry/floating_point.h"
#include "geometry/rational_point.h"
#include "morse/division_positions.h"
#include "morse/limit_partition.h"
#include "morse/polygon_turn.h"

namespace flowcert {

using namespace morse;

namespace {

constexpr std::size_t kListsBetweenTellings = 1024;

}  // namespace

struct FlowLimits::Parts {
  Parts(const VoronoiDiagram& voronoi, const StationaryPoints& list, const FlowOptions& options,
        const Progress& progress)
      : diagram(voronoi),
        stationary(list),
        edges(progress ? edges_of(voronoi) : 0),
        partition(voronoi, list, options, progress, edges + list.size()) {}

  [[nodiscard]] static std::size_t edges_of(const VoronoiDiagram& voronoi) {
    std::size_t count = 0;
    for_each_polygon(voronoi, [&count](PolygonRef) { ++count; });
    return count;
  }
  void make_lists(const Progress& progress);
  void turn_by_names(std::size_t record, std::vector<Division>& list) const;
  [[nodiscard]] std::span<const Division> entries(std::size_t i) const {
    FLOWCERT_REQUIRES(i < records.size());
    return std::span(divisions).subspan(first[i], first[i + 1] - first[i]);
  }

  // The first and the last are for who holds the mutex.
  [[nodiscard]] std::size_t first_direction(std::size_t i);
  template <class List>
  [[nodiscard]] List list_of(std::size_t i, const auto& position_of);
  [[nodiscard]] DivisionPositions& positions() {
    if (!made_positions) made_positions.emplace(diagram, partition);
    return *made_positions;
  }

  const VoronoiDiagram& diagram;
  const StationaryPoints& stationary;
  std::size_t edges;  // for the progress alone
  LimitPartition partition;
  std::vector<std::uint32_t> records;
  std::vector<std::size_t> first{0};
  std::vector<Division> divisions;
  std::mutex mutex;
  std::optional<DivisionPositions> made_positions;
};

// The partition's order is by VertexIndex and corners, the specification's by names.
void FlowLimits::Parts::turn_by_names(std::size_t record, std::vector<Division>& list) const {
  const StationaryIndex index = stationary.index(record);
  if (index.face_dimension == 1) {
    const auto [v0, v1] = facet_of_record(diagram, stationary, record);
    if (diagram.name(v0) < diagram.name(v1)) return;
    // A cycle still begins with a point.
    const bool is_cycle = index.is_critical() && list.size() > 1;
    std::reverse(list.begin() + (is_cycle ? 1 : 0), list.end());
    return;
  }
  if (!index.is_critical()) return;
  std::array<VertexIndex, 3> samples{};
  const auto contact = stationary.contact(record);
  for (std::size_t i = 0; i < 3; ++i) samples[i] = diagram.named(contact[i]);
  if (!has_turn(diagram, edge_of_record(stationary, record), samples)) std::swap(list.front(), list.back());
}

void FlowLimits::Parts::make_lists(const Progress& progress) {
  const std::size_t total = edges + stationary.size();
  std::vector<Division> list;
  for (std::size_t record = 0; record < stationary.size(); ++record) {
    if (progress && record % kListsBetweenTellings == 0) progress(edges + record, total);
    const unsigned face = stationary.index(record).face_dimension;
    if (face != 1 && face != 2) continue;
    partition.directions(record, list);
    turn_by_names(record, list);
    records.push_back(static_cast<std::uint32_t>(record));
    divisions.insert(divisions.end(), list.begin(), list.end());
    first.push_back(divisions.size());
  }
  if (progress) progress(total, total);
}

FlowLimits::FlowLimits(const VoronoiDiagram& diagram, const StationaryPoints& stationary, FlowOptions options,
                       const Progress& progress)
    : parts_(geometry::in_ieee_doubles([&] {
        auto parts = std::make_unique<Parts>(diagram, stationary, options, progress);
        parts->make_lists(progress);
        return parts;
      })) {}
FlowLimits::~FlowLimits() = default;
FlowLimits::FlowLimits(FlowLimits&&) noexcept = default;
FlowLimits& FlowLimits::operator=(FlowLimits&&) noexcept = default;

std::size_t FlowLimits::size() const { return parts_->records.size(); }
std::size_t FlowLimits::record(std::size_t i) const { return parts_->records[i]; }
std::size_t FlowLimits::arc_count(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  return static_cast<std::size_t>(std::ranges::count_if(parts_->entries(i), &Division::is_arc));
}
std::size_t FlowLimits::direction_count(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  return parts_->entries(i).size() - arc_count(i);
}

std::vector<FlowLimits::Entry> FlowLimits::entries(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  std::vector<Entry> entries;
  for (const Division& division : parts_->entries(i)) entries.push_back({division.limit, division.is_arc()});
  return entries;
}

namespace {

std::optional<std::size_t> limit_of(const Division& division) {
  return division.limit == kInfinityLimit ? std::nullopt : std::optional<std::size_t>(division.limit);
}

}  // namespace

// The list with positions by `position_of(point, is_vector)`.
template <class List>
List FlowLimits::Parts::list_of(std::size_t i, const auto& position_of) {
  const std::scoped_lock lock(mutex);
  const auto first = static_cast<std::ptrdiff_t>(first_direction(i));
  List list;
  for (const Division& division : entries(i)) {
    if (division.is_arc()) {
      list.arcs.push_back(limit_of(division));
      continue;
    }
    const bool is_vector = partition.point(division.point).kind == DivisionPoint::Kind::kEnd;
    list.directions.push_back({limit_of(division), position_of(division.point, is_vector), is_vector});
  }
  if (first > 0) {
    std::rotate(list.directions.begin(), list.directions.begin() + first, list.directions.end());
    std::rotate(list.arcs.begin(), list.arcs.begin() + first, list.arcs.end());
  }
  return list;
}

// Among the directions of a cycle, the one whose exit is the least. Other lists begin with their first one.
std::size_t FlowLimits::Parts::first_direction(std::size_t i) {
  if (stationary.index(records[i]) != StationaryIndex{1, 1}) return 0;
  std::vector<PointOfDivision> exits;
  for (const Division& division : entries(i)) {
    if (!division.is_arc()) exits.push_back(division.point);
  }
  return exits.empty() ? 0 : positions().least(exits);
}

LambdaList FlowLimits::list(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  return parts_->list_of<LambdaList>(i, [this](PointOfDivision point, bool is_vector) {
    RationalPoint position = parts_->positions().exact(point);
    return is_vector ? as_direction(position) : position;
  });
}

RoundedLambdaList FlowLimits::rounded_list(std::size_t i) const {
  const geometry::IeeeDoubles ieee;
  return parts_->list_of<RoundedLambdaList>(
      i, [this](PointOfDivision point, bool) { return parts_->positions().rounded(point); });
}

std::size_t FlowLimits::point_count() const { return parts_->partition.point_count(); }
const LimitPartition& LimitPartition::of(const FlowLimits& limits) { return limits.parts_->partition; }

}  // namespace flowcert
