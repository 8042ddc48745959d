// How surfaces are built and written.
//
// A front belongs to only one stable set (FC-STAB-01), so it is forgotten after that set. Samples and the stationary
// points where sets end are kept. The writers are our own, because CGAL's are templates over its own meshes, which this
// layer does not have.
#include "flowcert/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "geometry/floating_point.h"
#include "io/number_text.h"
#include "io/ply_header.h"
#include "io/triangle_orientation.h"

namespace flowcert {

using namespace io;

namespace {

// Samples, and points where the flow ends, by their contact sets. A front is a vertex of its set alone.
class MeshBuilder {
 public:
  explicit MeshBuilder(const PointSet& points) : points_(points) {}

  void add(std::size_t number, const RoundedSegments& set) {
    vertex_of_.assign(set.positions.size(), kNone);
    // The file formats have signed numbers.
    if (mesh_.triangles.size() + 2 * set.segments.size() > kMostNumbers) {
      throw InvalidInput("a surface of more than 2^31 - 1 triangles cannot be written");
    }
    for (const auto& [samples, front, back] : set.segments) {
      const std::uint32_t start = vertex(set, front), end = vertex(set, back);
      mesh_.triangles.push_back({sample(samples[0]), start, end});
      mesh_.triangles.push_back({sample(samples[1]), end, start});
      mesh_.set_of_triangle.insert(mesh_.set_of_triangle.end(), 2, number);
    }
  }

  [[nodiscard]] SurfaceMesh take() {
    // Its memory is given back before the orientation takes some.
    ends_ = {};
    mesh_.edges = orient(mesh_.triangles, mesh_.vertices.size());
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::size_t kMostNumbers = std::numeric_limits<std::int32_t>::max();

  std::uint32_t sample(PointId id) { return end_vertex({id}, {points_.at_row(id), 0}); }

  std::uint32_t vertex(const RoundedSegments& set, std::uint32_t place) {
    const auto& [sphere, end] = set.positions[place];
    if (!end.empty()) return end_vertex(end, sphere);
    if (vertex_of_[place] == kNone) vertex_of_[place] = new_vertex(sphere);
    return vertex_of_[place];
  }

  std::uint32_t end_vertex(const std::vector<PointId>& contact, const RoundedSphere& sphere) {
    const auto [at, is_new] = ends_.try_emplace(contact, kNone);
    if (is_new) at->second = new_vertex(sphere, contact.size() == 1 ? std::optional(contact.front()) : std::nullopt);
    return at->second;
  }

  std::uint32_t new_vertex(const RoundedSphere& sphere, std::optional<PointId> sample = std::nullopt) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    if (next >= kMostNumbers) throw InvalidInput("a surface of more than 2^31 - 1 vertices cannot be written");
    mesh_.vertices.push_back(finite(sphere.center));
    mesh_.samples.push_back(sample);
    const bool is_finite = std::isfinite(sphere.squared_radius);
    mesh_.squared_distances.push_back(is_finite ? std::optional(sphere.squared_radius) : std::nullopt);
    return next;
  }

  const PointSet& points_;
  std::unordered_map<std::vector<PointId>, std::uint32_t, boost::hash<std::vector<PointId>>> ends_;
  std::vector<std::uint32_t> vertex_of_;  // by place in the set
  SurfaceMesh mesh_;
};

template <class SegmentsOf>
SurfaceMesh mesh_of(const FlowComplex& complex, std::span<const std::size_t> sets, const Progress& progress,
                    const SegmentsOf& segments_of) {
  const geometry::IeeeDoubles ieee;
  MeshBuilder builder(complex.points());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    builder.add(sets[k], segments_of(sets[k]));
    if (progress) progress(k + 1, sets.size());
  }
  return builder.take();
}

}  // namespace

SurfaceMesh surface_mesh(const FlowComplex& complex, std::span<const std::size_t> sets, const Progress& progress) {
  return mesh_of(complex, sets, progress, [&](std::size_t set) { return complex.stable().rounded_segments(set); });
}

SurfaceMesh loop_surface_mesh(const FlowComplex& complex, std::span<const std::uint32_t> surface) {
  const auto& counts = complex.stationary().critical_counts();
  std::vector<std::size_t> sets;
  for (const std::uint32_t saddle : surface) sets.push_back(saddle - counts[0] - counts[1]);
  return mesh_of(complex, sets, {}, [&](std::size_t set) { return complex.stable().segments_to_boundary(set); });
}

void write_ply(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  io::write_ply(out, mesh.vertices, mesh.triangles, comment);
}

void write_off(std::ostream& out, const SurfaceMesh& mesh, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  out << fmt::format("OFF\n# {}\n{} {} 0\n", comment, mesh.vertices.size(), mesh.triangles.size());
  for (const Point& point : mesh.vertices) out << fmt::format("{} {} {}\n", point.x, point.y, point.z);
  for (const auto& [a, b, c] : mesh.triangles) out << fmt::format("3 {} {} {}\n", a, b, c);
}

}  // namespace flowcert
