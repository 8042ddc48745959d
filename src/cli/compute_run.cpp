#include "cli/compute_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "cli/progress.h"
#include "cli/table.h"

namespace flowcert::cli {

namespace {

using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

struct NamedPart {
  FlowComplexPart part;
  const char* key;   // in JSON
  const char* name;  // in a table
};
// In the order of reports.
constexpr NamedPart kParts[] = {{FlowComplexPart::kStationary, "critical", "critical points"},
                                {FlowComplexPart::kUnstable, "u2", "unstable manifolds U2"},
                                {FlowComplexPart::kStable, "s2", "stable manifolds S2"},
                                {FlowComplexPart::kLimits, "limits", "limits of all directions"},
                                {FlowComplexPart::kVolumes, "volumes", "volumes"},
                                {FlowComplexPart::kPersistence, "pairs", "pairs"}};

}  // namespace

Measured measure(const PointSet& points, unsigned runs, const FlowOptions& options,
                 const std::vector<FlowComplexPart>& parts, const PartMade& made) {
  const ProgressLine progress("computing");
  Measured result{.last = {}, .runs = runs, .seconds = {}};
  std::map<FlowComplexPart, std::vector<double>> times;
  std::vector<double> after_delaunay;
  for (unsigned run = 0; run < runs; ++run) {
    result.last.reset();
    result.last.emplace(points, options, part_progress(runs == 1 ? "" : fmt::format(", run {} of {}", run + 1, runs)));
    const auto seconds_to_make = [&](FlowComplexPart part) {
      const Clock::time_point start = Clock::now();
      result.last->make(part);
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      times[part].push_back(seconds);
      if (made && run + 1 == runs) made(*result.last, part);
      return seconds;
    };
    seconds_to_make(FlowComplexPart::kTriangulation);
    after_delaunay.push_back(seconds_to_make(FlowComplexPart::kStationary));
    for (const FlowComplexPart part : parts) after_delaunay.back() += seconds_to_make(part);
  }
  for (const auto& [part, seconds] : times) {
    const bool is_for_pairs = part == FlowComplexPart::kChains || part == FlowComplexPart::kLinks;
    result.seconds[is_for_pairs ? FlowComplexPart::kPersistence : part] += median(seconds);
  }
  result.seconds_after_delaunay = median(after_delaunay);
  result.has_ratios = points.size() >= 4 && result.seconds.at(FlowComplexPart::kTriangulation) > 0;
  return result;
}

void print_times(const Measured& measured) {
  print_row("Delaunay triangulation", seconds_text(measured.seconds.at(FlowComplexPart::kTriangulation)),
            measured.runs == 1 ? "" : fmt::format("median of {} runs", measured.runs));
  for (const auto& [part, key, name] : kParts) {
    if (measured.seconds.contains(part)) print_time(measured, name, measured.seconds.at(part));
  }
}

void print_time(const Measured& measured, const char* name, double seconds) {
  const double delaunay = measured.seconds.at(FlowComplexPart::kTriangulation);
  print_row(name, seconds_text(seconds),
            measured.has_ratios ? fmt::format("{:.2f} x the triangulation", seconds / delaunay) : "");
}

void add_times(Json& object, const Measured& measured) {
  const double delaunay = measured.seconds.at(FlowComplexPart::kTriangulation);
  const auto ratio = [&](double seconds) { return measured.has_ratios ? Json(seconds / delaunay) : Json(nullptr); };
  Json seconds, ratios;
  seconds["delaunay"] = delaunay;
  for (const auto& [part, key, name] : kParts) {
    if (!measured.seconds.contains(part)) continue;
    seconds[key] = measured.seconds.at(part);
    ratios[key] = ratio(measured.seconds.at(part));
  }
  ratios["all"] = ratio(measured.seconds_after_delaunay);
  object["seconds"] = std::move(seconds);
  object["ratio_to_delaunay"] = std::move(ratios);
}

}  // namespace flowcert::cli
