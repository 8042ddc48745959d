// The namespace of the layer that the kernels are a part of. They know nothing of the rest of it.
#pragma once

#include "voronoi/layer.h"

namespace flowcert::flow {
using namespace voronoi;
}  // namespace flowcert::flow
