// The signal handlers know one file at a time. A command never writes more than one at once.
#include "io/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

namespace flowcert::io {

namespace {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};

// A signal handler reads this, and may touch nothing that allocates. So it is a plain array. Empty means no file.
char temporary_in_progress[4096] = {};

void remove_and_end(int signal_number) {
  if (temporary_in_progress[0] != '\0') ::unlink(temporary_in_progress);
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

// Holds the signals back while there is a file that the handlers do not know yet.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal_number : kEndingSignals) ::sigaddset(&ending, signal_number);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

// A signal that is ignored (nohup, a shell's background job) stays ignored.
void replace_handlers(void (*from)(int), void (*to)(int)) {
  for (const int signal_number : kEndingSignals) {
    struct sigaction current {};
    if (::sigaction(signal_number, nullptr, &current) == 0 && current.sa_handler == from) {
      ::signal(signal_number, to);
    }
  }
}

void remember(const std::string& temporary) {
  if (temporary.size() < sizeof(temporary_in_progress)) {
    std::memcpy(temporary_in_progress, temporary.c_str(), temporary.size() + 1);
  }
  replace_handlers(SIG_DFL, remove_and_end);
}

// Returns a descriptor, or -1 with errno. Replaces the X's at the end of the name.
int make_temporary(std::vector<char>& name) {
  const SignalsHeld held;
  const int descriptor = ::mkstemp(name.data());
  if (descriptor >= 0) remember(name.data());
  return descriptor;
}

void forget() {
  temporary_in_progress[0] = '\0';
  replace_handlers(remove_and_end, SIG_DFL);
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path) {
  if (std::filesystem::is_directory(path_)) fail("Is a directory");
  // /dev/stdout or a named pipe is no regular file, and cannot be replaced by renaming.
  if (std::filesystem::exists(path_) && !std::filesystem::is_regular_file(path_)) {
    stream_.open(path_, std::ios::binary);
    if (!stream_) fail(std::strerror(errno));
    return;
  }
  std::vector<char> name(path_.begin(), path_.end());
  for (const char c : {'.', 'X', 'X', 'X', 'X', 'X', 'X', '\0'}) name.push_back(c);
  const int descriptor = make_temporary(name);
  if (descriptor < 0) fail(std::strerror(errno));
  // Only the owner can read a file that mkstemp makes. An output has to be as readable as any new file.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);
  ::close(descriptor);
  temporary_ = name.data();
  stream_.open(temporary_, std::ios::binary);
  if (!stream_) {
    const int reason = errno;
    // The destructor will not run after a throwing constructor.
    ::unlink(temporary_.c_str());
    forget();
    fail(std::strerror(reason));
  }
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  stream_.close();
  ::unlink(temporary_.c_str());
  forget();
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) fail(errno != 0 ? std::strerror(errno) : "write failed");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(std::strerror(errno));
  temporary_.clear();
  forget();
}

void OutputFile::fail(const std::string& what) const { throw OutputError(path_ + ": cannot be written: " + what); }

}  // namespace flowcert::io
