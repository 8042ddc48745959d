// Which surfaces a selection chooses, and what the histogram counts: against exact numbers in sorted lists, on inputs
// of every family.
//
// Guarantees: the lists are made of exact spheres and of all distances between samples, with rationals alone. Bounds
// are taken from the lists themselves, so that they are met exactly. A run fails too when too few choices had ties.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "flowcert/surface.h"
#include "fuzz/inputs/families.h"
#include "fuzz/properties/input_points.h"
#include "geometry/difference_of_roots.h"
#include "io/coordinate_rounding.h"
#include "io/surface_selection.h"
#include "morse/saddle_radii.h"
#include "tests/cites.h"
#include "tests/exact_valley.h"
#include "tests/property/orbit_subject.h"
#include "tests/property/property_parameters.h"

namespace flowcert::property::surface_choice_test {
namespace {

using geometry::RootDifference;
using Numbers = std::vector<Rational>;

// By number in StableManifolds.
struct ExactLists {
  explicit ExactLists(const FlowComplex& complex) {
    const auto& counts = complex.stationary().critical_counts();
    const std::size_t first = counts[0] + counts[1];
    for (std::size_t i = 0; i < counts[2]; ++i) squared_radii.push_back(complex.sphere(first + i).squared_radius);
    lengths.resize(counts[2]);
    for (const PersistencePair& pair : complex.persistence().pairs()) {
      if (pair.dimension == 0) continue;
      const Rational birth = complex.sphere(pair.birth).squared_radius;
      lengths.at((pair.dimension == 1 ? *pair.death : pair.birth) - first) = {
          complex.sphere(*pair.death).squared_radius, birth};
    }
    Numbers nearest;
    for (const Point& p : complex.points().points()) {
      std::optional<Rational> least;
      for (const Point& q : complex.points().points()) {
        const Rational x = Rational(p.x) - Rational(q.x), y = Rational(p.y) - Rational(q.y),
                       z = Rational(p.z) - Rational(q.z), square = x * x + y * y + z * z;
        if (square > 0 && (!least || square < *least)) least = square;
      }
      if (least) nearest.push_back(*least);
    }
    std::ranges::sort(nearest);
    if (!nearest.empty()) squared_spacing = nearest[(nearest.size() - 1) / 2];
  }

  Numbers squared_radii;
  std::vector<RootDifference> lengths;
  std::optional<Rational> squared_spacing;
};

template <typename All>
All sorted(All numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

struct ChoicesSeen {
  std::size_t choices = 0, parted = 0, met = 0;  // met: radii that equal another one
};

// is_chosen(i): whether the i-th critical point of index 2 has to be chosen.
template <typename IsChosen>
void require_choice(const fuzz::Input& input, const FlowComplex& complex, const std::string& expression,
                    const IsChosen& is_chosen, ChoicesSeen& seen) {
  const morse::SaddleRadii radii(complex);
  const std::vector<std::size_t> sets = SurfaceSelection({expression}).select(complex, radii).sets;
  require_none(input, sets == selected_sets(complex, {expression}) ? "" : "selected_sets() chooses others", expression);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (is_chosen(i)) expected.push_back(i);
  }
  require_none(input, sets == expected ? "" : "others are chosen: ", expression);
  ++seen.choices;
  seen.parted += !expected.empty() && expected.size() < radii.size() ? 1 : 0;
}

Rational chance(rc::Random& random) { return {static_cast<long>(random.next() % 13), 12}; }

void require_radii(const fuzz::Input& input, const FlowComplex& complex, const ExactLists& exact, rc::Random& random,
                   ChoicesSeen& seen) {
  const Numbers& squares = exact.squared_radii;
  const Numbers ascending = sorted(squares);
  const Rational spacing = exact.squared_spacing.value_or(0);
  const auto below = [&](const std::optional<Rational>& bound) {
    return [&squares, bound](std::size_t i) { return !bound || squares[i] < *bound; };
  };
  const Rational times(static_cast<long>(1 + random.next() % 40), 8);
  require_choice(input, complex, "index2-radius<" + flowcert::to_text(times) + "spacing",
                 below(times * times * spacing), seen);
  require_choice(input, complex, "index2-radius < " + flowcert::to_text(times), below(times * times), seen);
  const Rational share = chance(random);
  const auto place = static_cast<std::size_t>(Rational(share * 12) * squares.size() / 12);
  require_choice(input, complex, "index2-radius<q" + flowcert::to_text(share),
                 below(place < ascending.size() ? std::optional(ascending[place]) : std::nullopt), seen);
  const auto gap = flowcert_tests::exact_threshold(squares, spacing);
  require_choice(input, complex, "index2-radius<auto", below(gap ? std::optional(gap->second) : std::nullopt), seen);
  for (std::size_t k = 0; k + 1 < ascending.size(); ++k) seen.met += ascending[k] == ascending[k + 1] ? 1 : 0;
}

// The squares of the lengths from above: from the least one up, those that are more than the rounding beyond the last.
Numbers counted_once(const FlowComplex& complex, const std::vector<RootDifference>& lengths) {
  const Rational rounding = io::length_rounding(complex.points());
  Numbers squares, once;
  for (const RootDifference& length : lengths) squares.push_back(geometry::square_from_above(length));
  for (const Rational& square : sorted(squares)) {
    if (once.empty() || RootDifference{square, once.back()} > RootDifference{rounding * rounding})
      once.push_back(square);
  }
  return once;
}

void require_lengths(const fuzz::Input& input, const FlowComplex& complex, const ExactLists& exact, rc::Random& random,
                     ChoicesSeen& seen) {
  const std::vector<RootDifference>& lengths = exact.lengths;
  const std::vector<RootDifference> ascending = sorted(lengths);
  // The bound's square.
  const auto above = [&](const std::optional<Rational>& bound) {
    return [&lengths, bound](std::size_t i) { return !bound || lengths[i] > RootDifference{*bound}; };
  };
  const Rational times(static_cast<long>(random.next() % 9), 8);
  require_choice(input, complex, "persistence>" + flowcert::to_text(times) + "spacing",
                 above(times * times * exact.squared_spacing.value_or(0)), seen);
  if (!lengths.empty()) {
    const RootDifference& some = lengths[random.next() % lengths.size()];
    const double near = geometry::nearest_difference_of_roots(some.square, some.less);
    if (std::isfinite(near)) {
      const Rational met(near);
      require_choice(input, complex, "persistence>" + flowcert::to_text(met), above(met * met), seen);
    }
  }
  const Rational share = chance(random);
  const auto chosen = static_cast<std::size_t>(Rational((1 - share) * 12) * lengths.size() / 12);
  const std::size_t shorter = lengths.size() - chosen;
  require_choice(input, complex, "persistence>q" + flowcert::to_text(share),
                 above(shorter > 0 ? std::optional(geometry::square_from_above(ascending[shorter - 1])) : std::nullopt),
                 seen);
  const auto gap = flowcert_tests::exact_threshold(counted_once(complex, lengths), exact.squared_spacing.value_or(1));
  require_choice(input, complex, "persistence>auto", above(gap ? std::optional(gap->first) : std::nullopt), seen);
  // The first of equally long ones.
  const std::size_t count = random.next() % (lengths.size() + 2);
  std::vector<std::size_t> order(lengths.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  order.resize(std::min(count, order.size()));
  require_choice(
      input, complex, "largest-gaps=" + std::to_string(count),
      [&](std::size_t i) { return std::ranges::count(order, i) > 0; }, seen);
}

void require_histogram(const fuzz::Input& input, const FlowComplex& complex, const ExactLists& exact) {
  const morse::SaddleRadii radii(complex);
  require_none(input, radii.squared_spacing() == exact.squared_spacing ? "" : "the spacing is another one", "");
  require_none(input,
               morse::squared_spacing(complex) == exact.squared_spacing ? "" : "the spacing alone is another one", "");
  const std::vector<HistogramBin> bins = radii.histogram();
  const std::vector<HistogramBin> expected =
      flowcert_tests::exact_histogram(exact.squared_radii, exact.squared_spacing.value_or(1));
  require_none(input, bins.size() <= 30 ? "" : "there are too many bins", "");
  const bool is_same = std::ranges::equal(bins, expected, [](const HistogramBin& a, const HistogramBin& b) {
    return a.from == b.from && a.to == b.to && a.count == b.count;
  });
  require_none(input, is_same ? "" : "the histogram is another one", "");
}

TEST(SurfaceChoice, IsThatOfSortedExactNumbers) {
  CITES("FC-PERS-01", "FC-PERS-02", "FC-NUM-01", "FC-NUM-02");
  ChoicesSeen seen;
  bool held = true;
  for (const fuzz::Family& family : fuzz::families()) {
    const rc::Gen<fuzz::Input> generator = family.generate();
    const auto property = [&] {
      const fuzz::Input input = *generator;
      rc::Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1'000'000).as("dice")));
      const FlowComplex complex(point_set_of(input));
      const ExactLists exact(complex);
      require_radii(input, complex, exact, random, seen);
      if (!complex.points().empty()) require_lengths(input, complex, exact, random, seen);
      require_histogram(input, complex, exact);
    };
    held = expect_holds(family.name, parameters_of_run(100, held), property) && held;
  }
  std::printf("%zu choices, %zu of some and not all; %zu equal radii\n", seen.choices, seen.parted, seen.met);
  if (!held || scale_of_run() < 1) return;
  EXPECT_GE(seen.choices, 25000U);
  // `auto` parts few of these small sets; log_histogram_test has lists with valleys.
  EXPECT_GE(seen.parted, 3500U);
  EXPECT_GE(seen.met, 500U);
}

}  // namespace
}  // namespace flowcert::property::surface_choice_test
