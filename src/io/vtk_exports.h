// The flow complex as data sets for viewers: stationary points, the orbits of U2, and the surfaces S2, with
// arrays named as in TTK's Morse-Smale complex where they mean the same (spec/formats.md, "Exports").
//
// Guarantees: coordinates and values are the doubles nearest to the exact ones; a value beyond the doubles
// throws InvalidInput, but for the infinite ones of orbits that go to infinity.
#pragma once

#include <functional>

#include "flowcert/unstable_manifolds.h"
#include "io/surface_mesh.h"
#include "io/vtp_writer.h"

namespace flowcert::io {

using ExportProgress = std::function<void(std::size_t done, std::size_t total)>;

class VtkExports {
 public:
  // The others must outlive it. O(stationary points).
  VtkExports(const PointSet& points, const StationaryPoints& stationary, const ExportProgress& progress);

  [[nodiscard]] PolyData critical_points() const;
  // Exact coordinates of long orbits take time.
  [[nodiscard]] PolyData unstable_lines(UnstableManifolds& u2, const ExportProgress& progress) const;
  // mesh: of all critical points of index 2.
  [[nodiscard]] PolyData stable_surfaces(const StableManifolds& s2, const SurfaceMesh& mesh) const;

 private:
  const PointSet& points_;
  const StationaryPoints& stationary_;
  std::vector<Point> centers_;
  std::vector<Rational> squared_values_;  // by record
};

}  // namespace flowcert::io
