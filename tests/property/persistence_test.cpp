// Chain complex and persistence, on every family of degenerate inputs: against their own laws, against a
// textbook reduction of the whole boundary matrix, against themselves with ties broken otherwise, and against
// GUDHI's persistence of the alpha complex.
//
// Guarantees: everything is compared exactly. The test fails too when a run has met too few inputs without
// ties, or too few with ties.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>

#include "flowcert/flow_complex.h"
#include "fuzz/inputs/families.h"
#include "fuzz/inputs/integer_points.h"
#include "fuzz/inputs/stable_configurations.h"
#include "fuzz/properties/input_points.h"
#include "geometry/disjoint_sets.h"
#include "tests/cites.h"
#include "tests/property/alpha_persistence.h"
#include "tests/property/orbit_inputs.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::persistence_test {
namespace {

constexpr int kInputsPerFamily = 100;
constexpr int kInputsMadeForThis = 200;  // of each of the families for stable sets
constexpr int kLargerInputs = 2;
constexpr int kThroughTwo = 500;
constexpr std::uint64_t kSeeds[] = {1, 2, 3};

using Chain = std::vector<std::uint32_t>;  // records, ascending

// Everything of one input, with one way of breaking ties.
struct Subject : FlowComplex {
  explicit Subject(const PointSet& points, std::uint64_t seed = 0) : FlowComplex(points, {.seed = seed}) {}

  [[nodiscard]] int index(std::size_t record) const { return stationary().index(record).face_dimension; }
  [[nodiscard]] std::size_t critical_count() const {
    const auto& counts = stationary().critical_counts();
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  }
  [[nodiscard]] bool has_ties() const { return chains().broken_ties() > 0 || stable().statistics().broken_ties > 0; }
  [[nodiscard]] Chain boundary(std::size_t record) const {
    const auto boundary = chains().boundary(record);
    return {boundary.begin(), boundary.end()};
  }
};

Chain sum_mod_2(const Chain& a, const Chain& b) {
  Chain sum;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(sum));
  return sum;
}

Chain boundary_of_boundary(const Subject& subject, std::size_t record) {
  Chain sum;
  for (const std::uint32_t cell : subject.boundary(record)) sum = sum_mod_2(sum, subject.boundary(cell));
  return sum;
}

// A maximum's boundary without ties: the index-2 points of which exactly one orbit of U2 ends there.
Chain boundary_by_orbits(const Subject& subject, std::size_t maximum) {
  Chain boundary;
  for (std::size_t i = 0; i < subject.unstable().size(); ++i) {
    const bool both = subject.unstable().limit(i, 0) == subject.unstable().limit(i, 1);
    const bool ends_there = subject.unstable().limit(i, 0) == maximum || subject.unstable().limit(i, 1) == maximum;
    if (ends_there && !both) boundary.push_back(static_cast<std::uint32_t>(subject.unstable().saddle(i)));
  }
  return boundary;
}

// The samples of an index-1 point.
Chain samples_of(const Subject& subject, std::size_t record) {
  Chain samples;
  for (const PointId name : subject.stationary().contact(record)) {
    samples.push_back(static_cast<std::uint32_t>(subject.points().ordinal_of_row(name)));
  }
  return samples;
}

// The first law of chain complexes that is broken; empty if none.
std::string broken_complex(const Subject& subject) {
  for (std::size_t record = 0; record < subject.critical_count(); ++record) {
    const Chain boundary = subject.boundary(record);
    const std::string where = "record " + std::to_string(record) + ": ";
    if (!std::ranges::is_sorted(boundary) || std::ranges::adjacent_find(boundary) != boundary.end()) {
      return where + "the boundary is no ascending list";
    }
    for (const std::uint32_t cell : boundary) {
      if (subject.index(cell) != subject.index(record) - 1) return where + "a boundary of another dimension";
      if (subject.persistence().squared_value(cell) >= subject.persistence().squared_value(record)) {
        return where + "its boundary is not below it";
      }
    }
    if (subject.index(record) == 1 && boundary != samples_of(subject, record)) return where + "not its samples";
    if (subject.index(record) == 3 && !subject.has_ties() && boundary != boundary_by_orbits(subject, record)) {
      return where + "not the index-2 points of which one orbit ends there";
    }
    const bool has_to_vanish = subject.index(record) == 2 || !subject.has_ties();
    if (has_to_vanish && !boundary_of_boundary(subject, record).empty()) {
      return where + "the boundary of its boundary is not zero";
    }
  }
  return {};
}

// The reduction of the whole boundary matrix: columns from left to right, each reduced by those before it,
// with no clearing, no union-find, and no regard to dimension.
class Reduction {
 public:
  // Leaves out the cells of an index above this.
  Reduction(const Subject& subject, int highest_index) : subject_(subject) {
    std::vector<std::size_t> order(subject.critical_count());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t record) { return subject.index(record) > highest_index; });
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      const Rational &x = subject.persistence().squared_value(a), &y = subject.persistence().squared_value(b);
      return x != y ? x < y : subject.index(a) < subject.index(b);
    });
    std::map<std::size_t, std::uint32_t> place;
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<std::uint32_t>(k);
    for (const std::size_t record : order) {
      Chain column;
      for (const std::uint32_t cell : subject.boundary(record)) column.push_back(place.at(cell));
      std::ranges::sort(column);
      while (!column.empty() && column_of_.contains(column.back())) {
        column = sum_mod_2(column, column_of_.at(column.back()));
      }
      if (column.empty()) {
        zero_.insert(record);
      } else {
        partner_[order[column.back()]] = record;
        column_of_[column.back()] = column;
      }
    }
  }

  [[nodiscard]] bool is_zero(std::size_t record) const { return zero_.contains(record); }
  [[nodiscard]] std::vector<ExactPair> pairs() const {
    const auto value = [&](std::size_t record) { return subject_.persistence().squared_value(record); };
    std::vector<ExactPair> pairs;
    for (const std::size_t birth : zero_) {
      const auto death = partner_.find(birth);
      pairs.push_back({subject_.index(birth), value(birth), std::nullopt});
      if (death != partner_.end()) pairs.back().death = value(death->second);
    }
    std::ranges::sort(pairs, std::less<>());
    return pairs;
  }

 private:
  const Subject& subject_;
  std::map<std::uint32_t, Chain> column_of_;  // by the last place
  std::map<std::size_t, std::size_t> partner_;
  std::set<std::size_t> zero_;
};

// An index-2 point's boundary reduces to zero iff the union-find has paired the point with a maximum.
std::string broken_invariant(const Subject& subject) {
  std::set<std::size_t> opens_void;
  for (const PersistencePair& pair : subject.persistence().pairs()) {
    if (pair.dimension == 2) opens_void.insert(pair.birth);
  }
  const Reduction reduction(subject, 2);
  for (std::size_t record = 0; record < subject.critical_count(); ++record) {
    if (subject.index(record) == 2 && reduction.is_zero(record) != opens_void.contains(record)) {
      return "record " + std::to_string(record) + " " +
             (opens_void.contains(record) ? "opens a void, but its column is not zero"
                                          : "fills a tunnel, but its column is zero");
    }
  }
  return {};
}

// Every critical point is in one pair. Just one pair is without end, that of a component.
std::string broken_pairing(const Subject& subject) {
  std::vector<int> times(subject.critical_count(), 0);
  std::array<std::size_t, 4> lasting{};
  for (const PersistencePair& pair : subject.persistence().pairs()) {
    if (subject.index(pair.birth) != pair.dimension) return "a birth of another dimension";
    ++times[pair.birth];
    if (!pair.death) {
      ++lasting.at(static_cast<std::size_t>(pair.dimension));
      continue;
    }
    ++times[*pair.death];
    if (subject.index(*pair.death) != pair.dimension + 1) return "a death of another dimension";
    if (subject.persistence().squared_value(*pair.death) <= subject.persistence().squared_value(pair.birth)) {
      return "a pair of length zero, or less";
    }
  }
  if (std::ranges::any_of(times, [](int count) { return count != 1; })) return "a point in no pair, or in two";
  const std::array<std::size_t, 4> of_a_point = {subject.points().empty() ? 0U : 1U, 0, 0, 0};
  return lasting == of_a_point ? "" : "not the homology of a point";
}

// The link of an index-2 point of value s has, above each side, a maximum of the component of {d^2 > s} that has the
// limit of U2, too. The components come together from the greatest value down.
std::string broken_links(const Subject& subject) {
  const ChainComplex& chains = subject.chains();
  const SaddleLinks& links = subject.links();
  const std::size_t first = subject.stationary().critical_counts()[0] + subject.stationary().critical_counts()[1];
  if (links.size() != chains.limits().size()) return "links of other points";
  const auto leaf = [](std::uint32_t maximum) { return maximum == SaddleLinks::kInfinity ? 0 : maximum + 1; };
  std::vector<std::size_t> saddles(links.size());
  std::iota(saddles.begin(), saddles.end(), std::size_t{0});
  const auto value = [&](std::size_t i) { return subject.persistence().squared_value(first + i); };
  std::ranges::stable_sort(saddles, std::greater<>(), value);
  geometry::DisjointSets components(subject.critical_count() + 1);
  for (std::size_t k = 0; k < saddles.size();) {
    const std::size_t begin = k;
    for (; k < saddles.size() && value(saddles[k]) == value(saddles[begin]); ++k) {
      const std::size_t i = saddles[k];
      if (!std::ranges::equal(links.lower(i), chains.boundary(first + i)))
        return "a link whose lower part is no boundary";
      const auto sides = [&](const std::array<std::uint32_t, 2>& maxima) {
        return std::minmax({components.find(leaf(maxima[0])), components.find(leaf(maxima[1]))});
      };
      if (sides(links.upper(i)) != sides(chains.limits()[i])) {
        return "record " + std::to_string(first + i) + ": a link with a maximum of another component";
      }
    }
    for (std::size_t at = begin; at < k; ++at) {
      components.unite(leaf(links.upper(saddles[at])[0]), leaf(links.upper(saddles[at])[1]));
    }
  }
  const Persistence by_orbits(subject.points(), subject.stationary(), chains);
  return by_orbits.pairs() == subject.persistence().pairs() ? "" : "other pairs from the chain complex";
}

// What a run has met.
struct Seen {
  std::size_t inputs = 0;
  std::size_t with_maxima = 0;
  std::size_t free_of_ties = 0;  // of those with maxima
  std::size_t not_a_complex = 0;
  std::size_t u2_ties = 0;
  std::size_t s2_ties = 0;
  std::size_t other_choice = 0;  // another seed gave another boundary
  std::array<std::size_t, 3> pairs{};

  void add(const Seen& other);
};

void Seen::add(const Seen& other) {
  inputs += other.inputs;
  with_maxima += other.with_maxima;
  free_of_ties += other.free_of_ties;
  not_a_complex += other.not_a_complex;
  u2_ties += other.u2_ties;
  s2_ties += other.s2_ties;
  other_choice += other.other_choice;
  for (std::size_t k = 0; k < 3; ++k) pairs.at(k) += other.pairs.at(k);
}

void count(const Subject& subject, const std::vector<ExactPair>& pairs, Seen& seen) {
  ++seen.inputs;
  if (subject.stationary().critical_counts()[3] > 0) {
    ++seen.with_maxima;
    seen.free_of_ties += subject.has_ties() ? 0 : 1;
  }
  seen.u2_ties += subject.chains().broken_ties();
  seen.s2_ties += subject.stable().statistics().broken_ties;
  for (const ExactPair& pair : pairs) ++seen.pairs.at(static_cast<std::size_t>(pair.dimension));
  for (std::size_t record = 0; record < subject.critical_count(); ++record) {
    if (!boundary_of_boundary(subject, record).empty()) {
      ++seen.not_a_complex;
      break;
    }
  }
}

void print_head() {
  std::printf("FLOWCERT_PROPERTY_SEED=%llu:\n", static_cast<unsigned long long>(seed_of_run()));
  std::printf("%-22s %6s %7s %9s %8s %8s %6s %12s %21s\n", "family", "inputs", "maxima", "tie-free", "U2 ties",
              "S2 ties", "other", "dd not zero", "pairs of dim. 0, 1, 2");
}

void print_row(const std::string& name, const Seen& seen) {
  std::printf("%-22s %6zu %7zu %9zu %8zu %8zu %6zu %12zu %7zu %6zu %6zu\n", name.c_str(), seen.inputs, seen.with_maxima,
              seen.free_of_ties, seen.u2_ties, seen.s2_ties, seen.other_choice, seen.not_a_complex, seen.pairs[0],
              seen.pairs[1], seen.pairs[2]);
}

bool have_same_boundaries(const Subject& a, const Subject& b) {
  for (std::size_t record = 0; record < a.critical_count(); ++record) {
    if (a.boundary(record) != b.boundary(record)) return false;
  }
  return true;
}

// The first law that one way of breaking ties breaks; empty if none.
std::string broken_laws(const Subject& subject, const std::vector<ExactPair>& pairs) {
  for (const auto& law : {broken_complex, broken_links, broken_pairing, broken_invariant}) {
    if (const std::string broken = law(subject); !broken.empty()) return broken;
  }
  if (subject.has_ties()) return {};
  return difference(pairs, Reduction(subject, 3).pairs()).empty() ? "" : "not what the textbook has";
}

// What is wrong; empty if nothing is.
std::string complaint_about(const fuzz::Input& input, Seen& seen) {
  const PointSet points = point_set_of(input);
  const Subject first(points);
  const std::vector<ExactPair> pairs = exact_pairs(first.persistence());
  count(first, pairs, seen);
  if (const std::string broken = broken_laws(first, pairs); !broken.empty()) return broken;
  bool is_other = false;
  for (const std::uint64_t seed : kSeeds) {
    const Subject other(points, seed);
    const std::string which = ", ties broken with seed " + std::to_string(seed);
    const std::vector<ExactPair> others = exact_pairs(other.persistence());
    if (const std::string broken = broken_laws(other, others); !broken.empty()) return broken + which;
    if (others != pairs) return "other pairs" + which;
    if (!have_same_boundaries(first, other)) is_other = true;
    if (is_other && !first.has_ties()) return "other boundaries, though there is no tie" + which;
  }
  seen.other_choice += is_other ? 1 : 0;
  return difference(pairs, alpha_persistence(points.points()));
}

// Shrinks only the first failure, and that one only if `shrinks` is true.
Seen run_of(const std::vector<fuzz::Family>& families, int count, bool shrinks) {
  Seen all;
  bool agreed = true;
  print_head();
  for (const fuzz::Family& family : families) {
    Seen seen;
    const rc::Gen<fuzz::Input> inputs = family.generate();
    const auto holds = [&] {
      const fuzz::Input input = *inputs;
      const std::string complaint = complaint_about(input, seen);
      if (complaint.empty()) return;
      std::ostringstream text;
      text << complaint << "\ninput:\n" << input;
      RC_FAIL(text.str());
    };
    agreed = expect_holds(family.name, parameters_of_run(count, shrinks && agreed), holds) && agreed;
    print_row(family.name, seen);
    all.add(seen);
  }
  print_row("all", all);
  return all;
}

TEST(PersistenceTest, IsThatOfTheAlphaComplexHoweverTiesAreBroken) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02", "FC-CHAIN-03", "FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-04",
        "FC-TREE-04");
  const Seen all = run_of(fuzz::families(), kInputsPerFamily, true);
  if (scale_of_run() < 1) return;
  EXPECT_GE(all.with_maxima, all.inputs / 10);
  EXPECT_GE(all.free_of_ties, all.with_maxima / 3);
  EXPECT_GE(all.with_maxima - all.free_of_ties, all.with_maxima / 10);
  EXPECT_GT(all.u2_ties, 0U);
  EXPECT_GT(all.s2_ties, 0U);
  EXPECT_GT(all.other_choice, 0U);
  EXPECT_GT(all.not_a_complex, 0U);
}

TEST(PersistenceTest, IsThatOfTheAlphaComplexWhereBranchesMeetVoronoiVertices) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02", "FC-CHAIN-03", "FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-04");
  const Seen all = run_of(fuzz::stable_families(), kInputsMadeForThis, true);
  if (scale_of_run() < 1) return;
  EXPECT_GE(all.s2_ties, all.inputs / 2);
  EXPECT_GE(all.other_choice, all.inputs / 8);
}

TEST(PersistenceTest, IsThatOfTheAlphaComplexOfLargerInputs) {
  CITES("FC-CHAIN-01", "FC-CHAIN-02", "FC-CHAIN-03", "FC-PERS-01", "FC-PERS-02", "FC-PERS-03", "FC-PERS-04");
  const Seen all = run_of(larger_families(), kLargerInputs, false);
  if (scale_of_run() < 1) return;
  EXPECT_GT(all.free_of_ties, 0U);
  EXPECT_GT(all.other_choice, 0U);
  for (const std::size_t pairs : all.pairs) EXPECT_GE(pairs, 100U);
}

// Some path at a Voronoi vertex has a right-angled edge here. The edge's branch goes on along a Voronoi edge,
// and comes to another Voronoi vertex before it comes to that polygon's centre. Among random points one set
// in ten thousand does this.
const std::vector<fuzz::IntegerPoints> kThroughTwoVertices = {
    {{-1, 2, 1}, {2, 2, -1}, {0, -1, 0}, {-1, 0, 1}, {2, 0, 0}, {-1, 0, 0}},
    {{-2, 2, 4}, {0, 2, 3}, {2, 2, 7}, {-1, 2, 3}, {-1, -2, 4}, {-2, -1, 4}},
    {{1, -1, 1}, {2, 0, 2}, {-1, 1, -1}, {2, 2, 0}, {-1, 0, 2}, {0, -1, 2}},
    {{-2, -2, 1}, {-3, 0, 1}, {-1, 2, 2}, {-2, -1, 2}, {1, 2, -1}, {-1, -2, 2}, {0, -3, 0}},
    {{-1, 1, 1}, {0, -2, 0}, {-1, -1, 1}, {0, -1, -2}, {2, 1, -1}, {2, -1, 1}, {0, -1, 1}},
    {{2, 1, 3}, {3, 2, 0}, {0, 2, 0}, {2, 0, 2}, {2, 0, 1}, {0, 0, 1}, {1, 0, 0}, {3, 3, 2}}};

// One of these sets, with up to four points more.
fuzz::Family through_two_vertices() {
  const auto generate = [] {
    return fuzz::input_of(rc::gen::apply(
        [](fuzz::IntegerPoints points, const fuzz::IntegerPoints& more) {
          points.insert(points.end(), more.begin(), more.end());
          return points;
        },
        rc::gen::elementOf(kThroughTwoVertices),
        rc::gen::mapcat(rc::gen::inRange<std::size_t>(0, 5), [](std::size_t count) {
          return rc::gen::container<fuzz::IntegerPoints>(count, fuzz::integer_point(-6, 6));
        })));
  };
  return {"through-two-vertices", "a path turns at two Voronoi vertices", generate, {}};
}

TEST(PersistenceTest, PathsGoOnFromOneVoronoiVertexToTheNext) {
  CITES("FC-CHAIN-02", "FC-PERS-01");
  const Seen all = run_of({through_two_vertices()}, kThroughTwo, true);
  if (scale_of_run() < 1) return;
  EXPECT_GE(all.other_choice, all.inputs / 10);
}

// This is fuzz/regressions/boundary-of-boundary.xyz. Some choices at its ties suit each other, others do not.
TEST(PersistenceTest, ABoundaryOfABoundaryNeedNotBeZeroWhereThereIsATie) {
  CITES("FC-CHAIN-02", "FC-CHAIN-03", "FC-PERS-01");
  const fuzz::Input input{{{0, 5, 0}, {-3, 0, -2}, {3, 0, -2}, {0, 0, 12}, {0, -5, 0}}};
  const PointSet points = point_set_of(input);
  const std::vector<ExactPair> expected = alpha_persistence(points.points());
  std::set<std::vector<Chain>> complexes;
  std::set<bool> is_zero;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Subject subject(points, seed);
    EXPECT_TRUE(subject.has_ties());
    const std::size_t maximum = subject.critical_count() - 1;
    ASSERT_EQ(subject.index(maximum), 3);
    is_zero.insert(boundary_of_boundary(subject, maximum).empty());
    EXPECT_EQ(difference(exact_pairs(subject.persistence()), expected), "") << seed;
    std::vector<Chain> boundaries;
    for (std::size_t k = 0; k <= maximum; ++k) boundaries.push_back(subject.boundary(k));
    complexes.insert(boundaries);
  }
  EXPECT_EQ(is_zero, (std::set<bool>{false, true}));
  // There are four paths between opposite corners of a tetrahedron, and two ways on for each of two orbits.
  EXPECT_EQ(complexes.size(), 16U);
}

TEST(PersistenceTest, TheComplexOfTheCube) {
  CITES("FC-CHAIN-01");
  fuzz::Input input;
  for (int k = 0; k < 8; ++k) {
    input.rows.push_back({static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1), static_cast<double>(k >> 2)});
  }
  const PointSet points = point_set_of(input);
  const Subject subject(points);
  ASSERT_EQ(subject.critical_count(), 27U);
  EXPECT_FALSE(subject.has_ties());
  for (std::size_t record = 0; record < 27; ++record) {
    EXPECT_EQ(subject.boundary(record).size(), 2U * static_cast<std::size_t>(subject.index(record)));
    // A face contains the faces in its boundary.
    for (const std::uint32_t cell : subject.boundary(record)) {
      EXPECT_TRUE(std::ranges::includes(subject.stationary().contact(record), subject.stationary().contact(cell)));
    }
  }
}

}  // namespace
}  // namespace flowcert::property::persistence_test
