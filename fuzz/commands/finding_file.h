// The file of a finding, or any other XYZ file, as a case to be tried.
#pragma once

#include <filesystem>

#include "fuzz/campaign/finding.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

// Throws InvalidInput, "FILE:LINE: reason" or "FILE: reason".
[[nodiscard]] fuzz::Finding read_finding(const std::filesystem::path& path);

}  // namespace flowcert::commands
