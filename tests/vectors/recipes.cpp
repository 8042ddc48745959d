// The table of recipes: ids, the groups that are about stationary points, and what has to be refused. The other groups
// are in flow_recipes.cpp and whole_complex_recipes.cpp.
#include "tests/vectors/recipes.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <string_view>

#include "fuzz/inputs/families.h"
#include "oracle/program/read_points.h"
#include "oracle/program/read_records.h"

namespace oracle::vectors {

namespace {

using flowcert::fuzz::Family;

const Family& family_named(std::string_view name) {
  for (const Family& family : flowcert::fuzz::families()) {
    if (family.name == name) return family;
  }
  throw std::logic_error("there is no family " + std::string(name));
}

// What the inputs of a family aim at.
struct FamilyAims {
  const char* family;
  const char* aims;
};

constexpr FamilyAims kAimsOfFamilies[] = {
    {"general-position", "general-position"},
    {"lattice-2", "lattice"},
    {"lattice-3", "lattice"},
    {"lattice-4", "lattice"},
    {"few-points", ""},
    {"duplicates", "lattice"},
    {"signed-permutations", "cospherical"},
    {"integer-sphere", "cospherical"},
    {"sphere-and-others", "cospherical"},
    {"box-corners", "cospherical cocircular right-angle"},
    {"tilted-circle", "cocircular"},
    {"two-circles", "cospherical cocircular"},
    {"coplanar-lattice", "lattice"},
    {"coplanar-circles", "cocircular"},
    {"collinear", ""},
    {"right-angle-12", "cocircular right-angle"},
    {"right-angle-23", "cospherical right-angle"},
    {"right-angle-13", "cospherical right-angle"},
    {"right-angles", "right-angle"},
    {"sphere-scan", "scan"},
    {"torus-scan", "scan"},
    {"sheet-scan", "scan"},
    {"long-cascade", "cascade"},
    {"half-shell", "scan half-shell"},
    {"high-degree-facet", "high-degree-facet"},
    {"right-angle-chain", "right-angle right-angle-chain"},
    {"through-vertex", "symmetric"},
    {"rounded-sphere", "cospherical rounded"},
    {"rounded-rotation", "rounded"},
    {"rounded-to-float", "rounded single-precision"},
    {"one-ulp-off", "one-ulp"},
    {"far-away", ""},
    {"far-away-rounded", "rounded"},
    {"extreme-scale", "extreme-scale"},
    {"two-scales", ""},
    {"mixed-magnitudes", ""},
};

const char* aims_of(const std::string& family) {
  for (const FamilyAims& row : kAimsOfFamilies) {
    if (row.family == family) return row.aims;
  }
  throw std::logic_error("what does the family " + family + " aim at?");
}

Group critical_points() {
  GroupWriter cases("critical-points", "Critical points of all indices",
                    "FC-CRIT-02 FC-CRIT-05 FC-CRIT-06 FC-INV-01 FC-OUT-02 FC-SIGN-02");
  cases.given(1, "two points", "", {{0, 0, 0}, {1, 0, 0}});
  cases.given(2, "an acute triangle", "", kAcuteTriangle);
  cases.given(3, "an obtuse triangle", "", {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}});
  cases.given(4, "a regular tetrahedron", "", kTetrahedron);
  cases.given(5, "a tetrahedron without a maximum: its circumcentre is outside", "",
              {{0, 0, 0}, {6, 0, 0}, {2, 5, 0}, {2, 2, 1}});
  cases.given(6, "a square and a point above its centre", "", kSquareAndPoint);
  cases.drawn(7, "general-position", 100, seeds(7));
  cases.drawn(14, "general-position", 30, seeds(3));
  cases.drawn(17, "lattice-2", 100, {1, 3, 5, 6, 7});
  cases.drawn(22, "lattice-3", 100, seeds(7));
  cases.drawn(29, "lattice-4", 100, seeds(7));
  cases.drawn(36, "sphere-scan", 100, seeds(5));
  cases.drawn(41, "torus-scan", 100, seeds(5));
  cases.drawn(46, "sheet-scan", 100, seeds(5));
  cases.given(51, "the lattice {0..2}^3: FC-INV-05 gives its counts", "lattice cospherical", grid(3, 3, 3));
  cases.given(52, "the lattice {0..2}x{0..3}x{0..4}", "lattice cospherical", grid(3, 4, 5));
  cases.given(53, "20 points of {0..4}^3", "lattice", scattered(20, 5, 1));
  cases.given(54, "30 points of {0..4}^3", "lattice", scattered(30, 5, 2));
  cases.given(55, "40 points of {0..5}^3", "lattice", scattered(40, 6, 3));
  cases.given(56, "60 points of {0..6}^3", "lattice", scattered(60, 7, 4));
  cases.given(57, "20 points in general position", "general-position", general(20, 1));
  cases.given(58, "40 points in general position", "general-position", general(40, 2));
  cases.given(59, "60 points in general position", "general-position", general(60, 3));
  cases.given(60, "two edges whose midpoints are 2^-33 apart: one position can mean both", "",
              {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0x1p-33}, {0, -1, 0x1p-33}});
  return cases.group();
}

Group regular_stationary_points() {
  GroupWriter cases("regular-stationary-points",
                    "Stationary points that are not critical: an index 1, 2 or 3 collides with another",
                    "FC-CRIT-01 FC-CRIT-03 FC-CRIT-06 FC-INV-01 FC-OUT-02");
  cases.given(1, "a right triangle: kind 1-2", "right-angle", kRightTriangle);
  cases.given(2, "the centre of a sphere inside one of four triangles: kind 2-3", "", kKind23);
  cases.given(3, "an edge through the centre of a sphere: kind 1-3", "right-angle", kKind13);
  cases.given(4, "counting the faces of any one triangulation strictly gives a wrong Euler sum",
              "cospherical right-angle", kUnmergedFaces);
  cases.given(5, "right angles and cocircular points in several places, none of them stationary", "right-angle",
              kTieInTheComplex);
  cases.given(6, "a Voronoi vertex driven by the midpoint of the first and the last point", "right-angle",
              {{1, 2, 2}, {0, 2, 1}, {1, 2, 0}, {0, 1, 0}});
  cases.given(7, "half of the cuboctahedron: a square through the centre of the sphere", "cospherical",
              first_of(sphere(2), 8));
  cases.given(8, "half of a circle of 16 points, its diameter included", "cocircular right-angle",
              {{8, 1, 0}, {8, -1, 0}, {7, 4, 0}, {4, 7, 0}, {1, 8, 0}, {-1, 8, 0}, {-4, 7, 0}, {-7, 4, 0}, {-8, 1, 0}});
  cases.drawn(9, "right-angle-12", 100, seeds(10));
  cases.drawn(19, "right-angle-23", 100, seeds(11));
  cases.drawn(30, "right-angle-13", 100, seeds(11));
  cases.drawn(41, "right-angles", 100, seeds(5));
  cases.given(46, "16 of 24 points of a sphere, eight of them on a great circle: kind 2-3", "cospherical",
              first_of(sphere(5), 16));
  cases.given(47, "two trapezoids that share an edge through the centre of their sphere: kind 1-3", "cospherical",
              {{5, 0, 0}, {-5, 0, 0}, {3, 4, 0}, {-3, 4, 0}, {4, 0, 3}, {-4, 0, 3}});
  return cases.group();
}

Group cospherical_clusters() {
  GroupWriter cases("cospherical-clusters",
                    "Cospherical and cocircular points, which a Delaunay triangulation cuts arbitrarily",
                    "FC-CRIT-02 FC-OUT-01 FC-VOR-01 FC-VOR-04");
  cases.given(1, "a square", "cocircular", grid(2, 2, 1));
  cases.given(2, "the cube", "cospherical cocircular", grid(2, 2, 2));
  cases.given(3, "the octahedron", "cospherical", sphere(1));
  cases.given(4, "the octahedron and its centre", "right-angle", joined(sphere(1), {{0, 0, 0}}));
  cases.given(5, "the cuboctahedron", "cospherical cocircular", sphere(2));
  cases.given(6, "a prism over a triangle", "cospherical cocircular", kPrism);
  cases.given(7, "a pyramid over a pentagon of a circle", "cocircular",
              {{5, 0, 0}, {3, 4, 0}, {-4, 3, 0}, {-4, -3, 0}, {0, -5, 0}, {0, 0, 7}});
  cases.given(8, "two cubes with a common face", "lattice cospherical", grid(2, 2, 3));
  cases.given(9, "the rhombic dodecahedron's corners", "cocircular", joined(sphere(3), scaled(sphere(1), 1)));
  cases.drawn(10, "signed-permutations", 100, seeds(6));
  cases.drawn(16, "integer-sphere", 100, seeds(6));
  cases.drawn(22, "sphere-and-others", 100, seeds(6));
  cases.drawn(28, "box-corners", 100, seeds(6));
  cases.drawn(34, "tilted-circle", 100, seeds(6));
  cases.drawn(40, "two-circles", 100, seeds(6));
  cases.given(46, "24 points of one sphere", "cospherical cocircular", sphere(5));
  cases.given(47, "30 points of one sphere", "cospherical cocircular", sphere(9));
  cases.given(48, "48 points of one sphere", "cospherical cocircular", sphere(14));
  cases.given(49, "60 of the 72 points of a sphere: a part of it is missing", "cospherical cocircular", sphere(26, 60));
  cases.given(50, "16 points of a circle, and one above and one below its centre", "cocircular",
              joined(circle(65, 0), {{0, 0, 3}, {0, 0, -4}}));
  cases.given(51, "three circles of 8, 12 and 12 points about one axis", "cospherical cocircular",
              joined(joined(circle(5, 0), circle(25, 2)), circle(25, -3)));
  return cases.group();
}

Group flat_inputs() {
  GroupWriter cases("flat-inputs", "No point, few points, points of a line, points of a plane",
                    "FC-CRIT-02 FC-IN-04 FC-INV-01");
  cases.given(1, "no point", "", {});
  cases.given(2, "one point", "", {{1, 2, 3}});
  cases.given(3, "three points of a line", "", {{0, 0, 0}, {1, 1, 1}, {5, 5, 5}});
  cases.given(4, "a rectangle", "cocircular right-angle", {{0, 0, 1}, {3, 0, 1}, {3, 4, 1}, {0, 4, 1}});
  cases.given(5, "a kite with two right angles", "cocircular right-angle",
              {{0, 0, 0}, {25, 0, 0}, {9, 12, 0}, {9, -12, 0}});
  cases.given(6, "a triangle with a point strictly inside", "", {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {2, 3, 0}});
  cases.drawn(7, "few-points", 0, {24, 2, 5, 7, 8, 9, 10, 22});
  cases.drawn(15, "collinear", 100, seeds(6));
  cases.drawn(21, "coplanar-lattice", 100, seeds(8));
  cases.drawn(29, "coplanar-circles", 100, seeds(8));
  cases.given(37, "60 points of a line, unevenly spaced", "", [] {
    Rows rows;
    for (int k = 0; k < 60; ++k) {
      const double t = k * k % 61 + 61 * (k % 2);
      rows.push_back({t, 2 * t, -t});
    }
    return rows;
  }());
  cases.given(38, "a square lattice of 25 points", "lattice cocircular", grid(5, 5, 1));
  cases.given(39, "a square lattice of 60 points, upright", "lattice cocircular", grid(1, 6, 10));
  cases.given(40, "16 points of a circle", "cocircular", circle(65, 1));
  return cases.group();
}

Group duplicates() {
  GroupWriter cases("duplicates", "Rows with equal coordinates, and zeros of both signs",
                    "FC-CRIT-04 FC-IN-02 FC-IN-03 FC-OUT-01");
  cases.given(1, "one point, twice", "", {{1, 2, 3}, {1, 2, 3}});
  cases.given(2, "one point, with zeros of both signs", "", {{0, 0, 0}, {-0.0, 0, 0}, {0, -0.0, -0.0}});
  cases.given(3, "two classes, one inside the other", "", {{0, 0, 0}, {2, 0, -0.0}, {0, 0, 0}, {2, 0, 0}});
  cases.given(
      4, "a class is named by its first row: the cube, each corner again, backwards", "cospherical",
      joined(grid(2, 2, 2), {{1, 1, 1}, {1, 1, 0}, {1, 0, 1}, {1, 0, 0}, {0, 1, 1}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}));
  cases.given(5, "a right triangle, each corner twice", "right-angle", joined(kRightTriangle, kRightTriangle));
  cases.given(6, "one ulp is no duplicate", "", {{1, 0, 0}, {0x1.0000000000001p+0, 0, 0}, {1, 0, 0}});
  cases.given(7, "subnormals are not zero", "", {{0, 0, 0}, {0x1p-1074, 0, 0}, {-0.0, 0, 0}});
  cases.drawn(8, "duplicates", 100, seeds(14));
  cases.given(22, "60 rows, 40 points", "lattice", joined(scattered(40, 5, 11), first_of(scattered(40, 5, 11), 20)));
  return cases.group();
}

Group rounding() {
  GroupWriter cases("rounding", "Degenerate exactly, up to rounding, and up to one ulp",
                    "FC-CRIT-05 FC-NUM-01 FC-OUT-01");
  cases.threefold(1, "a right triangle", kRightTriangle, 0, 0);
  cases.threefold(4, "a square", grid(2, 2, 1), 3, 1);
  cases.threefold(7, "the cube", grid(2, 2, 2), 7, 2);
  cases.threefold(10, "the octahedron", sphere(1), 0, 0);
  cases.threefold(13, "the cuboctahedron", sphere(2), 5, 1);
  cases.threefold(16, "a regular stationary point of kind 2-3", kKind23, 0, 0);
  cases.threefold(19, "a regular stationary point of kind 1-3", kKind13, 2, 1);
  cases.threefold(22, "four points of a plane", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {3, 3, 0}}, 3, 2);
  cases.threefold(25, "three points of a line", {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, 1, 0);
  cases.threefold(28, "a prism", kPrism, 4, 2);
  cases.threefold(31, "a cospherical cluster with right angles", kUnmergedFaces, 3, 0);
  cases.drawn(34, "rounded-sphere", 100, seeds(5));
  cases.drawn(39, "rounded-rotation", 100, seeds(6));
  cases.drawn(45, "rounded-to-float", 100, {11, 12, 13, 14, 15, 16});
  cases.drawn(51, "one-ulp-off", 100, seeds(8));
  return cases.group();
}

Group magnitudes() {
  GroupWriter cases("magnitudes", "From the smallest subnormal to the largest double",
                    "FC-CRIT-05 FC-IN-04 FC-NUM-01 FC-NUM-02");
  constexpr double kLargest = 0x1.fffffffffffffp+1023;
  cases.given(1, "1e-300 and 1e300", "", {{1e-300, 0, 0}, {1e300, 0, 0}, {0, 1e-300, 1e300}, {0, 0, 1e-300}});
  cases.given(2, "a regular tetrahedron of subnormals", "extreme-scale", scaled(kTetrahedron, -1074));
  cases.given(3, "a regular tetrahedron next to overflow", "extreme-scale", scaled(kTetrahedron, 1023));
  cases.given(4, "the corners of the cube of all doubles", "cospherical extreme-scale", [] {
    Rows rows = sphere(3);
    for (Row& row : rows) {
      for (double& coordinate : row) coordinate *= kLargest;
    }
    return rows;
  }());
  cases.given(5, "the smallest and the largest doubles on a line", "",
              {{-kLargest, 0, 0}, {-0x1p-1074, 0, 0}, {0, 0, 0}, {0x1p-1074, 0, 0}, {kLargest, 0, 0}});
  cases.given(6, "a right triangle of subnormals", "right-angle extreme-scale", scaled(kRightTriangle, -1074));
  cases.given(7, "kind 2-3 next to overflow", "extreme-scale", scaled(kKind23, 1021));
  cases.given(8, "kind 1-3 at 2^-1060", "right-angle extreme-scale", scaled(kKind13, -1060));
  cases.given(9, "a cube of size 1 at 2^52", "cospherical", shifted(grid(2, 2, 2), {0x1p+52, 0x1p+52, -0x1p+52}));
  cases.drawn(10, "far-away", 100, seeds(7));
  cases.drawn(17, "far-away-rounded", 100, seeds(6));
  cases.drawn(23, "extreme-scale", 100, seeds(8));
  cases.drawn(31, "two-scales", 60, seeds(6));
  cases.drawn(37, "mixed-magnitudes", 10, seeds(7));
  return cases.group();
}

}  // namespace

std::string case_id(const std::string& group, std::size_t number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%04zu", number);
  return group + "-" + digits;
}

std::vector<std::uint64_t> seeds(std::size_t count) {
  std::vector<std::uint64_t> list(count);
  std::iota(list.begin(), list.end(), std::uint64_t{1});
  return list;
}

std::vector<Point> positions(std::initializer_list<const char*> texts) {
  std::vector<Point> list;
  for (const char* text : texts) list.push_back(parse_position(text, "a recipe: "));
  return list;
}

GroupWriter::GroupWriter(const char* name, const char* title, const char* clauses) {
  group_.name = name;
  group_.title = title;
  group_.clauses = fields(clauses);
}

void GroupWriter::drawn(std::size_t first, const char* name, int size, const std::vector<std::uint64_t>& seeds) {
  const Family& family = family_named(name);
  for (const std::uint64_t seed : seeds) {
    const std::string comment = family.description + " (family " + name + ", seed " + std::to_string(seed) + ", size " +
                                std::to_string(size) + ")";
    given(first++, comment, aims_of(name), flowcert::fuzz::draw(family, seed, size).rows);
  }
}

void GroupWriter::given(std::size_t number, const std::string& comment, const char* aims, const Rows& points) {
  Recipe& recipe = group_.recipes.emplace_back();
  recipe.id = case_id(group_.name, number);
  recipe.comment = comment;
  recipe.aims = fields(aims);
  recipe.points = points;
  recipe.asks = asks_;
}

void GroupWriter::start_from(const std::vector<Point>& starts) { group_.recipes.back().starts = starts; }

void GroupWriter::claim_cycles(const std::vector<std::string>& lines, const std::vector<std::string>& reasons) {
  group_.recipes.back().cycle_claims.push_back({lines, reasons});
}

void GroupWriter::threefold(std::size_t first, const std::string& comment, const Rows& points, std::size_t row,
                            std::size_t axis) {
  given(first, comment, "exact-of-three", points);
  given(first + 1, comment + ", a coordinate one ulp up", "one-ulp", nudged(points, row, axis, 1));
  given(first + 2, comment + ", a coordinate one ulp down", "one-ulp", nudged(points, row, axis, -1));
}

void GroupWriter::mirrored(std::size_t first, const std::string& comment, const char* aims, const Rows& points) {
  given(first, comment, aims, points);
  Rows image = points;
  for (Row& row : image) row[0] = -row[0];
  given(first + 1, comment + ", mirrored", (std::string(aims) + " mirror-image").c_str(), image);
  std::reverse(image.begin(), image.end());
  given(first + 2, comment + ", mirrored, under other names", (std::string(aims) + " renamed").c_str(), image);
}

void add_first_cases(GroupWriter& cases) {
  cases.given(1, "no point", "", {});
  cases.given(2, "one point, twice", "", {{1, 2, 3}, {1, 2, 3}});
  cases.given(3, "two points", "", {{0, 0, 0}, {1, 0, 0}});
  cases.given(4, "four points of a line", "", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}});
  cases.given(5, "an acute triangle", "", kAcuteTriangle);
  cases.given(6, "an obtuse triangle below an acute one", "", {{0, 0, 0}, {8, 0, 0}, {4, 7, 0}, {4, -2, 0}});
  cases.given(7, "a right triangle: kind 1-2", "right-angle", kRightTriangle);
  cases.given(8, "a square", "cocircular", grid(2, 2, 1));
}

void add_stationary_groups(std::vector<Group>& table) {
  table.push_back(critical_points());
  table.push_back(regular_stationary_points());
  table.push_back(cospherical_clusters());
  table.push_back(flat_inputs());
  table.push_back(duplicates());
  table.push_back(rounding());
  table.push_back(magnitudes());
}

void require_different_ids(const std::vector<Group>& table) {
  std::vector<std::string> ids;
  for (const Group& group : table) {
    for (const Recipe& recipe : group.recipes) ids.push_back(recipe.id);
    for (const InvalidRecipe& recipe : group.invalid_recipes) ids.push_back(recipe.id);
  }
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) throw std::logic_error(*twice + " is there twice");
}

const std::vector<Group>& groups() {
  static const std::vector<Group> all = [] {
    std::vector<Group> table;
    add_stationary_groups(table);
    add_orbit_groups(table);
    add_homology_groups(table);
    add_whole_complex_groups(table);
    add_landscape_groups(table);
    add_cycle_groups(table);
    add_invalid_groups(table);
    require_different_ids(table);
    return table;
  }();
  return all;
}

// ---- What has to be refused ----

namespace {

// Makes the group, case by case. Rows and aims are lists of words, parted by blanks.
class InvalidWriter {
 public:
  InvalidWriter(const char* name, const char* title, const char* clauses) {
    group_.name = name;
    group_.title = title;
    group_.clauses = fields(clauses);
  }

  void points(std::size_t number, const char* comment, const char* aim, std::initializer_list<const char*> rows) {
    InvalidRecipe& recipe = add(number, comment, aim);
    for (const char* row : rows) recipe.points.push_back(fields(row));
  }
  // Adds three points, with a word in place of a coordinate of the second one.
  void word(std::size_t number, const char* comment, const char* aim, const std::string& word) {
    points(number, comment, aim,
           {"0x0p+0 0x0p+0 0x0p+0", ("0x1p+0 " + word + " 0x0p+0").c_str(), "0x0p+0 0x1p+1 0x0p+0"});
  }
  void text(std::size_t number, const char* comment, const char* aim, const char* text) {
    add(number, comment, aim).text = text;
  }
  // Adds the start of an orbit around two points.
  void start(std::size_t number, const char* comment, const std::string& aim, const char* start) {
    points(number, comment, ("bad-start " + aim).c_str(), {"0x0p+0 0x0p+0 0x0p+0", "0x1p+0 0x0p+0 0x0p+0"});
    group_.invalid_recipes.back().start = fields(start);
  }
  // Adds a start that is right, without any point.
  void start_alone(std::size_t number, const char* comment, const char* start) {
    points(number, comment, "no-points", {});
    group_.invalid_recipes.back().start = fields(start);
  }

  [[nodiscard]] const Group& group() const { return group_; }

 private:
  InvalidRecipe& add(std::size_t number, const char* comment, const char* aims) {
    InvalidRecipe& recipe = group_.invalid_recipes.emplace_back();
    recipe.id = case_id(group_.name, number);
    recipe.comment = comment;
    recipe.aims = fields(aims);
    return recipe;
  }

  Group group_;
};

Group invalid_input() {
  InvalidWriter cases("invalid-input", "What has no answer, and has to be refused as a whole", "FC-IN-01 FC-IN-05");
  cases.word(1, "NaN", "not-finite", "nan");
  cases.word(2, "NaN, in capitals", "not-finite", "NaN");
  cases.word(3, "NaN with a sign", "not-finite", "-nan");
  cases.word(4, "infinity", "not-finite", "inf");
  cases.word(5, "minus infinity", "not-finite", "-inf");
  cases.word(6, "infinity, in full", "not-finite", "Infinity");
  cases.word(7, "a decimal beyond the largest double", "overflow", "1e309");
  cases.word(8, "far beyond, negative", "overflow", "-1e99999");
  cases.word(9, "the decimal halfway to the next power of two, which rounds to infinity", "overflow",
             "179769313486231580793728971405303415079934132710037826936173778980444968292764750946649017"
             "977587207096330286416692887910946555547851940402630657488671505820681908902000708383676273"
             "854845817711531764475730270069855571366959622842914819860834936475292719074168444365510704"
             "342711559699508093042880177904174497792");
  cases.word(10, "a hexadecimal float beyond the largest double", "overflow", "0x1p+1024");
  cases.word(11, "a hexadecimal float of 56 bits", "inexact-hex", "0x1.00000000000001p+0");
  cases.word(12, "a hexadecimal float below the smallest subnormal", "inexact-hex", "0x1p-1075");
  cases.word(13, "a word", "no-number", "one");
  cases.word(14, "a number with letters behind it", "no-number", "1.5m");
  cases.word(15, "two points in a number", "no-number", "1.2.3");
  cases.word(16, "an exponent without digits", "no-number", "1e");
  cases.word(17, "two signs", "no-number", "--1");
  cases.word(18, "a sign alone", "no-number", "-");
  cases.word(19, "a hexadecimal float without digits", "no-number", "0x");
  cases.word(20, "a fraction: point files have none", "no-number", "1/2");
  cases.points(21, "two numbers in the first row", "short-row", {"0x0p+0 0x0p+0", "0x1p+0 0x0p+0 0x0p+0"});
  cases.points(22, "two numbers in the last row", "short-row", {"0x1p+0 0x0p+0 0x0p+0", "0x0p+0 0x0p+0"});
  cases.points(23, "one number", "short-row", {"0x1p+0"});
  cases.points(24, "NaN in the last of many rows: no part is used", "not-finite",
               {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 1 0", "1 0 1", "0 1 1", "1 1 nan"});
  cases.text(25, "no byte", "nothing-to-read", "");
  cases.text(26, "blanks and line ends", "nothing-to-read", " \t\n\n  \n");
  cases.text(27, "nothing between two commas", "no-number", "0,0,0\n1,,0\n");
  cases.text(28, "cut short in the last row", "short-row", "0 0 0\n1 0 0\n0 1");
  cases.start(29, "NaN", "not-finite start-not-finite", "nan 0 0");
  cases.start(30, "infinity", "not-finite start-not-finite", "0 0 inf");
  cases.start(31, "beyond the largest double", "overflow start-not-finite", "0 1e309 0");
  cases.start(32, "a division by zero", "not-finite start-not-finite", "1/0 0 0");
  cases.start(33, "two coordinates", "short-row", "1 2");
  cases.start(34, "a word", "no-number", "0 x 0");
  cases.start(35, "a fraction without a denominator", "no-number", "1/ 0 0");
  cases.start(36, "a hexadecimal float of 56 bits", "inexact-hex", "0x1.00000000000001p+0 0 0");
  cases.text(37, "one blank", "nothing-to-read", " ");
  cases.text(38, "empty lines as other systems end them", "nothing-to-read", "\r\n\r\n");
  cases.text(39, "tabulators, and no end of a line", "nothing-to-read", "\t\t");
  cases.start_alone(40, "the origin, and no point", "0 0 0");
  cases.start_alone(41, "fractions, and no point", "1/2 -1/3 5");
  cases.start_alone(42, "the smallest subnormal, and no point", "0 0x1p-1074 0");
  return cases.group();
}

}  // namespace

void add_invalid_groups(std::vector<Group>& table) { table.push_back(invalid_input()); }

}  // namespace oracle::vectors
