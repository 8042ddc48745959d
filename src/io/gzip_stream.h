// Gzip, from memory to memory.
//
// Guarantees: all or nothing. A stream that is cut short, fails its checksum, or is followed by anything but
// another stream or zero bytes (padding) throws InvalidInput "FILE: reason". Memory is bounded by twice the
// decompressed size.
#pragma once

#include <string>
#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// Whether the first two bytes are those of a gzip stream.
[[nodiscard]] bool is_gzip(std::string_view bytes);

// The concatenated contents of the streams (RFC 1952: a file may hold several) in `bytes`.
[[nodiscard]] std::string gunzip(std::string_view bytes, std::string_view file);

}  // namespace flowcert::io
