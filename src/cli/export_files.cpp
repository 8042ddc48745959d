#include "cli/export_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

#include "cli/command.h"
#include "cli/progress.h"
#include "flowcert/reproducibility.h"
#include "io/number_text.h"
#include "io/output_file.h"
#include "io/region_exports.h"
#include "io/unstable_surface_export.h"
#include "io/vtk_exports.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

void write_data(std::ostream& out, const PolyData& data, const std::string& made_by) { write_vtp(out, data, made_by); }
void write_data(std::ostream& out, const UnstructuredGrid& data, const std::string& made_by) {
  write_vtu(out, data, made_by);
}

}  // namespace

std::optional<Rational> clip_factor(const std::string& text) {
  if (text == "none") return std::nullopt;
  const Rational factor = naming("--clip", [&] { return io::parse_rational(text); });
  if (factor < 1) throw InvalidInput("--clip: neither a number from 1 nor none: " + io::in_quotes(text));
  return factor;
}

std::optional<ClipBox> clip_box(const PointSet& points, const std::optional<Rational>& factor) {
  if (!factor || points.empty()) return std::nullopt;
  return ClipBox(points, *factor);
}

void make_directory(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", directory, error.message()));
}

void write_export(const std::string& directory, const std::string& name, const FlowComplex& complex,
                  const WriteExport& write) {
  const ProgressLine progress("writing " + name);
  io::write_whole_file((fs::path(directory) / name).string(),
                       [&](std::ostream& out) { write(out, made_by_text("flowcert-export", 1, complex.points())); });
}

bool write_table(const std::string& path, const std::function<void(std::ostream& out)>& write) {
  if (path == kStandardStream) {
    write(std::cout);
    std::cout.flush();
    return true;
  }
  if (!path.empty()) {
    const ProgressLine progress("writing " + fs::path(path).filename().string());
    io::write_whole_file(path, write);
  }
  return false;
}

ExportFiles::ExportFiles(ExportChoice choice, std::string input_name)
    : choice_(std::move(choice)), input_name_(std::move(input_name)) {
  std::error_code ignored;
  if (fs::exists(choice_.directory, ignored) && !fs::is_directory(choice_.directory, ignored)) {
    throw OutputError(choice_.directory + ": cannot be written: Not a directory");
  }
}

void ExportFiles::write_after(const FlowComplex& complex, FlowComplexPart part) {
  const auto box = [&] { return clip_box(complex.points(), choice_.clip); };
  if (part == FlowComplexPart::kStationary && choice_.critical) {
    write(complex, "critical_points.vtp", "critical points",
          [&](ProgressLine& progress) { return critical_point_data(complex, std::ref(progress)); });
  }
  if (part == FlowComplexPart::kStable && choice_.surfaces) write_surfaces(complex);
  if (part == FlowComplexPart::kUnstable && choice_.lines) {
    write(complex, "unstable_lines.vtp", "unstable manifolds",
          [&](ProgressLine& progress) { return unstable_line_data(complex, box(), std::ref(progress)); });
  }
  if (part == FlowComplexPart::kLimits && choice_.fans) {
    write(complex, "unstable_fans.vtp", "unstable manifolds of index-1 points",
          [&](ProgressLine&) { return unstable_fan_data(complex); });
  }
  if (part != FlowComplexPart::kVolumes) return;
  if (choice_.cells) {
    write(complex, "stable_cells.vtu", "stable sets of dimension 3",
          [&](ProgressLine&) { return stable_cell_data(complex); });
  }
  if (choice_.infinity) {
    write(complex, "infinity_cells.vtu", "the stable set of infinity",
          [&](ProgressLine&) { return infinity_cell_data(complex, box()); });
  }
  if (choice_.sheets) write_sheets(complex);
}

template <typename Make>
void ExportFiles::write(const FlowComplex& complex, const char* name, const char* what, const Make& make) {
  attempt(name, [&] {
    ProgressLine progress(std::string("exporting ") + what);
    const auto data = make(progress);
    write_file(name, complex, [&](std::ostream& out, const std::string& made_by) { write_data(out, data, made_by); });
  });
}

void ExportFiles::write_surfaces(const FlowComplex& complex) {
  constexpr const char *kMeshName = "stable_surfaces.ply", *kDataName = "stable_surfaces.vtp";
  SurfaceMesh mesh;
  attempt(kMeshName, [&] {
    ProgressLine progress("exporting stable manifolds");
    mesh = surface_mesh(complex, selected_sets(complex, {}), std::ref(progress));
    write_file(kMeshName, complex,
               [&](std::ostream& out, const std::string& made_by) { write_ply(out, mesh, made_by); });
  });
  attempt(kDataName, [&] {
    const PolyData data = stable_surface_data(complex, std::move(mesh));
    write_file(kDataName, complex,
               [&](std::ostream& out, const std::string& made_by) { write_vtp(out, data, made_by); });
  });
}

void ExportFiles::write_sheets(const FlowComplex& complex) {
  constexpr const char *kDataName = "unstable_surfaces.vtp", *kMeshName = "unstable_surfaces.ply";
  std::optional<UnstableSurfaceExport> surfaces;
  attempt(kDataName, [&] {
    make_directory(choice_.directory);
    ProgressLine progress("exporting unstable manifolds of index-1 points");
    surfaces.emplace(complex, clip_box(complex.points(), choice_.clip), choice_.directory, std::ref(progress));
    write_file(kDataName, complex,
               [&](std::ostream& out, const std::string& made_by) { surfaces->write_vtp(out, made_by); });
  });
  attempt(kMeshName, [&] {
    write_file(kMeshName, complex,
               [&](std::ostream& out, const std::string& made_by) { surfaces->write_ply(out, made_by); });
  });
}

void ExportFiles::write_file(const char* name, const FlowComplex& complex, const WriteExport& write) {
  make_directory(choice_.directory);
  write_export(choice_.directory, name, complex, write);
  written_.emplace_back(name);
}

void ExportFiles::attempt(const char* name, const std::function<void()>& write) {
  try {
    write();
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}; {} is not written{}", input_name_, error.what(), name, what_stays()));
  } catch (const OutputError& error) {
    throw OutputError(error.what() + what_stays());
  }
}

std::string ExportFiles::what_stays() const {
  if (written_.empty()) return "";
  return fmt::format("; written before: {}", fmt::join(written_, ", "));
}

}  // namespace flowcert::cli
