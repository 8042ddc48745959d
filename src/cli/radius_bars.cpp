#include "cli/radius_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/histogram.h"
#include "cli/rough_number.h"
#include "cli/table.h"
#include "cli/wrapped_text.h"

namespace flowcert::cli {

namespace {

// The place of the bin that has a multiple of the spacing.
std::size_t bin_of(const std::vector<HistogramBin>& bins, const Rational& square) {
  std::size_t place = 0;
  while (place + 1 < bins.size() && bins[place].to * bins[place].to <= square) ++place;
  return place;
}

// The columns that the numbers before a bar and the mark behind it leave. Two blanks come before each column.
std::size_t room_for_radius_bars(const std::vector<HistogramBin>& bins, std::size_t mark) {
  constexpr std::size_t kLongest = 60;
  std::size_t from = columns_of("from"), to = columns_of("to"), count = columns_of("count");
  for (const HistogramBin& bin : bins) {
    from = std::max(from, rough_text(bin.from).size());
    to = std::max(to, rough_text(bin.to).size());
    count = std::max(count, with_commas(bin.count).size());
  }
  return std::min(kLongest, kLineWidth - (from + to + count + mark + 10));
}

}  // namespace

void print_radius_bars(const morse::SaddleRadii& radii, const std::optional<Rational>& squared_threshold) {
  const std::vector<HistogramBin> bins = radii.histogram();
  print_wrapped("\nradii of the index-2 saddles, in multiples of the spacing; the bars are logarithmic", 2);
  if (bins.empty()) {
    fmt::print("  none\n");
    return;
  }
  std::size_t marked = bins.size();
  std::string mark;
  if (squared_threshold) {
    const Rational square = *squared_threshold / radii.squared_spacing().value();
    marked = bin_of(bins, square);
    mark = "< " + rough_root_text(square);
  }
  double top = 0;
  for (const HistogramBin& bin : bins) top = std::max(top, static_cast<double>(bin.count));
  const std::size_t longest = room_for_radius_bars(bins, mark.size());
  Table table("rrrll", {"from", "to", "count"});
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double share = share_of_axis(static_cast<double>(bins[k].count), top, true);
    const auto marks = static_cast<std::size_t>(std::ceil(static_cast<double>(longest) * share));
    table.row(rough_text(bins[k].from)).cell(rough_text(bins[k].to)).cell(bins[k].count);
    table.cell(std::string(marks, '#')).cell(k == marked ? mark : "");
  }
  table.print();
}

}  // namespace flowcert::cli
