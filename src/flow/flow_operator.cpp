// The choice between kernels.
#include "flow/flow_operator.h"

#include "flow/kernel_flow_operator.h"
#include "flow/kernels/exact_kernel.h"
#include "flow/kernels/lazy_kernel.h"

namespace flowcert::flow {

std::unique_ptr<FlowOperator> make_flow_operator(VoronoiFaces& faces, FlowOptions options) {
  if (options.kernel == ConstructionKernel::kCascade) return make_cascade_operator(faces, options.search);
  if (options.kernel == ConstructionKernel::kLazy) {
    return std::make_unique<KernelFlowOperator<LazyKernel>>(faces, options.search);
  }
  return std::make_unique<KernelFlowOperator<ExactKernel>>(faces, options.search);
}

}  // namespace flowcert::flow
