// The commands that draw inputs and judge claims and programs, in a program that was built without them. Each has
// its name and its purpose, says what builds it, and has the exit status of unusable input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "fuzz/commands/commands.h"

namespace flowcert::commands {

namespace {

void add_absent_command(CLI::App& app, const std::string& name, const char* purpose) {
  CLI::App* command = app.add_subcommand(name, purpose);
  command->set_help_flag();  // `--help` gets the same answer as anything else
  command->prefix_command();
  command->callback([name] {
    throw InvalidInput(fmt::format(
        "{}: this program was built without it; './dev build' adds it (in CMake, FLOWCERT_JUDGE=ON)", name));
  });
}

}  // namespace

void add_check_command(CLI::App& app, int&) { add_absent_command(app, "check", cli::kCheckPurpose); }
void add_conformance_command(CLI::App& app, int&) { add_absent_command(app, "conformance", cli::kConformancePurpose); }
void add_fuzz_command(CLI::App& app, int&) { add_absent_command(app, "fuzz", cli::kFuzzPurpose); }
void add_generate_command(CLI::App& app, int&) { add_absent_command(app, "generate", cli::kGeneratePurpose); }
void add_verify_command(CLI::App& app, int&) { add_absent_command(app, "verify", cli::kVerifyPurpose); }

void put_absent_commands_apart(CLI::App& app) {
  for (const char* name : {"view", "check", "conformance", "generate", "verify", "fuzz"}) {
    app.get_subcommand(name)->group("Not built yet: ./dev build adds these");
  }
}

}  // namespace flowcert::commands

namespace flowcert::cli {

void add_view_command(CLI::App& app, int&) { commands::add_absent_command(app, "view", kViewPurpose); }

}  // namespace flowcert::cli
