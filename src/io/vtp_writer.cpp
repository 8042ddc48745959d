// See vtp_writer.h. Arrays are raw bytes after the XML, each behind its length; the XML says where each
// begins.
#include "io/vtp_writer.h"

#include <fmt/format.h>

#include "io/little_endian.h"

namespace flowcert::io {

namespace {

const char* type_name(std::int8_t) { return "Int8"; }
const char* type_name(std::int64_t) { return "Int64"; }
const char* type_name(double) { return "Float64"; }

class Document {
 public:
  explicit Document(std::ostream& out) : out_(out) {}

  void text(const std::string& line) { out_ << line << '\n'; }

  template <typename Number>
  void array(const std::string& name, int components, const std::vector<Number>& values) {
    text(fmt::format(
        R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)",
        type_name(Number{}), name, components, appended_.size()));
    append_little_endian(appended_, std::uint64_t{values.size() * sizeof(Number)});
    for (const Number value : values) append_little_endian(appended_, value);
  }

  void array(const VtpArray& array_of_any) {
    std::visit([&](const auto& values) { array(array_of_any.name, 1, values); }, array_of_any.values);
  }

  void section(const char* name, const std::vector<VtpArray>& arrays) {
    text(fmt::format("<{}>", name));
    for (const VtpArray& each : arrays) array(each);
    text(fmt::format("</{}>", name));
  }

  void cells(const char* name, const VtpCells& cells) {
    text(fmt::format("<{}>", name));
    array("connectivity", 1, cells.connectivity);
    array("offsets", 1, cells.offsets);
    text(fmt::format("</{}>", name));
  }

  void appended_data() {
    out_ << R"(<AppendedData encoding="raw">)"
         << "\n_" << appended_ << '\n';
    text("</AppendedData>");
  }

 private:
  std::ostream& out_;
  std::string appended_;
};

std::vector<double> coordinates_of(const std::vector<Point>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point& point : points) coordinates.insert(coordinates.end(), {point.x, point.y, point.z});
  return coordinates;
}

}  // namespace

void write_vtp(std::ostream& out, const PolyData& data, const std::string& comment) {
  Document document(out);
  document.text(R"(<?xml version="1.0"?>)");
  document.text(R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">)");
  document.text(fmt::format("<!-- {} -->", comment));
  document.text("<PolyData>");
  document.text(fmt::format(
      R"(<Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="{}" NumberOfStrips="0" NumberOfPolys="{}">)",
      data.points.size(), data.vertices.offsets.size(), data.lines.offsets.size(),
      data.polygons.offsets.size()));
  document.section("PointData", data.point_data);
  document.section("CellData", data.cell_data);
  document.text("<Points>");
  document.array("Points", 3, coordinates_of(data.points));
  document.text("</Points>");
  document.cells("Verts", data.vertices);
  document.cells("Lines", data.lines);
  document.cells("Polys", data.polygons);
  document.text("</Piece>");
  document.text("</PolyData>");
  document.appended_data();
  document.text("</VTKFile>");
}

}  // namespace flowcert::io
