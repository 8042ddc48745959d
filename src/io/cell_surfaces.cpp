#include "io/cell_surfaces.h"

#include <algorithm>
#include <unordered_map>

#include "geometry/floating_point.h"
#include "io/cell_faces.h"
#include "io/layer.h"
#include "io/number_text.h"
#include "io/ply_header.h"

namespace flowcert {

using namespace io;

namespace {

// Takes over triangles, and numbers their corners anew.
class SurfaceBuilder {
 public:
  void add(const CellFaces& all, const CellFace& face, bool is_turned) {
    for (auto [a, b, c] : face.triangles) {
      if (is_turned) std::swap(b, c);
      surface_.triangles.push_back({number_of(all, a), number_of(all, b), number_of(all, c)});
    }
  }
  [[nodiscard]] CellSurface take() { return std::move(surface_); }

 private:
  std::uint32_t number_of(const CellFaces& all, std::uint32_t corner) {
    const auto [found, is_new] = numbers_.try_emplace(corner, static_cast<std::uint32_t>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(finite(all.corners[corner]));
    return found->second;
  }

  CellSurface surface_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
};

}  // namespace

std::vector<CellSurface> cell_surfaces(const FlowComplex& complex,
                                       const std::vector<std::span<const std::uint32_t>>& cells) {
  const geometry::IeeeDoubles ieee;
  std::vector<std::vector<std::uint32_t>> cells_with(complex.stationary().size());  // ascending, by stationary point
  std::vector<bool> is_wanted(complex.stationary().size(), false);
  for (std::uint32_t number = 0; number < cells.size(); ++number) {
    for (const std::uint32_t record : cells[number]) {
      cells_with[record].push_back(number);
      is_wanted[record] = true;
    }
  }
  const CellFaces faces = cell_faces(complex, is_wanted);
  std::vector<SurfaceBuilder> builders(cells.size());
  for (const CellFace& face : faces.faces) {
    std::array<std::span<const std::uint32_t>, 2> sides;
    for (const std::size_t side : {0U, 1U}) {
      if (face.limits[side] != CellFace::kInfinity) sides[side] = cells_with[face.limits[side]];
    }
    // Faces between parts of one cell are inside of it.
    for (const std::size_t side : {0U, 1U}) {
      for (const std::uint32_t number : sides[side]) {
        if (!std::ranges::binary_search(sides[1 - side], number)) builders[number].add(faces, face, side == 1);
      }
    }
  }
  std::vector<CellSurface> surfaces;
  surfaces.reserve(builders.size());
  for (SurfaceBuilder& builder : builders) surfaces.push_back(builder.take());
  return surfaces;
}

void write_ply(std::ostream& out, const CellSurface& surface, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  io::write_ply(out, surface.vertices, surface.triangles, comment);
}

}  // namespace flowcert
