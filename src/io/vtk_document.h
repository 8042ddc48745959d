// A file of VTK's XML formats, as it is written: PolyData or UnstructuredGrid, of one piece.
//
// Guarantees: numbers are written to the bit. The XML first says where each array begins in the appended data, and the
// arrays follow as raw bytes, each after its length. The writer is our own, because VTK would be a dependency of 190 MB
// for a list of arrays. Tests read the files with VTK itself.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "io/byte_spool.h"
#include "io/vtk_exports.h"

namespace flowcert::io {

// How many of each sort a file of PolyData has.
struct PolyDataCounts {
  std::size_t points = 0, vertices = 0, lines = 0, polygons = 0;
};

class VtkDocument {
 public:
  // type: "PolyData" or "UnstructuredGrid". comment: of one line, without "--".
  VtkDocument(std::ostream& out, std::string type, const std::string& comment);

  // First what the piece has, then its parts in VTK's order, then the end, which writes the arrays. They must live
  // until then.
  void piece(const PolyDataCounts& counts);
  void piece(std::size_t points, std::size_t cells);
  void section(const char* name, const std::vector<VtpArray>& arrays);
  void points(const std::vector<Point>& points);
  // Only those of a grid have shapes.
  void cells(const char* name, const VtpCells& cells, const std::vector<UnstructuredGrid::Shape>* shapes = nullptr);
  void end();

  // For arrays that are not in memory. An array of so many bytes, which `write` writes.
  using Write = std::function<void(std::ostream& out)>;
  void begin(const char* name);
  void array(const std::string& name, const char* type, int components, std::uint64_t bytes, Write write);
  void end(const char* name);

 private:
  void text(const std::string& line) { out_ << line << '\n'; }
  template <class Number>
  void array(const std::string& name, const std::vector<Number>& values, int components = 1);

  struct Appended {
    std::uint64_t bytes;
    Write write;
  };

  std::ostream& out_;
  std::string type_;
  std::uint64_t offset_ = 0;
  std::vector<Appended> appended_;
};

}  // namespace flowcert::io
