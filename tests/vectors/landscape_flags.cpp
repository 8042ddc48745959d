#include "tests/vectors/landscape_flags.h"

#include <algorithm>
#include <set>

#include "oracle/medial_axis.h"
#include "oracle/persistence.h"

namespace oracle::vectors {

// ---- Locations

namespace {

bool is_location_of_itself(const Findings& found, std::size_t k) {
  const auto& limit = found.locations[k].limit;
  return limit && limit->center == found.starts[k];
}

// Whether both are on one ray from a sample that is nearest to both, and none is that sample.
bool are_on_a_ray(const Findings& found, std::size_t i, std::size_t j) {
  const Point zero = {0, 0, 0};
  for (const std::size_t name : found.locations[i].nearest) {
    if (!std::count(found.locations[j].nearest.begin(), found.locations[j].nearest.end(), name)) continue;
    const Point& p = found.set.points[places_of(found.set, {name}).front()];
    const Point a = minus(found.starts[i], p), b = minus(found.starts[j], p);
    if (cross(a, b) == zero && dot(a, b) > 0) return true;
  }
  return false;
}

template <class Holds>
bool some_location(const Findings& found, const Holds& holds) {
  return std::any_of(found.locations.begin(), found.locations.end(), holds);
}

}  // namespace

bool has_location_at_start(const Findings& found) {
  for (std::size_t k = 0; k < found.locations.size(); ++k) {
    if (is_location_of_itself(found, k)) return true;
  }
  return false;
}
bool has_location_at_regular(const Findings& found) {
  for (std::size_t k = 0; k < found.locations.size(); ++k) {
    const auto& limit = found.locations[k].limit;
    if (limit && !limit->is_critical() && !is_location_of_itself(found, k)) return true;
  }
  return false;
}
bool has_location_at_infinity(const Findings& found) {
  return some_location(found, [](const Location& one) { return !one.limit; });
}
bool has_several_nearest(const Findings& found) {
  return some_location(found, [](const Location& one) { return one.nearest.size() > 1; });
}
bool has_two_on_a_ray(const Findings& found) {
  for (std::size_t j = 1; j < found.locations.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (are_on_a_ray(found, i, j)) return true;
    }
  }
  return false;
}

// ---- Merge trees

namespace {

bool joins_three(const MergeTree& tree) {
  return std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const MergeNode& one) { return one.parts.size() > 2; });
}

bool has_equal_values(const MergeTree& tree) {
  return std::adjacent_find(tree.nodes.begin(), tree.nodes.end(), [](const MergeNode& a, const MergeNode& b) {
           return a.value == b.value;
         }) != tree.nodes.end();
}

}  // namespace

bool joins_three_pockets(const Findings& found) { return found.trees && joins_three(found.trees->pockets); }
bool joins_three_components(const Findings& found) { return found.trees && joins_three(found.trees->components); }
bool has_gates_beyond_need(const Findings& found) {
  if (!found.trees) return false;
  const auto& nodes = found.trees->pockets.nodes;
  return std::any_of(nodes.begin(), nodes.end(),
                     [](const MergeNode& one) { return one.points.size() >= one.parts.size(); });
}
bool has_two_nodes_of_a_value(const Findings& found) {
  return found.trees && (has_equal_values(found.trees->pockets) || has_equal_values(found.trees->components));
}
bool has_node_of_nodes(const Findings& found) { return found.trees && found.trees->pockets.nodes.size() > 1; }
bool has_only_infinity(const Findings& found) { return found.trees && found.trees->pockets.leaves == 1; }

// ---- Pockets

namespace {

template <class Holds>
bool some_answer(const Findings& found, const Holds& holds) {
  return std::any_of(found.pockets.begin(), found.pockets.end(), holds);
}

template <class Holds>
bool some_pocket(const Findings& found, const Holds& holds) {
  return some_answer(found, [&](const PocketAnswer& answer) {
    const auto& all = answer.found.pockets;
    return std::any_of(all.begin(), all.end(), [&](const Pocket& one) { return holds(answer, one); });
  });
}

bool some_passage(const Findings& found, Passage wanted) {
  return some_answer(found, [&](const PocketAnswer& answer) {
    return std::any_of(answer.probes.begin(), answer.probes.end(), [&](const ProbeAnswer& probe) {
      return std::count(probe.passages.begin(), probe.passages.end(), wanted) > 0;
    });
  });
}

}  // namespace

bool lists_pocket(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer&, const Pocket&) { return true; });
}
bool lists_no_pocket(const Findings& found) {
  return some_answer(found, [](const PocketAnswer& answer) { return answer.found.pockets.empty(); });
}
bool has_merged_pocket(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer&, const Pocket& one) { return one.maxima.size() > 1; });
}
bool has_merged_outside(const Findings& found) {
  return some_answer(found, [](const PocketAnswer& answer) { return !answer.found.outside.empty(); });
}
bool has_pocket_apart(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer& answer, const Pocket& one) {
    return is_root_difference_up_to(one.height, one.highest_mouth, answer.persistence * answer.persistence);
  });
}
bool has_several_peaks(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer&, const Pocket& one) { return one.peaks.size() > 1; });
}
bool has_wider_cell(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer&, const Pocket& one) { return one.cell.size() > one.maxima.size(); });
}
bool has_neighbour_pocket(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer& answer, const Pocket& one) {
    return !one.neighbours.empty() && one.neighbours.front() < answer.found.pockets.size();
  });
}
bool has_several_gates(const Findings& found) {
  return some_pocket(found, [](const PocketAnswer&, const Pocket& one) { return one.to_infinity.gates.size() > 1; });
}
bool has_several_largest_balls(const Findings& found) {
  return some_answer(found, [&](const PocketAnswer& answer) {
    return largest_balls(found.answer.stationary, answer.found).size() > 1;
  });
}
bool has_cavity(const Findings& found) { return some_passage(found, Passage::kCavity); }
bool has_narrow_pocket(const Findings& found) { return some_passage(found, Passage::kPocket); }
bool has_channel(const Findings& found) { return some_passage(found, Passage::kChannel); }
bool passes_exactly(const Findings& found) {
  return some_answer(found, [](const PocketAnswer& answer) {
    return std::any_of(answer.probes.begin(), answer.probes.end(), [&](const ProbeAnswer& probe) {
      const auto& all = answer.found.pockets;
      return std::any_of(all.begin(), all.end(),
                         [&](const Pocket& one) { return one.to_infinity.value == probe.radius * probe.radius; });
    });
  });
}

// ---- The medial axis

bool has_angle_at_bound(const Findings& found) {
  if (!found.medial) return false;
  const auto& all = found.answer.stationary;
  return std::any_of(all.begin(), all.end(), [&](const StationaryPoint& x) {
    if (!x.is_critical() || x.hull_dimension != 2) return false;
    const Rational cosine = contact_cosine(found.set, x);
    return cosine == Rational(-1, 2) || cosine == -1;
  });
}
bool has_angle_between(const Findings& found) {
  if (!found.medial) return false;
  std::set<std::size_t> counts;  // of points of index 2 above each angle
  for (const AngleAnswer& angle : found.medial->angles) {
    counts.insert(static_cast<std::size_t>(std::count_if(angle.above.begin(), angle.above.end(), [&](auto place) {
      return found.answer.stationary[place].hull_dimension == 2;
    })));
  }
  return counts.size() > 2;
}
bool leaves_choice(const Findings& found) {
  if (!found.medial) return false;
  for (const LengthAnswer& length : found.medial->lengths) {
    for (const LevelCount& level : length.levels) {
      if (level.above > 0 && level.above < level.points) return true;
    }
  }
  return false;
}

// ---- Infinity

bool has_bounded_piece(const Findings& found) {
  if (!found.infinity) return false;
  const auto& [points, segments, intervals, crossed, sectors, has_vertex] = *found.infinity;
  return std::any_of(segments.begin(), segments.end(), [](const auto& one) { return !one.front.at_infinity; }) ||
         !std::all_of(sectors.begin(), sectors.end(), is_unbounded);
}
bool has_sector_of_two_ends(const Findings& found) {
  if (!found.infinity) return false;
  const auto& all = found.infinity->sectors;
  return std::any_of(all.begin(), all.end(), [](const Region& sector) {
    return std::count_if(sector.corners.begin(), sector.corners.end(),
                         [](const Corner& corner) { return corner.at_infinity; }) == 2;
  });
}
bool has_ray_from_regular(const Findings& found) {
  if (!found.infinity) return false;
  const auto& all = found.infinity->segments;
  return std::any_of(all.begin(), all.end(), [](const BackwardSegment& one) {
    return one.front.at_infinity && one.back_kind == BackKind::kRegular;
  });
}

// ---- Statistics

bool has_cascade(const Findings& found) { return found.statistics && !found.statistics->n_wcc.empty(); }
bool has_long_connecting_orbit(const Findings& found) {
  return found.statistics && !found.statistics->n_s2.empty() && found.statistics->n_s2.rbegin()->first > 1;
}

}  // namespace oracle::vectors
