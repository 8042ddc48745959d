// The program `flowcert`: parses the command line, and turns every failure into one line on standard error
// and an exit status. Without a command it prints an overview on standard output. Nothing was judged then, so the
// status is not that of a right answer, and a script whose command is missing does not go on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <initializer_list>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/huge_pages.h"
#include "cli/layer.h"
#include "flowcert/reproducibility.h"
#include "fuzz/commands/commands.h"
#include "io/diagnostic.h"
#include "io/out_of_memory.h"
#include "io/output_file.h"

namespace {

using namespace flowcert;
using namespace flowcert::cli;
using namespace flowcert::commands;

std::string version_text() {
  const Reproducibility made_by = reproducibility();
  return fmt::format("flowcert {} (commit {}; kernel: {}; compiler: {}; CGAL {})", made_by.version, made_by.commit,
                     made_by.kernel, made_by.compiler, made_by.cgal);
}

int complain(const std::string& what) {
  io::tell(fmt::format("flowcert: {}\n", on_one_line(what)));
  return kUnusable;
}

// A full disk shows only when the buffer is written.
int finish_output(int status) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  return complain(fmt::format("standard output cannot be written: {}", std::strerror(errno != 0 ? errno : EIO)));
}

// CLI11's own codes are 100 and more; help and version are not errors.
int exit_status_of(const CLI::App& app, const CLI::ParseError& error, std::span<const std::string> words) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(error);
    std::cout.flush();
    return finish_output(kRight);
  }
  return complain(complaint_about(app, error, words));
}

void put_in_group(CLI::App& app, const char* group, std::initializer_list<const char*> commands) {
  for (const char* command : commands) app.get_subcommand(command)->group(group);
}

void add_commands(CLI::App& app, int& status) {
  add_compute_command(app);
  add_surface_command(app);
  add_persistence_command(app);
  add_cycles_command(app);
  add_pockets_command(app);
  add_pores_command(app);
  add_stats_command(app);
  add_view_command(app, status);
  add_explain_command(app, status);
  add_orbit_command(app);
  add_locate_command(app);
  add_medial_command(app);
  add_points_command(app);
  add_check_command(app, status);
  add_conformance_command(app, status);
  add_generate_command(app, status);
  add_verify_command(app, status);
  add_fuzz_command(app, status);
  add_help_command(app);
  add_shell_commands(app);
  put_in_group(app, "Compute", {"compute", "surface", "persistence", "cycles", "pockets", "pores", "medial", "stats"});
  put_in_group(app, "Look closely", {"view", "explain", "orbit", "locate", "points", "help"});
  put_in_group(app, "Judge claims and programs", {"check", "conformance", "generate", "verify", "fuzz"});
  put_absent_commands_apart(app);
}

int run(int argc, char** argv) {
  CLI::App app{"The flow complex of a point set in three dimensions, exactly."};
  app.name("flowcert");
  app.formatter(help_formatter());
  app.set_version_flag("--version", version_text(), "Print what made this program, for reproducibility");
  app.require_subcommand(1);
  app.footer(
      "Examples:\n  flowcert compute bunny.obj\n  flowcert surface bunny.obj --select largest-gaps=20 -o shape.ply\n\n"
      "Exit status: 0 right, 1 a negative verdict, 2 unusable input or usage.");
  int status = kRight;
  add_commands(app, status);
  if (argc <= 1) {
    fmt::print("{}", overview(app));
    return finish_output(kUnusable);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return exit_status_of(app, error, std::vector<std::string>(argv + 1, argv + std::max(argc, 1)));
  }
  return finish_output(status);
}

}  // namespace

int main(int argc, char** argv) {
  io::prepare_standard_streams();
  io::prepare_for_out_of_memory("flowcert");
  prepare_for_huge_pages();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    io::end_out_of_memory();
  } catch (const std::filesystem::filesystem_error& error) {
    // Its own text is the C++ library's, with the name of a function.
    return complain(fmt::format("{}: {}", error.path1().string(), error.code().message()));
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
