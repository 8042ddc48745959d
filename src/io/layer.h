// The namespace of this layer, files, sees those of the layers below. Public types are in flowcert.
#pragma once

#include "morse/layer.h"

namespace flowcert::io {
using namespace morse;
}  // namespace flowcert::io
