#include "io/byte_spool.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "io/output_file.h"

namespace flowcert::io {

namespace {

// Returns a descriptor, or -1 with errno. Some file systems have no O_TMPFILE. There the name goes at once.
int open_without_name(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file >= 0) return file;
  std::string name = folder + "/.flowcert.XXXXXX";
  const int named = ::mkstemp(name.data());
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

}  // namespace

ByteSpool::~ByteSpool() {
  if (file_ >= 0) ::close(file_);
}

void ByteSpool::fail() const { throw OutputError(folder_ + ": cannot be written: " + std::strerror(errno)); }

void ByteSpool::store() {
  if (file_ < 0) file_ = open_without_name(folder_);
  if (file_ < 0) fail();
  for (std::size_t done = 0; done < latest_.size();) {
    const ssize_t count = ::write(file_, latest_.data() + done, latest_.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail();
    done += static_cast<std::size_t>(count);
  }
  stored_ += latest_.size();
  latest_.clear();
}

void ByteSpool::copy_to(std::ostream& out) const {
  std::vector<char> piece(stored_ > 0 ? kPiece : 0);
  for (std::uint64_t done = 0; done < stored_;) {
    const std::size_t wanted = static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), stored_ - done));
    const ssize_t count = ::pread(file_, piece.data(), wanted, static_cast<off_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail();
    out.write(piece.data(), count);
    done += static_cast<std::uint64_t>(count);
  }
  out.write(latest_.data(), static_cast<std::streamsize>(latest_.size()));
}

}  // namespace flowcert::io
