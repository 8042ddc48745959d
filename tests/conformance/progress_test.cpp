// Progress on standard error, as a terminal shows it: for whatever takes more than two seconds, and gone at the end.
//
// Guarantees: the terminal is a real one of 80 columns, so the programs cannot know better. Inputs grow until a command
// takes long enough on this machine, so nothing passes because the machine is fast.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <functional>
#include <future>
#include <random>
#include <thread>

#include "tests/conformance/program_run.h"

namespace flowcert::conformance::progress_test {
namespace {

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr double kDelay = 2, kLongEnough = 3, kShownWithin = 3;
constexpr char kErased[] = "\r\x1b[K";

// A terminal, of which the programs get the other end.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    const winsize size{.ws_row = 24, .ws_col = 80, .ws_xpixel = 0, .ws_ypixel = 0};
    ::ioctl(master_, TIOCSWINSZ, &size);
    // While this end is open, the terminal has not hung up.
    std::array<char, 64> name{};
    if (::ptsname_r(master_, name.data(), name.size()) != 0) throw std::runtime_error("no terminal");
    name_ = name.data();
    other_end_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  }
  ~Terminal() {
    ::close(other_end_);
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  // What has come since the last call, waiting for it a little.
  [[nodiscard]] std::string received() const {
    pollfd ready{master_, POLLIN, 0};
    if (::poll(&ready, 1, 20) <= 0) return "";
    std::string bytes(4096, '\0');
    const ssize_t count = ::read(master_, bytes.data(), bytes.size());
    bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return bytes;
  }

 private:
  int master_, other_end_ = -1;
  std::string name_;
};

struct Seen {
  int status = 0;
  double seconds = 0;
  double first = -1;  // when something was shown
  std::string text;
};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Runs it with a terminal as standard error. `meanwhile` is told the seconds so far, again and again.
Seen on_terminal(
    const Words& words, const std::string& input = "/dev/null",
    const std::function<void(double)>& meanwhile = [](double) {}) {
  const Terminal terminal;
  Seen seen;
  const Clock::time_point start = Clock::now();
  RunningProgram program(words,
                         {.standard_input = input, .standard_output = "/dev/null", .standard_error = terminal.name()});
  bool is_over = false;
  while (!is_over) {
    is_over = program.has_ended();
    const std::string some = terminal.received();
    if (!some.empty() && seen.first < 0) seen.first = seconds_since(start);
    seen.text += some;
    if (!some.empty()) is_over = false;
    meanwhile(seconds_since(start));
  }
  seen.seconds = seconds_since(start);
  seen.status = program.finish().status;
  return seen;
}

void expect_shown_and_gone(const Seen& seen, const std::string& word) {
  EXPECT_EQ(seen.status, 0) << seen.text;
  EXPECT_GE(seen.first, kDelay) << seen.text;
  EXPECT_LE(seen.first, kShownWithin) << seen.text;
  EXPECT_NE(seen.text.find(word), std::string::npos) << seen.text;
  EXPECT_TRUE(seen.text.ends_with(kErased)) << seen.text;
  EXPECT_EQ(seen.text.find('\n'), std::string::npos) << seen.text;
  // Each drawing is within the terminal's columns, or it could not be drawn over.
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = seen.text.find("\x1b[K", begin)) != std::string::npos; begin = end + 3) {
    EXPECT_LT(end - begin, 80U) << seen.text;
  }
}

// Makes the input larger until the command takes long.
Seen long_run(std::size_t size, double factor, const std::function<Words(std::size_t)>& command) {
  while (true) {
    const Seen seen = on_terminal(command(size));
    if (seen.seconds >= kLongEnough || seen.status != 0) return seen;
    size = static_cast<std::size_t>(static_cast<double>(size) * factor);
  }
}

std::string random_points(std::size_t count) {
  std::mt19937_64 random(5);
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    for (int axis = 0; axis < 3; ++axis) text += std::to_string(random() >> 40) + (axis < 2 ? " " : "\n");
  }
  return text;
}

TEST(Progress, OfPersistence) {
  const Scratch scratch;
  const Seen seen = long_run(30000, 2, [&](std::size_t count) {
    return Words{FLOWCERT_PROGRAM, "persistence", scratch.file("a.xyz", random_points(count)), "-o", "/dev/null"};
  });
  expect_shown_and_gone(seen, " s");
}

TEST(Progress, OfTheWholeComplex) {
  const Scratch scratch;
  const Seen seen = long_run(8000, 2, [&](std::size_t count) {
    return Words{FLOWCERT_PROGRAM, "compute", scratch.file("a.xyz", random_points(count)), "--manifolds", "all"};
  });
  expect_shown_and_gone(seen, " s");
}

TEST(Progress, OfACheck) {
  const Scratch scratch;
  const Seen seen = long_run(4000, 2, [&](std::size_t count) {
    const std::string input = scratch.file("a.xyz", random_points(count)), claim = scratch.path("a.jsonl");
    EXPECT_EQ(flowcert({"compute", input, "--manifolds", "u2", "--polylines", "-o", claim}).status, 0);
    return Words{FLOWCERT_PROGRAM, "check", input, claim};
  });
  expect_shown_and_gone(seen, " s");
}

TEST(Progress, OfTheOracle) {
  const Scratch scratch;
  const Seen seen = long_run(30, 1.3, [&](std::size_t count) {
    return Words{FLOWCERT_ORACLE_PROGRAM, "stationary", scratch.file("a.xyz", random_points(count))};
  });
  expect_shown_and_gone(seen, "searching");
}

// A program that is waited for: points come after three seconds.
class SlowPipe {
 public:
  explicit SlowPipe(std::string path, std::string text) : path_(std::move(path)), text_(std::move(text)) {
    if (::mkfifo(path_.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
    writer_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC);
  }
  ~SlowPipe() { close(); }
  SlowPipe(const SlowPipe&) = delete;
  SlowPipe& operator=(const SlowPipe&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  void write_after_three_seconds(double so_far) {
    if (so_far < kLongEnough || writer_ < 0) return;
    EXPECT_EQ(::write(writer_, text_.data(), text_.size()), static_cast<ssize_t>(text_.size()));
    close();
  }

 private:
  void close() {
    if (writer_ >= 0) ::close(writer_);
    writer_ = -1;
  }

  std::string path_, text_;
  int writer_ = -1;
};

TEST(Progress, OfWaitingForPoints) {
  const Scratch scratch;
  SlowPipe pipe(scratch.path("pipe"), "0 0 0\n3 0 0\n0 4 0\n");
  const Seen seen = on_terminal({FLOWCERT_PROGRAM, "compute", "-"}, pipe.path(),
                                [&](double so_far) { pipe.write_after_three_seconds(so_far); });
  expect_shown_and_gone(seen, "reading standard input  2 s");
}

// A pipe of three programs on one terminal: the last one says how far it is, with what is wrong.
Seen seen_of_a_pipe() {
  const std::string refuses = "grep '^case ' 2>/dev/null | head -n 9 | sed 's/case \\([^ ]*\\).*/refused \\1/'";
  return on_terminal(
      {"/bin/sh", "-c",
       "\"$0\" generate --level 2 | { " + refuses + "; sleep 3.5; } | \"$0\" verify --level 2 >/dev/null; test $? = 1",
       FLOWCERT_PROGRAM});
}

// Without `verify`, the first one says it.
Seen seen_without_verify() {
  return on_terminal({"/bin/sh", "-c", "\"$0\" generate --level 2 | sleep 3.2; true", FLOWCERT_PROGRAM});
}

TEST(Progress, OfWaitingForAnswers) {
  auto of_a_pipe = std::async(std::launch::async, seen_of_a_pipe);
  auto without_verify = std::async(std::launch::async, seen_without_verify);
  const Scratch scratch;
  SlowPipe pipe(scratch.path("pipe"), "");
  Seen seen = on_terminal({FLOWCERT_PROGRAM, "verify"}, pipe.path(),
                          [&](double so_far) { pipe.write_after_three_seconds(so_far); });
  // No answer is an error, which is told when the line is gone.
  EXPECT_EQ(seen.status, 2);
  const std::size_t error = seen.text.find("flowcert: ");
  ASSERT_NE(error, std::string::npos) << seen.text;
  seen.status = 0;
  seen.text.resize(error);
  expect_shown_and_gone(seen, "verifying  2 s");

  const Seen piped = of_a_pipe.get();
  expect_shown_and_gone(piped, "verifying: 9 of 5,000 cases, 9 wrong  ");
  EXPECT_EQ(piped.text.find("writing"), std::string::npos) << piped.text;
  const Seen alone = without_verify.get();
  expect_shown_and_gone(alone, "writing: ");
  EXPECT_NE(alone.text.find(" of 5,000 cases  "), std::string::npos) << alone.text;
}

TEST(Progress, IsNotShownToAFile) {
  const Scratch scratch;
  SlowPipe pipe(scratch.path("pipe"), "0 0 0\n3 0 0\n0 4 0\n");
  RunningProgram program({FLOWCERT_PROGRAM, "compute", "-"},
                         {.standard_input = pipe.path(), .standard_output = "/dev/null"});
  std::this_thread::sleep_for(std::chrono::duration<double>(kLongEnough));
  pipe.write_after_three_seconds(kLongEnough);
  const Finished finished = program.finish();
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(finished.err, "");
}

TEST(Progress, IsNotShownOfWhatIsShort) {
  const Scratch scratch;
  const Seen seen = on_terminal({FLOWCERT_PROGRAM, "compute", scratch.file("a.xyz", "0 0 0\n3 0 0\n0 4 0\n")});
  EXPECT_EQ(seen.status, 0);
  EXPECT_EQ(seen.text, "");
}

}  // namespace
}  // namespace flowcert::conformance::progress_test
