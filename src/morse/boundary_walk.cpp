// The boundary of a stable set as a closed walk (FC-STAB-07), and its connecting orbits (FC-STAB-06), from its
// segments alone. The segments with one front have sides of its polygon as samples: all sides at the stationary
// point; at a crossing, all but the one through which the branch comes.
#include <algorithm>
#include <map>

#include "flowcert/stable_manifolds.h"
#include "geometry/floating_point.h"
#include "morse/layer.h"

namespace flowcert {

using namespace morse;

// ---- The walk ----

namespace {

using Segments = std::vector<const BackwardSegment<>*>;
using Side = std::array<PointId, 2>;  // in the sense of the walk

PointId other_sample(const BackwardSegment<>& segment, PointId one) {
  return segment.samples[0] == one ? segment.samples[1] : segment.samples[0];
}

class Walker {
 public:
  Walker(const StableSet<>& set, std::span<const PointId> contact) : contact_(contact) {
    for (const BackwardSegment<>& segment : set.segments) {
      if (std::ranges::equal(segment.front_contact, contact)) {
        roots_.push_back(&segment);
      } else {
        by_front_[segment.front.position].push_back(&segment);
      }
    }
  }

  // Goes around the polygon. A side whose segment ends at a Voronoi edge is replaced by the other sides there.
  std::vector<PointId> walk() {
    const PointId first = contact_.front();
    follow_chain(roots_, first, first_neighbour(first));
    std::ranges::reverse(stack_);
    std::vector<PointId> samples;
    while (!stack_.empty()) {
      const auto [side, segment] = stack_.back();
      stack_.pop_back();
      if (segment == nullptr || segment->back_kind != BackKind::kEdge) {
        samples.push_back(side[0]);
        continue;
      }
      const std::size_t before = stack_.size();
      const Segments& sources = by_front_.at(segment->back.position);
      follow_chain(sources, side[0], next_on_chain(sources, side[0], nullptr), side[1]);
      std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(before), stack_.end());
    }
    return samples;
  }

 private:
  struct Step {
    Side side;
    const BackwardSegment<>* segment;  // none: the side whose midpoint is the regular point
  };

  static const BackwardSegment<>* next_on_chain(const Segments& segments, PointId at, const BackwardSegment<>* from) {
    for (const BackwardSegment<>* segment : segments) {
      if (segment != from && std::ranges::find(segment->samples, at) != segment->samples.end()) return segment;
    }
    return nullptr;
  }

  // The lesser neighbour of the first sample. At a regular point one neighbour may be the other end of the side that
  // no segment crosses.
  [[nodiscard]] const BackwardSegment<>* first_neighbour(PointId first) const {
    const BackwardSegment<>* const one = next_on_chain(roots_, first, nullptr);
    const BackwardSegment<>* const other = next_on_chain(roots_, first, one);
    if (other == nullptr) return other_sample(*one, first) < open_end(first) ? one : nullptr;
    return other_sample(*one, first) < other_sample(*other, first) ? one : other;
  }

  // The last sample of the chain of roots that begins at `at`.
  [[nodiscard]] PointId open_end(PointId at) const {
    const BackwardSegment<>* from = nullptr;
    while (const BackwardSegment<>* const next = next_on_chain(roots_, at, from)) {
      at = other_sample(*next, at);
      from = next;
    }
    return at;
  }

  // Pushes the sides from one sample on to another, or all around. It begins with the given one.
  void follow_chain(const Segments& segments, PointId at, const BackwardSegment<>* next,
                    std::optional<PointId> end = std::nullopt) {
    const PointId last = end.value_or(at);
    do {
      // Without a segment it is the side whose midpoint is the regular point.
      const PointId to = next == nullptr ? open_end(at) : other_sample(*next, at);
      stack_.push_back({{at, to}, next});
      at = to;
      if (at != last) next = next_on_chain(segments, at, next);
    } while (at != last);
  }

  std::span<const PointId> contact_;
  Segments roots_;
  std::map<RationalPoint, Segments> by_front_;
  std::vector<Step> stack_;
};

bool has_vertex(const StableSet<>& set) {
  return !set.intervals.empty() || std::ranges::any_of(set.segments, [](const BackwardSegment<>& segment) {
    return segment.back_kind == BackKind::kVertex;
  });
}

}  // namespace

std::optional<std::vector<PointId>> boundary_walk(const StableSet<>& set, StationaryIndex index,
                                                  std::span<const PointId> contact) {
  const geometry::IeeeDoubles ieee;
  if (index.hull_dimension != 2 || has_vertex(set)) return std::nullopt;
  return Walker(set, contact).walk();
}

// ---- Connecting orbits ----

std::vector<std::vector<std::size_t>> connecting_orbits(const StableSet<>& set, const RationalPoint& stationary) {
  const geometry::IeeeDoubles ieee;
  std::map<RationalPoint, std::size_t> by_back;
  for (std::size_t i = 0; i < set.segments.size(); ++i) by_back.emplace(set.segments[i].back.position, i);
  std::vector<std::vector<std::size_t>> orbits;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    if (set.segments[i].back_kind != BackKind::kCritical) continue;
    std::vector<std::size_t> orbit = {i};
    while (set.segments[orbit.back()].front.position != stationary) {
      const auto next = by_back.find(set.segments[orbit.back()].front.position);
      if (next == by_back.end()) break;
      orbit.push_back(next->second);
    }
    if (set.segments[orbit.back()].front.position != stationary) continue;
    std::ranges::reverse(orbit);
    orbits.push_back(std::move(orbit));
  }
  return orbits;
}

}  // namespace flowcert
