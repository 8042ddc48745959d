// A step of a run that takes long, with a progress line while it lasts.
#pragma once

#include <functional>

#include "cli/progress_line.h"

namespace flowcert::cli {

// What `make` makes, given something to tell its progress to.
template <typename Make>
auto with_progress(const char* what, const Make& make) {
  ProgressLine progress(what);
  return make(std::ref(progress));
}

}  // namespace flowcert::cli
