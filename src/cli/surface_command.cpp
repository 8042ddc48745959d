// `flowcert surface`: a subset of the stable manifolds S2, chosen by persistence or radius, as a surface in a PLY or
// OFF file (src/cli/manual/surfaces.md). The paper reconstructs a shape from its samples in this way.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>

#include "cli/automatic_threshold.h"
#include "cli/command.h"
#include "cli/progress.h"
#include "cli/radius_bars.h"
#include "cli/rough_number.h"
#include "cli/table.h"
#include "flowcert/reproducibility.h"
#include "flowcert/sphere.h"
#include "flowcert/surface.h"
#include "io/json_fields.h"
#include "io/output_file.h"
#include "io/surface_selection.h"
#include "morse/saddle_radii.h"

namespace flowcert::cli {

namespace {

struct SurfaceOptions {
  std::string input;
  ReadingOptions reading;
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
  const ProgressLine progress("writing the surface", path == kStandardStream ? STDOUT_FILENO : -1);
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
  TriangleEdges edges;
};

Counts counts_of(const FlowComplex& complex, const std::vector<std::size_t>& sets, const SurfaceMesh& mesh) {
  Counts counts = {.sets = complex.stationary().critical_counts()[2],
                   .selected = sets.size(),
                   .triangles = mesh.triangles.size(),
                   .vertices = mesh.vertices.size(),
                   .edges = mesh.edges};
  for (const std::size_t set : sets) counts.with_interval += complex.stable().has_interval(set) ? 1 : 0;
  return counts;
}

morse::SaddleRadii radii_of(const FlowComplex& complex) {
  const ProgressLine progress("computing");
  return morse::SaddleRadii(complex);
}

SelectedSets selected_of(const FlowComplex& complex, const SurfaceSelection& selection,
                         const morse::SaddleRadii& radii) {
  const ProgressLine progress("computing");
  return selection.select(complex, radii);
}

SurfaceMesh mesh_of(const SurfaceOptions& options, const FlowComplex& complex, const std::vector<std::size_t>& sets) {
  ProgressLine progress("surface");
  try {
    return surface_mesh(complex, sets, std::ref(progress));
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", display_name(options.input), error.what()));
  }
}

void print_edges(const TriangleEdges& edges) {
  print_row("edges of two triangles", with_commas(edges.manifold));
  print_row("edges of one", with_commas(edges.boundary), "boundary");
  print_row("edges of more than two", with_commas(edges.non_manifold), "not manifold");
  print_row("components", with_commas(edges.components), "joined by edges of two");
  print_row("components without orientation", with_commas(edges.without_orientation), "no consistent one is possible");
}

void print_thresholds(const SurfaceThresholds& thresholds, const morse::SaddleRadii& radii) {
  const auto& spacing = radii.squared_spacing();
  if (!spacing) return;
  print_row("spacing", rough_root_text(*spacing), "median of nearest neighbours");
  if (thresholds.automatic_radius) print_automatic("radii", *thresholds.automatic_radius, "all are taken");
  if (thresholds.automatic_persistence) {
    print_automatic("persistence", *thresholds.automatic_persistence, "all are taken");
  }
  if (const auto& square = thresholds.squared_radius_below) {
    print_row("radii below", rough_root_text(*square), rough_root_text(*square / *spacing) + " x the spacing");
  }
  if (const auto& square = thresholds.squared_persistence_above) {
    print_row("persistence above", rough_root_text(*square), rough_root_text(*square / *spacing) + " x the spacing");
  }
}

void print_table(const SurfaceOptions& options, const Input& input, const Counts& counts,
                 const SurfaceThresholds& thresholds, const morse::SaddleRadii& radii) {
  print_wrapped(fmt::format("{} ({})", display_name(options.input), input.file.format));
  print_row("points", with_commas(input.points.row_count()));
  print_row("surfaces S2", with_commas(counts.sets), "of all index-2 saddles");
  print_row("selected", with_commas(counts.selected));
  print_row("with parts of dimension 3", with_commas(counts.with_interval), "of these; no surface has them");
  print_row("triangles", with_commas(counts.triangles));
  print_row("vertices", with_commas(counts.vertices));
  print_edges(counts.edges);
  print_thresholds(thresholds, radii);
  print_radius_bars(radii, thresholds.squared_radius_below);
}

// An exact number with its nearest double; null for none.
void add_exact(Json& object, const std::string& key, const std::optional<Rational>& value) {
  object[key] = value ? Json(to_text(*value)) : Json(nullptr);
  object[key + "_double"] = value ? io::double_field(nearest_or_infinity(*value)) : Json(nullptr);
}

Json edges_field(const TriangleEdges& edges) {
  Json field;
  field["boundary"] = edges.boundary;
  field["manifold"] = edges.manifold;
  field["not_manifold"] = edges.non_manifold;
  field["components"] = edges.components;
  field["without_orientation"] = edges.without_orientation;
  return field;
}

Json radii_field(const morse::SaddleRadii& radii) {
  Json field = Json::array();
  for (const HistogramBin& bin : radii.histogram()) {
    Json entry;
    entry["from"] = nearest_or_infinity(bin.from);
    entry["to"] = nearest_or_infinity(bin.to);
    entry["count"] = bin.count;
    field.push_back(std::move(entry));
  }
  return field;
}

void print_json(const SurfaceOptions& options, const Input& input, const FlowComplex& complex, const Counts& counts,
                const SurfaceThresholds& thresholds, const morse::SaddleRadii& radii) {
  Json json = header_fields("flowcert-surface", 2, input.points);
  add_counts(json, input.points, complex.stationary());
  json["select"] = options.selections;
  json["sets"] = counts.sets;
  json["selected"] = counts.selected;
  json["with_interval"] = counts.with_interval;
  json["triangles"] = counts.triangles;
  json["vertices"] = counts.vertices;
  json["edges"] = edges_field(counts.edges);
  add_exact(json, "squared_spacing", radii.squared_spacing());
  add_exact(json, "squared_radius_below", thresholds.squared_radius_below);
  add_exact(json, "squared_persistence_above", thresholds.squared_persistence_above);
  if (thresholds.automatic_radius) json["auto_radius"] = automatic_field(*thresholds.automatic_radius);
  if (thresholds.automatic_persistence) json["auto_persistence"] = automatic_field(*thresholds.automatic_persistence);
  json["radii"] = radii_field(radii);
  fmt::print("{}\n", json.dump());
}

void write_surface(const SurfaceOptions& options) {
  const SurfaceSelection selection(options.selections);
  (void)writer_for(options.output);
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed && options.json) throw InvalidInput("-o - and --json would both write to standard output");
  const Input input = read_input(options.input, options.reading);
  const FlowComplex complex(input.points, complex_options(input, options.threads), part_progress());
  const morse::SaddleRadii radii = radii_of(complex);
  const auto [sets, thresholds] = selected_of(complex, selection, radii);
  const SurfaceMesh mesh = mesh_of(options, complex, sets);
  write_mesh(options.output, mesh, made_by_text("flowcert-surface", 1, input.points));
  if (is_streamed) return;
  const Counts counts = counts_of(complex, sets, mesh);
  if (options.json) {
    print_json(options, input, complex, counts, thresholds, radii);
  } else {
    print_table(options, input, counts, thresholds, radii);
  }
}

}  // namespace

void add_surface_command(CLI::App& app) {
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* command = app.add_subcommand("surface", "Stable manifolds of index-2 points as a surface, all or selected");
  add_input_options(*command, options->input, options->reading);
  command
      ->add_option("--select", options->selections,
                   "Only those with index2-radius<R, persistence>X (a difference of distances), or largest-gaps=N, the "
                   "N most persistent ones; given several times, all must hold. R and X may be 3spacing (of the "
                   "median distance of neighbours), q0.9 (a quantile), auto (the valley of their histogram; all where "
                   "it has none)")
      ->allow_extra_args(false);
  command
      ->add_option("-o,--output", options->output,
                   "Write the surface to this file, .ply or .off; -: to standard output, as PLY, instead of the table")
      ->required()
      ->check(complaint_about_path);
  command->add_flag("--json", options->json, "Print one JSON object instead of the table");
  add_threads_option(*command, options->threads);
  command->footer(
      "Examples:\n  flowcert surface bunny.obj --select 'index2-radius<1.6spacing' \\\n    -o bunny.ply\n"
      "  flowcert surface bunny.obj --select largest-gaps=20 -o - >gaps.ply");
  command->callback([options] { write_surface(*options); });
}

}  // namespace flowcert::cli
