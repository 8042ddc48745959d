// See bounded_file.h.
#include "fuzz/judge/bounded_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "flowcert/point_set.h"

namespace flowcert::judge {

namespace {

[[noreturn]] void reject(const std::string& name, const std::string& reason) {
  throw InvalidInput(fmt::format("{}: {}", name, reason));
}

// O_NONBLOCK: a named pipe opens at once, and is then seen to be one.
class OpenFile {
 public:
  OpenFile(const std::string& path, const std::string& name)
      : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    if (number_ < 0) reject(name, errno == ENOENT ? "there is no such file" : std::strerror(errno));
  }
  ~OpenFile() { ::close(number_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::string read_bounded(const std::string& path, std::size_t most, const std::string& name) {
  const OpenFile file(path, name);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) reject(name, std::strerror(errno));
  if (!S_ISREG(status.st_mode)) reject(name, "not a regular file");
  // One byte more than there may be, for files that grow, or do not tell their size.
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

}  // namespace flowcert::judge
