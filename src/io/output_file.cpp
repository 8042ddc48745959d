// The signal handlers know all temporary files of the process, up to a number that no command reaches.
#include "io/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <vector>

#include "io/diagnostic.h"
#include "io/foreign_text.h"
#include "io/input_bytes.h"

namespace flowcert::io {

namespace {

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGABRT, SIGQUIT, SIGXCPU};

// A signal handler reads these, and may touch nothing that allocates. So they are plain arrays. Empty means no file.
char temporaries_in_progress[512][4096] = {};
// Held while the temporary file is made, renamed or removed. A mutex may not be taken in a signal handler, this may.
std::atomic<bool> temporary_is_held = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler uses it");

constexpr timespec kMoment = {.tv_sec = 0, .tv_nsec = 100'000};

void hold_temporary() {
  while (temporary_is_held.exchange(true)) ::nanosleep(&kMoment, nullptr);
}

// For a handler. A thread that aborts while it holds the file never lets go, so this waits a second at most.
void hold_temporary_at_the_end() {
  for (int moment = 0; moment < 10'000 && temporary_is_held.exchange(true); ++moment) ::nanosleep(&kMoment, nullptr);
}

}  // namespace

void remove_temporaries() {
  hold_temporary_at_the_end();
  for (const auto& temporary : temporaries_in_progress) {
    if (temporary[0] != '\0') ::unlink(temporary);
  }
}

namespace {

// Any thread may be given a signal. It waits for the one that writes, and then never lets go: so no file is made
// between here and the end.
void remove_and_end(int signal_number) {
  remove_temporaries();
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

// Keeps the handlers away from the temporary file: in this thread no signal is handled, in others handlers wait.
class HandlersHeld {
 public:
  HandlersHeld() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal_number : kEndingSignals) ::sigaddset(&ending, signal_number);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
    hold_temporary();
  }
  ~HandlersHeld() {
    temporary_is_held = false;
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  HandlersHeld(const HandlersHeld&) = delete;
  HandlersHeld& operator=(const HandlersHeld&) = delete;

 private:
  sigset_t before_{};
};

// A signal that is ignored (nohup, a shell's background job) stays ignored. The handlers stay after the file: a signal
// that is on its way to another thread finds them.
void set_handlers() {
  for (const int signal_number : kEndingSignals) {
    struct sigaction current{};
    if (::sigaction(signal_number, nullptr, &current) == 0 && current.sa_handler == SIG_DFL) {
      ::signal(signal_number, remove_and_end);
    }
  }
  // A write beyond the limit of a file's size fails then, and its reason is reported.
  ::signal(SIGXFSZ, SIG_IGN);
}

void remember(const std::string& temporary) {
  for (auto& place : temporaries_in_progress) {
    if (place[0] != '\0' || temporary.size() >= sizeof(place)) continue;
    std::memcpy(place, temporary.c_str(), temporary.size() + 1);
    return;
  }
}

void forget(const std::string& temporary) {
  for (auto& place : temporaries_in_progress) {
    if (temporary == place) place[0] = '\0';
  }
}

// Returns a descriptor, or -1 with errno. Replaces the X's at the end of the name.
int make_temporary(std::vector<char>& name) {
  const int descriptor = ::mkstemp(name.data());
  if (descriptor >= 0) remember(name.data());
  return descriptor;
}

void remove_temporary(const std::string& temporary) {
  const HandlersHeld held;
  ::unlink(temporary.c_str());
  forget(temporary);
}

// Where symbolic links lead to, also one to a file that is still to be made.
std::string end_of_links(const std::string& path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  std::filesystem::path end = path;
  std::error_code failure;
  for (int link = 0; link < kMostLinks && std::filesystem::is_symlink(end, failure); ++link) {
    const std::filesystem::path next = std::filesystem::read_symlink(end, failure);
    if (failure) break;
    end = next.is_absolute() ? next : end.parent_path() / next;
  }
  return end.string();
}

void warn_of_owner(const std::string& path) {
  tell(fmt::format("warning: {}: its owner cannot be kept\n", on_one_line(path)));
}

// The owner first, because a change of it takes bits of the mode away.
void keep_owner_and_mode(int descriptor, const struct stat& status, const std::string& path) {
  const bool is_kept = ::fchown(descriptor, status.st_uid, status.st_gid) == 0;
  if (!is_kept) warn_of_owner(path);
  // The rights of one owner are not given to another one.
  ::fchmod(descriptor, status.st_mode & (is_kept ? 07777 : 0777));
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path) {
  // What cannot be found out here, in a folder that may not be entered, is reported when the file is made.
  struct stat status{};
  const bool is_there = ::stat(path_.c_str(), &status) == 0;
  if (is_there && S_ISDIR(status.st_mode)) fail("Is a directory");
  // /dev/stdout or a named pipe is no regular file, and cannot be replaced by renaming.
  if (is_there && !S_ISREG(status.st_mode)) {
    stream_.open(path_, std::ios::binary);
    if (!stream_) fail(std::strerror(errno));
    return;
  }
  if (is_there && is_input(status)) fail("it is an input of this run");
  target_ = end_of_links(path_);
  std::error_code ignored;
  if (std::filesystem::is_symlink(target_, ignored)) fail(std::strerror(ELOOP));
  std::vector<char> name(target_.begin(), target_.end());
  for (const char c : {'.', 'X', 'X', 'X', 'X', 'X', 'X', '\0'}) name.push_back(c);
  // Opening a stream makes the file anew where a handler has removed it. So they wait until it is open.
  std::optional<HandlersHeld> held(std::in_place);
  set_handlers();
  const int descriptor = make_temporary(name);
  if (descriptor < 0) fail(std::strerror(errno));
  if (is_there) {
    keep_owner_and_mode(descriptor, status, path_);
  } else {
    // Only the owner can read a file that mkstemp makes. An output has to be as readable as any new file.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(descriptor, 0666 & ~mask);
  }
  ::close(descriptor);
  temporary_ = name.data();
  stream_.open(temporary_, std::ios::binary);
  const int reason = errno;
  held.reset();
  if (!stream_) {
    // The destructor will not run after a throwing constructor.
    remove_temporary(temporary_);
    fail(std::strerror(reason));
  }
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  stream_.close();
  remove_temporary(temporary_);
}

void OutputFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) fail(errno != 0 ? std::strerror(errno) : "write failed");
  if (temporary_.empty()) return;
  const HandlersHeld held;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(std::strerror(errno));
  forget(temporary_);
  temporary_.clear();
}

void OutputFile::fail(const std::string& what) const { throw OutputError(path_ + ": cannot be written: " + what); }

void write_whole_file(const std::string& path, const std::function<void(std::ostream&)>& write) {
  OutputFile file(path);
  write(file.stream());
  file.commit();
}

}  // namespace flowcert::io
