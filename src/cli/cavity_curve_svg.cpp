#include "cli/cavity_curve_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cli/command.h"
#include "cli/svg_plot.h"

namespace flowcert::cli {

namespace {

// A line of steps from the left, whose number of cavities is `count` up to the probe `up_to`.
struct Step {
  double up_to;
  double count;
};

std::string labels_of_probes(double widest) {
  std::string drawn;
  constexpr int kLabels = 6;
  for (int k = 0; k <= kLabels; ++k) {
    const double x = kPlotLeft + (kPlotRight - kPlotLeft) * k / kLabels;
    drawn += line_from(x, kPlotBottom, x, kPlotBottom + 4, "black");
    drawn += text_at(x, kPlotBottom + 18, "middle", fmt::format("{:.3g}", widest * k / kLabels));
  }
  return drawn;
}

}  // namespace

std::string cavity_curve_svg(const Pores& pores, const std::string& source) {
  std::vector<Step> steps;
  double largest = 1, widest = 0;
  for (const CavityStep& step : pores.cavity_steps()) {
    steps.push_back({nearest_or_infinity(pores.value(step.point)), static_cast<double>(step.count)});
    largest = std::max(largest, steps.back().count);
    widest = std::max(widest, steps.back().up_to);
  }
  std::ranges::reverse(steps);
  if (!(widest > 0)) widest = 1;
  const std::vector<double> ticks = count_ticks(largest);
  std::string path = fmt::format("M{:.2f} {:.2f}", kPlotLeft, kPlotBottom);
  const auto height = [&](double count) { return kPlotBottom - (kPlotBottom - kPlotTop) * count / ticks.back(); };
  for (const Step& step : steps) {
    path +=
        fmt::format("V{:.2f}H{:.2f}", height(step.count), kPlotLeft + (kPlotRight - kPlotLeft) * step.up_to / widest);
  }
  path += fmt::format("V{:.2f}", kPlotBottom);
  const std::string curve =
      fmt::format("<path d=\"{}\" fill=\"#4477aa\" fill-opacity=\"0.25\" stroke=\"#4477aa\"/>\n", path);
  return svg_plot("Cavities for each probe", source, lines_of_counts(ticks, height) + labels_of_probes(widest) + curve,
                  "radius of the probe");
}

}  // namespace flowcert::cli
