// The options --kernel and --search, which say how orbits are computed, not what they are.
#pragma once

#include <array>
#include <string>

#include "cli/layer.h"
#include "flowcert/orbit.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace flowcert::cli {

struct FlowChoice {
  std::string kernel = "lazy";    // or "exact"
  std::string search = "binary";  // or "linear"

  [[nodiscard]] FlowOptions options() const;
};

// The two options are returned so that they can be made to need others.
std::array<CLI::Option*, 2> add_flow_options(CLI::App& command, FlowChoice& choice);

}  // namespace flowcert::cli
