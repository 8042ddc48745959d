// A progress bar on standard error. It is shown only on a terminal, and only for work that takes longer than two
// seconds. It is erased when the work is done.
//
// The code is our own. Debian's only C++ library for this is Boost's progress_display. That cannot be erased from
// the screen, and knows neither terminals nor delays.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/layer.h"
#include "flowcert/flow_complex.h"

namespace flowcert::cli {

class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(std::size_t done, std::size_t total);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
  bool is_terminal_;
  bool is_drawn_ = false;
};

// The progress of a flow complex while it is computed. Each of its parts has a line, one after the other.
class PartProgress {
 public:
  // what_of follows the part's name, for example ", run 2 of 5".
  explicit PartProgress(std::string what_of = "") : what_of_(std::move(what_of)) {}

  void operator()(FlowComplexPart part, std::size_t done, std::size_t total) {
    if (part_ != part) {
      line_.reset();
      line_.emplace(name_of(part) + what_of_);
      part_ = part;
    }
    (*line_)(done, total);
    if (done == total) end();
  }

 private:
  // Erases the line from the screen.
  void end() {
    line_.reset();
    part_.reset();
  }

  static std::string name_of(FlowComplexPart part) {
    switch (part) {
      case FlowComplexPart::kTriangulation:
        return "Delaunay triangulation";
      case FlowComplexPart::kDiagram:
      case FlowComplexPart::kStationary:
        return "critical points";
      case FlowComplexPart::kUnstable:
        return "unstable manifolds";
      case FlowComplexPart::kStable:
        return "stable manifolds";
      case FlowComplexPart::kChains:
        return "chain complex";
      case FlowComplexPart::kPersistence:
        break;
    }
    return "persistence";
  }

  std::string what_of_;
  std::optional<FlowComplexPart> part_;
  std::optional<ProgressLine> line_;
};

// The complex keeps this function. So parts that are computed later show their progress too.
inline FlowComplex::Progress part_progress(std::string what_of = "") {
  return [told = std::make_shared<PartProgress>(std::move(what_of))](FlowComplexPart part, std::size_t done,
                                                                     std::size_t total) { (*told)(part, done, total); };
}

}  // namespace flowcert::cli
