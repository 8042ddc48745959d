// The flow operator over plain rationals, and the choice between kernels.
#include "flow/flow_operator.h"
#include "geometry/exact_kernel.h"

namespace flowcert::flow {

std::unique_ptr<FlowMachine> make_exact_flow_machine(VoronoiFaces& faces, FacetSearch search) {
  return std::make_unique<FlowOperator<ExactKernel>>(faces, search);
}

std::unique_ptr<FlowMachine> make_flow_machine(VoronoiFaces& faces, FlowOptions options) {
  return options.kernel == ConstructionKernel::kLazy ? make_lazy_flow_machine(faces, options.search)
                                                     : make_exact_flow_machine(faces, options.search);
}

}  // namespace flowcert::flow
