// How the program ends where it does not prove: with an exit status, 1 or 2, and one line.
#pragma once

#include <string>

struct Verdict {
  int exit_status;
  std::string line;
};
[[noreturn]] inline void reject(const std::string& what) {  // begins with the condition that does not hold
  throw Verdict{1, "certificate rejected: " + what + ", nothing is said of the list"};
}
[[noreturn]] inline void refute(const std::string& what) { throw Verdict{1, what}; }
[[noreturn]] inline void cannot_decide(const std::string& what) { throw Verdict{2, what}; }
