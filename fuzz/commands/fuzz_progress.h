// How a campaign is getting on, on standard error: only on a terminal, only for what takes longer than two
// seconds, gone when it is done. The first line is about the whole, those below about families.
//
// ProgressLine knows a single number; this has a dozen lines.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

class FuzzProgress {
 public:
  // seconds: that it may take, if it is told.
  FuzzProgress(const fuzz::Campaign& campaign, std::optional<double> seconds);
  ~FuzzProgress();
  FuzzProgress(const FuzzProgress&) = delete;
  FuzzProgress& operator=(const FuzzProgress&) = delete;

  // Cases of batches that are under way, besides those of the campaign.
  void operator()(std::size_t under_way);

  [[nodiscard]] double seconds_so_far() const;

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] std::string first_line(std::size_t cases) const;
  void erase();

  const fuzz::Campaign& campaign_;
  std::optional<double> seconds_;
  std::size_t cases_before_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
  std::size_t lines_drawn_ = 0;
  bool is_terminal_;
};

}  // namespace flowcert::commands
