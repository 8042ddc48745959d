// A program that is asked case after case and answers each, as between `generate` and `verify`
// (src/cli/manual/cases.md), in one process for all of them.
//
// Guarantees: those of limited_program.h, but that the program runs where this one does; the limit of time holds for
// each case. What is said of a case does not depend on the cases before it: if the process ends, is late or cannot be
// read, it is ended, and the case is asked again of a new one. A new process is asked its first case twice, so that
// what it leaves behind after an answer is noticed.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "certify/layer.h"
#include "certify/programs/command_run.h"
#include "certify/programs/limited_program.h"
#include "certify/programs/verification.h"

namespace flowcert::certify {

// Why a case has no whole answer.
enum class Silence { kNone, kLate, kUnreadable, kEnded, kCancelled };

struct CaseReply {
  Answer answer;
  Silence silence = Silence::kNone;
  std::string reason;  // why it is unreadable; one line
  CommandRun run;      // how the process ended, and what it said; if it has ended
};

class CaseDialogue {
 public:
  // The folder is made when a process is started, for what it says on standard error.
  CaseDialogue(std::string command, std::filesystem::path folder, const ProgramLimits& limits,
               std::function<bool()> is_cancelled);
  ~CaseDialogue();
  CaseDialogue(const CaseDialogue&) = delete;
  CaseDialogue& operator=(const CaseDialogue&) = delete;

  // Throws std::system_error if no process can be started, and OutputError if the folder cannot be written.
  [[nodiscard]] CaseReply ask(const std::vector<Point>& rows);

 private:
  class Process;

  CaseReply ask_new_process(const std::vector<Point>& rows);

  std::string command_;
  std::filesystem::path folder_;
  ProgramLimits limits_;
  std::function<bool()> is_cancelled_;
  std::unique_ptr<Process> process_;
};

}  // namespace flowcert::certify
