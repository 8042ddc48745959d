// A kernel that does what the cascade kernel does, and compares what each of its precisions knows with the integers.
//
// Guarantees: a direction is compared exactly (exact_directions.h), and so is each sign. What has been met is counted
// by the kind of start or of crossing.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "flow/kernels/cascade_kernel.h"
#include "flow/kernels/exact_kernel.h"
#include "tests/unit/exact_directions.h"

namespace flowcert_tests {

using namespace flowcert::flow;
using flowcert::FlowPrimitive;
using flowcert::KernelTally;
using flowcert::RationalPoint;

// What was met, by the kind of start or of crossing.
struct Seen {
  struct Counts {
    std::size_t doubles = 0, doubled = 0, extended = 0, handed_down = 0, unknown = 0;
  };
  std::map<std::string, Counts> directions;
  std::size_t signs = 0, by_doubles = 0, by_doubled = 0, by_extended = 0, failures = 0;
};
// Where the kernels of a test count.
inline Seen* seen_now = nullptr;

// Four kernels do the same. Three are asked for one floating-point type alone, so that none of these gets help from
// above. The fourth one has the integers, which decide. The plain rationals of a fifth one confirm them.
class WatchedKernel {
 public:
  class MovingPoint;

  explicit WatchedKernel(KernelTally& tally) : exact_(tally) {}

  [[nodiscard]] PointNumber add(const RationalPoint& x) {
    return kept({}, {doubles_.add(x), doubled_.add(x), extended_.add(x), exact_.add(x), slow_.add(x)});
  }
  [[nodiscard]] PointNumber add_crossing(PointNumber from, const Point& p0, const Point& p1, const Point& q) {
    watch(from, {&p0, &p1});
    Made made;
    if (&p0 != &p1) made = {{&p0, &p1}, {&q}, {}};
    return kept(std::move(made), {doubles_.add_crossing(from, p0, p1, q), doubled_.add_crossing(from, p0, p1, q),
                                  extended_.add_crossing(from, p0, p1, q), exact_.add_crossing(from, p0, p1, q),
                                  slow_.add_crossing(from, p0, p1, q)});
  }
  [[nodiscard]] PointNumber add_circumcenter(std::span<const Point* const> simplex, Stay stay) {
    return kept({{}, {simplex.begin(), simplex.end()}, {}},
                {doubles_.add_circumcenter(simplex, stay), doubled_.add_circumcenter(simplex, stay),
                 extended_.add_circumcenter(simplex, stay), exact_.add_circumcenter(simplex, stay),
                 slow_.add_circumcenter(simplex, stay)});
  }

  template <class Query>
  [[nodiscard]] Sign sign(const Query& query) {
    if constexpr (std::is_same_v<Query, RayAtInfinity> || std::is_same_v<Query, OrderOfExits>) {
      watch(query.x, {&query.p0, &query.p1});
    }
    const Sign truth = *exact_.sign_on_rung(query, KernelRung::kExact);
    const MaybeSign lower = doubles_.sign_on_rung(query, KernelRung::kFilter);
    const MaybeSign between = doubled_.sign_on_rung(query, KernelRung::kDoubled);
    const MaybeSign middle = extended_.sign_on_rung(query, KernelRung::kExtended);
    seen_now->by_doubled += between ? 1 : 0;
    expect(between.value_or(truth) == truth, "doubled doubles contradict the integers");
    ++seen_now->signs;
    seen_now->by_doubles += lower ? 1 : 0;
    seen_now->by_extended += middle ? 1 : 0;
    expect(lower.value_or(truth) == truth && middle.value_or(truth) == truth, "a rung contradicts the integers");
    expect(slow_.sign_on_rung(query, KernelRung::kExact) == truth, "the rationals contradict the integers");
    return truth;
  }
  template <class Query>
  [[nodiscard]] MaybeSign sign_on_rung(const Query& query, KernelRung rung) {
    return exact_.sign_on_rung(query, rung);
  }

  [[nodiscard]] RationalPoint exact(PointNumber x) { return exact_.exact(x); }
  [[nodiscard]] std::optional<std::array<std::size_t, 3>> exact_bytes(PointNumber x) const {
    return exact_.exact_bytes(x);
  }
  [[nodiscard]] std::size_t deepest() const { return exact_.deepest(); }
  [[nodiscard]] PointNumber kept() const { return exact_.kept(); }
  void drop_from(PointNumber x) {
    for (CascadeKernel* one : {&doubles_, &doubled_, &extended_, &exact_}) one->drop_from(x);
    slow_.drop_from(x);
    made_.resize(x);
  }
  void drop_all() {
    for (CascadeKernel* one : {&doubles_, &doubled_, &extended_, &exact_}) one->drop_all();
    slow_.drop_all();
    made_.clear();
  }

 private:
  // A crossing has the facet and one sample. Other points have none, or the three or four of a centre.
  struct Made {
    FacetEdge facet;
    std::vector<const Point*> samples;
    FacetEdge watched;  // the direction from here has been compared
  };

  static void expect(bool holds, const std::string& complaint) {
    EXPECT_TRUE(holds) << complaint;
    seen_now->failures += holds ? 0 : 1;
  }

  PointNumber kept(Made made, const std::array<PointNumber, 5>& numbers) {
    for (const PointNumber number : numbers) EXPECT_EQ(number, numbers[0]);
    made_.push_back(std::move(made));
    return numbers[0];
  }

  [[nodiscard]] std::string branch(PointNumber x, FacetEdge to) const {
    const Made& made = made_[x];
    const auto has = [](const std::vector<const Point*>& all, const Point* one) {
      return std::find(all.begin(), all.end(), one) != all.end();
    };
    switch (made.samples.size()) {
      case 0:
        return "position";
      case 3:
        return has(made.samples, to.p0) && has(made.samples, to.p1) ? "side" : "circle";
      case 4:
        return "vertex";
      default:
        break;
    }
    const std::vector<const Point*> ends = {made.facet.p0, made.facet.p1};
    if (!has(ends, to.p0) && !has(ends, to.p1)) return "polygon sharing none";
    return has(made.samples, to.p0) || has(made.samples, to.p1) ? "triangle" : "polygon sharing a vertex";
  }

  void watch(PointNumber x, FacetEdge facet) {
    if (facet.p0 == facet.p1 || made_[x].watched == facet) return;
    made_[x].watched = facet;
    const IntegerDirection truth = exact_.direction_in_integers(x, facet);
    Seen::Counts& counts = seen_now->directions[branch(x, facet)];
    const Direction<Extended> extended = extended_.direction_in<Extended>(x, facet);
    if (extended.is_known()) {
      ++counts.extended;
      expect(broken_bound(extended, truth, facet).empty(), broken_bound(extended, truth, facet));
    }
    const Direction<DoubleDouble> doubled = doubled_.direction_in<DoubleDouble>(x, facet);
    if (doubled.is_known()) {
      ++counts.doubled;
      expect(broken_bound(doubled, truth, facet).empty(), broken_bound(doubled, truth, facet));
    }
    Direction<double> doubles = doubles_.direction_in_doubles(x, facet);
    if (doubles.is_known()) {
      ++counts.doubles;
      expect(broken_bound(doubles, truth, facet).empty(), broken_bound(doubles, truth, facet));
      return;
    }
    // Here the next rung would be asked, and its direction is handed down.
    ++counts.unknown;
    (void)doubles_.direction_in<Extended>(x, facet);
    doubles = doubles_.direction_in_doubles(x, facet);
    if (!doubles.is_known()) return;
    ++counts.handed_down;
    expect(broken_bound(doubles, truth, facet).empty(), "handed down: " + broken_bound(doubles, truth, facet));
  }

  KernelTally unused_;
  CascadeKernel doubles_{unused_}, doubled_{unused_}, extended_{unused_}, exact_;
  ExactKernel slow_{unused_};
  std::vector<Made> made_;
};

// It keeps all points, so that each direction is watched.
class WatchedKernel::MovingPoint : public ConstructedMovingPoint<WatchedKernel> {
 public:
  using ConstructedMovingPoint::ConstructedMovingPoint;
  [[nodiscard]] Sign sign_of_order(const Point& qi, const Point& qj) {
    return kernel_.sign(OrderOfExits{x_, *p0_, *p1_, qi, qj});
  }
};

}  // namespace flowcert_tests
