// See compute_report.h.
#include "cli/compute_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include "cli/s2_report.h"
#include "cli/table.h"

namespace flowcert::cli {

namespace {

// In bytes; Linux counts kilobytes.
unsigned long long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<unsigned long long>(usage.ru_maxrss) * 1024;
}

void print_counts(const PointSet& points, const StationaryPoints& stationary) {
  print_row("points", with_commas(points.row_count()));
  print_row("merged duplicates", with_commas(points.merged_duplicates()));
  constexpr const char* kMeaning[] = {"minima: the points themselves", "saddles on Gabriel edges",
                                      "saddles on Delaunay facets", "maxima"};
  for (std::size_t k = 0; k < 4; ++k) {
    print_row(fmt::format("critical points of index {}", k), with_commas(stationary.critical_counts()[k]),
              kMeaning[k]);
  }
  const RegularCounts& regular = stationary.regular_counts();
  print_row("regular stationary points 1-2", with_commas(regular.kind12),
            "an index 1 and an index 2 collide");
  print_row("regular stationary points 2-3", with_commas(regular.kind23),
            "an index 2 and an index 3 collide");
  print_row("regular stationary points 1-3", with_commas(regular.kind13),
            "an edge, two polygons and a maximum collide");
  print_row("Euler sum", fmt::format("{}", stationary.euler_sum()));
}

std::string multiple_text(const Measured& measured, double DelaunayRatios::*part) {
  return measured.ratios ? fmt::format("{:.2f} x the triangulation", *measured.ratios.*part) : "";
}

void print_times(const Measured& measured) {
  print_row("Delaunay triangulation", seconds_text(measured.delaunay_seconds),
            measured.runs == 1 ? "" : fmt::format("median of {} runs", measured.runs));
  print_row("critical points", seconds_text(measured.critical_seconds),
            multiple_text(measured, &DelaunayRatios::critical));
  if (measured.last->u2) {
    print_row("unstable manifolds U2", seconds_text(measured.u2_seconds),
              multiple_text(measured, &DelaunayRatios::u2));
  }
  if (measured.last->s2) {
    print_row("stable manifolds S2", seconds_text(measured.s2_seconds),
              multiple_text(measured, &DelaunayRatios::s2));
  }
}

Json seconds_field(const Measured& measured) {
  Json seconds;
  seconds["delaunay"] = measured.delaunay_seconds;
  seconds["critical"] = measured.critical_seconds;
  if (measured.last->u2) seconds["u2"] = measured.u2_seconds;
  if (measured.last->s2) seconds["s2"] = measured.s2_seconds;
  return seconds;
}

Json ratios_field(const Measured& measured) {
  const auto ratio = [&](double DelaunayRatios::*part) {
    return measured.ratios ? Json(*measured.ratios.*part) : Json(nullptr);
  };
  Json ratios;
  ratios["critical"] = ratio(&DelaunayRatios::critical);
  if (measured.last->u2) ratios["u2"] = ratio(&DelaunayRatios::u2);
  if (measured.last->s2) ratios["s2"] = ratio(&DelaunayRatios::s2);
  ratios["all"] = ratio(&DelaunayRatios::all);
  return ratios;
}

}  // namespace

void print_compute_table(const std::string& name, const Input& input, const Measured& measured,
                         const U2Choice& choice) {
  const ComputeRun& run = *measured.last;
  fmt::print("{} ({})\n", name, input.file.format);
  print_counts(input.points, run.stationary);
  if (run.u2) print_u2_rows(run.u2->statistics());
  if (run.s2) print_s2_rows(run.stationary, *run.s2);
  print_times(measured);
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    const FilterCount& count = run.tally.counts[k];
    print_row(fmt::format("filter failures, {}", kPredicateNames[k]), with_commas(count.failures),
              fmt::format("of {} calls", with_commas(count.calls)));
  }
  print_row("peak memory", fmt::format("{:.1f} MiB", static_cast<double>(peak_memory()) / (1024 * 1024)));
  if (run.u2 && choice.with_statistics) print_u2_statistics(run.u2->statistics());
  if (run.s2 && choice.with_statistics) print_s2_statistics(run.s2->statistics());
}

void print_compute_summary(const Input& input, const Measured& measured, const U2Choice& choice) {
  const ComputeRun& run = *measured.last;
  Json summary = header_fields("flowcert-summary", 1, input.sha256);
  add_counts(summary, input.points, run.stationary);
  summary["dimension"] = run.diagram.dimension();
  summary["euler"] = run.stationary.euler_sum();
  summary["runs"] = measured.runs;
  summary["seconds"] = seconds_field(measured);
  summary["ratio_to_delaunay"] = ratios_field(measured);
  Json& filters = summary["filters"] = Json::object();
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    Json& field = filters[kPredicateNames[k]];
    field["calls"] = run.tally.counts[k].calls;
    field["failures"] = run.tally.counts[k].failures;
  }
  if (run.u2) summary["u2"] = u2_field(choice, run.u2->statistics());
  if (run.s2) summary["s2"] = s2_field(choice, run.stationary, *run.s2);
  summary["peak_memory_bytes"] = peak_memory();
  fmt::print("{}\n", summary.dump());
}

}  // namespace flowcert::cli
