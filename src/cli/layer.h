// The namespace of this layer, the program, sees those of the layers below. Public types are in flowcert.
#pragma once

#include "certify/layer.h"

namespace flowcert::cli {
using namespace certify;
}  // namespace flowcert::cli
