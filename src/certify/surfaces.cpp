// Level 5 for stable sets: their sizes, boundary walks, skeletons and surfaces (FC-CLAIM-10).
//
// Each claimed piece must be a true one, and each true piece must be claimed once. There are two permitted
// variations. A claim may leave out the pieces beyond a Voronoi vertex, which a perturbation would not make. Or it
// may add pieces beyond a regular stationary point, which a perturbation might make.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <span>
#include <string>

#include "certify/boundaries.h"
#include "certify/check_run.h"
#include "certify/claimed_geometry.h"
#include "certify/finding_words.h"
#include "certify/piece_comparison.h"
#include "geometry/rational_point.h"

namespace flowcert::certify {

namespace {

constexpr char kSurfaceClause[] = "FC-CLAIM-10";
constexpr char kAddedPieces[] = "which pieces of a stable set a perturbation adds beyond a regular stationary point";
constexpr std::size_t kLongestList = 60;  // characters

// Its values belong to corners or to sides.
template <typename Each>
using Triangle = std::array<Each, 3>;

// For each segment: whether a claim must have it. It must if it is reached from z without passing a Voronoi vertex, or
// if z is a maximum.
std::vector<bool> determined_segments(const StableSet<>& set, const RationalPoint& z, StationaryIndex index) {
  std::vector<bool> determined(set.segments.size(), index == kMaximum);
  if (index.hull_dimension == 3) return determined;
  std::multimap<RationalPoint, std::size_t> by_front;
  for (std::size_t i = 0; i < set.segments.size(); ++i) by_front.emplace(set.segments[i].front.position, i);
  std::vector<RationalPoint> fronts(1, z);
  while (!fronts.empty()) {
    const auto [first, last] = by_front.equal_range(fronts.back());
    fronts.pop_back();
    for (auto it = first; it != last; ++it) {
      determined[it->second] = true;
      const BackwardSegment<>& segment = set.segments[it->second];
      if (segment.back_kind == BackKind::kEdge) fronts.push_back(segment.back.position);
    }
  }
  return determined;
}

// The largest squared distance of a regular back from its samples; none if no back is regular.
std::optional<Rational> value_of_regular_backs(const PointSet& points, const StableSet<>& set) {
  std::optional<Rational> value;
  for (const BackwardSegment<>& segment : set.segments) {
    if (segment.back_kind != BackKind::kRegular) continue;
    const Rational here = exact_sphere(points, segment.samples).squared_radius;
    if (!value || here > *value) value = here;
  }
  return value;
}

class Surfaces {
 public:
  Surfaces(CheckRun& run, Boundaries& boundaries) : run_(run), boundaries_(boundaries) {}

  void check(std::size_t k) {
    const ClaimedPoint& point = run_.claim.points[k];
    const std::size_t record = run_.placed[k].place->record;
    const bool needs_set = point.skeleton || point.surface || (point.stable && point.stable->walk);
    if (point.stable) check_summary(k, *point.stable, record);
    if (!needs_set) return;
    const ExactSphere sphere = run_.truth.sphere(record);
    const StableSet<> set = run_.truth.stable_set(record);
    const ValueScale scale(sphere, run_.options.tolerance);
    const auto determined = determined_segments(set, sphere.center, run_.index(record));
    if (point.stable && point.stable->walk) check_walk(k, *point.stable->walk, record, set);
    if (point.skeleton) check_skeleton(k, point, set, scale, determined);
    if (point.surface) check_surface(k, *point.surface, set, scale, determined);
  }

 private:
  void find(std::size_t k, FindingReason reason, const std::string& claimed, const std::string& truth) {
    run_.find(5, reason, kSurfaceClause, k, truth, claimed);
  }

  // A claim may leave out what lies beyond a Voronoi vertex, and add pieces beyond a regular back.
  void check_summary(std::size_t k, const ClaimedStable& claimed, std::size_t record) {
    const StableSummary truth = run_.truth.stable_summary(record);
    const auto judge = [&](bool is_permitted, const std::string& what, const std::string& right) {
      if (is_permitted) {
        run_.vary(5, FindingReason::kSymbolicPerturbation, kSurfaceClause, k, "it has " + right, what);
      } else {
        find(k, FindingReason::kWrongSurface, what, "it has " + right);
      }
    };
    if (claimed.segments && *claimed.segments != truth.segments) {
      judge(may_have_segments(*claimed.segments, truth.segments, record),
            std::to_string(*claimed.segments) + " segments", std::to_string(truth.segments) + " segments");
    }
    if (claimed.has_vertex && *claimed.has_vertex != truth.has_vertex) {
      judge(truth.has_vertex, *claimed.has_vertex ? "a Voronoi vertex" : "no Voronoi vertex",
            truth.has_vertex ? "one" : "none");
    }
    if (claimed.has_interval && *claimed.has_interval != truth.has_interval) {
      judge(truth.has_interval, *claimed.has_interval ? "an interval" : "no interval",
            truth.has_interval ? "one" : "none");
    }
  }

  // Whether a set of another number of segments than the true one is permitted.
  bool may_have_segments(std::size_t count, std::size_t true_count, std::size_t record) {
    const StableSet<> set = run_.truth.stable_set(record);
    if (count > true_count) {
      if (!value_of_regular_backs(run_.points, set)) return false;
      run_.leave_unjudged(kAddedPieces);
      return true;
    }
    const auto determined = determined_segments(set, run_.truth.sphere(record).center, run_.index(record));
    return count >= static_cast<std::size_t>(std::ranges::count(determined, true));
  }

  // Whether these are the same closed walk, which may begin anywhere and go either way around.
  static bool are_same_walks(std::vector<PointId> a, const std::vector<PointId>& b) {
    if (a.size() != b.size()) return false;
    for (int way = 0; way < 2; ++way) {
      for (std::size_t turn = 0; turn < a.size(); ++turn) {
        if (a == b) return true;
        std::rotate(a.begin(), a.begin() + 1, a.end());
      }
      std::ranges::reverse(a);
    }
    return a.empty();
  }

  void check_walk(std::size_t k, const std::vector<PointId>& rows, std::size_t record, const StableSet<>& set) {
    std::vector<PointId> walk;
    walk.reserve(rows.size());
    for (const PointId row : rows) walk.push_back(run_.points.name(run_.points.ordinal_of_row(row)));
    const auto truth = boundary_walk(set, run_.index(record), run_.truth.contact(record));
    if (truth && are_same_walks(walk, *truth)) return;
    if (!run_.index(record).is_critical()) {
      if (truth) {
        find(k, FindingReason::kWrongSurface, "walk " + names_text(rows), "the walk is " + names_text(*truth));
      } else {
        run_.leave_unjudged("boundary walks of regular stationary points that are Voronoi vertices");
      }
      return;
    }
    if (truth && !has_tie(run_.truth, record)) {
      find(k, FindingReason::kWrongSurface, "walk " + names_text(rows), "the walk is " + names_text(*truth));
      return;
    }
    std::vector<std::vector<PointId>> edges;
    edges.reserve(walk.size());
    for (std::size_t i = 0; i < walk.size(); ++i) edges.push_back({walk[i], walk[(i + 1) % walk.size()]});
    boundaries_.check(k, edges, 5, true);
  }

  // Whether a claim must have a true piece.
  using IsOwed = std::function<bool(std::size_t)>;
  static IsOwed owed(const std::vector<bool>& determined, std::size_t pieces_each) {
    return [&determined, pieces_each](std::size_t i) { return static_cast<bool>(determined[i / pieces_each]); };
  }

  // text(k): claimed piece k in words.
  template <typename Text>
  void judge(std::size_t k, const Comparison& found, const std::string& what, const IsOwed& is_owed, const Text& text) {
    std::size_t missing = 0, left_out = 0;
    for (std::size_t i = 0; i < found.is_claimed.size(); ++i) {
      if (!found.is_claimed[i]) ++(is_owed(i) ? missing : left_out);
    }
    if (!found.strange.empty() && found.is_beyond && missing + left_out == 0) {
      run_.vary(5, FindingReason::kSymbolicPerturbation, kSurfaceClause, k,
                std::to_string(found.strange.size()) + " " + what + "s beyond a regular stationary point");
      run_.leave_unjudged(kAddedPieces);
      return;
    }
    if (!found.strange.empty()) {
      find(k, rounding_or(FindingReason::kWrongSurface, found.is_rounding), text(found.strange.front()),
           "no such " + what + " is part of it (in all " + std::to_string(found.strange.size()) + " such claims)");
      return;
    }
    if (missing > 0) {
      find(k, FindingReason::kWrongSurface, "too few", std::to_string(missing) + " " + what + "s are missing");
    } else if (left_out > 0) {
      run_.vary(5, FindingReason::kSymbolicPerturbation, kSurfaceClause, k,
                std::to_string(left_out) + " " + what + "s beyond a Voronoi vertex are left out");
    }
  }

  void check_skeleton(std::size_t k, const ClaimedPoint& point, const StableSet<>& set, const ValueScale& scale,
                      const std::vector<bool>& determined) {
    const StableSet<ClaimedPosition>& claimed = *point.skeleton;
    const auto matcher = [&](const auto& pieces, const auto& truth) {
      return piece_matcher(run_.points, pieces, truth,
                           [&](const auto& x, const auto& y, const auto&) { return run_.match(x, y, scale); });
    };
    PieceMatcher segments = matcher(claimed.segments, set.segments);
    const std::optional<Rational> regular = value_of_regular_backs(run_.points, set);
    const IsOwed is_owed = owed(determined, 1);
    const Comparison found = segments.compare(
        is_owed, [&](std::size_t c) { return regular && may_be_added(claimed.segments[c], *regular); });
    judge(k, found, "segment", is_owed, [&](std::size_t c) { return segment_text(claimed.segments[c]); });
    const bool is_maximum = run_.index(run_.placed[k].place->record) == kMaximum;
    const IsOwed of_maximum = [is_maximum](std::size_t) { return is_maximum; };
    judge(k, matcher(claimed.intervals, set.intervals).compare(), "interval", of_maximum,
          [&](std::size_t c) { return "an interval of " + names_text(claimed.intervals[c].polygon); });
    judge(k, matcher(claimed.sectors, set.sectors).compare(), "sector", of_maximum,
          [&](std::size_t c) { return "a sector of " + names_text(claimed.sectors[c].samples); });
    if (point.orbits) {
      check_orbits(k, *point.orbits, found, segments, set, run_.truth.sphere(run_.placed[k].place->record).center);
    }
  }

  static std::string segment_text(const BackwardSegment<ClaimedPosition>& piece) {
    return "a segment of " + names_text(piece.samples) + " from " + position_text(piece.front.position) + " back to " +
           position_text(piece.back.position);
  }

  // Whether the segment goes back from a front that is no farther from its samples than a regular stationary point. It
  // is not judged whether both ends are as far from one sample as from the other, if they are claimed in decimals.
  bool may_be_added(const BackwardSegment<ClaimedPosition>& piece, const Rational& regular) const {
    const ClaimedPosition &front = piece.front.position, &back = piece.back.position;
    const auto far = [&](const ClaimedPosition& x, std::size_t k) {
      return squared_distance(values_of(x), sample(run_.points, piece.samples[k]));
    };
    const bool is_flat =
        (!is_exact(front) || far(front, 0) == far(front, 1)) && (!is_exact(back) || far(back, 0) == far(back, 1));
    return is_flat && piece.back_kind != BackKind::kVertex && far(front, 0) <= regular && far(back, 0) <= far(front, 0);
  }

  // Connecting orbits as chains of the claimed segments. Chains through segments that are left out may be left out, and
  // chains through segments that are added beyond a regular back may be added. `matcher` has compared the segments.
  void check_orbits(std::size_t k, const std::vector<std::vector<std::size_t>>& claimed, const Comparison& segments,
                    const PieceMatcher& matcher, const StableSet<>& set, const RationalPoint& z) {
    if (!run_.index(run_.placed[k].place->record).is_critical()) {
      run_.leave_unjudged("connecting orbits of regular stationary points");
      return;
    }
    // A chain of other partners may be meant.
    const auto find_orbits = [&](const std::string& what, const std::string& truth) {
      for (std::size_t c = 0; c < segments.partner.size(); ++c) {
        if (matcher.is_ambiguous(c)) {
          return run_.leave_unjudged("connecting orbits along segments of which one is near several true ones");
        }
      }
      find(k, FindingReason::kWrongSurface, what, truth);
    };
    std::set<std::vector<std::size_t>> missing;
    for (auto& chain : connecting_orbits(set, z)) missing.insert(std::move(chain));
    for (const auto& chain : claimed) {
      std::vector<std::size_t> pieces;
      for (const std::size_t place : chain) {
        if (segments.partner[place]) pieces.push_back(*segments.partner[place]);
      }
      if (pieces.size() == chain.size() && missing.erase(pieces) == 0) {
        return find_orbits("an orbit along the segments " + places_text(chain),
                           "that is no connecting orbit, or it is there twice");
      }
    }
    std::erase_if(missing, [&](const std::vector<std::size_t>& chain) {
      return !std::ranges::all_of(chain, [&](std::size_t i) { return segments.is_claimed[i]; });
    });
    if (missing.empty()) return;
    find_orbits(std::to_string(claimed.size()) + " connecting orbits",
                std::to_string(missing.size()) + " more go along the segments that are claimed");
  }

  static std::string places_text(const std::vector<std::size_t>& places) {
    return places.empty() ? "of no number" : shortened(fmt::format("{}", fmt::join(places, " ")), kLongestList);
  }

  // For each corner of the triangle take the larger squared distance to another corner. This is the least of them.
  static Rational least_reach(const Triangle<ClaimedPosition>& corners) {
    Triangle<Rational> sides;
    for (std::size_t i = 0; i < 3; ++i) {
      sides[i] = squared_distance(values_of(corners[i]), values_of(corners[(i + 1) % 3]));
    }
    // That corner is opposite the longest side, so the value is the second longest side.
    std::ranges::sort(sides);
    return sides[1];
  }

  ValueMatch match_corners(std::span<const ClaimedPosition> claimed, std::span<const RationalPoint> truth,
                           const ValueScale& scale) {
    return match_ring(claimed, truth, [&](const ClaimedPosition& corner, const RationalPoint& other) {
      return run_.match(corner, other, scale);
    });
  }

  void check_surface(std::size_t k, const ClaimedSurface& claimed, const StableSet<>& set, const ValueScale& scale,
                     const std::vector<bool>& determined) {
    if (!set.intervals.empty()) {
      run_.leave_unjudged("surfaces of stable sets that have parts of dimension 3");
      return;
    }
    std::vector<Triangle<RationalPoint>> truth;
    for (const BackwardSegment<>& segment : set.segments) {
      for (const PointId name : segment.samples) {
        truth.push_back({exact_position(sample(run_.points, name)), segment.front.position, segment.back.position});
      }
    }
    const auto corners = [&](const std::array<std::size_t, 3>& triangle) {
      return Triangle<ClaimedPosition>{claimed.vertices[triangle[0]], claimed.vertices[triangle[1]],
                                       claimed.vertices[triangle[2]]};
    };
    const std::optional<Rational> regular = value_of_regular_backs(run_.points, set);
    PieceMatcher triangles(PieceNames::none(claimed.triangles.size(), truth.size()), [&](std::size_t c, std::size_t i) {
      return match_corners(corners(claimed.triangles[c]), truth[i], scale);
    });
    const IsOwed is_owed = owed(determined, 2);
    const Comparison found = triangles.compare(
        is_owed, [&](std::size_t c) { return regular && least_reach(corners(claimed.triangles[c])) <= *regular; });
    judge(k, found, "triangle", is_owed, [&](std::size_t c) {
      const Triangle<ClaimedPosition> at = corners(claimed.triangles[c]);
      return "a triangle " + position_text(at[0]) + " " + position_text(at[1]) + " " + position_text(at[2]);
    });
  }

  CheckRun& run_;
  Boundaries& boundaries_;
};

bool has_stable_set(const ClaimedPoint& point) {
  const bool has_summary = point.stable && (point.stable->segments || point.stable->has_vertex ||
                                            point.stable->has_interval || point.stable->walk);
  return has_summary || point.skeleton || point.surface;
}

}  // namespace

bool check_surfaces(CheckRun& run) {
  Boundaries boundaries(run);
  Surfaces surfaces(run, boundaries);
  const bool judged = run.judge_each(5, 1, kPartsOfLevel5, [&](std::size_t k) {
    if (!has_stable_set(run.claim.points[k]) || !run.can_follow(k, "stable sets")) return false;
    surfaces.check(k);
    return true;
  });
  boundaries.conclude();
  return judged;
}

}  // namespace flowcert::certify
