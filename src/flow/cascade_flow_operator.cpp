// The flow operator over the cascade kernel.
#include "flow/flow_operator.h"
#include "flow/kernel_flow_operator.h"
#include "flow/kernels/cascade_moving_point.h"

namespace flowcert::flow {

std::unique_ptr<FlowOperator> make_cascade_operator(VoronoiFaces& faces, FacetSearch search) {
  return std::make_unique<KernelFlowOperator<CascadeKernel>>(faces, search);
}

}  // namespace flowcert::flow
