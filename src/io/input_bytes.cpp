// The C library reads files, and zlib's inflate decompresses gzip streams from memory. gzread is not used, because it
// cannot tell a damaged file from a whole one. It returns a file without a gzip header unchanged, and ends silently
// at garbage after a stream.
#include "io/input_bytes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

#include "io/line_reader.h"

namespace flowcert::io {

namespace {

// ---- Files that were read ----

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

// A regular file that was opened. Others are not remembered: nothing can replace them.
void remember_input(const std::string& path, int descriptor) {
  struct stat status{};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return;
  const std::scoped_lock lock(inputs_lock);
  std::erase_if(inputs_read, [&](const InputRead& input) { return input.path == path; });
  inputs_read.push_back({path, status.st_dev, status.st_ino});
}

// An open file. The destructor closes it, but standard input stays open.
class InputFile {
 public:
  InputFile(const std::string& path, const std::function<void()>& progress) {
    if (path == "-") return;
    // A signal interrupts the wait for a named pipe's writer.
    while ((descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC)) < 0) {
      if (errno != EINTR) reject_file(path, std::string("cannot open: ") + std::strerror(errno));
      if (progress) progress();
    }
  }
  ~InputFile() {
    if (descriptor_ != STDIN_FILENO) close(descriptor_);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = STDIN_FILENO;
};

}  // namespace

bool is_input(const struct stat& status) {
  const std::scoped_lock lock(inputs_lock);
  return std::ranges::any_of(inputs_read,
                             [&](const InputRead& input) { return is_same(input, status) && is_there(input); });
}

std::string read_bytes(const std::string& path, const std::function<void()>& progress) {
  const InputFile input(path, progress);
  remember_input(path, input.descriptor());
  std::string bytes;
  std::array<char, std::size_t{1} << 16> block{};
  while (true) {
    const ssize_t count = read(input.descriptor(), block.data(), block.size());
    if (count > 0) bytes.append(block.data(), static_cast<std::size_t>(count));
    if (count == 0) return bytes;
    if (count < 0 && errno != EINTR) {
      // Opening a directory succeeds. Only reading it fails.
      const char* const action = errno == EISDIR ? "cannot open: " : "cannot read: ";
      reject_file(path, action + std::string(std::strerror(errno)));
    }
    if (progress) progress();
  }
}

// ---- Gzip ----

namespace {

// Added to zlib's window size: only streams with a gzip header are taken.
constexpr int kGzipOnly = 16;
constexpr std::uint64_t kMostGrowth = 100, kAlwaysRead = std::uint64_t{1} << 20, kMostRead = std::uint64_t{1} << 32;

// Decompresses one stream from the front of `bytes` and appends it to `output`. Returns how many bytes it took.
std::size_t gunzip_one(std::string_view bytes, std::string_view file, std::uint64_t most, std::string& output) {
  z_stream stream{};
  if (inflateInit2(&stream, MAX_WBITS + kGzipOnly) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, decltype(&inflateEnd)> state(&stream, inflateEnd);
  std::array<char, std::size_t{1} << 16> block{};
  std::size_t taken = 0;
  int status = Z_OK;
  while (status != Z_STREAM_END) {
    const std::size_t given = std::min<std::size_t>(bytes.size() - taken, std::numeric_limits<uInt>::max());
    // zlib does not write through next_in; its type lacks the const for the sake of old compilers.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    taken += given - stream.avail_in;
    // There was room for output but no progress, so the input has run out.
    if (status == Z_BUF_ERROR) reject_file(file, "gzip data cut short");
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_OK && status != Z_STREAM_END) reject_file(file, "gzip data corrupted");
    output.append(block.data(), block.size() - stream.avail_out);
    if (output.size() > most) reject_file(file, complaint_about_growth("gzip data"));
  }
  return taken;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::uint64_t most_content(std::size_t compressed, bool is_unlimited) {
  if (is_unlimited) return std::numeric_limits<std::uint64_t>::max();
  return std::clamp(kMostGrowth * std::uint64_t{compressed}, kAlwaysRead, kMostRead);
}

std::string complaint_about_growth(const std::string& what) {
  return fmt::format("{} grow to more than {} times their size, or 4 GB; --unlimited reads them", what, kMostGrowth);
}

std::string gunzip(std::string_view bytes, std::string_view file, bool is_unlimited) {
  std::string output;
  const std::uint64_t most = most_content(bytes.size(), is_unlimited);
  while (is_gzip(bytes)) bytes.remove_prefix(gunzip_one(bytes, file, most, output));
  // Tapes and block devices pad with zeros, and gzip itself accepts that.
  if (bytes.find_first_not_of('\0') != std::string_view::npos) reject_file(file, "garbage after the gzip data");
  return output;
}

std::string_view without_byte_order_mark(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  return bytes;
}

std::string_view plain_content(std::string_view bytes, std::string_view file, std::string& decompressed,
                               bool is_unlimited) {
  if (is_gzip(bytes)) {
    decompressed = gunzip(bytes, file, is_unlimited);
    bytes = decompressed;
  }
  bytes = without_byte_order_mark(bytes);
  if (std::all_of(bytes.begin(), bytes.end(), is_blank)) reject_file(file, "empty");
  return bytes;
}

}  // namespace flowcert::io
