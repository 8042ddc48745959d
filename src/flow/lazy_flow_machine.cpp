// The flow operator over CGAL's lazy kernel.
#include "flow/flow_operator.h"
#include "geometry/lazy_kernel.h"

namespace flowcert::flow {

std::unique_ptr<FlowMachine> make_lazy_flow_machine(VoronoiFaces& faces, FacetSearch search) {
  return std::make_unique<FlowOperator<LazyKernel>>(faces, search);
}

}  // namespace flowcert::flow
