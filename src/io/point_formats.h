// The readers of the formats, one a file; read_points.cpp chooses between them.
//
// Each takes the whole file, decompressed, without a byte order mark, holding more than white space. Each
// guarantees what flowcert/read_points.h promises, and leaves PointFile::format to the caller.
#pragma once

#include <string_view>

#include "flowcert/read_points.h"
#include "io/layer.h"

namespace flowcert::io {

[[nodiscard]] PointFile read_xyz(std::string_view text, std::string_view file);
[[nodiscard]] PointFile read_off(std::string_view text, std::string_view file);
[[nodiscard]] PointFile read_ply(std::string_view bytes, std::string_view file);
[[nodiscard]] PointFile read_obj(std::string_view text, std::string_view file);

// Whether `word` is one of the keywords that an OFF file can begin with.
[[nodiscard]] bool is_off_keyword(std::string_view word);
// Whether `word` can begin a line of an OBJ file.
[[nodiscard]] bool is_obj_keyword(std::string_view word);

}  // namespace flowcert::io
