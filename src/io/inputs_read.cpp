#include "io/inputs_read.h"

#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace flowcert::io {

namespace {

struct InputRead {
  std::string path;
  dev_t device;
  ino_t inode;
};

std::mutex inputs_lock;
std::vector<InputRead> inputs_read;

bool is_same(const InputRead& input, const struct stat& status) {
  return input.device == status.st_dev && input.inode == status.st_ino;
}

bool is_there(const InputRead& input) {
  struct stat now{};
  const int failed = input.path == "-" ? ::fstat(STDIN_FILENO, &now) : ::stat(input.path.c_str(), &now);
  return failed == 0 && is_same(input, now);
}

}  // namespace

void remember_input(const std::string& path, int descriptor) {
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
  const std::scoped_lock lock(inputs_lock);
  std::erase_if(inputs_read, [&](const InputRead& input) { return input.path == path; });
  inputs_read.push_back({path, status.st_dev, status.st_ino});
}

bool is_input(const struct stat& status) {
  const std::scoped_lock lock(inputs_lock);
  return std::ranges::any_of(inputs_read,
                             [&](const InputRead& input) { return is_same(input, status) && is_there(input); });
}

}  // namespace flowcert::io
