// The parts of a flow complex in words, for whoever waits for them.
#pragma once

#include <array>
#include <string>

#include "flowcert/flow_complex.h"
#include "morse/layer.h"

namespace flowcert::morse {

[[nodiscard]] inline std::string part_text(FlowComplexPart part) {
  constexpr auto kTexts = std::to_array<const char*>({"Delaunay triangulation", "critical points", "critical points",
                                                      "unstable manifolds", "stable manifolds", "chain complex",
                                                      "links of saddles", "persistence", "limits of all directions",
                                                      "volumes", "unstable sets of dimension 2", "merge trees"});
  static_assert(kTexts.size() == kFlowComplexParts);
  return kTexts.at(static_cast<std::size_t>(part));
}

}  // namespace flowcert::morse
