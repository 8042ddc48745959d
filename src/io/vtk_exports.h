// The flow complex as data sets for viewers: stationary points, the orbits of U2, and the surfaces S2. An array has
// its name in TTK's Morse-Smale complex if it means the same there (src/cli/manual/exports.md). Files are VTK's XML
// PolyData and UnstructuredGrid, which ParaView and VTK open.
//
// Guarantees: coordinates and values are the doubles nearest to the exact ones, and files hold them to the bit. The
// points where orbits leave a clip box are rounded as src/cli/manual/exports.md says. Values of orbits that go to
// infinity may be infinite. Any other value beyond the doubles throws InvalidInput.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "flowcert/progress.h"
#include "flowcert/surface.h"
#include "io/clip_box.h"

namespace flowcert {

// One number, or several, for each point or cell.
struct VtpArray {
  std::string name;
  std::variant<std::vector<std::int8_t>, std::vector<std::int64_t>, std::vector<double>> values;
  int components = 1;
};

struct VtpCells {
  std::vector<std::int64_t> connectivity;  // points of all cells, one cell after the other
  std::vector<std::int64_t> offsets;       // where each cell ends in connectivity
};

struct PolyData {
  std::vector<Point> points;
  VtpCells vertices, lines, polygons;
  std::vector<VtpArray> point_data;
  std::vector<VtpArray> cell_data;  // vertices first, then lines, then polygons
};

// Cells of dimension 3.
struct UnstructuredGrid {
  enum class Shape : std::uint8_t { kTetrahedron = 10, kPyramid = 14 };  // VTK's numbers
  std::vector<Point> points;
  VtpCells cells;
  std::vector<Shape> shapes;
  std::vector<VtpArray> cell_data;
};

// comment: of one line, without "--". The data is not copied.
void write_vtp(std::ostream& out, const PolyData& data, const std::string& comment);
void write_vtu(std::ostream& out, const UnstructuredGrid& data, const std::string& comment);

[[nodiscard]] PolyData critical_point_data(const FlowComplex& complex, const Progress& progress = {});
// With a box, orbits to infinity end where they leave it, and the point data IsClipped marks these ends. Without one
// their last segment, which has no end, is left out. With records, only those of these stationary points are there, by
// place in the list, ascending.
[[nodiscard]] PolyData unstable_line_data(const FlowComplex& complex, const std::optional<ClipBox>& box,
                                          const Progress& progress = {},
                                          const std::vector<std::size_t>* records = nullptr);
// mesh: of any critical points of index 2.
[[nodiscard]] PolyData stable_surface_data(const FlowComplex& complex, SurfaceMesh mesh);

}  // namespace flowcert
