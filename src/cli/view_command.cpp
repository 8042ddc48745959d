// `flowcert view`: one page that shows the complex of an input in a browser and, if wanted, what is wrong with a claim;
// or, with radii, atoms as balls with the chambers between them (src/cli/manual/view.md). With a claim, the exit status
// is that of `check`.
//
// Guarantees: the page appears whole or not at all.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>

#include "certify/viewer_claim.h"
#include "cli/ball_input.h"
#include "cli/check_report.h"
#include "cli/command.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/check.h"
#include "io/output_file.h"
#include "io/pocket_persistence.h"
#include "io/viewer_page.h"

namespace flowcert::cli {

namespace {

struct ViewCommandOptions : BallOptions {
  std::string depth = "0.1";
  std::string output;
  std::string claim;
  CheckOptions check;
  bool is_strict = false;
  std::string pockets;
  ViewerOptions content;
};

// "bunny.obj.gz" gives "bunny.html", in the current folder.
std::string page_beside(const std::string& input) {
  std::filesystem::path name = input == kStandardStream ? "flow-complex" : std::filesystem::path(input).filename();
  if (name.extension() == ".gz") name = name.stem();
  return name.stem().string() + ".html";
}

// Without -o the page is beside INPUT.
void choose_output(ViewCommandOptions& options) {
  if (!options.output.empty()) return;
  options.output = page_beside(options.input);
  std::error_code ignored;
  if (std::filesystem::equivalent(options.output, options.input, ignored)) {
    throw InvalidInput(fmt::format("{}: the page would replace these points; name it with -o", options.input));
  }
}

using PageWriter = std::function<void(std::ostream&, ProgressLine&)>;

void write_page(const std::string& path, const std::string& name, const PageWriter& write) {
  std::optional<OutputFile> file;
  if (path != kStandardStream) file.emplace(path);
  ProgressLine progress("page", file ? -1 : STDOUT_FILENO);
  naming(name, [&] { write(file ? file->stream() : std::cout, progress); });
  if (file) file->commit();
}

void print_page(const std::string& page) {
  print_wrapped(fmt::format("{}: open it in a browser", on_one_line(page)));
  // A pipe has no size.
  std::error_code no_size;
  const std::uintmax_t size = std::filesystem::file_size(page, no_size);
  constexpr double kMegabyte = 1e6;
  if (!no_size) print_row("size", fmt::format("{:.1f} MB", static_cast<double>(size) / kMegabyte));
}

void print_page_table(const std::string& page, const Input& input, const FlowComplex& complex,
                      const ViewerOptions& content, const ViewerCounts& shown, const CheckReport* report) {
  const auto& counts = complex.stationary().critical_counts();
  print_page(page);
  print_row("points", with_commas(input.points.row_count()));
  for (std::size_t index = 0; index < counts.size(); ++index) {
    print_row(fmt::format("critical points of index {}", index), with_commas(counts.at(index)));
  }
  const auto of_all = [](const ViewerCounts::Part& part, const char* chosen) {
    return part.kept < part.all ? fmt::format("of {}: {}", with_commas(part.all), chosen) : "";
  };
  if (shown.records.kept < shown.records.all) {
    print_row("shown, from index 1 on", with_commas(shown.records.kept),
              of_all(shown.records, "those of the longest pairs (--most)"));
  }
  if (content.has_cells) {
    print_row("cells S3 drawn", with_commas(shown.cells.kept), of_all(shown.cells, "the largest (--most-cells)"));
    print_row("surfaces U1 drawn", with_commas(shown.surfaces.kept),
              of_all(shown.surfaces, "those of the longest pairs (--most-unstable)"));
  }
  if (content.pockets != nullptr) {
    print_row("pockets", with_commas(shown.pockets.kept), of_all(shown.pockets, "the deepest (--most-pockets)"));
  }
  if (report != nullptr) {
    print_row("findings", with_commas(report->findings.size()),
              fmt::format("verdict: {}", verdict_text(report->verdict)));
  }
}

int view_balls(ViewCommandOptions options) {
  const Rational depth = length_of_option(options.depth, "--depth");
  std::optional<Rational> probe;
  if (!options.probe.empty()) probe = length_of_option(options.probe, "--probe");
  const BallInput input = read_ball_input(options);
  choose_output(options);
  std::optional<Pores> pores;
  {
    const ProgressLine progress("computing");
    pores.emplace(input.balls, depth, input.threads);
  }
  write_page(options.output, input.name, [&](std::ostream& out, ProgressLine&) {
    write_viewer_page(out, input.name, input.file.file.rows,
                      {*pores, depth, probe, input.atoms(), on_one_line(options.radii)});
  });
  if (options.output == kStandardStream) return kRight;
  print_page(options.output);
  print_row("balls", with_commas(input.balls.size()));
  print_row("chambers", with_commas(pores->chambers().size()), fmt::format("of depth {} or more", options.depth));
  return kRight;
}

int view(ViewCommandOptions options) {
  if (!options.radii.empty()) return view_balls(std::move(options));
  if (options.input == kStandardStream && options.claim == kStandardStream) {
    throw InvalidInput("INPUT and --claim cannot both be standard input");
  }
  std::optional<Claim> claim;
  if (!options.claim.empty()) claim = read_claim(options.claim);
  const Input input = read_input(options);
  if (claim) require_rows(*claim, input.points, display_name(options.claim));
  choose_output(options);
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  tell_of_many_cells(complex);
  std::optional<Pockets> pockets;
  if (!options.pockets.empty()) {
    pockets.emplace(complex.merge_trees(), pocket_persistence(complex, options.pockets, "--pockets").square);
  }
  ViewerOptions& content = options.content;
  content.name = input.name;
  if (!input.file.atoms.empty()) content.atoms = &input.file.atoms;
  if (pockets) content.pockets = &*pockets;
  int status = kRight;
  std::optional<CheckReport> report;
  if (claim) {
    report = check(complex, *claim, options.check);
    content.claim = viewer_claim(complex, *claim, *report,
                                 {.name = display_name(options.claim), .tolerance = options.check.tolerance});
    status = status_of(report->verdict, options.is_strict);
  }
  ViewerCounts shown;
  write_page(options.output, content.name, [&](std::ostream& out, ProgressLine& progress) {
    shown = write_viewer_page(out, complex, content, std::ref(progress));
  });
  if (options.output != kStandardStream)
    print_page_table(options.output, input, complex, content, shown, report ? &*report : nullptr);
  return status;
}

}  // namespace

void add_view_command(CLI::App& app, int& status) {
  auto options = std::make_shared<ViewCommandOptions>();
  constexpr std::size_t kMost = 0xfffffff;
  CLI::App* command = app.add_subcommand("view", kViewPurpose);
  add_input_options(*command, *options);
  command
      ->add_option("-o,--output", options->output,
                   "Write the page to this file; -: to standard output; without this, INPUT's name with .html, in the "
                   "current folder")
      ->check(complaint_about_path);
  CLI::Option* claim = command->add_option(
      "--claim", options->claim,
      "Show what check finds wrong with this claim, in place; the exit status is then that of check");
  add_judging_options(*command, options->check, options->is_strict);
  for (const char* name : {"--tolerance", "--highest-level", "--indices", "--strict"}) {
    command->get_option(name)->needs(claim);
  }
  command
      ->add_option("--most", options->content.most_of_an_index,
                   "If there are more critical points of an index from 1 on, keep so many pairs of dimension 0, and so "
                   "many others: the longest, with their points and what these lead to")
      ->check(CLI::Range(std::size_t{1}, kMost))
      ->capture_default_str();
  CLI::Option* cells = command->add_flag(
      "--cells", options->content.has_cells,
      "Also say how large stable sets are, and where all directions from saddles lead; the picked point's cell S3, or "
      "its surface U1, is drawn");
  command->add_option("--most-cells", options->content.most_cells, "Draw at most so many cells S3, the largest")
      ->check(CLI::Range(std::size_t{0}, kMost))
      ->capture_default_str()
      ->needs(cells);
  command
      ->add_option("--most-unstable", options->content.most_surfaces,
                   "Draw at most so many surfaces U1: of regular stationary points, and of the longest pairs")
      ->check(CLI::Range(std::size_t{0}, kMost))
      ->capture_default_str()
      ->needs(cells);
  CLI::Option* pockets =
      command
          ->add_option("--pockets", options->pockets,
                       "Also tell pockets, merged by this persistence as by pockets --persistence; the deepest is "
                       "picked at first, and that of the picked point is drawn with its mouths")
          ->type_name("X");
  command->add_option("--most-pockets", options->content.most_pockets, "Have at most so many pockets, the deepest")
      ->check(CLI::Range(std::size_t{0}, kMost))
      ->capture_default_str()
      ->needs(pockets);
  add_radii_options(*command, *options, false);
  CLI::Option* radii = command->get_option("--radii");
  for (const char* name : {"--claim", "--most", "--cells", "--pockets"}) command->get_option(name)->excludes(radii);
  command->add_option("--depth", options->depth, "Have chambers whose peak is this much wider than their gate, or more")
      ->type_name("D")
      ->capture_default_str()
      ->needs(radii);
  command->add_option("--probe", options->probe, "Say for each chamber what it is for a probe of this radius")
      ->type_name("R")
      ->needs(radii);
  add_threads_option(*command, options->threads);
  command->footer(
      "With --radii the page has atoms as balls, and the chambers between them with their windows, as pores tells "
      "them.\n\n"
      "Examples:\n  flowcert view bunny.obj --pockets auto\n  flowcert view bunny.obj --claim claim.csv -o wrong.html\n"
      "  flowcert view cage.xyz --radii bondi --depth 0.5");
  command->callback([options, &status] { status = view(*options); });
}

}  // namespace flowcert::cli
