// Fills in the places of a user's command, such as {in} and {out}, runs it once on a point file, and reads what that
// leaves.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/layer.h"
#include "certify/programs/limited_program.h"

namespace flowcert::certify {

// ---- The command ----

[[nodiscard]] bool has_place(std::string_view command, std::string_view place);

// The text as one word of the shell, whatever it holds.
[[nodiscard]] std::string shell_word(const std::string& text);

// Replaces each place (first) by its value (second), as one word of the shell. What is filled in is not searched for
// places.
[[nodiscard]] std::string filled_in(std::string_view command,
                                    const std::vector<std::pair<std::string, std::string>>& values);

// ---- A run ----
// One run of a user's command on a point file, and what it leaves: its answer, what it said, how it ended.
//
// Guarantees: those of limited_program.h. The run has a folder, and runs in a subfolder of it, so that it meets none
// of our files but the points. Nothing is assumed of what it leaves.
struct CommandOrder {
  std::string command;  // with {in}; the answer is the file {out}, or standard output
  std::string points_name;
  std::string points;
  std::string out_name;
  std::vector<std::pair<std::string, std::string>> values;  // for further places
};

// A run that has ended, and where it has left its files.
struct CommandRun {
  std::filesystem::path folder;
  std::string answer_name;
  std::filesystem::path answer;
  ProgramEnd end;

  [[nodiscard]] std::filesystem::path work() const { return folder / "work"; }
  [[nodiscard]] std::filesystem::path out() const { return folder / "stdout"; }
  [[nodiscard]] std::filesystem::path err() const { return folder / "stderr"; }
};

// Makes the folder. Throws OutputError if the points cannot be written.
[[nodiscard]] CommandRun run_command(const CommandOrder& order, const std::filesystem::path& folder,
                                     const ProgramLimits& limits, const std::function<bool()>& is_cancelled);

// Whether a shell was not allowed to run the command, or did not find it.
[[nodiscard]] bool was_not_started(const ProgramEnd& end);
// "exit status 3: the first line that it said"
[[nodiscard]] std::string status_text(const CommandRun& run);
// Throws InvalidInput if the answer is missing, is no regular file, or is too long for a small input.
[[nodiscard]] std::string answer_bytes(const CommandRun& run);

// If a command names its program by a relative path, it would not find it in the folder of a run. Returns what to say
// then; empty if all is well.
[[nodiscard]] std::string complaint_about_relative_path(const std::string& command);

// What a program under test has written, for a line of a report: without control characters, and not endless.
[[nodiscard]] std::string one_line(const std::string& text);

// Throws OutputError.
void write_text_file(const std::filesystem::path& path, const std::string& text);

// ---- Its folder ----
// A directory for temporary files that goes away with the object, and with all that is in it.
class ScratchFolder {
 public:
  // In the directory for temporary files (TMPDIR, or /tmp). Throws std::filesystem::filesystem_error.
  ScratchFolder();
  // At this path, which must be new.
  explicit ScratchFolder(const std::filesystem::path& path);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace flowcert::certify
