#include "flowcert/flow_statistics.h"

#include <cmath>

#include "flow/layer.h"
#include "geometry/floating_point.h"

namespace flowcert {

using namespace flow;

std::size_t Distribution::count() const {
  std::size_t count = 0;
  for (const auto& [value, times] : times_) count += times;
  return count;
}

double Distribution::mean() const {
  const geometry::IeeeDoubles ieee;
  double sum = 0;
  for (const auto& [value, times] : times_) sum += static_cast<double>(value) * static_cast<double>(times);
  return times_.empty() ? 0 : sum / static_cast<double>(count());
}

std::size_t Distribution::max() const { return times_.empty() ? 0 : times_.rbegin()->first; }

double Distribution::standard_deviation() const {
  const geometry::IeeeDoubles ieee;
  const double center = mean();
  double sum = 0;
  for (const auto& [value, times] : times_) {
    const double difference = static_cast<double>(value) - center;
    sum += difference * difference * static_cast<double>(times);
  }
  return times_.empty() ? 0 : std::sqrt(sum / static_cast<double>(count()));
}

std::size_t Distribution::mode() const {
  std::size_t mode = 0, most = 0;
  for (const auto& [value, times] : times_) {
    if (times > most) mode = value, most = times;
  }
  return mode;
}

double Distribution::median() const {
  const geometry::IeeeDoubles ieee;
  if (times_.empty()) return 0;
  const auto at_rank = [this](std::size_t rank) {
    for (const auto& [value, times] : times_) {
      if (rank < times) return static_cast<double>(value);
      rank -= times;
    }
    return 0.0;
  };
  const std::size_t n = count();
  return (at_rank((n - 1) / 2) + at_rank(n / 2)) / 2;
}

}  // namespace flowcert
