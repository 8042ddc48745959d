// See surface_mesh.h. Fronts belong to one stable set alone (FC-STAB-01), so that their exact positions,
// which can be long, are kept no longer than their set; samples and the midpoints where sets end are kept.
#include "io/surface_mesh.h"

#include <gmp.h>

#include <limits>
#include <unordered_map>

#include "geometry/rational_point.h"
#include "io/rounded_position.h"

namespace flowcert::io {

namespace {

// Rationals are canonical: equal ones have equal words.
struct PositionHash {
  std::size_t operator()(const RationalPoint& position) const {
    std::size_t hash = 0;
    for (const Rational& coordinate : position) {
      const auto& words = coordinate.backend().data();
      for (const std::size_t word : {mpz_get_ui(mpq_numref(words)), mpz_get_ui(mpq_denref(words))}) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 32;
      }
    }
    return hash;
  }
};

using VertexAt = std::unordered_map<RationalPoint, std::uint32_t, PositionHash>;

class MeshBuilder {
 public:
  explicit MeshBuilder(const PointSet& points) : points_(points) {}

  void add(std::size_t number, const StableSet& set) {
    fronts_.clear();
    for (const BackwardSegment& segment : set.segments) {
      const bool ends = segment.back_kind == BackKind::kCritical || segment.back_kind == BackKind::kRegular;
      const RationalPoint apex = sample_position(segment.samples[0]);
      const std::uint32_t front = vertex(fronts_, segment.front, apex);
      const std::uint32_t back = vertex(ends ? ends_ : fronts_, segment.back, apex);
      mesh_.triangles.push_back({sample(segment.samples[0]), front, back});
      mesh_.triangles.push_back({sample(segment.samples[1]), back, front});
      mesh_.set_of_triangle.insert(mesh_.set_of_triangle.end(), 2, number);
    }
  }

  [[nodiscard]] SurfaceMesh take() { return std::move(mesh_); }

 private:
  [[nodiscard]] RationalPoint sample_position(PointId id) const {
    return exact_position(points_[points_.position_of_row(id)]);
  }

  std::uint32_t sample(PointId id) {
    const RationalPoint position = sample_position(id);
    return vertex(ends_, position, position);
  }

  // apex: a sample nearest to it.
  std::uint32_t vertex(VertexAt& known, const RationalPoint& position, const RationalPoint& apex) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [place, is_new] = known.try_emplace(position, next);
    if (!is_new) return place->second;
    // The file formats' indices have a sign.
    if (next >= static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max())) {
      throw InvalidInput("a surface of more than 2^31 - 1 vertices cannot be written");
    }
    mesh_.vertices.push_back(rounded(position));
    mesh_.squared_distances.push_back(nearest_double(squared_distance(position, apex)));
    return next;
  }

  const PointSet& points_;
  VertexAt fronts_, ends_;
  SurfaceMesh mesh_;
};

}  // namespace

SurfaceMesh surface_mesh(const PointSet& points, StableManifolds& s2, std::span<const std::size_t> sets,
                         const std::function<void(std::size_t, std::size_t)>& progress) {
  MeshBuilder builder(points);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    builder.add(sets[k], s2.set(sets[k]));
    if (progress) progress(k + 1, sets.size());
  }
  return builder.take();
}

}  // namespace flowcert::io
