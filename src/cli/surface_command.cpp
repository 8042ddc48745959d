// `flowcert surface`: a subset of the stable manifolds S2, chosen by persistence or radius, as a surface in a PLY or
// OFF file (src/cli/manual/surfaces.md). The paper reconstructs a shape from its samples in this way.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>

#include "cli/automatic_threshold.h"
#include "cli/command.h"
#include "cli/histogram.h"
#include "cli/progress.h"
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

struct SurfaceOptions : InputOptions {
  std::string output;
  std::vector<std::string> selections;
  bool json = false;
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
  io::write_whole_file(path, [&](std::ostream& out) { write(out, mesh, made_by); });
}

struct Surface {
  const SurfaceOptions& options;
  const Input& input;
  const FlowComplex& complex;
  const morse::SaddleRadii& radii;
  const SelectedSets& selected;
  const SurfaceMesh& mesh;

  [[nodiscard]] std::size_t with_interval() const {
    const auto has_interval = [this](std::size_t set) { return complex.stable().has_interval(set); };
    return static_cast<std::size_t>(std::ranges::count_if(selected.sets, has_interval));
  }
};

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

// The bin that has the threshold is marked, or the nearest one if none has it.
void print_radius_bars(const morse::SaddleRadii& radii, const std::optional<Rational>& squared_threshold) {
  std::vector<BarLine> lines;
  for (const HistogramBin& bin : radii.histogram()) {
    lines.push_back({rough_text(bin.from), rough_text(bin.to), bin.count, ""});
  }
  if (squared_threshold && !lines.empty()) {
    const Rational square = *squared_threshold / radii.squared_spacing().value();
    const auto is_below = [&](const HistogramBin& bin) { return bin.to * bin.to <= square; };
    const auto below = static_cast<std::size_t>(std::ranges::count_if(radii.histogram(), is_below));
    lines[std::min(below, lines.size() - 1)].mark = "< " + rough_root_text(square);
  }
  print_bars("radii of the index-2 saddles, in multiples of the spacing", lines, true, true);
}

void print_table(const Surface& surface) {
  const SurfaceThresholds& thresholds = surface.selected.thresholds;
  print_input(surface.input);
  print_row("points", with_commas(surface.input.points.row_count()));
  print_row("surfaces S2", with_commas(surface.complex.stationary().critical_counts()[2]), "of all index-2 saddles");
  print_row("selected", with_commas(surface.selected.sets.size()));
  print_row("with parts of dimension 3", with_commas(surface.with_interval()), "of these; no surface has them");
  print_row("triangles", with_commas(surface.mesh.triangles.size()));
  print_row("vertices", with_commas(surface.mesh.vertices.size()));
  print_edges(surface.mesh.edges);
  print_thresholds(thresholds, surface.radii);
  print_radius_bars(surface.radii, thresholds.squared_radius_below);
}

// An exact number with its nearest double; null for none.
void add_exact(Json& object, const std::string& key, const std::optional<Rational>& value) {
  object[key] = value ? Json(to_text(*value)) : Json(nullptr);
  object[key + "_double"] = value ? io::double_field(nearest_or_infinity(*value)) : Json(nullptr);
}

Json edges_field(const TriangleEdges& edges) {
  return {{"boundary", edges.boundary},
          {"manifold", edges.manifold},
          {"not_manifold", edges.non_manifold},
          {"components", edges.components},
          {"without_orientation", edges.without_orientation}};
}

void print_json(const Surface& surface) {
  const SurfaceThresholds& thresholds = surface.selected.thresholds;
  Json json = header_fields("flowcert-surface-summary", 1, surface.input.points);
  add_counts(json, surface.input.points, surface.complex.stationary());
  json["select"] = surface.options.selections;
  json["sets"] = surface.complex.stationary().critical_counts()[2];
  json["selected"] = surface.selected.sets.size();
  json["with_interval"] = surface.with_interval();
  json["triangles"] = surface.mesh.triangles.size();
  json["vertices"] = surface.mesh.vertices.size();
  json["edges"] = edges_field(surface.mesh.edges);
  add_exact(json, "squared_spacing", surface.radii.squared_spacing());
  add_exact(json, "squared_radius_below", thresholds.squared_radius_below);
  add_exact(json, "squared_persistence_above", thresholds.squared_persistence_above);
  if (thresholds.automatic_radius) json["auto_radius"] = automatic_field(*thresholds.automatic_radius);
  if (thresholds.automatic_persistence) json["auto_persistence"] = automatic_field(*thresholds.automatic_persistence);
  Json& radii = json["radii"] = Json::array();
  for (const HistogramBin& bin : surface.radii.histogram()) {
    radii.push_back(
        {{"from", nearest_or_infinity(bin.from)}, {"to", nearest_or_infinity(bin.to)}, {"count", bin.count}});
  }
  fmt::print("{}\n", json.dump());
}

void write_surface(const SurfaceOptions& options) {
  const SurfaceSelection selection(options.selections);
  (void)writer_for(options.output);
  const bool is_streamed = options.output == kStandardStream;
  if (is_streamed && options.json) throw InvalidInput("-o - and --json would both write to standard output");
  const Input input = read_input(options);
  const FlowComplex complex(input.points, complex_options(input), part_progress());
  const auto radii = with_progress("computing", [&] { return morse::SaddleRadii(complex); });
  const SelectedSets selected = with_progress("computing", [&] { return selection.select(complex, radii); });
  const SurfaceMesh mesh = naming(input.name, [&] {
    ProgressLine progress("surface");
    return surface_mesh(complex, selected.sets, std::ref(progress));
  });
  write_mesh(options.output, mesh, made_by_text("flowcert-surface", 1, input.points));
  const Surface surface{options, input, complex, radii, selected, mesh};
  if (options.json) {
    print_json(surface);
  } else if (!is_streamed) {
    print_table(surface);
  }
}

}  // namespace

void add_surface_command(CLI::App& app) {
  auto options = std::make_shared<SurfaceOptions>();
  CLI::App* command = app.add_subcommand("surface", "Stable manifolds of index-2 points as a surface, all or selected");
  add_input_options(*command, *options);
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
