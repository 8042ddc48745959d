// See made_by_text.h.
#include "io/made_by_text.h"

#include <fmt/format.h>

#include "flowcert/reproducibility.h"

namespace flowcert::io {

std::string made_by_text(const char* format, int format_version, const std::string& input_sha256) {
  const Reproducibility made_by = reproducibility();
  return fmt::format("{} {}, by flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {}), input_sha256 {}",
                     format, format_version, made_by.version, made_by.commit, made_by.kernel,
                     made_by.compiler, made_by.cgal, input_sha256);
}

}  // namespace flowcert::io
