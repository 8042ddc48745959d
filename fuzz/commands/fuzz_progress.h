// Shows the progress of a campaign on standard error. It is shown only on a terminal, after two seconds, and is
// erased at the end. The first line is about the whole campaign, the lines below are about families.
//
// ProgressLine shows a single number only; this has a dozen lines.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

class FuzzProgress {
 public:
  // `seconds` is the time that the run may take, if it has a limit.
  FuzzProgress(const fuzz::Campaign& campaign, std::optional<double> seconds);
  ~FuzzProgress();
  FuzzProgress(const FuzzProgress&) = delete;
  FuzzProgress& operator=(const FuzzProgress&) = delete;

  // `under_way` counts cases of batches under way. The campaign does not count these yet.
  void operator()(std::size_t under_way);

  // Erases it until the next call, so that something else can be printed.
  void hide();

  [[nodiscard]] double seconds_so_far() const { return fuzz::seconds_since(start_); }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string first_line(std::size_t cases) const;

  const fuzz::Campaign& campaign_;
  std::optional<double> seconds_;
  std::size_t cases_before_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
  std::size_t lines_drawn_ = 0;
  bool is_terminal_;
};

}  // namespace flowcert::commands
