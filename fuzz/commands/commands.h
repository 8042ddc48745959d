// The subcommands of `flowcert` that draw inputs, and judge claims and programs. A program that was built
// without FLOWCERT_JUDGE has them by name alone, and they say what builds them.
#pragma once

#include "cli/command.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

// `check --oracle` asks the oracle.
void add_check_command(CLI::App& app, int& status);
void add_conformance_command(CLI::App& app, int& status);
void add_fuzz_command(CLI::App& app, int& status);
void add_generate_command(CLI::App& app, int& status);
void add_verify_command(CLI::App& app, int& status);

}  // namespace flowcert::commands
