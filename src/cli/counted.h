// "1 case", "1,200 cases".
#pragma once

#include <cstddef>
#include <string>

#include "cli/command.h"
#include "cli/layer.h"

namespace flowcert::cli {

[[nodiscard]] inline std::string counted(std::size_t count, const std::string& what) {
  return with_commas(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace flowcert::cli
