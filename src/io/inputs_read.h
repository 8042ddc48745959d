// The files that this process has read, so that no output takes the place of one of them.
//
// Guarantees: a file is known by its device and inode, whatever its name, also as standard input. A file that is gone
// since is known no more, so that its inode may have a new file. Any thread may call these.
#pragma once

#include <sys/stat.h>

#include <string>

#include "io/layer.h"

namespace flowcert::io {

// A regular file that was opened; "-" is standard input. Others are not remembered: nothing can replace them.
void remember_input(const std::string& path, int descriptor);

// Whether the file with this status is one of them.
[[nodiscard]] bool is_input(const struct stat& status);

}  // namespace flowcert::io
