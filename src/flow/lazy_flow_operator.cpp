// The flow operator over CGAL's lazy kernel.
#include "flow/kernel_flow_operator.h"
#include "flow/kernels/lazy_kernel.h"

namespace flowcert::flow {

std::unique_ptr<FlowOperator> make_lazy_flow_operator(VoronoiFaces& faces, FacetSearch search) {
  return std::make_unique<KernelFlowOperator<LazyKernel>>(faces, search);
}

}  // namespace flowcert::flow
