// λ-lists of the fast implementation against the oracle's (FC-UNST-01, 02), on all families.
//
// Guarantees: lists are compared exactly, directions as rational vectors and limits by contact sets. The oracle follows
// families of rays forward, by scans over all points. The fast implementation divides each Voronoi facet once, and
// hands the parts back. The test fails too when too few lists had ties.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "flowcert/flow_limits.h"
#include "flowcert/sphere.h"
#include "fuzz/properties/stable_pieces.h"
#include "oracle/unstable_set.h"
#include "tests/cites.h"
#include "tests/property/family_run.h"
#include "tests/property/orbit_subject.h"

namespace flowcert::property::limit_agreement_test {
namespace {

constexpr int kInputsPerFamily = 10;
constexpr int kInputsMadeForThis = 33;      // of each of the families for stable sets
constexpr std::size_t kListsByOracle = 16;  // at most so many of an input

struct Totals {
  std::size_t lists = 0, arcs = 0, directions = 0, isolated_in_one_limit = 0, regular = 0;

  void add(const Totals& part) {
    lists += part.lists;
    arcs += part.arcs;
    directions += part.directions;
    isolated_in_one_limit += part.isolated_in_one_limit;
    regular += part.regular;
  }
  void print_row(const std::string& name) const {
    std::printf("%-24s %6zu λ-lists, %5zu of regular points; %6zu arcs, %6zu directions, %4zu amid one limit\n",
                name.c_str(), lists, regular, arcs, directions, isolated_in_one_limit);
  }
};

// The direction, scaled so that its largest coordinate is 1 or -1, and the limit's contact set. Infinity has none.
struct Entry {
  oracle::Direction direction;
  Ids limit;
  friend bool operator==(const Entry&, const Entry&) = default;
};
struct List {
  std::vector<Entry> directions;
  std::vector<Ids> arcs;
  friend bool operator==(const List&, const List&) = default;
};

oracle::Direction scaled(const oracle::Point& vector) {
  oracle::Rational largest = 0;
  for (const oracle::Rational& x : vector) largest = std::max(largest, oracle::Rational(abs(x)));
  return {vector[0] / largest, vector[1] / largest, vector[2] / largest};
}

Ids contact_of(const std::optional<oracle::StationaryPoint>& limit) {
  return limit ? Ids(limit->contact.begin(), limit->contact.end()) : Ids{};
}

List list_of(const std::vector<oracle::UnstableEntry>& entries) {
  List list;
  for (const oracle::UnstableEntry& entry : entries) {
    if (entry.is_arc) {
      list.arcs.push_back(contact_of(entry.limit));
    } else {
      list.directions.push_back({*entry.from, contact_of(entry.limit)});
    }
  }
  return list;
}

List list_of(const StationaryPoints& stationary, const RationalPoint& y, const LambdaList& fast) {
  const auto limit = [&](const std::optional<std::size_t>& record) {
    return record ? ids(stationary.contact(*record)) : Ids{};
  };
  List list;
  for (const LambdaList::Direction& direction : fast.directions) {
    oracle::Point vector;
    for (std::size_t k = 0; k < 3; ++k) vector[k] = direction.is_vector ? direction.exit[k] : direction.exit[k] - y[k];
    list.directions.push_back({scaled(vector), limit(direction.limit)});
  }
  for (const auto& arc : fast.arcs) list.arcs.push_back(limit(arc));
  return list;
}

// The oracle's cycle begins with the least direction, which need not have the least exit.
void begin_with_least(List& list) {
  const auto first = std::ranges::min_element(list.directions, {}, &Entry::direction) - list.directions.begin();
  std::rotate(list.directions.begin(), list.directions.begin() + first, list.directions.end());
  std::rotate(list.arcs.begin(), list.arcs.begin() + first, list.arcs.end());
}

std::string in_words(const List& list) {
  std::string text;
  for (std::size_t i = 0; i < std::max(list.directions.size(), list.arcs.size()); ++i) {
    if (i < list.directions.size()) {
      const auto& [u, limit] = list.directions[i];
      text += "(" + u[0].str() + "," + u[1].str() + "," + u[2].str() + ")->" + text_of(limit) + " ";
    }
    if (i < list.arcs.size()) text += "arc->" + text_of(list.arcs[i]) + " ";
  }
  return text + "\n";
}

// Vectors are scaled before.
bool rounds_to(const LambdaList& list, const RoundedLambdaList& rounded) {
  if (list.arcs != rounded.arcs || list.directions.size() != rounded.directions.size()) return false;
  for (std::size_t k = 0; k < list.directions.size(); ++k) {
    const auto& [limit, exit, is_vector] = list.directions[k];
    const auto& [its_limit, its_exit, its_is_vector] = rounded.directions[k];
    const RationalPoint exact = is_vector ? scaled(exit) : exit;
    const bool is_same = rounded_point(exact) == its_exit;
    if (!is_same || limit != its_limit || is_vector != its_is_vector) return false;
  }
  return true;
}

void require_right_lists(const Subject& subject, Totals& totals) {
  const StationaryPoints& stationary = subject.complex.stationary();
  const FlowLimits cascade(subject.complex.diagram(), stationary);
  const FlowLimits exact(subject.complex.diagram(), stationary, {ConstructionKernel::kExact, FacetSearch::kLinear});
  const std::size_t step = 1 + cascade.size() / kListsByOracle;
  for (std::size_t i = 0; i < cascade.size(); i += step) {
    const auto z = oracle_point(subject.complex.points(), stationary, cascade.record(i));
    const RationalPoint y = subject.complex.sphere(cascade.record(i)).center;
    const StationaryIndex index = stationary.index(cascade.record(i));
    const LambdaList fast = cascade.list(i);
    List mine = list_of(stationary, y, fast);
    RC_ASSERT(list_of(stationary, y, exact.list(i)) == mine);
    require_none(subject.input, rounds_to(fast, cascade.rounded_list(i)) ? "" : "rounded to other doubles", "");
    const List its = list_of(oracle::lambda_list(subject.set, z));
    if (index == StationaryIndex{1, 1} && !mine.directions.empty()) begin_with_least(mine);
    require_none(subject.input,
                 mine == its ? "" : "another λ-list of " + text_of(ids(stationary.contact(cascade.record(i)))),
                 "the fast implementation's:\n" + in_words(mine) + "the oracle's:\n" + in_words(its));
    ++totals.lists;
    totals.arcs += mine.arcs.size();
    totals.directions += mine.directions.size();
    totals.regular += index.is_critical() ? 0 : 1;
    for (std::size_t k = 1; k < mine.arcs.size(); ++k) totals.isolated_in_one_limit += mine.arcs[k] == mine.arcs[k - 1];
  }
}

TEST(LimitAgreement, ListsAreTheOracles) {
  CITES("FC-UNST-01", "FC-UNST-02");
  Totals all;
  const bool agreed =
      expect_in_all_families("λ-lists", {kInputsPerFamily, kInputsMadeForThis}, require_right_lists, all);
  if (agreed && scale_of_run() >= 1) {
    EXPECT_GE(all.lists, 2650U);
    EXPECT_GE(all.regular, 200U);
    EXPECT_GE(all.isolated_in_one_limit, 100U);
  }
}

}  // namespace
}  // namespace flowcert::property::limit_agreement_test
