// The commands that draw inputs and judge claims and programs, in a program that was built without them. Each has
// only its name, says what builds it, and has the exit status of unusable input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "fuzz/commands/commands.h"

namespace flowcert::commands {

namespace {

void add_absent_command(CLI::App& app, const std::string& name) {
  CLI::App* command = app.add_subcommand(name, "Not built yet: ./dev build adds it");
  command->set_help_flag();  // `--help` gets the same answer as anything else
  command->prefix_command();
  command->callback([name] {
    throw InvalidInput(fmt::format(
        "{}: this program was built without it; './dev build' adds it (in CMake, FLOWCERT_JUDGE=ON)", name));
  });
}

}  // namespace

void add_check_command(CLI::App& app, int&) { add_absent_command(app, "check"); }
void add_conformance_command(CLI::App& app, int&) { add_absent_command(app, "conformance"); }
void add_fuzz_command(CLI::App& app, int&) { add_absent_command(app, "fuzz"); }
void add_generate_command(CLI::App& app, int&) { add_absent_command(app, "generate"); }
void add_verify_command(CLI::App& app, int&) { add_absent_command(app, "verify"); }

}  // namespace flowcert::commands

namespace flowcert::cli {

void add_view_command(CLI::App& app, int&) { commands::add_absent_command(app, "view"); }

}  // namespace flowcert::cli
