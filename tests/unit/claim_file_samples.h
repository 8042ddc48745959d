// Claims made in memory, for the tests of their readers: what compute writes, VTP files in every encoding,
// and a little of each other format.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <sstream>
#include <string>
#include <vector>

#include "flowcert/claim.h"
#include "fuzz/properties/exchange_file.h"
#include "tests/unit/point_file_samples.h"

namespace flowcert {

// The message that a claim is refused with.
inline std::string claim_refusal(const std::string& bytes, const std::string& name = "a") {
  try {
    return "accepted, " + std::to_string(read_claim_from(bytes, name).points.size()) + " points";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

// Rows with every kind of stationary point except 2-3, a repeated row, and orbits that end at infinity.
inline std::vector<Point> rows_of_many_kinds() {
  return {{0, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 1, 1}, {1, 0, 1}, {0, 0, 1}, {0.1, 5, 0.2}, {3, 4, -1}};
}

inline std::string csv_file() {
  return "# made by a test\nindex,x,y,z,squared_distance,contact ids\n0,0,0,0,0,3\n"
         "1,0.5,-1e-3,0x1p-2,.25,0,1\n2,1/3,2,3\n3,1,2,3,,0 1,2,4,,\n";
}

inline std::string giesen_kuehne_file() {
  return "inf 3\n7 | 0 \n0 4 5 | 0.707106781186547573 | 0 2 4 5 | inf \n0 2 4 5 | 0.866025403784438597 \n"
         "4 5 | 0.5 | 0 4 5 | 2 4 5 |\n";
}

struct VtpChoices {
  std::string encoding = "ascii";  // or "base64", "appended base64", "appended raw"
  bool compressed = false;
  bool big_endian = false;
  bool long_header = false;  // UInt64
  bool doubles = true;       // positions are doubles, else floats
  std::string types = "Int32";
};

inline std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = bits << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j) text += k + j > bytes.size() ? '=' : digits[bits >> (18 - 6 * j) & 63];
  }
  return text;
}

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string output(size, '\0');
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(output.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                     static_cast<uLong>(bytes.size())),
            Z_OK);
  output.resize(size);
  return output;
}

// Header and data, as VTK writes them. Compressed blocks have 16 bytes here, and base64 pads the header alone.
inline std::string vtp_binary(const std::string& bytes, const VtpChoices& choices) {
  const auto number = [&](std::size_t value) {
    return choices.long_header ? bytes_of(std::uint64_t{value}, choices.big_endian)
                               : bytes_of(static_cast<std::uint32_t>(value), choices.big_endian);
  };
  const bool raw = choices.encoding == "appended raw";
  if (!choices.compressed) {
    const std::string all = number(bytes.size()) + bytes;
    return raw ? all : base64(all);
  }
  constexpr std::size_t kBlock = 16;
  std::string header;
  std::string blocks;
  for (std::size_t k = 0; k < bytes.size(); k += kBlock) {
    const std::string block = deflated(bytes.substr(k, kBlock));
    header += number(block.size());
    blocks += block;
  }
  const std::size_t count = (bytes.size() + kBlock - 1) / kBlock;
  header = number(count) + number(kBlock) + number(bytes.size() % kBlock) + header;
  return raw ? header + blocks : base64(header) + base64(blocks);
}

struct VtpPoint {
  int type;
  Point position;
};

inline const std::vector<VtpPoint> kVtpPoints = {
    {0, {0.5, -1.25, 3}}, {1, {1, 2, 1e5}}, {2, {0, 0, 0.125}}, {3, {-7, 8, 9}}, {0, {1, 1, 1}}};

inline std::string vtp_file(const VtpChoices& choices, const std::vector<VtpPoint>& points = kVtpPoints) {
  const bool ascii = choices.encoding == "ascii";
  const bool appended = choices.encoding.starts_with("appended");
  std::ostringstream types;
  std::ostringstream positions;
  for (const auto& [type, p] : points) {
    if (ascii) {
      types << type << ' ';
      positions << p.x << ' ' << p.y << "\n " << p.z << '\n';
      continue;
    }
    types << (choices.types == "Int8" ? std::string(1, static_cast<char>(type))
                                      : bytes_of(std::int32_t{type}, choices.big_endian));
    for (const double x : {p.x, p.y, p.z}) {
      positions << (choices.doubles ? bytes_of(x, choices.big_endian)
                                    : bytes_of(static_cast<float>(x), choices.big_endian));
    }
  }
  const std::string type_data = ascii ? types.str() : vtp_binary(types.str(), choices);
  const std::string position_data = ascii ? positions.str() : vtp_binary(positions.str(), choices);
  const auto array = [&](const std::string& attributes, std::size_t offset, const std::string& data) {
    const std::string start = "<DataArray " + attributes;
    if (appended) return start + " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
    // VTK adds such elements to arrays of several components.
    const std::string key = "<InformationKey name=\"L2_NORM_RANGE\"><Value index=\"0\">5</Value></InformationKey>";
    return start + " format=\"" + (ascii ? "ascii" : "binary") + "\">\n   " + data + "\n" + key + "</DataArray>\n";
  };
  std::ostringstream file;
  file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\""
       << (choices.big_endian ? "BigEndian" : "LittleEndian") << "\" header_type=\""
       << (choices.long_header ? "UInt64" : "UInt32") << '"'
       << (choices.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") << ">\n<PolyData>\n"
       << "<FieldData><DataArray type=\"Int8\" Name=\"CriticalType\" "
          "format=\"ascii\">9</DataArray></FieldData>"
       << "<Piece NumberOfPoints=\"" << points.size() << "\" NumberOfVerts=\"0\">\n<PointData>\n"
       << "<DataArray type=\"Int32\" Name=\"Other\" format=\"ascii\">not looked at</DataArray>\n"
       << array("type=\"" + choices.types + "\" Name=\"CriticalType\"", 0, type_data)
       << "</PointData>\n<CellData></CellData><Points>\n"
       << array(std::string("type=\"") + (choices.doubles ? "Float64" : "Float32") +
                    "\" Name=\"Points\" NumberOfComponents=\"3\"",
                type_data.size(), position_data)
       << "</Points>\n</Piece></PolyData>\n";
  if (appended) {
    file << "<AppendedData encoding=\"" << choices.encoding.substr(9) << "\">\n _" << type_data << position_data
         << "\n</AppendedData>\n";
  }
  file << "</VTKFile>\n";
  return file.str();
}

// Every way to write a VTP file.
inline std::vector<VtpChoices> all_vtp_choices() {
  std::vector<VtpChoices> all = {{.types = "Int8"}};
  for (const char* encoding : {"base64", "appended base64", "appended raw"}) {
    for (unsigned bits = 0; bits < 16; ++bits) {
      all.push_back({.encoding = encoding,
                     .compressed = (bits & 1) != 0,
                     .big_endian = (bits & 2) != 0,
                     .long_header = (bits & 4) != 0,
                     .doubles = (bits & 8) != 0,
                     .types = (bits & 8) != 0 ? "Int32" : "Int8"});
    }
  }
  return all;
}

}  // namespace flowcert
