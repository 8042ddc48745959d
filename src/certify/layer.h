// The namespace of this layer, judging claims, sees those of the layers below. Public types are in flowcert.
#pragma once

#include "io/layer.h"

namespace flowcert::certify {
using namespace io;
}  // namespace flowcert::certify
