// The namespace of the layer that the kernels are a part of. Of the rest of it they know the public tally alone.
#pragma once

#include "voronoi/layer.h"

namespace flowcert::flow {
using namespace voronoi;
}  // namespace flowcert::flow
