// A temporary file goes away on a signal, whichever thread is given the signal, and at whatever moment.
//
// A child process makes and drops files without a pause, beside a thread that waits. While the writing thread holds
// signals back, the kernel gives them to the waiting one. Each child is killed at another moment.
#include "io/output_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

namespace flowcert::io::output_file_test {
namespace {

namespace fs = std::filesystem;

constexpr int kChildren = 200;

constexpr int kSignals[] = {SIGTERM, SIGABRT, SIGQUIT, SIGXCPU, SIGHUP};

[[noreturn]] void write_without_end(const std::string& path) {
  constexpr rlimit kNoCore = {0, 0};
  ::setrlimit(RLIMIT_CORE, &kNoCore);
  std::thread waits([] { ::pause(); });
  while (true) {
    OutputFile output(path);
    output.stream() << "new";
  }
}

TEST(OutputFile, LeavesNothingWhicheverThreadIsGivenTheSignal) {
  std::string folder = (fs::temp_directory_path() / "output_file_test.XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  for (int i = 0; i < kChildren && !HasFailure(); ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_without_end(folder + "/out");
    std::this_thread::sleep_for(std::chrono::microseconds(2000 + 37 * i));
    const int signal_number = kSignals[static_cast<std::size_t>(i) % std::size(kSignals)];
    ASSERT_EQ(::kill(child, signal_number), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal_number) << status;
    EXPECT_TRUE(fs::is_empty(folder)) << fs::directory_iterator(folder)->path();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace flowcert::io::output_file_test
