// The process is killed rather than left alone with its closed input, since nothing can be assumed of it.
#include "certify/programs/case_dialogue.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <istream>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>

#include "io/number_text.h"
#include "io/output_file.h"

namespace flowcert::certify {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Answers to a few points are a thousandth of this size.
constexpr std::size_t kMostBytesOfReply = std::size_t{16} << 20;
constexpr std::chrono::milliseconds kLook{50};
constexpr std::string_view kItsOutput = "standard output";

// Between this process and the program, in one direction. The program gets neither end but as a standard descriptor.
class OneWay {
 public:
  OneWay() : OneWay(opened()) {}

  Descriptor reading, writing;

 private:
  explicit OneWay(const std::array<int, 2>& ends) : reading(ends[0]), writing(ends[1]) {}
  static std::array<int, 2> opened() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    return ends;
  }
};

// Whether the descriptor is ready for these events before the deadline.
bool waits_for(int descriptor, short events, Clock::time_point deadline, const std::function<bool()>& is_cancelled) {
  while (!is_cancelled()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    if (left.count() <= 0) return false;
    pollfd waited{descriptor, events, 0};
    if (::poll(&waited, 1, static_cast<int>(std::min(left, kLook).count())) > 0) return true;
  }
  return false;
}

// What the program writes, up to a deadline. It ends there, and says why.
class ReplyBytes final : public std::streambuf {
 public:
  ReplyBytes(int descriptor, std::function<bool()> is_cancelled)
      : descriptor_(descriptor), is_cancelled_(std::move(is_cancelled)) {}

  void expect_reply_until(Clock::time_point deadline) {
    deadline_ = deadline;
    taken_ = 0;
  }
  [[nodiscard]] Silence why() const { return why_; }

 protected:
  int_type underflow() override {
    while (why_ == Silence::kNone) {
      if (!waits_for(descriptor_, POLLIN, deadline_, is_cancelled_)) {
        why_ = is_cancelled_() ? Silence::kCancelled : Silence::kLate;
        break;
      }
      const ssize_t count = ::read(descriptor_, bytes_.data(), bytes_.size());
      if (count < 0 && errno == EINTR) continue;
      taken_ += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
      if (count <= 0) why_ = Silence::kEnded;
      if (taken_ > kMostBytesOfReply) why_ = Silence::kUnreadable;
      if (why_ != Silence::kNone) break;
      setg(bytes_.data(), bytes_.data(), bytes_.data() + count);
      return traits_type::to_int_type(bytes_.front());
    }
    return traits_type::eof();
  }

 private:
  int descriptor_;
  std::function<bool()> is_cancelled_;
  Clock::time_point deadline_;
  std::size_t taken_ = 0;  // bytes since the case was asked
  Silence why_ = Silence::kNone;
  std::array<char, 65536> bytes_{};
};

}  // namespace

// ---- One process ----

class CaseDialogue::Process {
 public:
  Process(const std::string& command, const fs::path& folder, const ProgramLimits& limits,
          const std::function<bool()>& is_cancelled)
      : limits_(limits),
        is_cancelled_(is_cancelled),
        run_{.folder = folder, .answer_name = std::string(kItsOutput), .answer = {}, .end = {}},
        messages_(run_.err().string(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND),
        running_(command, fs::current_path().string(),
                 {cases_.reading.number(), replies_.writing.number(), messages_.number()}, limits),
        bytes_(replies_.reading.number(), is_cancelled),
        stream_(&bytes_),
        reader_(stream_, kItsOutput) {
    cases_.reading.close();
    replies_.writing.close();
    ::fcntl(cases_.writing.number(), F_SETFL, O_NONBLOCK);
  }

  [[nodiscard]] bool has_ended() const { return running_.has_ended(); }
  [[nodiscard]] bool is_ours() const { return owner_ == ::getpid(); }
  void forget() { running_.forget(); }

  CaseReply ask(const std::vector<Point>& rows) {
    const std::string id = fmt::format("fuzz:{}", ++asked_);
    const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.seconds));
    const Clock::time_point deadline = Clock::now() + limit;
    write(case_text(id, rows, NumberForm::kDecimal), deadline);
    bytes_.expect_reply_until(deadline);
    CaseReply reply = read_reply(id);
    if (reply.silence == Silence::kNone) {
      (void)!::ftruncate(messages_.number(), 0);
      return reply;
    }
    reply.run = run_;
    reply.run.end = running_.end();
    return reply;
  }

 private:
  // A program that is gone, or reads nothing, is noticed by its silence.
  void write(std::string_view text, Clock::time_point deadline) const {
    const auto before = ::signal(SIGPIPE, SIG_IGN);
    while (!text.empty() && waits_for(cases_.writing.number(), POLLOUT, deadline, is_cancelled_)) {
      const ssize_t count = ::write(cases_.writing.number(), text.data(), text.size());
      if (count < 0 && errno != EINTR && errno != EAGAIN) break;
      text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    ::signal(SIGPIPE, before);
  }

  CaseReply read_reply(const std::string& id) {
    CaseReply reply;
    try {
      const bool is_whole = reader_.next(reply.answer) && !reply.answer.is_cut;
      if (is_whole && reply.answer.id == id) return reply;
      if (is_whole)
        return unreadable(fmt::format("an answer to {} where {} was asked", in_quotes(reply.answer.id), id));
    } catch (const InvalidInput& error) {
      if (bytes_.why() != Silence::kUnreadable) return unreadable(error.what());
    }
    reply.silence = bytes_.why();
    if (reply.silence == Silence::kUnreadable) {
      return unreadable(fmt::format("{}: more than {} bytes", kItsOutput, kMostBytesOfReply));
    }
    return reply;
  }
  static CaseReply unreadable(const std::string& reason) {
    CaseReply reply;
    reply.silence = Silence::kUnreadable;
    reply.reason = reason;
    return reply;
  }

  ProgramLimits limits_;
  const std::function<bool()>& is_cancelled_;
  CommandRun run_;
  Descriptor messages_;  // each write goes to the end, so that the file can be emptied meanwhile
  OneWay cases_, replies_;
  RunningCommand running_;
  ReplyBytes bytes_;
  std::istream stream_;
  AnswerReader reader_;
  std::size_t asked_ = 0;
  pid_t owner_ = ::getpid();
};

// ---- All of them ----

CaseDialogue::CaseDialogue(std::string command, fs::path folder, const ProgramLimits& limits,
                           std::function<bool()> is_cancelled)
    : command_(std::move(command)),
      folder_(std::move(folder)),
      limits_(limits),
      is_cancelled_(std::move(is_cancelled)) {}

CaseDialogue::~CaseDialogue() {
  if (process_ && !process_->is_ours()) process_->forget();
}

CaseReply CaseDialogue::ask_new_process(const std::vector<Point>& rows) {
  const fs::path folder = folder_.string() + fmt::format("-{}", ::getpid());
  fs::create_directories(folder);
  process_ = std::make_unique<Process>(command_, folder, limits_, is_cancelled_);
  CaseReply reply = process_->ask(rows);
  if (reply.silence == Silence::kNone) reply = process_->ask(rows);
  if (reply.silence != Silence::kNone) process_.reset();
  return reply;
}

CaseReply CaseDialogue::ask(const std::vector<Point>& rows) {
  if (process_ && !process_->is_ours()) process_->forget();
  if (process_ && (!process_->is_ours() || process_->has_ended())) process_.reset();
  if (process_) {
    CaseReply reply = process_->ask(rows);
    if (reply.silence == Silence::kNone) return reply;
    process_.reset();
    if (reply.silence == Silence::kCancelled) return reply;
  }
  return ask_new_process(rows);
}

}  // namespace flowcert::certify
