// `flowcert persistence`: the persistence pairs of the squared distance function. The output is a file that GUDHI
// reads, a table for people, or one exact JSON object (spec/formats/persistence.md).
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/compute_run.h"
#include "cli/fixed_decimals.h"
#include "cli/layer.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/flow_complex.h"
#include "geometry/difference_of_roots.h"
#include "io/json_fields.h"
#include "io/ordered_text.h"
#include "io/output_file.h"
#include "morse/longest_pairs.h"
#include "morse/saddle_radii.h"

namespace flowcert::cli {

namespace {

struct PersistenceOptions : InputOptions {
  std::string output;
  std::string certificate;
  bool json = false;
  bool is_plain = false;
  bool with_zero = false;
  std::uint64_t seed = 0;
};

// Pairs of one dimension.
struct PairCounts {
  std::size_t positive = 0;  // of positive length
  std::size_t zero = 0;      // of length zero: regular stationary points
  std::size_t lasting = 0;
};

std::array<PairCounts, 3> counts_of(const FlowComplex& complex) {
  std::array<PairCounts, 3> counts;
  for (const PersistencePair& pair : complex.persistence().pairs()) {
    PairCounts& count = counts.at(static_cast<std::size_t>(pair.dimension));
    ++(pair.death ? count.positive : count.lasting);
  }
  const RegularCounts& regular = complex.stationary().regular_counts();
  counts[1].zero = regular.kind12 + regular.kind13;
  counts[2].zero = regular.kind23 + regular.kind13;
  return counts;
}

// ---- The longest pairs ----

constexpr std::size_t kLongestPairs = 5;  // of each dimension

// Those that last come first. Of equally long pairs, the first in the list come first.
std::vector<PersistencePair> longest_pairs(const Persistence& persistence, int dimension) {
  std::vector<PersistencePair> longest, ending;
  for (const PersistencePair& pair : persistence.pairs()) {
    if (pair.dimension != dimension) continue;
    if (pair.death) {
      ending.push_back(pair);
    } else if (longest.size() < kLongestPairs) {
      longest.push_back(pair);
    }
  }
  const auto next = morse::longest_pairs(persistence.squared_distances(), ending, kLongestPairs - longest.size());
  longest.insert(longest.end(), next.begin(), next.end());
  return longest;
}

// What a person reads is not squared.
std::string distance_text(const Rational& squared, const FixedDecimals& decimals) {
  return decimals.length(geometry::nearest_difference_of_roots(squared, 0));
}

void print_longest_pairs(const Input& input, const FlowComplex& complex) {
  const Persistence& persistence = complex.persistence();
  const StationaryPoints& stationary = complex.stationary();
  const FixedDecimals decimals(morse::squared_spacing(complex, persistence.squared_distances()));
  const auto place = [&](std::size_t record) { return contact_text(input.file.atoms, stationary.contact(record)); };
  Table table("rrrrll", {"dimension", "length", "birth", "death", "born at", "dies at"});
  for (int dimension = 0; dimension < 3; ++dimension) {
    for (const PersistencePair& pair : longest_pairs(persistence, dimension)) {
      const Rational birth = persistence.squared_value(pair.birth);
      const std::optional<Rational> death =
          pair.death ? std::optional(persistence.squared_value(*pair.death)) : std::nullopt;
      table.row(std::to_string(dimension));
      table.cell(death ? decimals.length(geometry::nearest_difference_of_roots(*death, birth)) : "inf");
      table.cell(distance_text(birth, decimals)).cell(death ? distance_text(*death, decimals) : "inf");
      table.cell(place(pair.birth)).cell(pair.death ? place(*pair.death) : "never");
    }
  }
  if (table.height() == 1) return;
  print_wrapped(
      fmt::format("\nthe {} longest pairs of each dimension, by distances that are not squared, and the contact "
                  "sets of both ends: the points nearest to them, by row from 0",
                  kLongestPairs),
      2);
  table.print();
  print_wrapped("\nflowcert explain tells where an end is, by --ids and its contact set; flowcert view draws all pairs",
                2);
}

// ---- What is computed ----

struct Computed {
  Measured measured;
  // Told by the parts that are forgotten before the pairs are made.
  std::size_t cells = 0;
  std::size_t ties = 0;  // boundaries that a tie leaves open
};

// The pairs take as much memory as all before them, which a certificate alone needs afterwards.
Computed compute_pairs(const Input& input, const PersistenceOptions& options) {
  using enum FlowComplexPart;
  Computed computed;
  const PartMade made = [&](FlowComplex& complex, FlowComplexPart part) {
    if (part != kLinks) return;
    computed.cells = complex.delaunay_cells();
    computed.ties = complex.stable().statistics().broken_ties;
    if (options.certificate.empty()) complex.forget_diagram();
  };
  computed.measured =
      measure(input.points, 1, complex_options(input, {.seed = options.seed}), {kStable, kLinks, kPersistence}, made);
  return computed;
}

// ---- What is printed ----

void print_table(const Input& input, const Computed& computed, bool with_zero) {
  const Measured& measured = computed.measured;
  const FlowComplex& complex = *measured.last;
  print_input(input);
  print_point_counts(input.points);
  constexpr const char* kNames[] = {"components", "tunnels", "voids"};
  std::size_t zero = 0;
  const auto counts = counts_of(complex);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    print_row(
        fmt::format("pairs of dimension {}", k), with_commas(counts[k].positive),
        fmt::format("{}; {} last{}", kNames[k], with_commas(counts[k].lasting), counts[k].lasting == 1 ? "s" : ""));
    zero += counts[k].zero;
  }
  print_row("pairs of length zero", with_commas(zero),
            with_zero ? "regular stationary points" : "regular; --zero writes them");
  if (computed.ties > 0) {
    print_row("choices at ties, surfaces", with_commas(computed.ties),
              "one of several boundaries was taken; pairs do not depend on it");
  }
  print_times(measured);
  print_time(measured, "all after the triangulation", measured.seconds_after_delaunay);
  print_longest_pairs(input, complex);
}

void print_json(const Input& input, const Computed& computed, const PersistenceDiagram& diagram, std::uint64_t seed) {
  const FlowComplex& complex = *computed.measured.last;
  Json json = header_fields("flowcert-persistence", 1, input.points);
  add_counts(json, input.points, complex.stationary());
  Json& counts = json["counts"] = Json::array();
  for (const PairCounts& count : counts_of(complex)) {
    counts.push_back({{"positive", count.positive}, {"zero", count.zero}, {"lasting", count.lasting}});
  }
  json["ties_broken"] = computed.ties;
  json["seed"] = seed;
  json["has_zero"] = diagram.has_zero();
  // The pairs come last, and are printed as they are made: all of them as one object take gigabytes.
  json["pairs"] = Json::array();
  std::string text = json.dump();
  text.resize(text.size() - 2);
  std::fwrite(text.data(), 1, text.size(), stdout);
  ProgressLine progress("writing pairs", STDOUT_FILENO);
  const auto make = [&](std::size_t first, std::size_t last, std::string& part) {
    for (std::size_t k = first; k < last; ++k) {
      if (k > 0) part += ',';
      part += pair_field(diagram, diagram.pairs()[k]).dump();
    }
  };
  const auto write = [&](const std::string& part, std::size_t done) {
    progress(done, diagram.pairs().size());
    return std::fwrite(part.data(), 1, part.size(), stdout) == part.size();
  };
  io::write_in_order(diagram.pairs().size(), io::kShortRecords, complex.threads(), make, write);
  fmt::print("]}}\n");
}

// A value beyond the doubles is the input's fault.
auto naming_input(const PersistenceOptions& options, const auto& write) {
  return naming(display_name(options.input),
                [&] { return write(options.is_plain ? PersistenceValues::kPlain : PersistenceValues::kSquared); });
}

void print_pairs(const PersistenceOptions& options, const PersistenceDiagram& diagram) {
  const ProgressLine progress("writing pairs", STDOUT_FILENO);
  fmt::print("{}", naming_input(options, [&](PersistenceValues values) { return pers_text(diagram, values); }));
}

void write_file(const PersistenceOptions& options, const PersistenceDiagram& diagram) {
  const ProgressLine progress("writing pairs");
  io::write_whole_file(options.output, [&](std::ostream& out) {
    naming_input(options, [&](PersistenceValues values) { write_pers(out, diagram, values); });
  });
}

void print_persistence(const PersistenceOptions& options) {
  if (options.output == kStandardStream && options.json) {
    throw InvalidInput("-o - and --json would both write to standard output");
  }
  require_another_file(options.certificate, options.output);
  const Input input = read_input(options);
  const Computed computed = compute_pairs(input, options);
  const FlowComplex& complex = *computed.measured.last;
  tell_of_many_cells(computed.cells, input.points.size());
  const auto diagram = with_progress("pairs", [&] { return PersistenceDiagram(complex, options.with_zero); });
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed) print_pairs(options, diagram);
  if (!is_streamed && !options.output.empty()) write_file(options, diagram);
  write_certificate_file(options.certificate, complex);
  if (options.json) {
    print_json(input, computed, diagram, options.seed);
  } else if (!is_streamed) {
    print_table(input, computed, options.with_zero);
  }
}

// Returns what is wrong. CLI11 itself reads -1, and a number that is too large, as the largest number.
std::string complaint_about_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? "" : "not a number from 0 to 2^64 - 1: " + text;
}

}  // namespace

void add_persistence_command(CLI::App& app) {
  auto options = std::make_shared<PersistenceOptions>();
  CLI::App* command = app.add_subcommand("persistence", "Persistence of the distance: components, tunnels, voids");
  add_input_options(*command, *options);
  CLI::Option* output =
      command
          ->add_option("-o,--output", options->output,
                       "Write all pairs to this file, in GUDHI's .pers format, with squared distances; -: to standard "
                       "output, without the table")
          ->check(complaint_about_path);
  command->add_flag("--plain", options->is_plain, "The file has distances that are not squared; check refuses it")
      ->needs(output);
  add_certificate_option(*command, options->certificate);
  command->add_flag("--json", options->json, "Print one JSON object, all exact, with the critical points");
  command->add_flag("--zero", options->with_zero, "Regular stationary points as well, as pairs of length zero");
  command
      ->add_option("--seed-ties", options->seed, "Break ties at random, reproducibly; births and deaths stay the same")
      ->check(complaint_about_seed);
  add_threads_option(*command, options->threads);
  command->footer(
      "The pairs are those of the alpha complex, as GUDHI has them.\n\n"
      "Examples:\n  flowcert persistence bunny.obj -o bunny.pers\n  flowcert persistence bunny.obj --json >bunny.json");
  command->callback([options] { print_persistence(*options); });
}

}  // namespace flowcert::cli
