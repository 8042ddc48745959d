// See command_run.h.
#include "fuzz/judge/command_run.h"

#include <fmt/format.h>

#include <fstream>

#include "flowcert/point_set.h"
#include "fuzz/judge/bounded_file.h"
#include "fuzz/judge/command_template.h"
#include "fuzz/judge/conformance_words.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::judge {

namespace {

namespace fs = std::filesystem;

// What a shell exits with that was not allowed to run the command, or did not find it.
constexpr int kNotExecutable = 126;
constexpr int kNotFound = 127;

// Answers to the vectors are a hundredth of this, and a compressed one could become a thousand times larger.
constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::size_t kMostCompressedBytes = std::size_t{1} << 20;

// Empty, too, where the program has put something else in its place, which opening could wait for.
std::string first_line_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "";
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

CommandRun run_command(const CommandOrder& order, const fs::path& folder, const ProgramLimits& limits,
                       const std::function<bool()>& is_cancelled) {
  CommandRun run;
  run.folder = folder;
  fs::create_directories(run.work());
  const fs::path points = run.work() / order.points_name;
  write_text_file(points, order.points);
  const bool has_out = has_place(order.command, "{out}");
  run.answer_name = has_out ? order.out_name : "standard output";
  run.answer = has_out ? run.work() / order.out_name : run.out();
  auto values = order.values;
  values.emplace_back("{in}", points.string());
  values.emplace_back("{out}", run.answer.string());
  run.end = run_limited(filled_in(order.command, values),
                        {run.work().string(), run.out().string(), run.err().string()}, limits, is_cancelled);
  return run;
}

bool was_not_started(const ProgramEnd& end) {
  return end.ending == ProgramEnding::kExited && (end.number == kNotExecutable || end.number == kNotFound);
}

std::string status_text(const CommandRun& run) {
  const std::string said = first_line_of(run.err());
  return fmt::format("exit status {}{}", run.end.number, said.empty() ? "" : ": " + one_line(said));
}

std::string answer_bytes(const CommandRun& run) {
  std::string bytes = read_bounded(run.answer.string(), kMostBytes, run.answer_name);
  const bool is_compressed = bytes.starts_with("\x1f\x8b");
  if (is_compressed && bytes.size() > kMostCompressedBytes) {
    throw InvalidInput(
        fmt::format("{}: more than {} compressed bytes are not read", run.answer_name, kMostCompressedBytes));
  }
  return bytes;
}

std::string fault_of_relative_path(const std::string& command) {
  const std::string program = command.substr(0, command.find_first_of(" \t\n;|&<>()"));
  std::error_code ignored;
  const bool is_relative =
      program.find('/') != std::string::npos && program.front() != '/' && fs::exists(program, ignored);
  if (!is_relative) return "";
  return fmt::format(
      "the command does not run here, but in a folder for each case: name {} by its full path, \"$PWD/{}\"",
      in_quotes(program), program);
}

void write_text_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw OutputError(path.string() + ": cannot be written");
}

}  // namespace flowcert::judge
