// `flowcert stats`: the histograms that the paper shows of a computation of U2 and S2 (Figures 10, 11 and 12), as bars
// for people, as SVG files, or as one JSON object for programs (src/cli/manual/stats.md).
//
// Guarantees: all pictures are made before the first is written. Each appears whole or not at all.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/compute_report.h"
#include "cli/compute_run.h"
#include "cli/export_files.h"
#include "cli/histogram.h"
#include "cli/histogram_svg.h"
#include "io/json_fields.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

struct StatsOptions : InputOptions {
  std::string svg_directory;
  bool json = false;
  bool logarithmic = false;
  unsigned runs = 1;
  std::vector<std::string> manifolds = {"u2", "s2"};
  U2Choice u2{.flow = {}, .alone = false, .with_statistics = true};
};

std::vector<FlowComplexPart> wanted_parts(const StatsOptions& options) {
  std::vector<FlowComplexPart> parts;
  if (std::ranges::count(options.manifolds, "s2") > 0) parts.push_back(FlowComplexPart::kStable);
  if (std::ranges::count(options.manifolds, "u2") > 0) parts.push_back(FlowComplexPart::kUnstable);
  return parts;
}

// A distribution, and how it is shown.
struct Shown {
  const char* name;  // in the table
  const Distribution& distribution;
  Histogram histogram;
};

std::vector<Shown> histograms_of(const Measured& measured, bool logarithmic) {
  std::vector<Shown> all;
  if (measured.has_s2()) {
    const StableStatistics& s2 = measured.last->stable().statistics();
    all.push_back({"n_S2, down to index 1",
                   s2.n_s2,
                   {"n_s2", "n_S2: segments from a saddle of index 2 down to one of index 1", "segments", logarithmic,
                    equal_bins(s2.n_s2)}});
  }
  if (!measured.has_u2()) return all;
  const FlowStatistics& u2 = measured.last->unstable().statistics();
  all.push_back({"n_U2, orbits",
                 u2.n_u2,
                 {"n_u2", "n_U2: segments of an orbit up from a saddle of index 2", "segments", logarithmic,
                  equal_bins(u2.n_u2)}});
  all.push_back({"n_WCC, cascades",
                 u2.n_wcc,
                 {"n_wcc", "n_WCC: constructed points in a row, on orbits up", "constructed points", logarithmic,
                  equal_bins(u2.n_wcc)}});
  all.push_back({"bytes of exact numbers",
                 u2.exact_bytes,
                 {"exact_bytes", "Sizes of the exact numbers of U2", "bytes", true, doubling_bins(u2.exact_bytes)}});
  return all;
}

void print_text(const StatsOptions& options, const Input& input, const Measured& measured,
                const std::vector<Shown>& all) {
  print_wrapped(fmt::format("{} ({}), kernel {}\n", input.name, input.file.format, options.u2.flow.kernel));
  Table table = distribution_table();
  for (const Shown& shown : all) add_distribution(table, shown.name, shown.distribution);
  table.print();
  fmt::print("\ndeepest construction:");
  if (measured.has_s2()) fmt::print(" S2 {}", with_commas(measured.last->stable().statistics().depth));
  if (measured.has_u2()) fmt::print(" U2 {}", with_commas(measured.last->unstable().statistics().depth));
  fmt::print("\n");
  for (const Shown& shown : all) print_bars(shown.histogram);
}

void print_json(const StatsOptions& options, const Input& input, const Measured& measured) {
  Json json = compute_summary(input, measured, options.u2);
  json["format"] = "flowcert-stats";
  if (measured.has_u2()) {
    json["u2"]["exact_bytes"] = distribution_field(measured.last->unstable().statistics().exact_bytes);
  }
  if (measured.has_s2()) json["s2"]["depth"] = measured.last->stable().statistics().depth;
  fmt::print("{}\n", json.dump());
}

void write_pictures(const StatsOptions& options, const std::vector<Shown>& all) {
  const std::string source =
      fmt::format("{}, kernel {}", fs::path(display_name(options.input)).filename().string(), options.u2.flow.kernel);
  std::vector<std::pair<std::string, std::string>> files;
  for (const Shown& shown : all) {
    const fs::path path = fs::path(options.svg_directory) / (shown.histogram.name + ".svg");
    files.emplace_back(path.string(), histogram_svg(shown.histogram, source));
  }
  for (const auto& [path, text] : files) {
    io::write_whole_file(path, [&](std::ostream& out) { out << text; });
  }
}

void show_statistics(const StatsOptions& options) {
  const Input input = read_input(options);
  if (!options.svg_directory.empty()) make_directory(options.svg_directory);
  const FlowOptions how = complex_options(input, options.u2.options());
  const Measured measured = measure(input.points, options.runs, how, wanted_parts(options));
  const std::vector<Shown> all = histograms_of(measured, options.logarithmic);
  if (!options.svg_directory.empty()) write_pictures(options, all);
  if (options.json) {
    print_json(options, input, measured);
  } else {
    print_text(options, input, measured, all);
  }
}

}  // namespace

void add_stats_command(CLI::App& app) {
  auto options = std::make_shared<StatsOptions>();
  CLI::App* command = app.add_subcommand("stats", "Histograms of what flows: lengths of cascades, sizes of numbers");
  add_input_options(*command, *options);
  command->add_flag("--json", options->json, "Print one JSON object instead of the bars");
  command->add_flag("--log", options->logarithmic, "Logarithmic bars in all histograms, not only for sizes of numbers");
  command->add_option("--svg", options->svg_directory,
                      "Write each histogram into this directory, as SVG: n_s2, n_u2, n_wcc, exact_bytes");
  command->add_option("--manifolds", options->manifolds, "Only these, separated by commas: u2, s2")
      ->delimiter(',')
      ->check(CLI::IsMember({"u2", "s2"}));
  command->add_option("--runs", options->runs, "Measure this many times; the times of --json are medians")
      ->check(CLI::Range(1, 1000));
  command->add_flag("--alone", options->u2.alone, "Compute each orbit alone, as the paper did");
  add_flow_options(*command, options->u2.flow);
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert stats bunny.obj\n  flowcert stats bunny.obj --kernel lazy --svg bunny-histograms");
  command->callback([options] { show_statistics(*options); });
}

}  // namespace flowcert::cli
