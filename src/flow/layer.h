// The namespace of this layer, the flow operator, sees those of the layers below. Public types are in flowcert.
#pragma once

#include "flow/kernels/layer.h"
