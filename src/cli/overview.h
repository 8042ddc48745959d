// What the program can do, in one screen: what it says when it is asked for nothing.
#pragma once

#include <string>

#include "cli/layer.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::cli {

// The group of commands that no overview has.
inline constexpr char kSetUpGroup[] = "Set up a shell";

// Groups of commands with a line each, and what to begin with. At most 24 lines of 80 columns.
[[nodiscard]] std::string overview(const CLI::App& app);

}  // namespace flowcert::cli
