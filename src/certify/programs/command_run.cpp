// A command is one line of the shell, with its places filled in.
#include "certify/programs/command_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <system_error>

#include "flowcert/point_set.h"
#include "geometry/contract.h"
#include "io/foreign_text.h"
#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::certify {

// ---- The command ----

// Words that mean nothing special to the shell stay as they are. So a user's own quotes around a place, "{in}", do no
// harm.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

bool has_place(std::string_view command, std::string_view place) {
  return command.find(place) != std::string_view::npos;
}

std::string filled_in(std::string_view command, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string text;
  while (!command.empty()) {
    const auto value =
        std::ranges::find_if(values, [&](const auto& candidate) { return command.starts_with(candidate.first); });
    if (value != values.end()) {
      text += shell_word(value->second);
      command.remove_prefix(value->first.size());
    } else {
      text += command.front();
      command.remove_prefix(1);
    }
  }
  return text;
}

// ---- What it leaves ----

namespace {

[[noreturn]] void reject(const std::string& name, const std::string& reason) {
  throw InvalidInput(fmt::format("{}: {}", name, reason));
}

// Reads a file that some other program left, of which nothing can be assumed. It never waits for the other end of a
// pipe, and takes bounded memory. Throws InvalidInput "NAME: reason" if the file is missing, is no regular file, or
// is longer than `most` bytes.
std::string read_bounded(const std::string& path, std::size_t most, const std::string& name) {
  // With O_NONBLOCK a named pipe opens at once, and is then recognised.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (file.number() < 0) reject(name, errno == ENOENT ? "there is no such file" : std::strerror(errno));
  struct stat status{};
  if (::fstat(file.number(), &status) != 0) reject(name, std::strerror(errno));
  if (!S_ISREG(status.st_mode)) reject(name, "not a regular file");
  // It may read more than `most` bytes, to notice files that grow or have no known size.
  std::string bytes;
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most) reject(name, fmt::format("{} bytes; more than {} are not read", size, most));
  while (bytes.size() <= most) {
    constexpr std::size_t kBlock = std::size_t{1} << 16;
    const std::size_t before = bytes.size();
    bytes.resize(before + kBlock);
    const ssize_t count = ::read(file.number(), bytes.data() + before, kBlock);
    bytes.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) reject(name, std::strerror(errno));
    if (count == 0) return bytes;
  }
  reject(name, fmt::format("more than {} bytes are not read", most));
}

// ---- A run ----

namespace fs = std::filesystem;

// A shell exits with these if it was not allowed to run the command, or did not find it.
constexpr int kNotExecutable = 126;
constexpr int kNotFound = 127;

// Answers to the vectors are a hundredth of this size. A compressed one could become a thousand times larger.
constexpr std::size_t kMostBytes = std::size_t{16} << 20;
constexpr std::size_t kMostCompressedBytes = std::size_t{1} << 20;

// Also empty if the program has put something else in the file's place, since opening that could wait.
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
  run.end = run_limited(filled_in(order.command, values), {run.work().string(), run.out().string(), run.err().string()},
                        limits, is_cancelled);
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

std::string complaint_about_relative_path(const std::string& command) {
  const std::string program = command.substr(0, command.find_first_of(" \t\n;|&<>()"));
  std::error_code ignored;
  const bool is_relative =
      program.find('/') != std::string::npos && program.front() != '/' && fs::exists(program, ignored);
  if (!is_relative) return "";
  return fmt::format(
      "the command does not run here, but in a folder for each case: name {} by its full path, \"$PWD/{}\"",
      in_quotes(program), program);
}

std::string one_line(const std::string& text) {
  constexpr std::size_t kLongestLine = 300;
  const std::string line = io::on_one_line(io::front_of(text, kLongestLine));
  return text.size() > kLongestLine ? line + "..." : line;
}

void write_text_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw OutputError(path.string() + ": cannot be written");
}

// ---- Its folder ----

ScratchFolder::ScratchFolder() {
  std::error_code failure;
  const fs::path folder = fs::temp_directory_path(failure);
  if (failure) {
    const char* const said = std::getenv("TMPDIR");
    throw OutputError(fmt::format("no folder for temporary files: TMPDIR is '{}'", said == nullptr ? "" : said));
  }
  std::string name = (fs::absolute(folder) / "flowcert-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw fs::filesystem_error("no temporary directory", name, std::error_code(errno, std::generic_category()));
  }
  path_ = name;
}

ScratchFolder::ScratchFolder(const fs::path& path) : path_(path) {
  FLOWCERT_REQUIRES(!fs::exists(path_));
  fs::create_directory(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code failure;
  fs::remove_all(path_, failure);
  if (!failure) return;
  // The program may have closed its folder to everyone, us included.
  std::error_code ignored;
  const auto skip = fs::directory_options::skip_permission_denied;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  for (fs::recursive_directory_iterator entry(path_, skip, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    std::error_code unchanged;
    if (entry->is_directory(unchanged) && !entry->is_symlink(unchanged)) {
      fs::permissions(entry->path(), fs::perms::owner_all, unchanged);
    }
  }
  fs::remove_all(path_, ignored);
}

}  // namespace flowcert::certify
