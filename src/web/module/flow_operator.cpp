// One kernel, the fastest. The modules offer no choice, and CGAL's lazy numbers would be a twentieth of them.
#include "flow/flow_operator.h"

#include <stdexcept>

namespace flowcert::flow {

std::unique_ptr<FlowOperator> make_flow_operator(VoronoiFaces& faces, FlowOptions options) {
  if (options.kernel != ConstructionKernel::kCascade)
    throw std::logic_error("the modules have the cascade kernel alone");
  return make_cascade_operator(faces, options.search);
}

}  // namespace flowcert::flow
