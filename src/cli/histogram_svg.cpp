#include "cli/histogram_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/command.h"
#include "cli/svg_plot.h"

namespace flowcert::cli {

namespace {

constexpr std::size_t kMostLabels = 15;

struct CountAxis {
  double top = 1;
  std::vector<double> ticks;
  bool is_logarithmic = false;

  [[nodiscard]] double at(double count) const {
    return kPlotBottom - (kPlotBottom - kPlotTop) * share_of_axis(count, top, is_logarithmic);
  }
};

// A logarithmic axis has ticks at powers of ten.
CountAxis count_axis(const Histogram& histogram) {
  const auto largest = static_cast<double>(std::max<std::size_t>(largest_count(histogram.bins), 1));
  CountAxis axis{.top = 1, .ticks = {}, .is_logarithmic = histogram.is_logarithmic};
  if (histogram.is_logarithmic) {
    for (axis.ticks = {1}; axis.ticks.back() < largest;) axis.ticks.push_back(10 * axis.ticks.back());
    axis.top = axis.ticks.back();
    return axis;
  }
  axis.ticks = count_ticks(largest);
  axis.top = axis.ticks.back();
  return axis;
}

std::string bars_of(const Histogram& histogram, const CountAxis& axis) {
  std::string out;
  const std::size_t n = histogram.bins.size();
  const double width = (kPlotRight - kPlotLeft) / static_cast<double>(std::max<std::size_t>(n, 1));
  const std::size_t every = n / kMostLabels + 1;
  for (std::size_t k = 0; k < n; ++k) {
    const Bin& bin = histogram.bins[k];
    const double x = kPlotLeft + width * static_cast<double>(k);
    const double y = axis.at(static_cast<double>(bin.count));
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#4477aa\">"
        "<title>{} to {}: {}</title></rect>\n",
        x + width * 0.05, y, width * 0.9, kPlotBottom - y, bin.first, bin.last, bin.count);
    if (k % every == 0) out += text_at(x + width / 2, kPlotBottom + 18, "middle", with_commas(bin.first));
  }
  return out;
}

}  // namespace

std::string histogram_svg(const Histogram& histogram, const std::string& source) {
  const CountAxis axis = count_axis(histogram);
  const std::string drawn =
      lines_of_counts(axis.ticks, [&](double tick) { return axis.at(tick); }) + bars_of(histogram, axis);
  const std::string scale = histogram.is_logarithmic ? "; the counts are on a logarithmic axis" : "";
  return svg_plot(histogram.title, source, drawn, histogram.value + ", from" + scale);
}

}  // namespace flowcert::cli
