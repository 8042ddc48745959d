#include "cli/export_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

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

void make_directory(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", directory, error.message()));
}

}  // namespace

std::optional<Rational> clip_factor(const std::string& text) {
  if (text == "none") return std::nullopt;
  Rational factor = 0;
  try {
    factor = io::parse_rational(text);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("--clip: {}", error.what()));
  }
  if (factor < 1) throw InvalidInput("--clip: neither a number from 1 nor none: " + io::in_quotes(text));
  return factor;
}

ExportFiles::ExportFiles(ExportChoice choice, std::string input_name)
    : choice_(std::move(choice)), input_name_(std::move(input_name)) {
  std::error_code ignored;
  if (fs::exists(choice_.directory, ignored) && !fs::is_directory(choice_.directory, ignored)) {
    throw OutputError(choice_.directory + ": cannot be written: Not a directory");
  }
}

void ExportFiles::write_after(const FlowComplex& complex, FlowComplexPart part) {
  if (part == FlowComplexPart::kStationary && choice_.critical) write_critical_points(complex);
  if (part == FlowComplexPart::kStable && choice_.surfaces) write_surfaces(complex);
  if (part == FlowComplexPart::kUnstable && choice_.lines) write_lines(complex);
  if (part == FlowComplexPart::kLimits && choice_.fans) write_fans(complex);
  if (part == FlowComplexPart::kVolumes && choice_.cells) write_cells(complex);
  if (part == FlowComplexPart::kVolumes && choice_.infinity) write_infinity(complex);
  if (part == FlowComplexPart::kVolumes && choice_.sheets) write_sheets(complex);
}

void ExportFiles::write_critical_points(const FlowComplex& complex) {
  constexpr const char* kName = "critical_points.vtp";
  attempt(kName, [&] {
    ProgressLine progress("exporting critical points");
    const PolyData data = critical_point_data(complex, std::ref(progress));
    write_file(kName, complex, [&](std::ostream& out, const std::string& made_by) { write_vtp(out, data, made_by); });
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

void ExportFiles::write_lines(const FlowComplex& complex) {
  constexpr const char* kName = "unstable_lines.vtp";
  attempt(kName, [&] {
    ProgressLine progress("exporting unstable manifolds");
    const PolyData data = unstable_line_data(complex, box(complex), std::ref(progress));
    write_file(kName, complex, [&](std::ostream& out, const std::string& made_by) { write_vtp(out, data, made_by); });
  });
}

void ExportFiles::write_fans(const FlowComplex& complex) {
  constexpr const char* kName = "unstable_fans.vtp";
  attempt(kName, [&] {
    const ProgressLine progress("exporting unstable manifolds of index-1 points");
    const PolyData data = unstable_fan_data(complex);
    write_file(kName, complex, [&](std::ostream& out, const std::string& made_by) { write_vtp(out, data, made_by); });
  });
}

void ExportFiles::write_cells(const FlowComplex& complex) {
  constexpr const char* kName = "stable_cells.vtu";
  attempt(kName, [&] {
    const ProgressLine progress("exporting stable sets of dimension 3");
    const UnstructuredGrid data = stable_cell_data(complex);
    write_file(kName, complex, [&](std::ostream& out, const std::string& made_by) { write_vtu(out, data, made_by); });
  });
}

void ExportFiles::write_infinity(const FlowComplex& complex) {
  constexpr const char* kName = "infinity_cells.vtu";
  attempt(kName, [&] {
    const ProgressLine progress("exporting the stable set of infinity");
    const UnstructuredGrid data = infinity_cell_data(complex, box(complex));
    write_file(kName, complex, [&](std::ostream& out, const std::string& made_by) { write_vtu(out, data, made_by); });
  });
}

void ExportFiles::write_sheets(const FlowComplex& complex) {
  constexpr const char *kDataName = "unstable_surfaces.vtp", *kMeshName = "unstable_surfaces.ply";
  std::optional<UnstableSurfaceExport> surfaces;
  attempt(kDataName, [&] {
    make_directory(choice_.directory);
    ProgressLine progress("exporting unstable manifolds of index-1 points");
    surfaces.emplace(complex, box(complex), choice_.directory, std::ref(progress));
    write_file(kDataName, complex,
               [&](std::ostream& out, const std::string& made_by) { surfaces->write_vtp(out, made_by); });
  });
  attempt(kMeshName, [&] {
    write_file(kMeshName, complex,
               [&](std::ostream& out, const std::string& made_by) { surfaces->write_ply(out, made_by); });
  });
}

std::optional<ClipBox> ExportFiles::box(const FlowComplex& complex) const {
  if (!choice_.clip || complex.points().empty()) return std::nullopt;
  return ClipBox(complex.points(), *choice_.clip);
}

void ExportFiles::write_file(const char* name, const FlowComplex& complex, const Write& write) {
  make_directory(choice_.directory);
  const ProgressLine progress(std::string("writing ") + name);
  OutputFile file((fs::path(choice_.directory) / name).string());
  write(file.stream(), made_by_text("flowcert-export", 1, complex.points()));
  file.commit();
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
