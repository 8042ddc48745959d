#include "cli/histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "cli/command.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kMostBins = 30;
constexpr std::size_t kLongestBar = 60;

// The least of 1, 2, 5, 10, 20, 50, … with which the bins from `least` to `most` are few enough.
std::size_t bin_width(std::size_t least, std::size_t most) {
  for (std::size_t power = 1;; power *= 10) {
    for (const std::size_t digit : {1U, 2U, 5U}) {
      const std::size_t width = digit * power;
      if (most / width - least / width < kMostBins) return width;
    }
  }
}

}  // namespace

std::vector<Bin> equal_bins(const Distribution& distribution) {
  const auto& times = distribution.times();
  if (times.empty()) return {};
  const std::size_t least = times.begin()->first;
  const std::size_t width = bin_width(least, distribution.max());
  std::vector<Bin> bins;
  for (std::size_t k = least / width; k <= distribution.max() / width; ++k) {
    bins.push_back({k * width, k * width + width - 1, 0});
  }
  for (const auto& [value, count] : times) bins[value / width - least / width].count += count;
  return bins;
}

std::vector<Bin> doubling_bins(const Distribution& distribution) {
  std::map<std::size_t, std::size_t> ranges;
  for (const auto& [value, times] : distribution.times()) ranges[std::bit_floor(value)] += times;
  std::vector<Bin> bins;
  const auto add = [&bins](std::size_t from, std::size_t count) {
    bins.push_back({from, from == 0 ? 0 : from + (from - 1), count});
  };
  for (const auto& [from, count] : ranges) {
    while (!bins.empty() && bins.back().first > 0 && bins.back().first * 2 < from) add(bins.back().first * 2, 0);
    add(from, count);
  }
  return bins;
}

std::size_t largest_count(const std::vector<Bin>& bins) {
  std::size_t largest = 0;
  for (const Bin& bin : bins) largest = std::max(largest, bin.count);
  return largest;
}

double share_of_axis(double count, double top, bool is_logarithmic) {
  if (count <= 0) return 0;
  return is_logarithmic ? std::log(2 * count) / std::log(2 * top) : count / top;
}

namespace {

// The columns that the numbers before a bar leave.
std::size_t room_for_bars(const std::vector<Bin>& bins) {
  std::size_t first = columns_of("from"), last = columns_of("to"), count = columns_of("count");
  for (const Bin& bin : bins) {
    first = std::max(first, with_commas(bin.first).size());
    last = std::max(last, with_commas(bin.last).size());
    count = std::max(count, with_commas(bin.count).size());
  }
  return std::min(kLongestBar, kLineWidth - (first + last + count + 8));  // two blanks before each column
}

}  // namespace

void print_bars(const Histogram& histogram) {
  print_wrapped(fmt::format("\n{}{}", histogram.title, histogram.is_logarithmic ? "; the bars are logarithmic" : ""),
                2);
  if (histogram.bins.empty()) {
    fmt::print("  none\n");
    return;
  }
  Table table("rrrl", {"from", "to", "count"});
  const auto top = static_cast<double>(largest_count(histogram.bins));
  const std::size_t longest_bar = room_for_bars(histogram.bins);
  for (const Bin& bin : histogram.bins) {
    const double share = share_of_axis(static_cast<double>(bin.count), top, histogram.is_logarithmic);
    const auto marks = static_cast<std::size_t>(std::ceil(static_cast<double>(longest_bar) * share));
    table.row(with_commas(bin.first)).cell(with_commas(bin.last)).cell(bin.count).cell(std::string(marks, '#'));
  }
  table.print();
}

}  // namespace flowcert::cli
