// `flowcert generate`: cases for any program to answer, on standard output (src/cli/manual/cases.md).
// The counterpart of `flowcert verify`.
//
// Guarantees: each case is flushed before the next is made, so that it can be answered at once. If its reader goes
// away, it ends silently, as any filter does.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "certify/programs/asked_cases.h"
#include "cli/case_progress.h"
#include "cli/reason_table.h"
#include "fuzz/commands/commands.h"
#include "fuzz/commands/run_options.h"
#include "fuzz/inputs/case_stream.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::commands {

namespace {

struct GenerateOptions {
  RunOptions run;
  std::optional<std::size_t> only;
  bool hexadecimal = false;
  bool is_xyz = false;
};

struct ReaderIsGone {};

// Ends the program by SIGPIPE, which is ignored before, so that no line of progress stays.
[[noreturn]] void end_of_the_pipe() {
  ::signal(SIGPIPE, SIG_DFL);
  ::raise(SIGPIPE);
  throw OutputError("standard output cannot be written: the pipe is closed");
}

void put(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw ReaderIsGone();
  throw OutputError(fmt::format("standard output cannot be written: {}", std::strerror(errno != 0 ? errno : EIO)));
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

// No reader takes an empty file.
std::string point_file(const std::vector<Point>& rows, NumberForm form) {
  return rows.empty() ? "# no points\n" : certify::points_text(rows, form);
}

void generate_one(const AskedCases& cases, std::size_t number, const GenerateOptions& options, NumberForm form) {
  if (number >= cases.size()) {
    throw InvalidInput(fmt::format("--case: the run has {}, 0 to {}", counted(cases.size(), "case"), cases.size() - 1));
  }
  const AskedCase one = cases.numbered(number);
  if (!cases.asks(one)) {
    throw InvalidInput(
        fmt::format("--case: case {} has {}, more than --most-points says", number, points_text(one.rows.size())));
  }
  if (options.is_xyz) return put(point_file(one.rows, form));
  const std::string id = cases.id(one);
  put(introduction(cases, id) + case_text(id, one.rows, form));
}

void generate_all(const AskedCases& cases, NumberForm form) {
  CaseProgress progress("writing", STDOUT_FILENO, PlaceInPipe::kFirst);
  bool is_begun = false;
  for (std::size_t number = 0; number < cases.size(); ++number) {
    const AskedCase one = cases.numbered(number);
    progress(number, cases.size());
    if (!cases.asks(one)) continue;
    const std::string id = cases.id(one);
    put((is_begun ? "" : introduction(cases, id)) + case_text(id, one.rows, form));
    is_begun = true;
  }
  if (!is_begun) throw InvalidInput("--most-points: every case has more points than that");
}

void generate(const GenerateOptions& options) {
  const std::unique_ptr<AskedCases> cases = cases_of(options.run);
  const auto form = options.hexadecimal ? NumberForm::kHexadecimal : NumberForm::kDecimal;
  ::signal(SIGPIPE, SIG_IGN);
  try {
    if (options.only) return generate_one(*cases, *options.only, options, form);
    generate_all(*cases, form);
  } catch (const ReaderIsGone&) {
    end_of_the_pipe();
  }
}

}  // namespace

void add_generate_command(CLI::App& app, int& status) {
  auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", cli::kGeneratePurpose);
  add_run_options(*command, options->run);
  auto* only = command->add_option("--case", options->only, "This case of the run alone, by its number, from 0")
                   ->check(CLI::NonNegativeNumber);
  command->add_flag("--hex", options->hexadecimal, "Print hexadecimal floats, not decimals");
  command->add_flag("--xyz", options->is_xyz, "Print the points of that case alone, as a point file")->needs(only);
  command->footer(
      "Examples:\n  flowcert generate --seed 7 | ./your-program | flowcert verify --seed 7\n"
      "  flowcert generate --level 1 --seed 7 --case 12\n"
      "  flowcert generate --level 1 --seed 7 --case 12 --xyz | flowcert compute -\n"
      "  flowcert generate --vectors | ./your-program | flowcert verify --vectors\n"
      "  flowcert generate --level 1 --most-points 6 | ./your-program \\\n"
      "    | flowcert verify --level 1 --most-points 6");
  command->callback([options, &status] {
    generate(*options);
    status = kRight;
  });
}

}  // namespace flowcert::commands
