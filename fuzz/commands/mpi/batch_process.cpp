#include "fuzz/commands/mpi/batch_process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "certify/programs/command_run.h"
#include "fuzz/campaign/batch.h"
#include "fuzz/campaign/worker_processes.h"

namespace flowcert::commands {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kBetweenCounts{1};
// A process whose rank leaves it has so long to put its files away.
constexpr std::chrono::seconds kGrace{1};
constexpr const char* kPlanWord = "plan ";
constexpr const char* kOrderWord = "order ";
constexpr const char* kStopWord = "stop";

// ---- In the process

// The campaign, which is at the other end of two pipes.
class DistantCampaign : public fuzz::BatchSource {
 public:
  DistantCampaign(int orders, int messages) : orders_(orders), messages_(messages), reader_(orders) {}

  // Returns false if there is no more to do.
  bool wait_for_plan() {
    const auto text = next_after(kPlanWord);
    if (text) plan_ = fuzz::plan_of(*text);
    return text.has_value();
  }
  void tell(const std::string& line) const {
    if (!fuzz::write_line(messages_, line)) throw std::runtime_error("the rank of this process is gone");
  }
  bool is_stopped() {
    // "stop" may have come together with the order.
    is_stopped_ = is_stopped_ || is_told_to_stop();
    pollfd waited{orders_, POLLIN, 0};
    if (!is_stopped_ && ::poll(&waited, 1, 0) > 0) is_stopped_ = !reader_.read_more() || is_told_to_stop();
    return is_stopped_;
  }

  [[nodiscard]] const fuzz::CampaignPlan& plan() const override { return plan_; }
  std::optional<fuzz::BatchOrder> next_batch() override {
    if (!is_given_back_) {
      const auto text = next_after(kOrderWord);
      if (!text) return std::nullopt;
      order_ = fuzz::order_of(*text);
    }
    is_given_back_ = false;
    return order_;
  }
  void give_back(std::size_t) override { is_given_back_ = true; }
  void absorb(const std::string& message) override {
    const auto object = nlohmann::json::parse(message);
    if (object.contains("finding")) {
      const fuzz::Counterexample counterexample = fuzz::counterexample_of(object.at("finding"));
      if (fuzz::ends_process(counterexample)) order_.left_out.insert(counterexample.number);
    }
    tell(message);
  }

 private:
  bool is_told_to_stop() { return reader_.next_line() == kStopWord; }

  // Waits for a line. Returns nothing if the line begins with another word, or if no line will come.
  std::optional<std::string> next_after(const std::string& word) {
    std::optional<std::string> line;
    while (!is_stopped_ && !(line = reader_.next_line())) is_stopped_ = !reader_.read_more();
    if (!line || !line->starts_with(word)) return std::nullopt;
    return line->substr(word.size());
  }

  int orders_, messages_;
  fuzz::LineReader reader_;
  fuzz::CampaignPlan plan_;
  fuzz::BatchOrder order_;
  bool is_given_back_ = false;
  bool is_stopped_ = false;
};

void do_batches(DistantCampaign& campaign, const FuzzOptions& options) {
  if (!campaign.wait_for_plan()) return;
  require_startable(campaign.plan());
  const auto properties = properties_of(campaign.plan());
  campaign.tell("ready " + fuzz::program_version());
  Clock::time_point counted = Clock::now();
  fuzz::WorkOptions work;
  work.hang_seconds = hang_seconds(campaign.plan(), options);
  work.is_stopped = [&] { return campaign.is_stopped(); };
  work.progress = [&](std::size_t under_way) {
    if (Clock::now() - counted < kBetweenCounts) return;
    counted = Clock::now();
    campaign.tell(fmt::format("cases {}", under_way));
  };
  fuzz::work_on(campaign, properties, work);
}

void be_the_process(const FuzzOptions& options, int orders, int messages) {
  try {
    DistantCampaign campaign(orders, messages);
    do_batches(campaign, options);
  } catch (const std::exception& error) {
    (void)fuzz::write_line(messages, "gone " + one_line(error.what()));
  }
}

}  // namespace

// ---- In the rank

BatchProcess::BatchProcess(const FuzzOptions& options) {
  // The end of its lines shows that a process is gone, so no signal is needed.
  ::signal(SIGPIPE, SIG_IGN);
  process_ = fuzz::start_child([&] {
    to_it_.close_writing();
    from_it_.close_reading();
    be_the_process(options, to_it_.reading(), from_it_.writing());
  });
  to_it_.close_reading();
  from_it_.close_writing();
  reader_ = fuzz::LineReader(from_it_.reading());
}

BatchProcess::~BatchProcess() {
  to_it_.close_writing();
  const Clock::time_point start = Clock::now();
  while (::waitpid(process_, nullptr, WNOHANG) == 0) {
    if (Clock::now() - start > kGrace) ::kill(process_, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

void BatchProcess::give(const std::string& line) { (void)fuzz::write_line(to_it_.writing(), line); }

std::vector<std::string> BatchProcess::lines(int milliseconds) {
  std::vector<std::string> lines;
  pollfd waited{from_it_.reading(), POLLIN, 0};
  if (has_ended_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  } else if (::poll(&waited, 1, milliseconds) > 0) {
    has_ended_ = !reader_.read_more();
    while (auto line = reader_.next_line()) lines.push_back(std::move(*line));
  }
  return lines;
}

}  // namespace flowcert::commands
