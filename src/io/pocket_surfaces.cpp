#include "io/pocket_surfaces.h"

#include <unordered_map>

#include "geometry/floating_point.h"
#include "io/cell_faces.h"
#include "io/layer.h"
#include "io/number_text.h"
#include "io/ply_header.h"

namespace flowcert {

using namespace io;

namespace {

constexpr std::uint32_t kNoPocket = 0xffffffffu;

// Takes over triangles, and numbers their corners anew.
class SurfaceBuilder {
 public:
  void add(const CellFaces& all, const CellFace& face, bool is_turned) {
    for (auto [a, b, c] : face.triangles) {
      if (is_turned) std::swap(b, c);
      surface_.triangles.push_back({number_of(all, a), number_of(all, b), number_of(all, c)});
    }
  }
  [[nodiscard]] PocketSurface take() { return std::move(surface_); }

 private:
  std::uint32_t number_of(const CellFaces& all, std::uint32_t corner) {
    const auto [found, is_new] = numbers_.try_emplace(corner, static_cast<std::uint32_t>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(finite(all.corners[corner]));
    return found->second;
  }

  PocketSurface surface_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
};

}  // namespace

std::vector<PocketSurface> pocket_surfaces(const FlowComplex& complex, const Pockets& pockets) {
  const geometry::IeeeDoubles ieee;
  std::vector<std::uint32_t> pocket_of(complex.stationary().size(), kNoPocket);
  std::vector<bool> is_wanted(complex.stationary().size(), false);
  for (std::uint32_t number = 0; number < pockets.size(); ++number) {
    for (const std::uint32_t record : pockets[number].cell) {
      pocket_of[record] = number;
      is_wanted[record] = true;
    }
  }
  const CellFaces faces = cell_faces(complex, is_wanted);
  std::vector<SurfaceBuilder> builders(pockets.size());
  for (const CellFace& face : faces.faces) {
    std::array<std::uint32_t, 2> sides{};
    for (const std::size_t side : {0U, 1U}) {
      sides[side] = face.limits[side] == CellFace::kInfinity ? kNoPocket : pocket_of[face.limits[side]];
    }
    // Faces between parts of one cell are inside of it.
    if (sides[0] == sides[1]) continue;
    if (sides[0] != kNoPocket) builders[sides[0]].add(faces, face, false);
    if (sides[1] != kNoPocket) builders[sides[1]].add(faces, face, true);
  }
  std::vector<PocketSurface> surfaces;
  surfaces.reserve(builders.size());
  for (SurfaceBuilder& builder : builders) surfaces.push_back(builder.take());
  return surfaces;
}

void write_ply(std::ostream& out, const PocketSurface& surface, const std::string& comment) {
  const geometry::IeeeDoubles ieee;
  io::write_ply(out, surface.vertices, surface.triangles, comment);
}

}  // namespace flowcert
