// Processes that are forked to work for this one.
//
// Guarantees: such a process ends when its parent does, however that comes about, and leaves Ctrl-C, SIGTERM
// and SIGHUP to it. An exception in its work ends it as a crash does: nothing of its parent's is undone in
// it.
#pragma once

#include <sys/types.h>

#include <functional>

namespace flowcert::fuzz {

// Does the work in a new process, which then ends with 0. Throws std::system_error.
[[nodiscard]] pid_t start_child(const std::function<void()>& work);

// Waits; its status as of waitpid.
int wait_for_end(pid_t child);

}  // namespace flowcert::fuzz
