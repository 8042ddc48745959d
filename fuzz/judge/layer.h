// The code that runs and judges programs sees the names of the library.
#pragma once

#include "certify/layer.h"

namespace flowcert::judge {
using namespace certify;
}  // namespace flowcert::judge
