// See flow_options.h.
#include "cli/flow_options.h"

#include <CLI/CLI.hpp>

namespace flowcert::cli {

FlowOptions FlowChoice::options() const {
  return {.kernel = kernel == "exact" ? ConstructionKernel::kExact : ConstructionKernel::kLazy,
          .search = search == "linear" ? FacetSearch::kLinear : FacetSearch::kBinary};
}

std::array<CLI::Option*, 2> add_flow_options(CLI::App& command, FlowChoice& choice) {
  CLI::Option* kernel =
      command
          .add_option("--kernel", choice.kernel,
                      "How points on orbits are represented: lazy (CGAL's Epeck) or exact (rationals, slow)")
          ->check(CLI::IsMember({"lazy", "exact"}))
          ->capture_default_str();
  CLI::Option* search =
      command
          .add_option("--search", choice.search,
                      "How the edge at which an orbit leaves a Voronoi facet is found: binary or linear")
          ->check(CLI::IsMember({"binary", "linear"}))
          ->capture_default_str();
  return {kernel, search};
}

}  // namespace flowcert::cli
