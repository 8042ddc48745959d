// Arrays of numbers as a viewer page holds them: planes of bytes, compressed, in base64 (src/cli/manual/view.md).
//
// Guarantees: the page gets the same numbers, to the bit. Planes make the compressed text a third shorter, because
// neighbouring numbers have the same leading bytes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/json_fields.h"
#include "io/layer.h"

namespace flowcert::io {

[[nodiscard]] Json viewer_blob(std::span<const double> numbers);
[[nodiscard]] Json viewer_blob(std::span<const float> numbers);
[[nodiscard]] Json viewer_blob(std::span<const std::uint32_t> numbers);
[[nodiscard]] Json viewer_blob(std::span<const std::uint8_t> numbers);

}  // namespace flowcert::io
