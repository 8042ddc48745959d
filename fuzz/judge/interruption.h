// Ctrl-C, SIGTERM and SIGHUP as something to ask for, while there is something to put away first.
//
// Guarantees: as long as an object lives, these signals only leave a note; a signal that is ignored (nohup, a
// shell's background job) stays so. One object at a time.
#pragma once

#include "fuzz/judge/layer.h"

namespace flowcert::judge {

class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  // The first signal that came; 0 if none has.
  [[nodiscard]] static int signal();
};

// Thrown where the work has stopped because of it.
struct Interrupted {
  int signal = 0;
};

}  // namespace flowcert::judge
