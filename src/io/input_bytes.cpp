// See input_bytes.h.
#include "io/input_bytes.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "io/line_reader.h"

namespace flowcert::io {
namespace {

// An open file, closed however the function that holds it is left. Standard input stays open.
class InputFile {
 public:
  explicit InputFile(const std::string& path)
      : descriptor_(path == "-" ? STDIN_FILENO : open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) reject_file(path, std::string("cannot open: ") + std::strerror(errno));
  }
  ~InputFile() {
    if (descriptor_ != STDIN_FILENO) close(descriptor_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

}  // namespace

std::string read_bytes(const std::string& path) {
  const InputFile input(path);
  std::string bytes;
  std::array<char, std::size_t{1} << 16> block{};
  while (true) {
    const ssize_t count = read(input.descriptor(), block.data(), block.size());
    if (count > 0) bytes.append(block.data(), static_cast<std::size_t>(count));
    if (count == 0) return bytes;
    if (count < 0 && errno != EINTR) {
      // A directory opens, and only reading it fails.
      const char* const action = errno == EISDIR ? "cannot open: " : "cannot read: ";
      reject_file(path, action + std::string(std::strerror(errno)));
    }
  }
}

}  // namespace flowcert::io
