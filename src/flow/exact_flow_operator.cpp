// The flow operator over plain rationals, and the choice between kernels.
#include "flow/kernel_flow_operator.h"
#include "flow/kernels/exact_kernel.h"

namespace flowcert::flow {

std::unique_ptr<FlowOperator> make_exact_flow_operator(VoronoiFaces& faces, FacetSearch search) {
  return std::make_unique<KernelFlowOperator<ExactKernel>>(faces, search);
}

std::unique_ptr<FlowOperator> make_flow_operator(VoronoiFaces& faces, FlowOptions options) {
  return options.kernel == ConstructionKernel::kLazy ? make_lazy_flow_operator(faces, options.search)
                                                     : make_exact_flow_operator(faces, options.search);
}

}  // namespace flowcert::flow
