// Between fork and exec only what POSIX allows there is called, because other threads may hold any lock.
#include "fuzz/judge/limited_program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

namespace flowcert::judge {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// A shell adds the first to the signal that ended its program. Like a shell, we exit with the second if the program
// was not started at all.
constexpr int kShellSignal = 128;
constexpr int kNotStarted = 127;
constexpr int kLastSignal = 31;

// This signal, which programs do not use, tells the leader of a group that this process has ended.
const int kParentEnded = SIGRTMIN + 7;

// A killed process may take a moment to go, and is not waited for longer than this.
constexpr Seconds kLongestDying{5};

class Descriptor {
 public:
  Descriptor(const std::string& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) throw std::system_error(errno, std::generic_category(), path);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

using ResourceLimit = std::pair<int, rlimit>;

// A limit that is already lower stays, because only root may raise it.
ResourceLimit limit_of(int resource, rlim_t most) {
  rlimit current{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &current);
  const rlim_t value = std::min(most, current.rlim_max);
  return {resource, {value, value}};
}

// Everything that the new process needs, made before the fork.
struct Start {
  pid_t parent;
  const char* command;
  const char* directory;
  std::array<int, 3> descriptors;
  std::array<ResourceLimit, 3> limits;
};

void end_own_group(int) { ::kill(0, SIGKILL); }

// Sets up the group's leader, and so the command.
bool set_up(const Start& start) {
  ::setpgid(0, 0);
  for (int number = 1; number < NSIG; ++number) ::signal(number, SIG_DFL);
  ::signal(kParentEnded, end_own_group);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int target = 0; target < 3; ++target) {
    if (::dup2(start.descriptors[static_cast<std::size_t>(target)], target) < 0) return false;
  }
  ::close_range(3, ~0U, 0);
  ::prctl(PR_SET_PDEATHSIG, kParentEnded, 0UL, 0UL, 0UL);
  return ::getppid() == start.parent;
}

bool set_limits(const Start& start) {
  for (const auto& [resource, limit] : start.limits) {
    if (::setrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0) return false;
  }
  return true;
}

[[noreturn]] void become_command(const Start& start) {
  if (set_limits(start) && ::chdir(start.directory) == 0) {
    ::execl("/bin/sh", "sh", "-c", start.command, static_cast<char*>(nullptr));
  }
  ::_exit(kNotStarted);
}

// Waits for the command. If our parent ends, even by being killed, this ends the whole group, since nobody else
// would.
[[noreturn]] void lead_group(const Start& start) {
  const pid_t command = set_up(start) ? ::_Fork() : -1;  // fork itself may take locks
  if (command < 0) ::_exit(kNotStarted);
  if (command == 0) become_command(start);
  int status = 0;
  while (::waitpid(command, &status, 0) < 0 && errno == EINTR) continue;
  ::_exit(WIFSIGNALED(status) ? kShellSignal + WTERMSIG(status) : WEXITSTATUS(status));
}

pid_t start_process(const Start& start) {
  // Orphans of the group become our children, so that we can wait for them.
  ::prctl(PR_SET_CHILD_SUBREAPER, 1UL, 0UL, 0UL, 0UL);
  const pid_t process = ::fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "no process can be started");
  if (process == 0) lead_group(start);
  // The parent does it too, so that the group exists when we first signal it.
  ::setpgid(process, process);
  return process;
}

// The process stays a zombie and keeps its number, so that the group can still be signalled.
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

// Kills what is left of the group, and waits for it. Returns the status of the process that leads it.
int end_group(pid_t leader) {
  ::kill(-leader, SIGKILL);
  int status = 0;
  while (::waitpid(leader, &status, 0) < 0 && errno == EINTR) continue;
  const Clock::time_point since = Clock::now();
  for (;;) {
    const pid_t orphan = ::waitpid(-leader, nullptr, WNOHANG);
    if ((orphan < 0 && errno != EINTR) || Clock::now() - since > kLongestDying) return status;
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

ProgramEnd run_limited(const std::string& command, const ProgramPlaces& places, const ProgramLimits& limits,
                       const std::function<bool()>& is_cancelled) {
  const Descriptor in("/dev/null", O_RDONLY);
  const Descriptor out(places.standard_output, O_WRONLY | O_CREAT | O_TRUNC);
  const Descriptor err(places.standard_error, O_WRONLY | O_CREAT | O_TRUNC);
  const rlim_t memory = limits.memory_bytes == 0 ? RLIM_INFINITY : limits.memory_bytes;
  const Clock::time_point since = Clock::now();
  const pid_t process = start_process(
      {::getpid(),
       command.c_str(),
       places.directory.c_str(),
       {in.number(), out.number(), err.number()},
       {limit_of(RLIMIT_AS, memory), limit_of(RLIMIT_FSIZE, limits.file_bytes), limit_of(RLIMIT_CORE, 0)}});
  bool is_late = false, is_over = false;
  while (!has_ended(process)) {
    is_over = is_cancelled();
    is_late = Clock::now() - since > Seconds(limits.seconds);
    if (is_over || is_late) break;
    pause(since);
  }
  const double seconds = Seconds(Clock::now() - since).count();
  ProgramEnd end = end_of(end_group(process));
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

void note(int number) {
  int none = 0;
  noted.compare_exchange_strong(none, number);
}

void replace_handlers(void (*from)(int), void (*to)(int)) {
  for (const int number : kSignals) {
    struct sigaction current {};
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

}  // namespace flowcert::judge
