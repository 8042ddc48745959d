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

void print_bars(const std::string& title, const std::vector<BarLine>& lines, bool is_logarithmic, bool has_marks) {
  print_wrapped(fmt::format("\n{}{}", title, is_logarithmic ? "; the bars are logarithmic" : ""), 2);
  if (lines.empty()) {
    fmt::print("  none\n");
    return;
  }
  std::size_t from = columns_of("from"), to = columns_of("to"), count = columns_of("count"), mark = 0, top = 0;
  for (const BarLine& line : lines) {
    from = std::max(from, line.from.size());
    to = std::max(to, line.to.size());
    count = std::max(count, with_commas(line.count).size());
    mark = std::max(mark, line.mark.size());
    top = std::max(top, line.count);
  }
  // Two blanks come before each column.
  const std::size_t others = from + to + count + 8 + (has_marks ? mark + 2 : 0);
  const auto longest = static_cast<double>(std::min(kLongestBar, kLineWidth - others));
  Table table(has_marks ? "rrrll" : "rrrl", {"from", "to", "count"});
  for (const BarLine& line : lines) {
    const double share = share_of_axis(static_cast<double>(line.count), static_cast<double>(top), is_logarithmic);
    table.row(line.from).cell(line.to).cell(line.count);
    table.cell(std::string(static_cast<std::size_t>(std::ceil(longest * share)), '#'));
    if (has_marks) table.cell(line.mark);
  }
  table.print();
}

void print_bars(const Histogram& histogram) {
  std::vector<BarLine> lines;
  for (const Bin& bin : histogram.bins) {
    lines.push_back({with_commas(bin.first), with_commas(bin.last), bin.count, ""});
  }
  print_bars(histogram.title, lines, histogram.is_logarithmic, false);
}

}  // namespace flowcert::cli
