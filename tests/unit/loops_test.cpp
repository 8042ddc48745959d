// Surfaces and loops of persistence pairs, by elimination in full columns over Z/2. The test reads boundaries and pairs
// of the library, and reduces for itself.
#include "flowcert/loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "flowcert/flow_complex.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"
#include "tests/unit/drawn_sets.h"

namespace flowcert::loops_test {
namespace {

using Chain = std::set<std::uint32_t>;

void add(Chain& chain, std::span<const std::uint32_t> other) {
  for (const std::uint32_t point : other) {
    if (!chain.erase(point)) chain.insert(point);
  }
}

// Boundaries, of which no two have the same latest point.
class Basis {
 public:
  explicit Basis(const SquaredDistances& values) : values_(&values) {}

  // What is left of a chain when columns have been added to it.
  [[nodiscard]] Chain rest(Chain chain) const {
    Chain left;
    while (!chain.empty()) {
      const std::uint32_t latest = latest_of(chain);
      if (const auto known = columns_.find(latest); known != columns_.end()) {
        add(chain, std::vector(known->second.begin(), known->second.end()));
      } else {
        left.insert(latest);
        chain.erase(latest);
      }
    }
    return left;
  }
  // Whether it was independent.
  bool insert(const Chain& chain) {
    const Chain left = rest(chain);
    if (left.empty()) return false;
    columns_[latest_of(left)] = left;
    return true;
  }
  // A basis of the sums of columns that have no greater values than the level.
  [[nodiscard]] Basis up_to(const Rational& level) const {
    Basis lower(*values_);
    for (const auto& [latest, column] : columns_) {
      if (values_->exact(latest) <= level) lower.columns_[latest] = column;
    }
    return lower;
  }
  // Adds those of another basis that have no point of this rank or a greater one.
  void insert_below(std::uint32_t rank, const Basis& other) {
    for (const auto& [latest, column] : other.columns_) {
      if (values_->rank(latest) < rank) insert(column);
    }
  }

 private:
  [[nodiscard]] std::uint32_t latest_of(const Chain& chain) const {
    return *std::ranges::max_element(chain, {}, [this](std::uint32_t e) { return std::pair{values_->rank(e), e}; });
  }

  const SquaredDistances* values_;
  std::map<std::uint32_t, Chain> columns_;
};

struct Seen {
  std::size_t loops = 0, additions = 0, several = 0, polygons = 0, cocycles = 0, met = 0;
};

class LoopsOf {
 public:
  LoopsOf(const FlowComplex& complex, Seen& seen)
      : complex_(complex),
        persistence_(complex.persistence()),
        values_(persistence_.squared_distances()),
        loops_(complex.stationary(), complex.links(), persistence_),
        seen_(seen) {
    seen.additions += persistence_.additions().size();
  }

  void expect_right() {
    const auto& counts = complex_.stationary().critical_counts();
    const std::size_t first_saddle = counts[0] + counts[1];
    std::map<std::uint32_t, std::vector<PersistencePair>> by_death;
    for (const PersistencePair& pair : persistence_.pairs()) {
      if (pair.dimension == 1) by_death[values_.rank(*pair.death)].push_back(pair);
    }
    std::vector<std::uint32_t> saddles;
    for (const std::uint32_t record : values_.ascending()) {
      if (record >= first_saddle && record < first_saddle + counts[2]) saddles.push_back(record);
    }
    Basis before(values_);  // boundaries of points below the death
    Basis until(values_);   // those of points of the death's value, too
    const auto insert_until = [&](auto& next, Basis& basis, std::uint32_t end) {
      for (; next != saddles.end() && values_.rank(*next) < end; ++next) {
        const auto lower = complex_.links().lower(*next - first_saddle);
        basis.insert(Chain(lower.begin(), lower.end()));
      }
    };
    auto next_before = saddles.begin(), next_until = saddles.begin();
    for (const auto& [death, pairs] : by_death) {
      insert_until(next_before, before, death);
      insert_until(next_until, until, death + 1);
      for (const PersistencePair& pair : pairs) {
        const Rational b = values_.exact(pair.birth), d = values_.exact(*pair.death);
        for (const int share : {0, 1, 2, 3}) expect_loops_at(b + (d - b) * share / 4, pairs, before);
        expect_loops_at_birth(values_.rank(pair.birth), pairs, before, until);
        expect_witness(pair);
      }
    }
  }

 private:
  // The loops at one level of pairs of one death are a basis of their quotient (FC-CYC-03).
  void expect_loops_at(const Rational& level, const std::vector<PersistencePair>& pairs, const Basis& before) {
    Basis quotient = before.up_to(level);
    for (const PersistencePair& pair : pairs) {
      if (values_.exact(pair.birth) > level) continue;
      const std::vector<std::uint32_t> surface = loops_.surface(pair, level);
      expect_surface(surface, pair, level);
      const std::vector<std::uint32_t> loop = loops_.boundary(surface);
      for (const std::uint32_t edge : loop) EXPECT_LE(values_.exact(edge), level);
      EXPECT_TRUE(quotient.insert(Chain(loop.begin(), loop.end())));
      expect_polygons(loop);
      ++seen_.loops;
      seen_.several += surface.size() > 1 ? 1 : 0;
    }
  }

  // The loops at birth of pairs of one birth and death are a basis of theirs (FC-CYC-02).
  void expect_loops_at_birth(std::uint32_t birth, const std::vector<PersistencePair>& pairs, const Basis& before,
                             const Basis& until) {
    std::optional<Basis> quotient;
    for (const PersistencePair& pair : pairs) {
      if (values_.rank(pair.birth) != birth) continue;
      const Rational level = values_.exact(pair.birth);
      if (!quotient) {
        quotient = before.up_to(level);
        quotient->insert_below(birth, until);
      }
      const std::vector<std::uint32_t> loop = loops_.boundary(loops_.surface(pair, level));
      EXPECT_TRUE(quotient->insert(Chain(loop.begin(), loop.end())));
    }
  }

  // The only chain of this kind (FC-CYC-04).
  void expect_surface(const std::vector<std::uint32_t>& surface, const PersistencePair& pair, const Rational& level) {
    EXPECT_TRUE(std::ranges::is_sorted(surface));
    EXPECT_TRUE(std::ranges::binary_search(surface, *pair.death));
    for (const std::uint32_t saddle : surface) {
      if (saddle == *pair.death) continue;
      EXPECT_LT(std::pair(values_.rank(saddle), saddle), std::pair(values_.rank(*pair.death), *pair.death));
      EXPECT_EQ(complex_.stationary().index(persistence_.partner(saddle)), (StationaryIndex{1, 1}));
      EXPECT_GT(values_.exact(persistence_.partner(saddle)), level);
    }
  }

  // What FC-CYC-08 asks for, of all index-2 points there are.
  void expect_witness(const PersistencePair& pair) {
    const auto [surface, loop, cocycle, met] = loops_.witness(pair);
    const auto common = [&](std::span<const std::uint32_t> chain) {
      return std::ranges::count_if(chain, [&](std::uint32_t e) { return std::ranges::binary_search(cocycle, e); });
    };
    EXPECT_EQ(loops_.boundary(surface), loop);
    EXPECT_EQ(common(loop) % 2, 1);
    for (const std::uint32_t edge : loop) EXPECT_LE(values_.rank(edge), values_.rank(pair.birth));
    for (const std::uint32_t saddle : surface) EXPECT_LE(values_.rank(saddle), values_.rank(*pair.death));
    for (const std::uint32_t edge : cocycle) EXPECT_GE(values_.rank(edge), values_.rank(pair.birth));
    const auto& counts = complex_.stationary().critical_counts();
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < counts[2]; ++i) {
      const auto saddle = static_cast<std::uint32_t>(counts[0] + counts[1] + i);
      if (values_.rank(saddle) >= values_.rank(*pair.death)) continue;
      const auto times = common(complex_.links().lower(i));
      EXPECT_EQ(times % 2, 0);
      if (times > 0) expected.push_back(saddle);
    }
    EXPECT_EQ(met, expected);
    seen_.cocycles += cocycle.size() > 1 ? 1 : 0;
    seen_.met += met.size();
  }

  // They have the edges of the loop, once each, and no sample twice.
  void expect_polygons(const std::vector<std::uint32_t>& loop) {
    std::set<std::pair<PointId, PointId>> edges, walked;
    for (const std::uint32_t edge : loop) {
      const auto ends = complex_.stationary().contact(edge);
      edges.emplace(ends[0], ends[1]);
    }
    const std::vector<LoopPolygon> polygons = loops_.polygons(loop);
    for (const LoopPolygon& polygon : polygons) {
      EXPECT_EQ(std::set(polygon.begin(), polygon.end()).size(), polygon.size());
      EXPECT_EQ(*std::ranges::min_element(polygon), polygon.front());
      EXPECT_LT(polygon[1], polygon.back());
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const auto [one, other] = std::minmax(polygon[k], polygon[(k + 1) % polygon.size()]);
        EXPECT_TRUE(walked.emplace(one, other).second);
      }
    }
    EXPECT_EQ(walked, edges);
    seen_.polygons += polygons.size() > 1 ? 1 : 0;
  }

  const FlowComplex& complex_;
  const Persistence& persistence_;
  const SquaredDistances& values_;
  Loops loops_;
  Seen& seen_;
};

TEST(Loops, AreABasisAtEachLevelOfDegenerateInputs) {
  CITES("FC-CYC-01", "FC-CYC-02", "FC-CYC-03", "FC-CYC-04", "FC-CYC-05", "FC-CYC-08");
  Seen seen;
  flowcert_tests::for_each_drawn_set({.seeds = 6, .made = 2, .most_rows = 60}, [&](const auto& rows, std::uint64_t) {
    const FlowComplex complex(PointSet(property::rows_of(fuzz::Input{.rows = rows})));
    LoopsOf(complex, seen).expect_right();
  });
  EXPECT_GT(seen.loops, 1000U);
}

// Only larger inputs have surfaces of many points.
TEST(Loops, AreABasisAtEachLevelOfLargerInputs) {
  CITES("FC-CYC-02", "FC-CYC-03", "FC-CYC-04", "FC-CYC-05", "FC-CYC-08");
  Seen seen;
  flowcert_tests::for_each_grid([&](const auto& rows) {
    const FlowComplex complex(PointSet(property::rows_of(fuzz::Input{.rows = rows})));
    LoopsOf(complex, seen).expect_right();
  });
  EXPECT_GT(seen.additions, 100U);
  EXPECT_GT(seen.several, 100U);
  EXPECT_GT(seen.cocycles, 100U);
  EXPECT_GT(seen.met, 100U);
  EXPECT_GT(seen.polygons, 0U) << "otherwise no loop of several polygons was seen";
}

}  // namespace
}  // namespace flowcert::loops_test
