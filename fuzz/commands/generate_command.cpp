// `flowcert generate`: cases for any program to answer, on standard output (spec/formats/cases.md).
// The counterpart of `flowcert verify`.
//
// Guarantees: each case is flushed before the next is made, so that it can be answered at once. If its reader goes
// away, it ends silently, as any filter does.
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "cli/progress.h"
#include "fuzz/commands/commands.h"
#include "fuzz/commands/run_options.h"
#include "fuzz/inputs/case_stream.h"
#include "fuzz/judge/asked_cases.h"
#include "io/output_file.h"

namespace flowcert::commands {

namespace {

struct GenerateOptions {
  RunOptions run;
  std::optional<std::size_t> only;
  bool hexadecimal = false;
  bool is_xyz = false;
};

// Ends the program by SIGPIPE, even if that signal is ignored.
[[noreturn]] void end_of_the_pipe() {
  ::signal(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
  throw OutputError("standard output cannot be written: the pipe is closed");
}

void put(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) end_of_the_pipe();
  throw OutputError(fmt::format("standard output cannot be written: {}", std::strerror(errno != 0 ? errno : EIO)));
}

// Into a pipe, the program that reads the cases shows how far it is.
bool is_file(int stream) {
  struct stat status{};
  return ::fstat(stream, &status) == 0 && S_ISREG(status.st_mode);
}

std::string introduction(const AskedCases& cases, const std::string& id) {
  return fmt::format(
      "# flowcert generate: {}.\n"
      "# After 'case ID N' come N points, x y z; a point's id is its place, from 0.\n"
      "# Answer each case to flowcert verify, in any order. A critical point is a line\n"
      "# index,x,y,z,squared_distance,ids of all nearest points;\n"
      "# what you do not have stays empty (other formats: spec/formats/claims.md).\n"
      "# For two points (0,0,0) and (2,0,0):\n"
      "#   answer {}\n"
      "#   0,0,0,0,0,0\n"
      "#   0,2,0,0,0,1\n"
      "#   1,1,0,0,1,0,1\n"
      "#   end\n"
      "# or, if your program gives up on a case: refused ID REASON\n",
      cases.description(), id);
}

void generate(const GenerateOptions& options) {
  const std::unique_ptr<AskedCases> cases = cases_of(options.run);
  if (options.only && *options.only >= cases->size()) {
    throw InvalidInput(
        fmt::format("--only: the run has {} cases, 0 to {}", with_commas(cases->size()), cases->size() - 1));
  }
  const auto form = options.hexadecimal ? fuzz::NumberForm::kHexadecimal : fuzz::NumberForm::kDecimal;
  const std::size_t first = options.only.value_or(0);
  const std::size_t last = options.only.value_or(cases->size() - 1);
  std::optional<ProgressLine> progress;
  if (is_file(STDOUT_FILENO)) progress.emplace("drawing cases");
  for (std::size_t number = first; number <= last; ++number) {
    const AskedCase one = cases->numbered(number);
    if (progress) (*progress)(number - first, last - first + 1);
    if (options.is_xyz) {
      put(fuzz::points_text(one.input, form));
      continue;
    }
    const std::string id = cases->id(one);
    if (number == first) put(introduction(*cases, id));
    put(fuzz::case_text(id, one.input, form));
  }
}

}  // namespace

void add_generate_command(CLI::App& app, int& status) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "Cases for any program to answer, for flowcert verify");
  add_run_options(*command, options->run);
  auto* only = command->add_option("--only", options->only, "This case of the run alone, by its number, from 0")
                   ->check(CLI::NonNegativeNumber);
  command->add_flag("--hex", options->hexadecimal, "Print hexadecimal floats, not decimals");
  command->add_flag("--xyz", options->is_xyz, "Print the points of the case of --only alone, as a point file")
      ->needs(only);
  command->footer(
      "Examples:\n  flowcert generate --seed 7 | ./your-program | flowcert verify --seed 7\n"
      "  flowcert generate --level 1 --seed 7 --only 12\n"
      "  flowcert generate --level 1 --seed 7 --only 12 --xyz | flowcert compute -\n"
      "  flowcert generate --vectors | ./your-program | flowcert verify --vectors");
  command->callback([options, &status] {
    generate(*options);
    status = kRight;
  });
}

}  // namespace flowcert::commands
