// The commands that draw inputs and judge see the names of the other commands and of judging.
#pragma once

#include "cli/layer.h"
#include "fuzz/judge/layer.h"

namespace flowcert::commands {
using namespace cli;
using namespace judge;
}  // namespace flowcert::commands
