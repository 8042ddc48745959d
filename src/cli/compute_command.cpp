// `flowcert compute`: all stationary points of an input, as a table for people, one JSON object for programs
// (spec/formats.md, section 3), and a file of exact records (section 2).
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "cli/command.h"
#include "cli/progress_line.h"
#include "flowcert/write_stationary_points.h"
#include "io/json_fields.h"
#include "io/output_file.h"

namespace flowcert {

namespace {

struct ComputeOptions {
  std::string input;
  std::string output;
  bool json = false;
  unsigned runs = 1;
};

struct Measured {
  int dimension = -1;
  StationaryPoints stationary;
  FilterTally tally;
  double delaunay_seconds = 0;  // medians
  double critical_seconds = 0;
  unsigned runs = 0;
  // None for fewer than 4 points, or no measurable time.
  std::optional<double> ratio;
};

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

// Triangulation and critical points in turn, so that both see the same machine.
Measured measure(const PointSet& points, unsigned runs) {
  Measured result;
  std::vector<double> delaunay_seconds, critical_seconds;
  for (unsigned run = 0; run < runs; ++run) {
    ProgressLine progress(runs == 1 ? std::string("Delaunay triangulation")
                                    : fmt::format("Delaunay triangulation, run {} of {}", run + 1, runs));
    const Clock::time_point start = Clock::now();
    const Delaunay delaunay(points, std::ref(progress));
    const Clock::time_point middle = Clock::now();
    result.tally = {};
    result.stationary = stationary_points(delaunay, &result.tally);
    const Clock::time_point end = Clock::now();
    delaunay_seconds.push_back(seconds_between(start, middle));
    critical_seconds.push_back(seconds_between(middle, end));
    result.dimension = delaunay.dimension();
  }
  result.runs = runs;
  result.delaunay_seconds = median(delaunay_seconds);
  result.critical_seconds = median(critical_seconds);
  if (points.size() >= 4 && result.delaunay_seconds > 0) {
    result.ratio = result.critical_seconds / result.delaunay_seconds;
  }
  return result;
}

// In bytes; Linux counts kilobytes.
unsigned long long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<unsigned long long>(usage.ru_maxrss) * 1024;
}

std::string seconds_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.1f} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

void print_row(const std::string& name, const std::string& value, const std::string& remark = "") {
  fmt::print("{:<34}{:>14}{}{}\n", name, value, remark.empty() ? "" : "   ", remark);
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

void print_table(const ComputeOptions& options, const Input& input, const Measured& measured) {
  fmt::print("{} ({})\n", display_name(options.input), input.file.format);
  print_counts(input.points, measured.stationary);
  print_row("Delaunay triangulation", seconds_text(measured.delaunay_seconds),
            measured.runs == 1 ? "" : fmt::format("median of {} runs", measured.runs));
  print_row("critical points", seconds_text(measured.critical_seconds),
            measured.ratio ? fmt::format("{:.2f} x the triangulation", *measured.ratio) : "");
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    const FilterCount& count = measured.tally.counts[k];
    print_row(fmt::format("filter failures, {}", kPredicateNames[k]), with_commas(count.failures),
              fmt::format("of {} calls", with_commas(count.calls)));
  }
  print_row("peak memory", fmt::format("{:.1f} MiB", static_cast<double>(peak_memory()) / (1024 * 1024)));
}

void print_json(const Input& input, const Measured& measured) {
  Json summary = header_fields("flowcert-summary", 1, input.sha256);
  add_counts(summary, input.points, measured.stationary);
  summary["dimension"] = measured.dimension;
  summary["euler"] = measured.stationary.euler_sum();
  summary["runs"] = measured.runs;
  summary["seconds"] = {{"delaunay", measured.delaunay_seconds}, {"critical", measured.critical_seconds}};
  const Json ratio = measured.ratio ? Json(*measured.ratio) : Json(nullptr);
  summary["ratio_to_delaunay"] = {{"critical", ratio}, {"all", ratio}};
  Json& filters = summary["filters"] = Json::object();
  for (std::size_t k = 0; k < kPredicateCount; ++k) {
    const FilterCount& count = measured.tally.counts[k];
    filters[kPredicateNames[k]] = {{"calls", count.calls}, {"failures", count.failures}};
  }
  summary["peak_memory_bytes"] = peak_memory();
  fmt::print("{}\n", summary.dump());
}

void write_records(const std::string& path, const Input& input, const StationaryPoints& stationary) {
  OutputFile file(path);
  ProgressLine progress("writing exact records");
  write_stationary_points(file.stream(), input.points, stationary, input.sha256, std::ref(progress));
  file.commit();
}

void compute(const ComputeOptions& options) {
  const Input input = read_input(options.input);
  const Measured measured = measure(input.points, options.runs);
  if (!options.output.empty()) write_records(options.output, input, measured.stationary);
  if (options.json) {
    print_json(input, measured);
  } else {
    print_table(options, input, measured);
  }
}

}  // namespace

void add_compute_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ComputeOptions>();
  CLI::App* command = app.add_subcommand("compute", "All critical points of the distance function, exactly");
  command
      ->add_option("INPUT", options->input,
                   "Point file: XYZ/text, OFF, PLY or OBJ, also as .gz; - for standard input")
      ->required();
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  command->add_option("-o,--output", options->output, "Write the stationary points to this file, JSON Lines");
  command
      ->add_option("--runs", options->runs,
                   "Measure this many times and print medians; 5 for a ratio to quote")
      ->check(CLI::Range(1, 1000));
  command->footer("Example:\n  flowcert compute bunny.obj -o bunny.jsonl");
  command->callback([options, &status] {
    compute(*options);
    status = kRight;
  });
}

}  // namespace flowcert
