// The oracle's λ-lists against its stable sets and its orbits, on small inputs of all families.
//
// A list is made by following rays forward. A stable set is found by searching against the flow. So what both say of a
// direction is found in two ways that have nothing in common: the backward segments that end at a stationary point,
// and the open arcs of sectors with a corner there, are exactly the directions that lead to the set's stationary point.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "oracle/orbit.h"
#include "oracle/stable_set.h"
#include "oracle/unstable_set.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace oracle::oracle_unstable_families_test {
namespace {

using Rows = std::vector<std::array<double, 3>>;

Direction direction_of(const Point& vector) {
  Rational largest = 0;
  for (const Rational& x : vector) largest = std::max(largest, Rational(abs(x)));
  return {vector[0] / largest, vector[1] / largest, vector[2] / largest};
}

// Directions of one point lie in a plane or on a line. All of them turn around one axis.
class Turn {
 public:
  explicit Turn(const Point& axis) : axis_(axis) {}

  // Whether u is inside of the open arc that turns counterclockwise from a to b, which are different.
  [[nodiscard]] bool is_between(const Point& a, const Point& u, const Point& b) const {
    if (is_same(u, a) || is_same(u, b)) return false;
    return is_before(a, u, b);
  }
  [[nodiscard]] static bool is_same(const Point& a, const Point& b) { return direction_of(a) == direction_of(b); }

 private:
  // Going around from a, u comes before b.
  [[nodiscard]] bool is_before(const Point& a, const Point& u, const Point& b) const {
    const auto [side_u, cos_u] = key(a, u);
    const auto [side_b, cos_b] = key(a, b);
    if (side_u != side_b) return side_u < side_b;
    return dot(axis_, cross(u, b)) > 0;
  }
  // 0: less than half of a turn from a. 1: half a turn. 2: more.
  [[nodiscard]] std::pair<int, Rational> key(const Point& a, const Point& u) const {
    const Rational sine = dot(axis_, cross(a, u));
    return {sine > 0 ? 0 : sine == 0 ? 1 : 2, dot(a, u)};
  }

  Point axis_;
};

// What the search against the flow says of the directions of one stationary point.
struct Backward {
  struct Arc {
    std::array<std::size_t, 2> samples;  // of the facet
    Direction a, b;                      // in either order; less than half of a turn
    Point limit;
  };
  std::vector<std::pair<Direction, Point>> directions;  // with the stationary point's position
  std::vector<Arc> arcs;
};

void add_backward(const StationaryPoint& z, const StableSet& set, std::map<Point, Backward>& of) {
  for (const BackwardSegment& segment : set.segments) {
    const bool is_end = segment.back_kind == BackKind::kCritical || segment.back_kind == BackKind::kRegular;
    if (is_end) {
      of[segment.back.position].directions.emplace_back(direction_of(way_to(segment.front, segment.back.position)),
                                                        z.center);
    }
  }
  for (const auto& [polygon, front, back] : set.intervals) {
    of[back.position].directions.emplace_back(direction_of(way_to(front, back.position)), z.center);
  }
  for (const auto& [samples, corners] : set.sectors) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner& before = corners[(i + corners.size() - 1) % corners.size()];
      const Corner& after = corners[(i + 1) % corners.size()];
      const Point& x = corners[i].position;
      of[x].arcs.push_back({samples, direction_of(way_to(before, x)), direction_of(way_to(after, x)), z.center});
    }
  }
}

// The entry that has the direction.
const UnstableEntry* entry_at(const std::vector<UnstableEntry>& list, const Turn& turn, const Direction& u) {
  for (const UnstableEntry& entry : list) {
    if (!entry.is_arc && Turn::is_same(*entry.from, u)) return &entry;
    if (entry.is_arc && !entry.from) return &entry;
    if (!entry.is_arc) continue;
    const bool is_whole_turn = Turn::is_same(*entry.from, *entry.to);
    if (is_whole_turn ? !Turn::is_same(*entry.from, u) : turn.is_between(*entry.from, u, *entry.to)) return &entry;
  }
  return nullptr;
}

// A direction inside of an arc, near its beginning: less than a quarter of a turn away, and inside.
Direction inside(const Turn& turn, const Point& axis, const UnstableEntry& arc) {
  if (!arc.from) return {};
  Point ahead = cross(axis, *arc.from);
  Rational part = 1;
  const bool is_whole_turn = Turn::is_same(*arc.from, *arc.to);
  while (true) {
    const Point u = moved(*arc.from, part, ahead);
    if (is_whole_turn || turn.is_between(*arc.from, u, *arc.to)) return direction_of(u);
    part /= 2;
  }
}

std::optional<Point> position(const std::optional<StationaryPoint>& limit) {
  return limit ? std::optional(limit->center) : std::nullopt;
}

struct Subject {
  explicit Subject(const Rows& rows) : set(rows), all(stationary_points(rows).stationary) {
    for (const StationaryPoint& z : all) add_backward(z, stable_set(set, z), backward);
  }
  PointSet set;
  std::vector<StationaryPoint> all;
  std::map<Point, Backward> backward;
};

// An axis around which the directions turn, or zero where they do not.
Point axis_of(const Subject& subject, const StationaryPoint& y) {
  if (y.face_dimension != 1) return {};
  const Places contact = places_of(subject.set, y.contact);
  for (const std::size_t a : contact) {
    for (const std::size_t b : contact) {
      const Point sum = moved(subject.set.points[a], 1, subject.set.points[b]);
      if (a < b && minus(sum, y.center) == y.center) return minus(subject.set.points[b], subject.set.points[a]);
    }
  }
  ADD_FAILURE() << "no edge";
  return {};
}

struct Count {
  std::size_t directions = 0, arcs = 0, orbits = 0, lists = 0, whole = 0;
};

// Each direction and arc of the search is in an entry of the same limit.
void expect_backward_in_forward(const Backward& backward, const std::vector<UnstableEntry>& list, const Turn& turn,
                                Count& count) {
  for (const auto& [u, limit] : backward.directions) {
    const UnstableEntry* entry = entry_at(list, turn, u);
    ASSERT_NE(entry, nullptr);
    EXPECT_EQ(position(entry->limit), limit);
    ++count.directions;
  }
  for (const Backward::Arc& arc : backward.arcs) {
    const UnstableEntry* entry = entry_at(list, turn, direction_of(moved(arc.a, 1, arc.b)));
    ASSERT_NE(entry, nullptr);
    EXPECT_TRUE(entry->is_arc);
    EXPECT_EQ(position(entry->limit), arc.limit);
    if (!entry->is_arc || !entry->from) continue;
    // No end of the entry is inside of the arc.
    for (const Direction* end : {&*entry->from, &*entry->to}) {
      EXPECT_FALSE(turn.is_between(arc.a, *end, arc.b) && turn.is_between(arc.b, *end, arc.a));
      const bool is_forward = turn.is_between(arc.a, moved(arc.a, 1, arc.b), arc.b);
      EXPECT_FALSE(is_forward ? turn.is_between(arc.a, *end, arc.b) : turn.is_between(arc.b, *end, arc.a));
    }
    ++count.arcs;
  }
}

// Each entry that does not lead to infinity is found by the search, whole.
void expect_forward_in_backward(const Backward& backward, const std::vector<UnstableEntry>& list, const Turn& turn,
                                Count& count) {
  for (const UnstableEntry& entry : list) {
    if (!entry.limit) continue;
    const Point& limit = entry.limit->center;
    const auto is_direction = [&](const Direction& u) {
      return std::ranges::any_of(backward.directions, [&](const auto& found) {
        return Turn::is_same(found.first, u) && found.second == limit;
      });
    };
    if (!entry.is_arc) {
      EXPECT_TRUE(is_direction(*entry.from));
      continue;
    }
    // Arcs and directions of the search follow each other from the beginning to the end.
    std::vector<std::pair<Direction, Direction>> arcs;
    for (const Backward::Arc& arc : backward.arcs) {
      if (arc.limit != limit) continue;
      const bool is_forward = turn.is_between(arc.a, moved(arc.a, 1, arc.b), arc.b);
      arcs.emplace_back(is_forward ? arc.a : arc.b, is_forward ? arc.b : arc.a);
    }
    ASSERT_FALSE(arcs.empty());
    Direction at = entry.from ? *entry.from : arcs.front().first;
    const Direction end = entry.to ? *entry.to : at;
    std::size_t steps = 0;
    do {
      const auto next = std::ranges::find_if(arcs, [&](const auto& arc) { return Turn::is_same(arc.first, at); });
      ASSERT_NE(next, arcs.end()) << "a gap";
      EXPECT_TRUE(steps++ == 0 || is_direction(at));
      at = next->second;
      ASSERT_LE(steps, arcs.size());
    } while (!Turn::is_same(at, end));
    EXPECT_TRUE(entry.from || is_direction(at));
    count.whole += entry.from ? 0 : 1;
  }
}

// Points a little beyond y flow where the list says.
void expect_orbits(const Subject& subject, const StationaryPoint& y, const std::vector<UnstableEntry>& list,
                   const Turn& turn, const Point& axis, Count& count) {
  for (const UnstableEntry& entry : list) {
    const Point u =
        entry.is_arc ? (entry.from ? inside(turn, axis, entry) : direction_of(cross(axis, {3, 5, 7}))) : *entry.from;
    const Places crossed = crossed_places(subject.set, places_of(subject.set, y.contact), u);
    const auto meeting = subject.set.first_meeting(crossed.front(), y.center, u);
    const Point x = moved(y.center, meeting ? *meeting / 3 : Rational(1, 3), u);
    EXPECT_EQ(orbit(subject.set, x).limit, entry.limit);
    ++count.orbits;
  }
}

void expect_agreement(const Subject& subject, Count& count) {
  for (const StationaryPoint& y : subject.all) {
    if (y.face_dimension == 0) continue;
    const std::vector<UnstableEntry> list = lambda_list(subject.set, y);
    SCOPED_TRACE(testing::PrintToString(y.contact));
    const Point axis = axis_of(subject, y);
    const Turn turn(axis);
    const auto found = subject.backward.find(y.center);
    // A maximum may be a corner of sectors that flow into it. Only its own directions count, and it has none.
    if (y.face_dimension == 3) {
      EXPECT_TRUE(list.empty());
      continue;
    }
    const Backward backward = found == subject.backward.end() ? Backward{} : found->second;
    Backward away;
    away.directions = backward.directions;
    // Only sectors in the facet of y's own edge lead away from y.
    for (const Backward::Arc& arc : backward.arcs) {
      const auto point = [&](std::size_t k) { return subject.set.points[places_of(subject.set, {arc.samples[k]})[0]]; };
      if (y.face_dimension == 1 && moved(point(0), 1, point(1)) == moved(y.center, 1, y.center))
        away.arcs.push_back(arc);
    }
    expect_backward_in_forward(away, list, turn, count);
    expect_forward_in_backward(away, list, turn, count);
    expect_orbits(subject, y, list, turn, axis, count);
    ++count.lists;
  }
}

TEST(OracleUnstableFamilies, ListsAreWhatTheSearchAgainstTheFlowFinds) {
  CITES("FC-UNST-01", "FC-UNST-02", "FC-UNST-03");
  const double scale = flowcert::property::scale_of_run();
  Count count;
  const std::uint64_t seeds = flowcert_tests::scaled_seeds(2);
  flowcert_tests::for_each_drawn_set({seeds, seeds, scale < 1 ? 7U : 10U}, [&](const Rows& rows, std::uint64_t) {
    if (!rows.empty()) expect_agreement(Subject(rows), count);
  });
  EXPECT_GT(count.directions, 40 * scale);
  EXPECT_GT(count.arcs, 40 * scale);
  EXPECT_GT(count.lists, 40 * scale);
  std::printf("%zu lists, %zu orbits; backward: %zu directions, %zu arcs; %zu whole circles\n", count.lists,
              count.orbits, count.directions, count.arcs, count.whole);
}

}  // namespace
}  // namespace oracle::oracle_unstable_families_test
