// The flow complex that a user holds: its parts are those that are computed one by one, it may be moved and
// shared, and it is made once however many threads ask for it.
#include "flowcert/flow_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <latch>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "fuzz/inputs/case_stream.h"
#include "fuzz/properties/account_of_parts.h"
#include "fuzz/properties/input_points.h"
#include "geometry/rational_point.h"
#include "tests/cites.h"

namespace flowcert::flow_complex_test {
namespace {

// A square and a point above its centre.
std::vector<Point> pyramid() { return {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}}; }

// Positions from which to flow: the means of a point with its neighbours in the list, and one far away.
std::vector<RationalPoint> starts_for(const FlowComplex& complex) {
  const PointSet& points = complex.points();
  std::vector<RationalPoint> starts;
  for (std::size_t k = 0; k + 1 < points.size() && k < 8; ++k) {
    const RationalPoint p = geometry::exact_position(points[k]), q = geometry::exact_position(points[k + 1]);
    starts.push_back({(2 * p[0] + q[0]) / 3, (2 * p[1] + q[1]) / 3, (2 * p[2] + q[2]) / 3});
  }
  if (!points.empty()) starts.push_back({Rational(points[0].x) + 1, Rational(points[0].y) - 9, Rational(1) / 3});
  return starts;
}

std::string text_of(const RationalPoint& x) {
  return '(' + to_text(x[0]) + ", " + to_text(x[1]) + ", " + to_text(x[2]) + ')';
}

std::string text_of(const Orbit& orbit) {
  std::string text;
  for (const FlowSegment& segment : orbit.segments) {
    text += type_text(segment.type) + ' ' + text_of(segment.start) + '\n';
  }
  return text + (orbit.limit ? text_of(orbit.limit->position) : "infinity") + '\n';
}

// All that is asked of a complex here, as text, with exact coordinates.
std::string account_of(const FlowComplex& complex) {
  std::string text = std::to_string(complex.stationary().euler_sum()) + '\n';
  for (std::size_t i = 0; i < complex.unstable().size(); ++i) {
    for (const std::size_t side : {0U, 1U}) {
      const auto limit = complex.unstable().limit(i, side);
      text += limit ? std::to_string(*limit) : "infinity";
      text += ' ' + text_of(complex.unstable().orbit(i, side));
    }
  }
  for (std::size_t i = 0; i < complex.stable().size(); ++i) {
    for (const BackwardSegment<>& segment : complex.stable().set(i).segments)
      text += text_of(segment.back.position) + '\n';
  }
  for (const auto& [one, other] : complex.chains().limits()) text += std::to_string(one) + ' ' + std::to_string(other);
  for (std::size_t i = 0; i < complex.limits().size(); ++i) {
    for (const FlowLimits::Entry& entry : complex.limits().entries(i)) text += std::to_string(entry.limit) + ' ';
  }
  for (std::size_t i = 0; i < complex.stationary().size(); ++i) text += to_text(complex.volumes().exact(i)) + '\n';
  for (const MergeTree* tree : {&complex.merge_trees().pockets(), &complex.merge_trees().components()}) {
    for (const MergeNode& node : tree->nodes) {
      for (const std::uint32_t part : node.parts) text += std::to_string(part) + ' ';
      for (const std::uint32_t point : node.points) text += std::to_string(point) + ' ';
    }
  }
  for (std::size_t i = 0; i < complex.unstable_surfaces().size(); ++i) {
    for (const RationalPoint& vertex : complex.unstable_surfaces().set(i).vertices) text += text_of(vertex) + '\n';
  }
  for (const RationalPoint& start : starts_for(complex)) {
    text += text_of(complex.orbit(start)) + type_text(complex.step(start).type) + '\n';
  }
  for (const auto& [x, y, z] : complex.centers()) {
    text += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
  }
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    text += std::to_string(pair.dimension) + ' ' + to_text(complex.persistence().squared_value(pair.birth)) + '\n';
  }
  return text;
}

FlowComplex returned_by_value() {
  FlowComplex complex(pyramid());
  complex.make(FlowComplexPart::kPersistence);
  return complex;
}

TEST(FlowComplex, IsMovedAndReturnedWithAllItsParts) {
  CITES("FC-INV-01", "FC-PERS-01");
  FlowComplex complex = returned_by_value();
  const StationaryPoints* stationary = &complex.stationary();
  const std::string account = account_of(complex);
  EXPECT_EQ(complex.stationary().euler_sum(), 1);
  const FlowComplex moved = std::move(complex);
  EXPECT_EQ(&moved.stationary(), stationary);
  EXPECT_EQ(account_of(moved), account);
  EXPECT_EQ(account_of(FlowComplex(pyramid())), account);
}

TEST(FlowComplex, CentersAreTheNearestDoubles) {
  CITES("FC-NUM-02");
  const FlowComplex complex(pyramid());
  const auto centers = complex.centers();
  ASSERT_EQ(centers.size(), complex.stationary().size());
  for (std::size_t record = 0; record < centers.size(); ++record) {
    const RationalPoint exact = complex.sphere(record).center;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(centers[record].at(axis), nearest_double(exact.at(axis)));
  }
}

TEST(FlowComplex, FlowsFromAnywhere) {
  CITES("FC-FLOW-05");
  const FlowComplex complex(pyramid());
  const RationalPoint start = {Rational(1) / 2, Rational(1) / 4, Rational(1) / 2};
  const Orbit orbit = complex.orbit(start);
  Flow flow(complex.diagram());
  EXPECT_EQ(orbit.segments.size(), 3U);
  EXPECT_EQ(orbit.segments.size(), flow.orbit(start).segments.size());
  ASSERT_TRUE(orbit.limit);
  EXPECT_EQ(orbit.limit->index, (StationaryIndex{3, 3}));
}

// The end of an orbit is found without its segments, by a flow that has found others before.
TEST(FlowComplex, LimitsAreThoseOfOrbits) {
  CITES("FC-FLOW-05");
  fuzz::CaseRun run;
  run.seed = 7;
  std::size_t ends = 0, infinite = 0;
  for (std::size_t number = 0; number < 60; ++number) {
    const FlowComplex complex(property::point_set_of(fuzz::input_of_case(run, number)));
    for (const RationalPoint& start : starts_for(complex)) {
      const Orbit orbit = complex.orbit(start);
      const std::optional<StationaryLimit> limit = complex.limit(start);
      ASSERT_EQ(limit.has_value(), orbit.limit.has_value());
      ++(limit ? ends : infinite);
      if (!limit) continue;
      EXPECT_EQ(limit->position, orbit.limit->position);
      EXPECT_EQ(limit->index, orbit.limit->index);
      EXPECT_EQ(limit->contact, orbit.limit->contact);
    }
  }
  EXPECT_GT(ends, 100U);
  EXPECT_GT(infinite, 10U);
}

// Points on a grid, many of them cospherical, and points in general position.
std::vector<Point> many_points(bool on_grid, std::size_t count) {
  std::mt19937_64 engine(7);
  const auto coordinate = [&] {
    return on_grid ? static_cast<double>(engine() % 26) : static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  std::vector<Point> points(count);
  for (Point& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

// Each part is told to the same observer, once.
TEST(FlowComplex, TellsItsProgressAndComputesEachPartOnce) {
  CITES("FC-INV-01");
  std::map<FlowComplexPart, std::size_t> ends;
  const FlowComplex complex(pyramid(), {}, [&](FlowComplexPart part, std::size_t done, std::size_t total) {
    if (done == total) ++ends[part];
  });
  EXPECT_TRUE(ends.empty());
  (void)account_of(complex);
  (void)account_of(complex);
  for (std::size_t part = 0; part < kFlowComplexParts; ++part) {
    EXPECT_EQ(ends[static_cast<FlowComplexPart>(part)], 1U) << part;
  }
}

// What is there without the diagram is enough to write pairs. All else is made once more, and is the same.
TEST(FlowComplex, IsTheSameAfterItsDiagramIsForgotten) {
  CITES("FC-INV-01", "FC-PERS-01");
  std::map<FlowComplexPart, std::size_t> ends;
  FlowComplex complex(pyramid(), {}, [&](FlowComplexPart part, std::size_t done, std::size_t total) {
    if (done == total) ++ends[part];
  });
  const std::string account = account_of(complex);
  const FlowPlace place = complex.locate(Point{0.25, 0.5, 1});
  const auto pairs = [&] {
    std::string text;
    for (const PersistencePair& pair : complex.persistence().pairs()) {
      text += to_text(complex.persistence().squared_value(pair.birth)) + ' ' +
              to_text(complex.sphere(pair.death.value_or(pair.birth)).squared_radius) + '\n';
    }
    return text;
  };
  const std::string before = pairs();
  complex.forget_diagram();
  EXPECT_EQ(pairs(), before);
  EXPECT_EQ(complex.chains().broken_ties(), 0U);
  EXPECT_EQ(ends[FlowComplexPart::kTriangulation], 1U);
  EXPECT_EQ(complex.locate(Point{0.25, 0.5, 1}), place);
  EXPECT_EQ(account_of(complex), account);
  for (std::size_t part = 0; part < kFlowComplexParts; ++part) {
    const auto which = static_cast<FlowComplexPart>(part);
    const bool stays = which == FlowComplexPart::kStationary || which == FlowComplexPart::kChains ||
                       which == FlowComplexPart::kLinks || which == FlowComplexPart::kPersistence;
    EXPECT_EQ(ends[which], stays ? 1U : 2U) << part;
  }
}

// The stages that pass over all cells tell how far they are, too, and so do those of the whole complex.
TEST(FlowComplex, PartsWithStagesTellHowFarTheyAre) {
  CITES("FC-INV-01", "FC-UNST-02", "FC-VOL-01");
  const std::vector<Point> rows = many_points(false, 12000);
  for (const unsigned threads : {1U, 3U}) {
    std::map<FlowComplexPart, std::size_t> told;
    std::size_t last = 0;
    const FlowComplex complex(std::span<const Point>(rows), {.threads = threads},
                              [&](FlowComplexPart part, std::size_t done, std::size_t total) {
                                if (done == total) return;
                                EXPECT_LT(done, total);
                                EXPECT_TRUE(told[part]++ == 0 || done > last) << "it ascends";
                                last = done;
                              });
    (void)complex.volumes();
    EXPECT_GE(told[FlowComplexPart::kDiagram], 4U);
    EXPECT_GE(told[FlowComplexPart::kStationary], 4U);
    EXPECT_GE(told[FlowComplexPart::kLimits], 100U) << "once for about a thousand edges and lists";
    EXPECT_GE(told[FlowComplexPart::kVolumes], 1000U);
  }
}

// They tell nothing in between, so a bar would not show which of them is under way.
TEST(FlowComplex, PartsWithoutStagesTellThatTheyBegin) {
  CITES("FC-CHAIN-02", "FC-PERS-01");
  std::vector<std::pair<FlowComplexPart, std::size_t>> told;
  const FlowComplex complex(pyramid(), {}, [&](FlowComplexPart part, std::size_t done, std::size_t) {
    if (part >= FlowComplexPart::kChains) told.emplace_back(part, done);
  });
  (void)complex.chains();
  (void)complex.persistence();
  (void)complex.unstable_surfaces();
  EXPECT_EQ(told, (std::vector<std::pair<FlowComplexPart, std::size_t>>{{FlowComplexPart::kChains, 0},
                                                                        {FlowComplexPart::kChains, 1},
                                                                        {FlowComplexPart::kLinks, 0},
                                                                        {FlowComplexPart::kLinks, 1},
                                                                        {FlowComplexPart::kPersistence, 0},
                                                                        {FlowComplexPart::kPersistence, 1},
                                                                        {FlowComplexPart::kUnstableSurfaces, 0},
                                                                        {FlowComplexPart::kUnstableSurfaces, 1}}));
}

TEST(FlowComplex, APartThatWasStoppedIsMadeWhenItIsAskedForAgain) {
  CITES("FC-INV-01");
  bool stops = true;
  const FlowComplex complex(pyramid(), {}, [&](FlowComplexPart part, std::size_t, std::size_t) {
    if (stops && part == FlowComplexPart::kUnstable) throw std::runtime_error("stopped");
  });
  EXPECT_THROW((void)complex.unstable(), std::runtime_error);
  stops = false;
  EXPECT_EQ(account_of(complex), account_of(FlowComplex(pyramid())));
}

// Ctrl-C may come at any report, the last one of a part, too.
TEST(FlowComplex, AnswersAreTheSameAfterAStopAtAnyReport) {
  CITES("FC-INV-01");
  for (const std::vector<Point>& rows : {pyramid(), many_points(true, 60)}) {
    const std::string right = account_of(FlowComplex(rows));
    std::size_t reports = 0, stops = 0;
    (void)account_of(FlowComplex(rows, {}, [&](FlowComplexPart, std::size_t, std::size_t) { ++reports; }));
    // Small sets stop at each report, larger ones at a hundred of them.
    const std::size_t step = 1 + reports / 100;
    for (std::size_t stop = 1; stop <= reports; stop += step) {
      std::size_t told = 0;
      const FlowComplex complex(rows, {}, [&](FlowComplexPart, std::size_t, std::size_t) {
        if (++told == stop) throw std::runtime_error("stopped");
      });
      // Part by part, so that the stop is in a part that is asked for again.
      for (std::size_t part = 0; part < kFlowComplexParts; ++part) {
        try {
          complex.make(static_cast<FlowComplexPart>(part));
        } catch (const std::runtime_error&) {
          ++stops;
          complex.make(static_cast<FlowComplexPart>(part));
        }
      }
      ASSERT_EQ(account_of(complex), right) << "stopped at report " << stop << " of " << reports;
    }
    EXPECT_EQ(stops, (reports + step - 1) / step);
    EXPECT_GE(stops, 15U);
  }
}

// Makes the parts in an order of the thread's own, and then tells all that there is.
std::string account_in_order(const FlowComplex& complex, std::size_t thread, std::latch& together) {
  std::array<std::size_t, kFlowComplexParts> order{};
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::minstd_rand(static_cast<unsigned>(thread)));
  together.arrive_and_wait();
  for (const std::size_t part : order) complex.make(static_cast<FlowComplexPart>(part));
  return account_of(complex);
}

// The sanitizers' build, and ThreadSanitizer's, look at the same threads.
TEST(FlowComplex, ThreadsThatShareItGetTheSameAnswers) {
  CITES("FC-INV-01");
  fuzz::CaseRun run;
  run.seed = 5;
  for (std::size_t number = 0; number < 20; ++number) {
    const PointSet points = property::point_set_of(fuzz::input_of_case(run, number));
    const std::string alone = account_of(FlowComplex(points));
    const FlowComplex shared(points);
    std::vector<std::string> accounts(4);
    std::latch together(4);
    {
      std::vector<std::jthread> threads;
      threads.reserve(accounts.size());
      for (std::size_t k = 0; k < accounts.size(); ++k)
        threads.emplace_back([&, k] { accounts[k] = account_in_order(shared, k, together); });
    }
    for (const std::string& account : accounts) EXPECT_EQ(account, alone);
  }
}

// One thread's part is stopped while others wait for it. One of them makes it then.
TEST(FlowComplex, APartThatIsStoppedInOneThreadIsMadeInAnother) {
  CITES("FC-INV-01");
  std::atomic<int> begun{0};
  const FlowComplex shared(pyramid(), {}, [&](FlowComplexPart part, std::size_t done, std::size_t) {
    if (part == FlowComplexPart::kUnstable && done == 0 && begun++ == 0) throw std::runtime_error("stopped");
  });
  std::atomic<int> stopped{0}, made{0};
  {
    std::latch together(4);
    std::vector<std::jthread> threads;
    threads.reserve(4);
    for (int k = 0; k < 4; ++k) {
      threads.emplace_back([&] {
        together.arrive_and_wait();
        try {
          made += shared.unstable().size() > 0 ? 1 : 0;
        } catch (const std::runtime_error&) {
          ++stopped;
        }
      });
    }
  }
  EXPECT_EQ(stopped, 1);
  EXPECT_EQ(made, 3);
}

TEST(FlowComplex, IsTheSameForAnyNumberOfThreads) {
  CITES("FC-NUM-01", "FC-OUT-02");
  const auto expect_same = [](const std::vector<Point>& rows) {
    for (const FacetSearch search : {FacetSearch::kBinary, FacetSearch::kLinear}) {
      const auto with = [&](unsigned threads) {
        return property::account_of_parts(
            FlowComplex(std::span(rows), {.search = search, .seed = 3, .threads = threads}));
      };
      const std::string alone = with(1);
      for (const unsigned threads : {2U, 3U, 8U}) EXPECT_EQ(with(threads), alone) << threads;
    }
  };
  // Large enough that several threads get a part of the cells.
  expect_same(many_points(false, 9000));
  expect_same(many_points(true, 7000));
  fuzz::CaseRun run;
  run.seed = 5;
  for (std::size_t number = 0; number < 60; ++number) {
    expect_same(property::rows_of(fuzz::input_of_case(run, number)));
  }
}

TEST(FlowComplex, NoThreadAtAllIsRefused) {
  CITES("FC-NUM-01");
  EXPECT_THROW(FlowComplex(pyramid(), {.threads = 0}), std::invalid_argument);
}

TEST(FlowComplex, AProgressThatThrowsStopsAllThreads) {
  CITES("FC-NUM-01");
  const std::vector<Point> rows = many_points(false, 3000);
  struct Stop {};
  for (const FlowComplexPart stopped :
       {FlowComplexPart::kUnstable, FlowComplexPart::kStable, FlowComplexPart::kLimits, FlowComplexPart::kVolumes}) {
    bool stops = true;
    std::size_t last = 0;
    const FlowComplex complex(std::span<const Point>(rows), {.threads = 3},
                              [&](FlowComplexPart part, std::size_t done, std::size_t) {
                                if (part != stopped) return;
                                EXPECT_TRUE(done >= last || !stops);
                                last = done;
                                if (stops && done > 500) throw Stop();
                              });
    EXPECT_THROW(complex.make(stopped), Stop);
    stops = false;
    EXPECT_EQ(property::account_of_parts(complex),
              property::account_of_parts(FlowComplex{std::span<const Point>(rows)}));
  }
}

}  // namespace
}  // namespace flowcert::flow_complex_test
