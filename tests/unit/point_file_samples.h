// Point files made in memory, for the tests of the readers: gzip streams, and PLY files with everything that
// a PLY file may have around its vertices.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "flowcert/read_points.h"

namespace flowcert {

using Rows = std::vector<Point>;

inline Rows rows_of(const std::string& bytes, const std::string& name, const ReadingOptions& options = {}) {
  return read_points_from(bytes, name, options).rows;
}

// The message that a file is refused with.
inline std::string refusal(const std::string& bytes, const std::string& name, const ReadingOptions& options = {}) {
  try {
    return "accepted, " + std::to_string(rows_of(bytes, name, options).size()) + " rows";
  } catch (const InvalidInput& error) {
    return error.what();
  }
}

using Notes = std::vector<std::string>;

// What is said of how it was read.
inline Notes notes_of(const PointFile& file) {
  Notes notes;
  notes.reserve(file.notes.size());
  for (const ReadingNote& note : file.notes) notes.push_back(note.text);
  return notes;
}

inline std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string output(deflateBound(&stream, bytes.size()) + 64, '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = static_cast<uInt>(output.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  output.erase(stream.total_out);
  deflateEnd(&stream);
  return output;
}

template <class Value>
inline std::string bytes_of(Value value, bool big_endian) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

// Elements before and after the vertices, with lists; a list among the vertex properties; z before x.
inline std::string ply_header_with_everything(const std::string& format, const std::string& coordinate_type) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by a test\nelement patch 2\nproperty list uchar short ids\nproperty float32 "
         "weight\n"
         "element pair 2\nproperty int8 a\nproperty uint16 b\n"
         "element vertex 2\nproperty " +
         coordinate_type + " z\nproperty list uint8 int32 near\nproperty " + coordinate_type +
         " x\nproperty uchar red\nproperty " + coordinate_type +
         " y\nobj_info more\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n";
}

inline const Rows kPlyRows = {{1, -2, 3}, {100, 0, -7}};

template <class Coordinate>
inline std::string ply_binary(bool big_endian, const std::string& coordinate_type, const Rows& rows = kPlyRows) {
  const auto put = [&](auto value) { return bytes_of(value, big_endian); };
  std::string file =
      ply_header_with_everything(big_endian ? "binary_big_endian" : "binary_little_endian", coordinate_type);
  file += put(std::uint8_t{2}) + put(std::int16_t{5}) + put(std::int16_t{6}) + put(0.5F);
  file += put(std::uint8_t{0}) + put(0.25F);
  file += put(std::int8_t{1}) + put(std::uint16_t{2}) + put(std::int8_t{3}) + put(std::uint16_t{4});
  std::uint8_t near = 3;
  for (const Point& row : rows) {
    file += put(static_cast<Coordinate>(row.z)) + put(near);
    for (; near > 0; --near) file += put(std::int32_t{-1});
    file += put(static_cast<Coordinate>(row.x)) + put(std::uint8_t{255}) + put(static_cast<Coordinate>(row.y));
  }
  return file + put(std::uint8_t{3}) + put(std::uint32_t{0}) + put(std::uint32_t{1}) + put(std::uint32_t{0});
}

inline std::string ply_ascii(const std::string& coordinate_type = "float") {
  return ply_header_with_everything("ascii", coordinate_type) +
         "2 5 6 0.5\n0 0.25\n1 2\n3 4\n3 3 -1 -1 -1 1 255 -2\n-7 0 100 255 0\n3 0 1 0\n";
}

}  // namespace flowcert
