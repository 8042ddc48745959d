// Cells are glued along a walk in depth, and the file says of each only which sample is new in it: neighbours in the
// triangulation mostly have samples that are neighbours in the input, too, whose numbers are short.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include "flowcert/reproducibility.h"
#include "flowcert/write_stationary_points.h"
#include "io/byte_spool.h"
#include "voronoi/voronoi_diagram.h"

namespace flowcert {

namespace {

using voronoi::CellIndex;
using voronoi::VertexIndex;

// The bytes of FC-FILE-49. The samples of a cell are in the order that a reader has, which is not the diagram's.
class GluingOrder {
 public:
  GluingOrder(std::ostream& out, const voronoi::VoronoiDiagram& diagram)
      : bytes_(out),
        diagram_(diagram),
        delaunay_(diagram.delaunay()),
        corners_(static_cast<std::uint32_t>(diagram.dimension()) + 1),
        is_entered_(delaunay_.finite_count, false) {}

  void write() {
    const auto& first = delaunay_.vertices(0);
    for (std::uint32_t i = 0; i < corners_; ++i) put(diagram_.name(first[i]));
    enter(0, first, corners_);
    while (!open_.empty()) {
      OpenFacet facet = open_.back();
      open_.pop_back();
      pass(facet);
    }
  }

 private:
  using Samples = std::array<VertexIndex, 4>;
  struct OpenFacet {
    CellIndex cell;
    Samples samples;     // of the cell
    std::uint32_t apex;  // the place among them that the facet is without
  };

  [[nodiscard]] voronoi::FacetRef facet_of(CellIndex cell, VertexIndex apex) const {
    return {cell, voronoi::place_among(delaunay_.vertices(cell), apex)};
  }

  // entrance: the facet through which it was entered; none of them for the first cell.
  void enter(CellIndex cell, const Samples& samples, std::uint32_t entrance) {
    is_entered_[cell] = true;
    for (std::uint32_t i = 0; i < corners_; ++i) {
      const CellIndex other = delaunay_.neighbors(cell)[facet_of(cell, samples[i]).index];
      const bool is_paired = delaunay_.is_finite(other) && is_entered_[other];
      if (i != entrance && !is_paired) open_.push_back({cell, samples, i});
    }
  }

  void pass(const OpenFacet& facet) {
    const voronoi::FacetRef behind = delaunay_.mirror(facet_of(facet.cell, facet.samples[facet.apex]));
    if (!delaunay_.is_finite(behind.cell)) return put(0);
    if (is_entered_[behind.cell]) return;
    Samples samples = facet.samples;
    const VertexIndex apex = delaunay_.vertices(behind.cell)[behind.index];
    const auto step = std::int64_t{diagram_.name(apex)} - std::int64_t{diagram_.name(samples[facet.apex])};
    put(static_cast<std::uint64_t>(step < 0 ? -2 * step : 2 * step + 1));
    samples[facet.apex] = apex;
    // The order is turned, so that both cells have volumes of one sign.
    if (corners_ == 2) {
      std::swap(samples[0], samples[1]);
      return enter(behind.cell, samples, 1 - facet.apex);
    }
    const std::uint32_t a = facet.apex == 0 ? 1 : 0, b = facet.apex <= 1 ? 2 : 1;
    std::swap(samples[a], samples[b]);
    enter(behind.cell, samples, facet.apex);
  }

  void put(std::uint64_t number) {
    for (; number >= 128; number >>= 7) bytes_.append(static_cast<std::uint8_t>(number % 128 + 128));
    bytes_.append(static_cast<std::uint8_t>(number));
  }

  io::ByteWriter bytes_;
  const voronoi::VoronoiDiagram& diagram_;
  const voronoi::CompactDelaunay& delaunay_;
  const std::uint32_t corners_;
  std::vector<bool> is_entered_;
  std::vector<OpenFacet> open_;
};

}  // namespace

void write_certificate(std::ostream& out, const FlowComplex& complex) {
  const voronoi::VoronoiDiagram& diagram = complex.diagram();
  const bool has_cells = diagram.dimension() >= 1;
  out << fmt::format("flowcert-certificate 1\npoints {}\nsha256 {}\ndimension {}\ncells {}\n\n",
                     complex.points().row_count(), coordinates_sha256(complex.points()), diagram.dimension(),
                     has_cells ? diagram.delaunay().finite_count : 0);
  if (has_cells) GluingOrder(out, diagram).write();
}

}  // namespace flowcert
