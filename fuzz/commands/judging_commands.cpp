// Gives the commands that judge the oracle and the drawn cases, which src/ does not know. In a program with this no
// command is absent.
#include "cli/check_command.h"
#include "fuzz/commands/commands.h"
#include "fuzz/commands/run_options.h"
#include "fuzz/judge/drawn_cases.h"
#include "fuzz/judge/oracle_truth.h"

namespace flowcert::commands {

void add_check_command(CLI::App& app, int& status) { cli::add_check_command(app, status, truth_of_oracle()); }

void add_conformance_command(CLI::App& app, int& status) {
  cli::add_conformance_command(app, status, truth_of_oracle());
}

void add_verify_command(CLI::App& app, int& status) {
  const auto add_options = [](CLI::App& command) {
    auto options = std::make_shared<RunOptions>();
    add_run_options(command, *options);
    return [options] { return options->is_given ? cases_of(*options) : nullptr; };
  };
  cli::add_verify_command(app, status, truth_of_oracle(), {add_options, drawn_cases_of});
}

void put_absent_commands_apart(CLI::App& /*app*/) {}

}  // namespace flowcert::commands
