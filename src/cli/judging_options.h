// The options that commands share which judge claims: --tolerance and --levels.
#pragma once

#include "cli/layer.h"
#include "flowcert/check.h"

namespace CLI {
class App;
}  // namespace CLI

namespace flowcert::cli {

// options must outlive the parsing of the command line.
void add_judging_options(CLI::App& command, CheckOptions& options);

}  // namespace flowcert::cli
