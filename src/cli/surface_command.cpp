// `flowcert surface`: a subset of the stable manifolds S2, chosen by persistence or radius, as a surface in a PLY or
// OFF file (spec/formats/surfaces.md). The paper reconstructs a shape from its samples in this way.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>

#include "cli/command.h"
#include "cli/progress.h"
#include "cli/table.h"
#include "flowcert/reproducibility.h"
#include "flowcert/surface.h"
#include "io/json_fields.h"
#include "io/output_file.h"

namespace flowcert::cli {

namespace {

struct SurfaceOptions {
  std::string input;
  std::string output;
  std::vector<std::string> selections;
  bool json = false;
  unsigned threads = 1;
};

using Write = void (*)(std::ostream&, const SurfaceMesh&, const std::string&);

Write writer_for(const std::string& path) {
  if (path == kStandardStream || path.ends_with(".ply")) return write_ply;
  if (path.ends_with(".off")) return write_off;
  throw InvalidInput("-o: the file's name must end in .ply or .off: " + path);
}

void write_mesh(const std::string& path, const SurfaceMesh& mesh, const std::string& made_by) {
  const Write write = writer_for(path);
  if (path == kStandardStream) {
    write(std::cout, mesh, made_by);
    std::cout.flush();
    return;
  }
  OutputFile file(path);
  write(file.stream(), mesh, made_by);
  file.commit();
}

struct Counts {
  std::size_t sets = 0, selected = 0, triangles = 0, vertices = 0, with_interval = 0;
};

Counts counts_of(const FlowComplex& complex, const std::vector<std::size_t>& sets, const SurfaceMesh& mesh) {
  Counts counts = {.sets = complex.stationary().critical_counts()[2],
                   .selected = sets.size(),
                   .triangles = mesh.triangles.size(),
                   .vertices = mesh.vertices.size()};
  for (const std::size_t set : sets) counts.with_interval += complex.stable().has_interval(set) ? 1 : 0;
  return counts;
}

SurfaceMesh mesh_of(const SurfaceOptions& options, const FlowComplex& complex, const std::vector<std::size_t>& sets) {
  ProgressLine progress("surface");
  try {
    return surface_mesh(complex, sets, std::ref(progress));
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", display_name(options.input), error.what()));
  }
}

void print_table(const SurfaceOptions& options, const Input& input, const Counts& counts) {
  print_wrapped(fmt::format("{} ({})", display_name(options.input), input.file.format));
  print_row("points", with_commas(input.points.row_count()));
  print_row("surfaces S2", with_commas(counts.sets), "of all index-2 saddles");
  print_row("selected", with_commas(counts.selected));
  print_row("with parts of dimension 3", with_commas(counts.with_interval), "of these; no surface has them");
  print_row("triangles", with_commas(counts.triangles));
  print_row("vertices", with_commas(counts.vertices));
}

void print_json(const SurfaceOptions& options, const Input& input, const FlowComplex& complex, const Counts& counts) {
  Json json = header_fields("flowcert-surface", 1, input.points);
  add_counts(json, input.points, complex.stationary());
  json["select"] = options.selections;
  json["sets"] = counts.sets;
  json["selected"] = counts.selected;
  json["with_interval"] = counts.with_interval;
  json["triangles"] = counts.triangles;
  json["vertices"] = counts.vertices;
  fmt::print("{}\n", json.dump());
}

void write_surface(const SurfaceOptions& options) {
  const SurfaceSelection selection(options.selections);
  (void)writer_for(options.output);
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed && options.json) throw InvalidInput("-o - and --json would both write to standard output");
  const Input input = read_input(options.input);
  const FlowComplex complex(input.points, {.flow = {}, .threads = options.threads}, part_progress());
  const std::vector<std::size_t> sets = selection.sets(complex);
  const SurfaceMesh mesh = mesh_of(options, complex, sets);
  write_mesh(options.output, mesh, made_by_text("flowcert-surface", 1, input.points));
  if (is_streamed) return;
  const Counts counts = counts_of(complex, sets, mesh);
  if (options.json) {
    print_json(options, input, complex, counts);
  } else {
    print_table(options, input, counts);
  }
}

}  // namespace

void add_surface_command(CLI::App& app, int& status) {
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* command =
      app.add_subcommand("surface", "Stable manifolds of index-2 points as a surface: all of them, or those selected");
  command->add_option("INPUT", options->input, "Point file, or - for standard input")->required();
  command
      ->add_option("--select", options->selections,
                   "Only those with persistence>X (a difference of squared distances), index2-radius<R, or "
                   "largest-gaps=N, the N most persistent ones; given several times, all must hold")
      ->allow_extra_args(false);
  command
      ->add_option("-o,--output", options->output,
                   "Write the surface to this file, .ply or .off; -: to standard output, as PLY, instead of the table")
      ->required()
      ->check(complaint_about_path);
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert surface bunny.obj --select 'index2-radius<0.01' \\\n    --select 'persistence>1e-6' -o "
      "bunny.ply\n"
      "  flowcert surface bunny.obj --select largest-gaps=20 -o - >gaps.ply");
  command->callback([options, &status] {
    write_surface(*options);
    status = kRight;
  });
}

}  // namespace flowcert::cli
