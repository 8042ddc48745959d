// Between fork and exec only what POSIX allows there is called, because other threads may hold any lock.
#include "certify/programs/limited_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

namespace flowcert::certify {

Descriptor::Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
  if (number_ < 0) throw std::system_error(errno, std::generic_category(), path);
}

void Descriptor::close() {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// A shell adds the first to the signal that ended its program. Beyond the last signal a status is the program's own,
// such as 255. Like a shell, we exit with the third if the program was not started at all.
constexpr int kShellSignal = 128;
constexpr int kLastSignal = 64;
constexpr int kNotStarted = 127;

// This signal, which programs do not use, means to a guard that the command is to end. The kernel sends it when this
// process has ended.
const int kEndIt = SIGRTMIN + 7;

// A killed process may take a moment to go, and is not waited for longer than this. A guard looks this often.
constexpr Seconds kLongestDying{5};
constexpr timespec kLook = {.tv_sec = 0, .tv_nsec = 500'000};
constexpr int kMostLooks = 10'000;

using ResourceLimit = std::pair<int, rlimit>;

// A limit that is already lower stays, because only root may raise it.
ResourceLimit limit_of(int resource, rlim_t most) {
  rlimit current{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &current);
  const rlim_t value = std::min(most, current.rlim_max);
  return {resource, {value, value}};
}

// A number that the guard hands to this process.
class SharedProcess {
 public:
  SharedProcess() : place_(::mmap(nullptr, sizeof(pid_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (place_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "no memory to share");
  }
  ~SharedProcess() { ::munmap(place_, sizeof(pid_t)); }
  SharedProcess(const SharedProcess&) = delete;
  SharedProcess& operator=(const SharedProcess&) = delete;

  [[nodiscard]] volatile pid_t& number() const { return *static_cast<volatile pid_t*>(place_); }

 private:
  void* place_;
};

// Everything that the new processes need, made before the fork.
struct Start {
  pid_t parent;
  const char* command;
  const char* directory;
  std::array<int, 3> descriptors;
  std::array<ResourceLimit, 3> limits;
  const SharedProcess& group;  // the command's
};

// ---- The guard ----
// A process between this one and the command, which is its child. Whatever the command starts comes to the guard when
// its own parent ends, also what has left the command's group by setsid. So the guard finds all of it.

// Only guards catch the signal that sets it.
volatile sig_atomic_t has_to_end = 0;
void note_end(int) { has_to_end = 1; }
void wake_up(int) {}

// Nothing but SIGKILL and kEndIt can disturb a guard.
bool set_up_guard(const Start& start) {
  ::setpgid(0, 0);
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  ::signal(kEndIt, note_end);
  ::signal(SIGCHLD, wake_up);
  sigset_t all;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);
  for (int target = 0; target < 3; ++target) {
    if (::dup2(start.descriptors[static_cast<std::size_t>(target)], target) < 0) return false;
  }
  ::close_range(3, ~0U, 0);
  if (::prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL) != 0) return false;
  ::prctl(PR_SET_PDEATHSIG, kEndIt, 0UL, 0UL, 0UL);
  return ::getppid() == start.parent;
}

bool set_limits(const Start& start) {
  for (const auto& [resource, limit] : start.limits) {
    if (::setrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return false;
  }
  return true;
}

[[noreturn]] void become_command(const Start& start) {
  ::setpgid(0, 0);
  if (set_limits(start) && ::chdir(start.directory) == 0) {
    for (const int number : {kEndIt, SIGCHLD}) ::signal(number, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::execl("/bin/sh", "sh", "-c", start.command, static_cast<char*>(nullptr));
  }
  ::_exit(kNotStarted);
}

// Waits until the command has ended, or has to. False in the second case.
bool wait_for(pid_t command, int& status) {
  sigset_t others;
  ::sigfillset(&others);
  ::sigdelset(&others, kEndIt);
  ::sigdelset(&others, SIGCHLD);
  while (has_to_end == 0) {
    int status_of_one = 0;
    const pid_t ended = ::waitpid(-1, &status_of_one, WNOHANG);
    if (ended == command) {
      status = status_of_one;
      return true;
    }
    if (ended <= 0) ::sigsuspend(&others);
  }
  return false;
}

// The kernel lists the numbers with a blank after each.
void kill_children() {
  const int list = ::open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return;
  std::array<char, 4096> text;
  pid_t child = 0;
  for (ssize_t count = 0; (count = ::read(list, text.data(), text.size())) > 0;) {
    for (const char c : std::string_view(text.data(), static_cast<std::size_t>(count))) {
      if ('0' <= c && c <= '9') {
        child = child * 10 + (c - '0');
      } else {
        if (child > 0) ::kill(child, SIGKILL);
        child = 0;
      }
    }
  }
  ::close(list);
}

// Kills children until there is none. Those of a killed child become the guard's.
void end_children(pid_t command) {
  for (int look = 0; look < kMostLooks; ++look) {
    ::kill(-command, SIGKILL);
    kill_children();
    pid_t ended = 1;
    while (ended > 0) ended = ::waitpid(-1, nullptr, WNOHANG);
    if (ended < 0 && errno == ECHILD) return;
    ::nanosleep(&kLook, nullptr);
  }
}

[[noreturn]] void guard(const Start& start) {
  const pid_t command = set_up_guard(start) ? ::_Fork() : -1;  // fork itself may take locks
  if (command < 0) ::_exit(kNotStarted);
  if (command == 0) become_command(start);
  // The guard does it too, so that the group exists when it is first signalled.
  ::setpgid(command, command);
  start.group.number() = command;
  int status = 0;
  const bool has_ended = wait_for(command, status);
  end_children(command);
  if (!has_ended) ::_exit(kNotStarted);  // nobody asks
  ::_exit(WIFSIGNALED(status) ? kShellSignal + WTERMSIG(status) : WEXITSTATUS(status));
}

pid_t start_guard(const Start& start) {
  // Where a guard is killed itself, the command comes to us.
  ::prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL);
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "no process can be started");
  if (process == 0) guard(start);
  return process;
}

// ---- This process ----

// The process stays a zombie and keeps its number.
bool has_ended(pid_t process) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == process;
}

// Waits a tenth of the time that has passed: short runs are delayed little, and long ones are looked at rarely.
void pause(Clock::time_point since) {
  using std::chrono::microseconds;
  const auto passed = std::chrono::duration_cast<microseconds>(Clock::now() - since);
  std::this_thread::sleep_for(std::clamp(passed / 10, microseconds(200), microseconds(10'000)));
}

// Waits for the guard, and returns its status. It needs a moment to end what is left.
int end_of_guard(pid_t guard, const SharedProcess& group) {
  const Clock::time_point since = Clock::now();
  while (!has_ended(guard) && Clock::now() - since < 2 * kLongestDying) pause(since);
  ::kill(guard, SIGKILL);  // nothing, if it has ended
  int status = 0;
  while (::waitpid(guard, &status, 0) < 0 && errno == EINTR) continue;
  const pid_t command = group.number();
  if (!WIFSIGNALED(status) || command <= 0) return status;
  ::kill(-command, SIGKILL);
  for (;;) {
    const pid_t orphan = ::waitpid(-command, nullptr, WNOHANG);
    if ((orphan < 0 && errno != EINTR) || Clock::now() - since > 3 * kLongestDying) return status;
    if (orphan == 0) pause(since);
  }
}

ProgramEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {ProgramEnding::kSignalled, WTERMSIG(status)};
  const int number = WEXITSTATUS(status);
  if (number > kShellSignal && number <= kShellSignal + kLastSignal) {
    return {ProgramEnding::kSignalled, number - kShellSignal};
  }
  return {ProgramEnding::kExited, number};
}

}  // namespace

struct RunningCommand::Guarded {
  SharedProcess group;
  pid_t process = -1;
};

RunningCommand::RunningCommand(const std::string& command, const std::string& directory,
                               const std::array<int, 3>& standard, const ProgramLimits& limits)
    : guarded_(std::make_unique<Guarded>()) {
  const rlim_t memory = limits.memory_bytes == 0 ? RLIM_INFINITY : limits.memory_bytes;
  guarded_->process =
      start_guard({::getpid(),
                   command.c_str(),
                   directory.c_str(),
                   standard,
                   {limit_of(RLIMIT_AS, memory), limit_of(RLIMIT_FSIZE, limits.file_bytes), limit_of(RLIMIT_CORE, 0)},
                   guarded_->group});
}

RunningCommand::~RunningCommand() {
  if (guarded_) (void)end();
}

bool RunningCommand::has_ended() const { return certify::has_ended(guarded_->process); }

ProgramEnd RunningCommand::end() {
  if (!has_ended()) ::kill(guarded_->process, kEndIt);
  const ProgramEnd end = end_of(end_of_guard(guarded_->process, guarded_->group));
  guarded_.reset();
  return end;
}

void RunningCommand::forget() { guarded_.reset(); }

ProgramEnd run_limited(const std::string& command, const ProgramPlaces& places, const ProgramLimits& limits,
                       const std::function<bool()>& is_cancelled) {
  const Descriptor in("/dev/null", O_RDONLY);
  const Descriptor out(places.standard_output, O_WRONLY | O_CREAT | O_TRUNC);
  const Descriptor err(places.standard_error, O_WRONLY | O_CREAT | O_TRUNC);
  const Clock::time_point since = Clock::now();
  RunningCommand running(command, places.directory, {in.number(), out.number(), err.number()}, limits);
  bool is_late = false, is_over = false;
  while (!running.has_ended()) {
    is_over = is_cancelled();
    is_late = Clock::now() - since > Seconds(limits.seconds);
    if (is_over || is_late) break;
    pause(since);
  }
  const double seconds = Seconds(Clock::now() - since).count();
  ProgramEnd end = running.end();
  if (is_over) end = {ProgramEnding::kCancelled, 0};
  if (is_late && !is_over) end = {ProgramEnding::kTimedOut, 0};
  end.seconds = seconds;
  return end;
}

std::string signal_text(int number) {
  const char* name = ::sigabbrev_np(number);
  return name == nullptr ? "signal " + std::to_string(number) : std::string("SIG") + name;
}

// ---- Signals ----

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// Read by all threads, written by a signal handler.
std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free);

// Whoever asks twice does not want to wait for a case that is being judged.
void note(int number) {
  int none = 0;
  if (noted.compare_exchange_strong(none, number)) return;
  ::signal(number, SIG_DFL);
  ::raise(number);
}

void replace_handlers(void (*from)(int), void (*to)(int)) {
  for (const int number : kSignals) {
    struct sigaction current{};
    if (::sigaction(number, nullptr, &current) == 0 && current.sa_handler == from) ::signal(number, to);
  }
}

}  // namespace

Interruption::Interruption() {
  noted = 0;
  replace_handlers(SIG_DFL, note);
}

Interruption::~Interruption() { replace_handlers(note, SIG_DFL); }

int Interruption::signal() { return noted; }

}  // namespace flowcert::certify
