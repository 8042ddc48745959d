// The subcommands of `flowcert` that draw inputs, or judge claims and programs. In a program that was built without
// FLOWCERT_JUDGE they have a name and a purpose only, and say what builds them.
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

// Gives those that are names only a group of their own, which says so. Does nothing where all are built.
void put_absent_commands_apart(CLI::App& app);

}  // namespace flowcert::commands
