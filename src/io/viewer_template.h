// The page of src/viewer/, without data.
#pragma once

#include <string_view>

#include "io/layer.h"

namespace flowcert::io {

// src/viewer/page.html as it was when the program was compiled.
[[nodiscard]] std::string_view viewer_template();

}  // namespace flowcert::io
