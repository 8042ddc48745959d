#include "cli/histogram_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/command.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

// In pixels: the picture, and the rectangle between the axes.
constexpr double kPictureWidth = 720, kPictureHeight = 420;
constexpr double kPlotLeft = 90, kPlotRight = 700, kPlotTop = 60, kPlotBottom = 360;
constexpr std::size_t kMostLabels = 15;

struct CountAxis {
  double top = 1;
  std::vector<double> ticks;
  bool is_logarithmic = false;

  [[nodiscard]] double at(double count) const {
    return kPlotBottom - (kPlotBottom - kPlotTop) * share_of_axis(count, top, is_logarithmic);
  }
};

// A logarithmic axis has ticks at powers of ten. The other one has 2 to 5 of them, at multiples of 1, 2 or 5 times a
// power of ten.
CountAxis count_axis(const Histogram& histogram) {
  const auto largest = static_cast<double>(std::max<std::size_t>(largest_count(histogram.bins), 1));
  CountAxis axis{.top = 1, .ticks = {}, .is_logarithmic = histogram.is_logarithmic};
  if (histogram.is_logarithmic) {
    for (axis.ticks = {1}; axis.ticks.back() < largest;) axis.ticks.push_back(10 * axis.ticks.back());
    axis.top = axis.ticks.back();
    return axis;
  }
  const double power = std::pow(10, std::floor(std::log10(largest)));
  const double step = largest < 2 * power ? power / 2 : largest < 5 * power ? power : 2 * power;
  const double whole_step = std::max(step, 1.0);
  axis.ticks = {0};
  while (axis.ticks.back() < largest) axis.ticks.push_back(axis.ticks.back() + whole_step);
  axis.top = axis.ticks.back();
  return axis;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text, int size = 12) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y, anchor,
                     size, xml_text(text));
}

std::string line_from(double x1, double y1, double x2, double y2, const char* color) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2,
                     color);
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
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
      kPictureWidth, kPictureHeight);
  out += text_at(kPlotLeft, 24, "start", histogram.title, 15) + text_at(kPlotLeft, 44, "start", source);
  for (const double tick : axis.ticks) {
    const double y = axis.at(tick);
    out += line_from(kPlotLeft, y, kPlotRight, y, "#dddddd");
    out += text_at(kPlotLeft - 8, y + 4, "end", with_commas(static_cast<unsigned long long>(tick)));
  }
  out += bars_of(histogram, axis);
  out += line_from(kPlotLeft, kPlotTop, kPlotLeft, kPlotBottom, "black") +
         line_from(kPlotLeft, kPlotBottom, kPlotRight, kPlotBottom, "black");
  const std::string scale = histogram.is_logarithmic ? "; the counts are on a logarithmic axis" : "";
  out += text_at((kPlotLeft + kPlotRight) / 2, kPlotBottom + 42, "middle", histogram.value + ", from" + scale);
  return out + "</svg>\n";
}

}  // namespace flowcert::cli
