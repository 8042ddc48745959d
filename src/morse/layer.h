// The namespace of this layer, manifolds and what is counted of them, sees those of the layers below. Public
// types are in flowcert.
#pragma once

#include "flow/layer.h"

namespace flowcert::morse {
using namespace flow;
}  // namespace flowcert::morse
