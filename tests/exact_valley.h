// The histogram of positive numbers and its valley, word by word as src/cli/manual/surfaces.md has them: every edge
// that a double can reach stands in a list, and every word is a loop.
//
// Guarantees: exact; rationals alone.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "flowcert/rational.h"
#include "morse/length_bound.h"

namespace flowcert_tests {

using flowcert::HistogramBin;
using flowcert::Rational;

// The numbers of a series, in hundredths, times each `step`-th power of ten.
struct EdgesOfBins {
  EdgesOfBins(const std::vector<int>& hundredths, int step) {
    for (int power = -700; power <= 700; power += step) {
      const auto size = static_cast<unsigned>(power < 0 ? -power : power);
      const Rational ten_to = pow(boost::multiprecision::mpz_int(10), size);
      for (const int number : hundredths) {
        edges.push_back(Rational(number, 100) * (power < 0 ? Rational(1 / ten_to) : ten_to));
        squares.push_back(edges.back() * edges.back());
      }
    }
  }
  std::vector<Rational> edges, squares;
};

inline const std::vector<EdgesOfBins>& series_of_edges() {
  static const std::vector<EdgesOfBins> all = [] {
    std::vector<EdgesOfBins> series = {{{100, 125, 160, 200, 250, 315, 400, 500, 630, 800}, 1}, {{100, 200, 500}, 1}};
    for (const int step : {1, 2, 5, 10, 20, 50, 100}) series.push_back({{100}, step});
    return series;
  }();
  return all;
}

// Of the roots of the squares that are not 0, as multiples of the root of the unit.
inline std::vector<HistogramBin> exact_histogram(const std::vector<Rational>& squares, const Rational& squared_unit) {
  for (const EdgesOfBins& series : series_of_edges()) {
    std::vector<std::size_t> places;
    for (const Rational& square : squares) {
      if (square == 0) continue;
      const auto above = std::ranges::upper_bound(series.squares, Rational(square / squared_unit));
      places.push_back(static_cast<std::size_t>(std::distance(series.squares.begin(), above)) - 1);
    }
    if (places.empty()) return {};
    const auto [least, most] = std::ranges::minmax(places);
    if (most - least >= 30) continue;
    std::vector<HistogramBin> bins;
    for (std::size_t k = least; k <= most; ++k) {
      const auto count = static_cast<std::size_t>(std::ranges::count(places, k));
      bins.push_back({series.edges[k], series.edges[k + 1], count});
    }
    return bins;
  }
  return {};
}

// The number of a bin.
inline std::optional<std::size_t> exact_valley(const std::vector<HistogramBin>& bins) {
  std::size_t highest = 0;
  for (std::size_t k = 0; k < bins.size(); ++k) highest = bins[k].count > bins[highest].count ? k : highest;
  for (std::size_t valley = highest + 1; valley < bins.size(); ++valley) {
    const std::size_t low = bins[valley].count;
    bool is_least = true;
    for (std::size_t k = highest; k < valley; ++k) is_least = is_least && low < bins[k].count;
    for (std::size_t k = valley + 1; is_least && k < bins.size() && bins[k].count >= low; ++k) {
      const std::size_t high = bins[k].count, more = high - low;
      if (high >= 2 * low && more * more > 9 * (high + low)) return valley;
    }
  }
  return std::nullopt;
}

// The ends of the widest gap in the valley.
inline std::optional<std::pair<Rational, Rational>> exact_threshold(std::vector<Rational> squares,
                                                                    const Rational& squared_unit) {
  const std::vector<HistogramBin> bins = exact_histogram(squares, squared_unit);
  const std::optional<std::size_t> valley = exact_valley(bins);
  if (!valley) return std::nullopt;
  std::ranges::sort(squares);
  const HistogramBin& bin = bins[*valley];
  std::optional<std::pair<Rational, Rational>> widest;
  for (std::size_t k = 0; k + 1 < squares.size(); ++k) {
    const bool ends_before = squares[k + 1] < bin.from * bin.from * squared_unit;
    const bool begins_behind = squares[k] >= bin.to * bin.to * squared_unit;
    if (ends_before || begins_behind || squares[k] == 0) continue;
    if (!widest || squares[k + 1] * widest->first > widest->second * squares[k]) {
      widest = std::pair(squares[k], squares[k + 1]);
    }
  }
  return widest;
}

}  // namespace flowcert_tests
