// Lines to infinity, cut at a box: on inputs of every family, with boxes of several sizes.
//
// Guarantees: the lines are compared with those that are not cut, and with exact orbits. A run fails too when too few
// lines were cut, in or before their last segment, or where they start.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "io/vtk_exports.h"
#include "tests/cites.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::clipped_lines_test {
namespace {

// A line, by places in its data set.
struct LineData {
  std::vector<std::size_t> places;
  bool to_infinity = false;
};

template <typename Number>
const std::vector<Number>& numbers(const std::vector<VtpArray>& arrays, std::string_view name) {
  for (const VtpArray& array : arrays) {
    if (array.name == name) return std::get<std::vector<Number>>(array.values);
  }
  throw std::runtime_error("no array " + std::string(name));
}

// By SeparatrixId, because a line that is cut where it starts stands among the vertices.
std::vector<LineData> lines_of(const PolyData& data) {
  const auto& ids = numbers<std::int64_t>(data.cell_data, "SeparatrixId");
  const auto& to_infinity = numbers<std::int8_t>(data.cell_data, "ToInfinity");
  std::vector<LineData> lines(ids.size());
  std::size_t cell = 0;
  for (const VtpCells* cells : {&data.vertices, &data.lines}) {
    std::int64_t first = 0;
    for (const std::int64_t last : cells->offsets) {
      LineData& line = lines.at(static_cast<std::size_t>(ids[cell]));
      line.to_infinity = to_infinity[cell++] == 1;
      for (; first < last; ++first) {
        line.places.push_back(static_cast<std::size_t>(cells->connectivity[static_cast<std::size_t>(first)]));
      }
    }
  }
  return lines;
}

struct ClippedSeen {
  std::size_t in_last = 0, before_last = 0, at_start = 0, not_cut = 0, flat = 0;
};

bool is_on_side(const Point& x, const ClipBox& box) {
  return x.x == box.low().x || x.x == box.high().x || x.y == box.low().y || x.y == box.high().y || x.z == box.low().z ||
         x.z == box.high().z;
}

void require_cut(const fuzz::Input& input, const FlowComplex& complex, const Rational& factor, ClippedSeen& seen) {
  const ClipBox box(complex.points(), factor);
  for (const Point& sample : complex.points().points()) {
    require_none(input, box.contains(sample) ? "" : "a sample is not in the box", "");
  }
  const PolyData whole = unstable_line_data(complex, std::nullopt), cut = unstable_line_data(complex, box);
  const std::vector<LineData> all = lines_of(whole), lines = lines_of(cut);
  const auto& marks = numbers<std::int8_t>(cut.point_data, "IsClipped");
  const auto& values = numbers<double>(cut.point_data, "SquaredDistance");
  const auto& whole_values = numbers<double>(whole.point_data, "SquaredDistance");
  require_none(input, all.size() == lines.size() ? "" : "another number of lines", "");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::vector<std::size_t>& places = lines[k].places;
    const bool to_infinity = lines[k].to_infinity;
    const auto& before = all[k].places;
    const auto point = [&](std::size_t i) { return cut.points[places[i]]; };
    for (std::size_t i = 0; i < places.size(); ++i) {
      require_none(input, box.contains(point(i)) ? "" : "a point is beyond the box", "");
      const bool is_end = to_infinity && i + 1 == places.size();
      require_none(input, (marks[places[i]] == 1) == is_end ? "" : "a mark is wrong", "");
      const bool is_kept = i < before.size() && point(i) == whole.points[before[i]];
      const bool is_same = is_kept && values[places[i]] == whole_values[before[i]];
      require_none(input, is_same || (is_end && i > 0) ? "" : "a point before the cut is another one", "");
    }
    if (!to_infinity) {
      require_none(input, places.size() == before.size() ? "" : "a line that ends is cut", "");
      ++seen.not_cut;
      continue;
    }
    require_none(input, is_on_side(point(places.size() - 1), box) ? "" : "the cut is inside the box", "");
    ++(places.size() > before.size() ? seen.in_last : places.size() > 1 ? seen.before_last : seen.at_start);
    seen.flat += complex.dimension() == 2 ? 1 : 0;
    // The next point would be beyond the box.
    const bool is_kept =
        places.size() <= before.size() && point(places.size() - 1) == whole.points[before[places.size() - 1]];
    const std::size_t next = is_kept ? places.size() : places.size() - 1;
    const bool is_beyond = next >= before.size() || !box.contains(whole.points[before[next]]);
    require_none(input, is_beyond ? "" : "a line is cut too early", "");
  }
}

TEST(ClippedLines, AreInTheBoxAndTheSameBeforeTheCut) {
  CITES("FC-FLOW-07", "FC-NUM-02");
  ClippedSeen seen;
  bool held = true;
  for (const fuzz::Family& family : fuzz::families()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    const auto property = [&] {
      const fuzz::Input input = *generator;
      const FlowComplex complex(point_set_of(input));
      if (complex.points().empty()) return;
      try {
        (void)unstable_line_data(complex, std::nullopt);
      } catch (const InvalidInput&) {
        return;  // beyond the doubles
      }
      for (const Rational& factor : {Rational(1), Rational(3, 2), Rational(3), Rational(1000)}) {
        require_cut(input, complex, factor, seen);
      }
    };
    held = expect_holds(family.name, parameters_of_run(80, held), property) && held;
  }
  std::printf("lines cut in their last segment %zu, before it %zu, where they start %zu, in a plane %zu; not cut %zu\n",
              seen.in_last, seen.before_last, seen.at_start, seen.flat, seen.not_cut);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.in_last, 5000U);
  EXPECT_GE(seen.before_last, 1000U);
  EXPECT_GE(seen.at_start, 50U);
  EXPECT_GE(seen.flat, 500U);
  EXPECT_GE(seen.not_cut, 1000U);
}

// (b-a) x (c-a) for the first three contact points, which points to side 1, or its opposite.
std::array<Rational, 3> normal_of(const FlowComplex& complex, std::size_t saddle, bool to_side_1) {
  const PointSet& points = complex.points();
  std::array<std::array<Rational, 3>, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = points[points.ordinal_of_row(complex.stationary().contact(saddle)[k])];
    at[k] = {Rational(p.x), Rational(p.y), Rational(p.z)};
  }
  std::array<Rational, 3> u, v, normal;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = at[1][k] - at[0][k];
    v[k] = at[2][k] - at[0][k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    normal[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    if (!to_side_1) normal[k] = -normal[k];
  }
  return normal;
}

// An orbit that never leaves its Voronoi edge goes along the normal of its circle.
TEST(ClippedLines, DirectionsAreThoseOfTheLastSegments) {
  CITES("FC-FLOW-07");
  std::size_t directions = 0, whole_lines = 0;
  for (const fuzz::Family& family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const FlowComplex complex(point_set_of(fuzz::draw(family, seed, 30)));
      const UnstableManifolds& u2 = complex.unstable();
      for (std::size_t i = 0; i < u2.size(); ++i) {
        for (const std::size_t side : {1U, 0U}) {
          const std::optional<Point> direction = u2.direction_to_infinity(i, side);
          ASSERT_EQ(direction.has_value(), !u2.limit(i, side));
          if (!direction) continue;
          const FlowSegment last = u2.orbit(i, side).segments.back();
          std::array<Rational, 3> way;
          for (std::size_t k = 0; k < 3; ++k) way[k] = last.start[k] - last.driver[k];
          if (last.start == last.driver) {
            way = normal_of(complex, u2.saddle(i), side == 1);
            ++whole_lines;
          }
          const Rational largest = std::max({Rational(abs(way[0])), Rational(abs(way[1])), Rational(abs(way[2]))});
          EXPECT_EQ(direction->x, nearest_double(way[0] / largest));
          EXPECT_EQ(direction->y, nearest_double(way[1] / largest));
          EXPECT_EQ(direction->z, nearest_double(way[2] / largest));
          ++directions;
        }
      }
    }
  }
  EXPECT_GT(directions, 500U);
  EXPECT_GT(whole_lines, 100U);
}

}  // namespace
}  // namespace flowcert::property::clipped_lines_test
