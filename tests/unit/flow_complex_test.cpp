// The flow complex that a user holds: its parts are those that are computed one by one, it may be moved and
// shared, and it is made once however many threads ask for it.
#include "flowcert/flow_complex.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "fuzz/inputs/case_stream.h"
#include "fuzz/properties/input_points.h"
#include "tests/cites.h"

namespace flowcert {
namespace {

// A square and a point above its centre.
std::vector<Point> pyramid() { return {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}}; }

// All that is asked of a complex here, as text.
std::string account_of(const FlowComplex& complex) {
  std::string text = std::to_string(complex.stationary().euler_sum()) + '\n';
  for (std::size_t i = 0; i < complex.unstable().size(); ++i) {
    for (const std::size_t side : {0U, 1U}) {
      const auto limit = complex.unstable().limit(i, side);
      text += limit ? std::to_string(*limit) : "infinity";
      text += ' ' + std::to_string(complex.unstable().orbit(i, side).segments.size()) + '\n';
    }
  }
  for (std::size_t i = 0; i < complex.stable().size(); ++i) {
    text += std::to_string(complex.stable().set(i).segments.size()) + '\n';
  }
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    text += std::to_string(pair.dimension) + ' ' + to_text(complex.persistence().squared_value(pair.birth)) +
            '\n';
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
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(centers[record].at(axis), nearest_double(exact.at(axis)));
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
  for (const FlowComplexPart part :
       {FlowComplexPart::kTriangulation, FlowComplexPart::kUnstable, FlowComplexPart::kStable}) {
    EXPECT_EQ(ends[part], 1U);
  }
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
    {
      std::vector<std::jthread> threads;
      for (std::string& account : accounts) threads.emplace_back([&] { account = account_of(shared); });
    }
    for (const std::string& account : accounts) EXPECT_EQ(account, alone);
  }
}

}  // namespace
}  // namespace flowcert
