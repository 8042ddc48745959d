// A progress bar on standard error: only on a terminal, only for what takes longer than two seconds, gone
// when it is done.
//
// Our own, since Debian has no C++ library for it but Boost's progress_display, which cannot be taken back
// from the screen and knows neither terminals nor delays.
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

// The progress of a flow complex that is being made: a line for each of its parts, one after the other.
class PartProgress {
 public:
  // what_of: after the part's name, as ", run 2 of 5".
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
  // What is on the screen goes.
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

// The complex keeps it: what is made later tells its progress, too.
inline FlowComplex::Progress part_progress(std::string what_of = "") {
  return [told = std::make_shared<PartProgress>(std::move(what_of))](
             FlowComplexPart part, std::size_t done, std::size_t total) { (*told)(part, done, total); };
}

}  // namespace flowcert::cli
