// See export_files.h.
#include "cli/export_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <numeric>
#include <system_error>

#include "cli/progress_line.h"
#include "io/made_by_text.h"
#include "io/output_file.h"
#include "io/vtk_exports.h"
#include "io/write_surface.h"

namespace flowcert::cli {

namespace {

namespace fs = std::filesystem;

struct Exports {
  PolyData critical_points, unstable_lines, stable_surfaces;
  SurfaceMesh mesh;
};

// The critical points of index 2 come first among the sets.
std::vector<std::size_t> all_surfaces(const StationaryPoints& stationary) {
  std::vector<std::size_t> sets(stationary.critical_counts()[2]);
  std::iota(sets.begin(), sets.end(), std::size_t{0});
  return sets;
}

Exports exports_of(const Input& input, ComputeRun& run) {
  Exports exports;
  ProgressLine points_progress("exporting critical points");
  const VtkExports data_sets(input.points, run.stationary, std::ref(points_progress));
  exports.critical_points = data_sets.critical_points();
  ProgressLine surfaces_progress("exporting stable manifolds");
  exports.mesh =
      surface_mesh(input.points, *run.s2, all_surfaces(run.stationary), std::ref(surfaces_progress));
  exports.stable_surfaces = data_sets.stable_surfaces(*run.s2, exports.mesh);
  ProgressLine lines_progress("exporting unstable manifolds");
  exports.unstable_lines = data_sets.unstable_lines(*run.u2, std::ref(lines_progress));
  return exports;
}

template <typename Write>
void write_file(const fs::path& path, const Write& write) {
  OutputFile file(path.string());
  write(file.stream());
  file.commit();
}

void make_directory(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw OutputError(fmt::format("{}: cannot be made: {}", directory, error.message()));
}

}  // namespace

void check_export_directory(const std::string& directory) {
  std::error_code ignored;
  if (fs::exists(directory, ignored) && !fs::is_directory(directory, ignored)) {
    throw OutputError(directory + ": cannot be written: Not a directory");
  }
}

void write_export_files(const std::string& directory, const std::string& input_name, const Input& input,
                        ComputeRun& run) {
  Exports exports;
  try {
    exports = exports_of(input, run);
  } catch (const InvalidInput& error) {
    throw InvalidInput(fmt::format("{}: {}", input_name, error.what()));
  }
  make_directory(directory);
  const fs::path folder(directory);
  const std::string comment = made_by_text("flowcert-export", 1, input.sha256);
  const std::pair<const char*, const PolyData*> data_sets[] = {
      {"critical_points.vtp", &exports.critical_points},
      {"unstable_lines.vtp", &exports.unstable_lines},
      {"stable_surfaces.vtp", &exports.stable_surfaces}};
  for (const auto& [name, data] : data_sets) {
    write_file(folder / name, [&comment, poly = data](std::ostream& out) { write_vtp(out, *poly, comment); });
  }
  write_file(folder / "stable_surfaces.ply",
             [&](std::ostream& out) { write_ply(out, exports.mesh, comment); });
}

}  // namespace flowcert::cli
