#include "io/vtk_document.h"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

namespace flowcert::io {

namespace {

const char* type_name(std::int8_t) { return "Int8"; }
const char* type_name(std::int64_t) { return "Int64"; }
const char* type_name(double) { return "Float64"; }
const char* type_name(UnstructuredGrid::Shape) { return "UInt8"; }

}  // namespace

VtkDocument::VtkDocument(std::ostream& out, std::string type, const std::string& comment)
    : out_(out), type_(std::move(type)) {
  text(R"(<?xml version="1.0"?>)");
  text(fmt::format(R"(<VTKFile type="{}" version="1.0" byte_order="LittleEndian" header_type="UInt64">)", type_));
  text(fmt::format("<!-- {} -->", comment));
  begin(type_.c_str());
}

void VtkDocument::begin(const char* name) { text(fmt::format("<{}>", name)); }
void VtkDocument::end(const char* name) { text(fmt::format("</{}>", name)); }

void VtkDocument::piece(const PolyDataCounts& counts) {
  text(fmt::format(
      R"(<Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="{}" NumberOfStrips="0" NumberOfPolys="{}">)",
      counts.points, counts.vertices, counts.lines, counts.polygons));
}

void VtkDocument::piece(std::size_t points, std::size_t cells) {
  text(fmt::format(R"(<Piece NumberOfPoints="{}" NumberOfCells="{}">)", points, cells));
}

void VtkDocument::array(const std::string& name, const char* type, int components, std::uint64_t bytes, Write write) {
  text(fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)", type,
                   name, components, offset_));
  offset_ += sizeof(std::uint64_t) + bytes;
  appended_.push_back({bytes, std::move(write)});
}

template <class Number>
void VtkDocument::array(const std::string& name, const std::vector<Number>& values, int components) {
  array(name, type_name(Number{}), components, values.size() * sizeof(Number), [&values](std::ostream& out) {
    ByteWriter bytes(out);
    for (const Number value : values) {
      if constexpr (std::is_enum_v<Number>) {
        bytes.append(static_cast<std::uint8_t>(value));
      } else {
        bytes.append(value);
      }
    }
  });
}

void VtkDocument::section(const char* name, const std::vector<VtpArray>& arrays) {
  begin(name);
  for (const VtpArray& each : arrays) {
    std::visit([&](const auto& values) { array(each.name, values, each.components); }, each.values);
  }
  end(name);
}

void VtkDocument::points(const std::vector<Point>& points) {
  begin("Points");
  array("Points", type_name(double{}), 3, 3 * points.size() * sizeof(double), [&points](std::ostream& out) {
    ByteWriter bytes(out);
    for (const Point& point : points) {
      for (const double coordinate : point.coordinates()) bytes.append(coordinate);
    }
  });
  end("Points");
}

void VtkDocument::cells(const char* name, const VtpCells& cells, const std::vector<UnstructuredGrid::Shape>* shapes) {
  begin(name);
  array("connectivity", cells.connectivity);
  array("offsets", cells.offsets);
  if (shapes != nullptr) array("types", *shapes);
  end(name);
}

void VtkDocument::end() {
  end("Piece");
  end(type_.c_str());
  text(R"(<AppendedData encoding="raw">)");
  out_ << '_';
  for (const Appended& each : appended_) {
    ByteWriter(out_).append(each.bytes);
    each.write(out_);
  }
  text("\n</AppendedData>");
  text("</VTKFile>");
}

}  // namespace flowcert::io
