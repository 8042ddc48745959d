// The namespace of what runs and judges programs sees those of the library, and what draws inputs.
#pragma once

#include "certify/layer.h"

namespace flowcert::judge {
using namespace certify;
}  // namespace flowcert::judge
