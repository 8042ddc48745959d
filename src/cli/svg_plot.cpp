#include "cli/svg_plot.h"

#include <algorithm>
#include <cmath>

#include "cli/command.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

std::string text_at(double x, double y, const char* anchor, const std::string& text, int size) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y, anchor,
                     size, xml_text(text));
}

std::string line_from(double x1, double y1, double x2, double y2, const char* color) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2, y2,
                     color);
}

std::vector<double> count_ticks(double largest) {
  const double power = std::pow(10, std::floor(std::log10(largest)));
  const double step = largest < 2 * power ? power / 2 : largest < 5 * power ? power : 2 * power;
  const double whole_step = std::max(step, 1.0);
  std::vector<double> ticks = {0};
  while (ticks.back() < largest) ticks.push_back(ticks.back() + whole_step);
  return ticks;
}

std::string lines_of_counts(const std::vector<double>& ticks, const std::function<double(double)>& at) {
  std::string drawn;
  for (const double tick : ticks) {
    const double y = at(tick);
    drawn += line_from(kPlotLeft, y, kPlotRight, y, "#dddddd");
    drawn += text_at(kPlotLeft - 8, y + 4, "end", with_commas(static_cast<unsigned long long>(tick)));
  }
  return drawn;
}

std::string svg_plot(const std::string& title, const std::string& source, const std::string& drawn,
                     const std::string& lower_axis) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
      "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"white\"/>\n",
      kPictureWidth, kPictureHeight);
  out += text_at(kPlotLeft, 24, "start", title, 15) + text_at(kPlotLeft, 44, "start", source) + drawn;
  out += line_from(kPlotLeft, kPlotTop, kPlotLeft, kPlotBottom, "black") +
         line_from(kPlotLeft, kPlotBottom, kPlotRight, kPlotBottom, "black");
  out += text_at((kPlotLeft + kPlotRight) / 2, kPlotBottom + 42, "middle", lower_axis);
  return out + "</svg>\n";
}

}  // namespace flowcert::cli
