// VTK's XML PolyData: points, cells and named arrays, as ParaView and VTK open them.
//
// Guarantees: everything is written, in binary, to the bit. Our own writer: VTK is a dependency of 190 MB for
// what is a list of arrays; tests read the files with VTK itself.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "flowcert/point_set.h"
#include "io/layer.h"

namespace flowcert::io {

// A number a point or a cell.
struct VtpArray {
  std::string name;
  std::variant<std::vector<std::int8_t>, std::vector<std::int64_t>, std::vector<double>> values;
};

struct VtpCells {
  std::vector<std::int64_t> connectivity;  // points of all cells, one cell after the other
  std::vector<std::int64_t> offsets;       // where each cell ends in it
};

struct PolyData {
  std::vector<Point> points;
  VtpCells vertices, lines, polygons;
  std::vector<VtpArray> point_data;
  std::vector<VtpArray> cell_data;  // vertices first, then lines, then polygons
};

// comment: of one line, without "--".
void write_vtp(std::ostream& out, const PolyData& data, const std::string& comment);

}  // namespace flowcert::io
