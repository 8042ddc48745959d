// Runs a program the way a shell does, and shows all that a user would see of it: exit status, standard
// output, standard error, and what it left in its directory.
//
// Guarantees: output is taken from files, so a program can never block on a full pipe; signals are at their
// defaults in the program, whatever the test runner ignores. Throws if the program cannot be started.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace flowcert::conformance {

// A directory of its own for one test, gone with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "flowcert-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    directory_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::string path(const std::string& name) const { return (directory_ / name).string(); }
  // Writes a file, and returns its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& content) const {
    std::ofstream(directory_ / name, std::ios::binary) << content;
    return path(name);
  }
  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) {
      result.insert(entry.path().filename().string());
    }
    return result;
  }

 private:
  std::filesystem::path directory_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

// The text with the lines joined again that were broken because they were too wide: the later parts are indented by
// four blanks.
inline std::string unbroken(std::string text) {
  constexpr std::string_view kBreak = "\n    ";
  for (std::size_t at = text.find(kBreak); at != std::string::npos; at = text.find(kBreak, at)) {
    text.replace(at, kBreak.size(), " ");
  }
  return text;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

struct Streams {
  std::string standard_input = "/dev/null";
  // If one of these is empty, the output is captured.
  std::string standard_output;
  std::string standard_error = {};
};

// A program that runs. finish() waits for it.
class RunningProgram {
 public:
  explicit RunningProgram(const std::vector<std::string>& words, const Streams& streams = {})
      : captures_output_(streams.standard_output.empty()) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, streams.standard_input.c_str(), O_RDONLY, 0);
    const std::string out = captures_output_ ? captured_.path("out") : streams.standard_output;
    const std::string err = streams.standard_error.empty() ? captured_.path("err") : streams.standard_error;
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t by_default;
    ::sigfillset(&by_default);
    ::posix_spawnattr_setsigdefault(&attributes, &by_default);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    std::vector<std::string> copies = words;
    std::vector<char*> argv;
    argv.reserve(copies.size() + 1);
    for (std::string& word : copies) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int failure = ::posix_spawn(&process_, argv[0], &actions, &attributes, argv.data(), environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::runtime_error("cannot start " + words.at(0));
  }

  void signal(int number) const { ::kill(process_, number); }
  // Signals the program and the children that it has now.
  void signal_family(int number) const {
    const std::string process = std::to_string(process_);
    std::istringstream children(content_of("/proc/" + process + "/task/" + process + "/children"));
    signal(number);
    for (pid_t child = 0; children >> child;) ::kill(child, number);
  }

  // Whether it has ended; never waits.
  [[nodiscard]] bool has_ended() {
    if (!has_ended_) has_ended_ = ::waitpid(process_, &wait_status_, WNOHANG) == process_;
    return has_ended_;
  }

  struct Result {
    int status = 0;  // the exit status, or minus the number of the signal that ended it
    std::string out;
    std::string err;
  };
  Result finish() {
    if (!has_ended_) ::waitpid(process_, &wait_status_, 0);
    has_ended_ = true;
    Result result;
    result.status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -WTERMSIG(wait_status_);
    if (captures_output_) result.out = content_of(captured_.path("out"));
    result.err = content_of(captured_.path("err"));
    return result;
  }

 private:
  Scratch captured_;
  bool captures_output_;
  pid_t process_ = 0;
  int wait_status_ = 0;
  bool has_ended_ = false;
};

using Finished = RunningProgram::Result;

// The two programs, by the paths that CMake defines for the test.
#ifdef FLOWCERT_PROGRAM
inline Finished flowcert(std::vector<std::string> arguments, const Streams& streams = {}) {
  arguments.insert(arguments.begin(), FLOWCERT_PROGRAM);
  return RunningProgram(arguments, streams).finish();
}
#endif
#ifdef FLOWCERT_ORACLE_PROGRAM
inline Finished flowcert_oracle(std::vector<std::string> arguments, const Streams& streams = {}) {
  arguments.insert(arguments.begin(), FLOWCERT_ORACLE_PROGRAM);
  return RunningProgram(arguments, streams).finish();
}
#endif

}  // namespace flowcert::conformance
