// What a process does first that was forked to work for another one.
//
// Guarantees: it ends when its parent does, however that comes about, and leaves Ctrl-C, SIGTERM and SIGHUP
// to it.
#pragma once

#include <sys/types.h>

namespace flowcert::fuzz {

// parent: as it was before the fork.
void be_a_child(pid_t parent);

}  // namespace flowcert::fuzz
